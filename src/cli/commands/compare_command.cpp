#include "cli/commands/compare_command.h"

#include "cli/commands/commands.h"
#include "cli/console/standard_streams.h"
#include "cli/console/stop.h"
#include "cli/console/terminal.h"
#include "cli/options/idle_options.h"
#include "cli/options/option_values.h"
#include "cli/options/typed_options.h"
#include "core/output/publish.h"
#include "core/text/text_io.h"
#include "core/words/suggest.h"
#include <mrsim/report_html.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <utility>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

void check_deviation_name(const CompareRequest& request) {
  const std::string& colored = request.deviation;
  const std::string end = std::filesystem::path(colored).extension().string();
  const std::array<std::string_view, 4> kept = {".ply", ".PLY", ".glb", ".GLB"};
  if (!colored.empty() && std::find(kept.begin(), kept.end(), end) == kept.end())
    fail_usage(fmt::format("{}: colours of deviation are kept by .ply and .glb", colored));
}

std::vector<NamedPath> named_files(const CompareRequest& request) {
  std::vector<NamedPath> out;
  for (const NamedPath& file : {NamedPath{request.deviation, "-o"},
                                {request.report, "--report"},
                                {request.junit, "--junit"},
                                {request.json, "--json"}})
    if (!file.path.empty()) out.push_back(file);
  return out;
}

// Checks the output files of `mrsim compare` before any work, so that no long comparison is lost to
// a missing folder.
void check_places(const CompareRequest& request) {
  const std::array<NamedPath, 2> inputs{
      {{request.part, "the part"}, {request.nominal, "the nominal"}}};
  prepare_outputs(named_files(request), inputs);
}

TriMesh read_named(const CompareRequest& request, const std::string& path, std::string& note) {
  const double deflection =
      request.deflection > 0 ? request.deflection : step_deflection(request.options.accept);
  return read_solid(path, deflection, request.options.threads, &note);
}

void warn(const CompareRequest& request, const std::string& text) {
  if (!request.quiet) say(printable(text) + "\n");
}

// Writes all of the files or none.
void write_results(const CompareRequest& request, const TriMesh& part, const TriMesh& nominal,
                   const Comparison& comparison, const ReportFacts& facts) {
  std::vector<OutputFile> files;
  if (!request.deviation.empty())
    files.push_back({request.deviation, [&](const ByteSink& sink) {
                       write_deviation(request, part, nominal, comparison, sink);
                     }});
  const auto add = [&](const std::string& path, std::function<std::string()> text) {
    if (!path.empty())
      files.push_back({path, [text = std::move(text)](const ByteSink& sink) {
                         const std::string bytes = text();
                         sink(bytes.data(), bytes.size());
                       }});
  };
  add(request.report,
      [&] { return report_html(part, nominal, comparison, facts, request.options.threads); });
  const auto said = [](std::string text) {
    set_last_words({});  // from here on these are the words
    return text;
  };
  add(request.junit, [&] { return said(comparison_junit(comparison)); });
  add(request.json, [&] { return said(comparison_json(comparison)); });
  write_files_atomically(files);
}

// --json and --junit of a comparison that has ended with an error. They replace no input and no
// other output either.
void tell_failure(const CompareRequest& request, const Failure& failure) {
  std::vector<NamedPath> kept{{request.part, "the part"}, {request.nominal, "the nominal"}};
  for (const std::string& path : {request.deviation, request.report})
    if (!path.empty()) kept.push_back({path, "an output"});
  const FailedComparison failed{request.part, request.nominal, failure.code, failure.text};
  write_last_words({request.json, comparison_json(failed), request.junit, comparison_junit(failed)},
                   kept);
}

}  // namespace

NamedNominal prepare_comparison(const CompareRequest& request) {
  NamedNominal out;
  check_deviation_name(request);
  if (request.nominal.empty()) return out;
  out.mesh = read_named(request, request.nominal, out.note);
  require_nominal(out.mesh, request.nominal, request.options.threads);
  return out;
}

Comparison compare_named(const CompareRequest& request, const TriMesh& part,
                         const TriMesh& nominal) {
  Comparison out = compare(part, nominal, request.options,
                           read_program_lines(part.origin, request.part, request.folders));
  out.part_name = request.part;
  out.nominal_name = request.nominal;
  return out;
}

void write_deviation(const CompareRequest& request, const TriMesh& part, const TriMesh& nominal,
                     const Comparison& comparison, const ByteSink& sink) {
  encode_mesh(deviation_mesh(part, nominal, comparison, request.scheme, request.options.threads),
              request.deviation, sink);
}

int show_comparison(const CompareRequest& request, const NamedNominal& nominal,
                    const Comparison& comparison) {
  if (!nominal.note.empty()) warn(request, nominal.note);
  if (!request.quiet && request.json != "-") print(comparison_text(comparison));
  return comparison.accepted.value_or(true) ? kDone : kRejected;
}

TriMesh color_by_deviation(const CompareRequest& request, const TriMesh& part) {
  const NamedNominal nominal = prepare_comparison(request);
  if (!nominal.note.empty()) warn(request, nominal.note);
  CompareOptions options = request.options;
  options.hints = false;
  const Comparison comparison = compare(part, nominal.mesh, options);
  return deviation_mesh(part, nominal.mesh, comparison, request.scheme, options.threads);
}

namespace {

// Reads, compares and writes; the exit code.
int compare_files(const CompareRequest& request) {
  check_places(request);
  const NamedNominal nominal = prepare_comparison(request);
  ReportFacts facts;
  facts.title = std::filesystem::path(request.part).filename().string();
  std::string note;
  const TriMesh part = read_named(request, request.part, note);
  if (!note.empty()) warn(request, note);
  protect_program(program_places(part.origin, request.part, request.folders), named_files(request));
  if (part.owners.empty())
    warn(request, request.part +
                      ": this file does not say which line cut which face, so no lines are named; "
                      ".ply, .obj, .glb, .3mf and .vdb do");
  const Comparison comparison = compare_named(request, part, nominal.mesh);
  facts.times = {{"compare", comparison.seconds}};
  if (!nominal.note.empty()) facts.facts.emplace_back("Nominal", nominal.note);
  write_results(request, part, nominal.mesh, comparison, facts);
  all_is_written();
  return finish_output(show_comparison(request, nominal, comparison));
}

CompareRequest typed_request(const TypedOptions& typed) {
  typed.refuse_unknown();
  if (typed.inputs().size() != 2)
    fail_usage(fmt::format("compare takes a part and a nominal; usage: {}",
                           command_line(kUseCompare).usage));
  CompareRequest out = compare_request(typed);
  tell_idle_options(command_line(kUseCompare), typed);
  out.part = typed.inputs()[0];
  out.nominal = typed.inputs()[1];
  out.deviation = typed.text("--output");
  out.folders = existing_paths("--path", typed.texts("--path"));
  out.quiet = typed.flag("--quiet");
  typed.read("--threads", out.options.threads, threads_value);
  limit_memory(typed);
  return out;
}

}  // namespace

int run_compare(int argc, const char* const* argv) {
  const TypedOptions typed(command_line(kUseCompare), argc, argv);
  if (!typed.help().empty()) {
    print(typed.help());
    return finish_output(kDone);
  }
  const std::vector<std::string>& inputs = typed.inputs();
  CompareRequest named = named_request(typed);
  if (!inputs.empty()) named.part = inputs[0];
  if (inputs.size() > 1) named.nominal = inputs[1];
  named.deviation = typed.text("--output");
  return run_told([&] { return compare_files(typed_request(typed)); },
                  [&](const Failure& failure) { tell_failure(named, failure); });
}

}  // namespace mrsim::cli
