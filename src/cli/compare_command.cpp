#include "cli/compare_command.h"

#include "cli/commands.h"
#include "cli/findings.h"
#include "cli/option_values.h"
#include "cli/report.h"
#include "core/output_place.h"
#include "core/publish.h"
#include "core/suggest.h"
#include "core/text_io.h"
#include <mrsim/memory.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace mrsim::cli {
namespace {

constexpr const char* kUsageLine = "mrsim compare PART NOMINAL [options]";

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

// The files of `mrsim compare`, before any work, so that a long comparison is not lost to a
// missing folder.
void check_places(const CompareRequest& request) {
  const std::vector<NamedPath> outputs = named_files(request);
  std::vector<std::string> paths;
  for (const NamedPath& output : outputs) {
    check_writable(output.path);
    paths.push_back(output.path);
  }
  const std::array<NamedPath, 2> inputs{
      {{request.part, "the part"}, {request.nominal, "the nominal"}}};
  refuse_overwrites(outputs, inputs);
  recover_outputs(paths);
}

// The programs whose lines are read beside the part.
void protect_programs(const CompareRequest& request, const OwnerTable& origin) {
  std::vector<NamedPath> inputs;
  for (const std::string& file : program_places(origin, request.part, request.folders))
    inputs.push_back({file, "the program"});
  refuse_overwrites(named_files(request), inputs);
}

TriMesh read_named(const CompareRequest& request, const std::string& path, std::string& note) {
  const double deflection =
      request.deflection > 0 ? request.deflection : step_deflection(request.options.accept);
  return read_solid(path, deflection, request.options.threads, &note);
}

void warn(const CompareRequest& request, const std::string& text) {
  if (!request.quiet) fmt::print(stderr, "{}\n", text);
}

// All of them or none.
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
  add(request.junit, [&] { return comparison_junit(comparison); });
  add(request.json, [&] { return comparison_json(comparison); });
  write_files_atomically(files);
}

Alignment alignment_value(const std::string& text) {
  if (text.empty() || text == "none") return Alignment::none;
  if (text == "bbox") return Alignment::bbox;
  if (text == "icp") return Alignment::icp;
  fail_usage(fmt::format("--align is none, bbox or icp, not \"{}\"", text));
}

const char* tool_kind(MachineKind kind) { return kind == MachineKind::lathe ? "lathe" : "mill"; }

}  // namespace

void add_compare_options(CLI::App& app, CompareTyped& typed, CompareUse use) {
  const auto add = [&](const char* name, std::string& value, const char* type, const char* text) {
    app.add_option(name, value, text)->type_name(type)->group("Comparison");
  };
  const bool picture = use == CompareUse::picture;
  if (use != CompareUse::command)
    add("--nominal", typed.nominal, "N",
        picture ? "colour by the deviation from this mesh or STEP file"
                : "compare the part with this mesh or STEP file");
  add("--accept", typed.accept, "T",
      picture ? "tolerance of the part, T or LO,HI in mm: what is green; default: 0.02"
              : "tolerance of the part, T or LO,HI in mm: gives the verdict and the exit code");
  add("--align", typed.align, "A", "none, bbox or icp: move the part onto the nominal first");
  add("--deflection", typed.deflection, "D",
      "STEP: largest distance from the exact faces, mm; default: a twentieth of the tolerance");
  add("--colors", typed.colors, "C", "standard, or safe for every kind of colour vision");
  if (picture) return;
  add("--density", typed.density, "N", "samples per mm2; default: 200 000 on each surface");
  add("--report", typed.report, "FILE", "self-contained HTML page");
  add("--json", typed.json, "FILE",
      use == CompareUse::run
          ? "what the run did, comparison included, as JSON; - for the standard output"
          : "comparison as JSON, - for the standard output");
  add("--junit", typed.junit, "FILE",
      use == CompareUse::run ? "the same as JUnit XML" : "verdict and regions as JUnit XML");
  add(use == CompareUse::run ? "--deviation" : "-o,--output", typed.deviation, "FILE",
      "part coloured by deviation: .ply or .glb");
}

CompareRequest compare_request(const CompareTyped& typed) {
  CompareRequest out;
  out.nominal = typed.nominal;
  if (!typed.accept.empty()) out.options.accept = parse_acceptance(typed.accept);
  out.options.align = alignment_value(typed.align);
  if (!typed.density.empty()) {
    out.options.density = number_value("--density", typed.density);
    if (!(out.options.density > 0))
      fail_usage(fmt::format("--density {} must be above 0, in samples a mm2", typed.density));
  }
  if (!typed.deflection.empty()) out.deflection = positive_value("--deflection", typed.deflection);
  if (!typed.colors.empty() && typed.colors != "standard" && typed.colors != "safe")
    fail_usage(fmt::format("--colors is standard or safe, not \"{}\"", typed.colors));
  if (typed.colors == "safe") out.scheme = DeviationScheme::safe;
  out.report = typed.report;
  out.json = typed.json;
  out.junit = typed.junit;
  out.deviation = typed.deviation;
  out.folders = typed.programs;
  return out;
}

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
  if (!request.quiet && request.json != "-")
    std::fputs(comparison_text(comparison).c_str(), stdout);
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

int run_compare(int argc, const char* const* argv) {
  CompareTyped typed;
  std::vector<std::string> inputs;
  std::string threads, max_memory;
  bool help = false, quiet = false;
  CLI::App app(
      "Says where a part differs from its drawing, by how much, and which line is to blame.");
  app.set_help_flag("");
  app.allow_extras();
  app.footer(
      "\nExamples:\n  mrsim compare part.ply nominal.step --accept 0.02 --report r.html\n"
      "  mrsim compare part.3mf nominal.stl --accept -0.02,0.05 --json - | jq .verdict\n\n"
      "Exit: 0 in tolerance, or no --accept; 1 a bad file; 2 wrong usage; 4 out of tolerance.");
  app.add_option("INPUT", inputs)->expected(0, -1)->group("");
  add_compare_options(app, typed, CompareUse::command);
  app.add_option("--path", typed.programs, "look for the programs here; may be repeated")
      ->type_name("DIR")
      ->group("Comparison")
      ->allow_extra_args(false);
  app.add_option("--threads", threads, "default: all cores; the result is the same for any number")
      ->type_name("N");
  app.add_option("--max-memory", max_memory, "refuse what would need more; default: what is free")
      ->type_name("SIZE");
  app.add_flag("-q,--quiet", quiet, "print errors only");
  app.add_flag("-h,--help", help, "print this and exit");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    fail_usage(error.what());
  }
  if (help) {
    fmt::print("Usage: {}\n{}", kUsageLine, app.help());
    return kDone;
  }
  refuse_unknown(app);
  if (inputs.size() != 2)
    fail_usage(fmt::format("compare takes a part and a nominal; usage: {}", kUsageLine));
  CompareRequest request = compare_request(typed);
  request.part = inputs[0];
  request.nominal = inputs[1];
  request.quiet = quiet;
  if (!threads.empty()) request.options.threads = threads_value("--threads", threads);
  set_memory_limit(max_memory.empty() ? 0 : size_value("--max-memory", max_memory));
  check_places(request);
  const NamedNominal nominal = prepare_comparison(request);
  ReportFacts facts;
  facts.title = std::filesystem::path(request.part).filename().string();
  std::string note;
  const TriMesh part = read_named(request, request.part, note);
  if (!note.empty()) warn(request, note);
  protect_programs(request, part.origin);
  if (part.owners.empty())
    warn(request, request.part +
                      ": this file does not say which line cut which face, so no lines are named; "
                      ".ply, .glb, .3mf and .vdb do");
  const Comparison comparison = compare_named(request, part, nominal.mesh);
  facts.times = {{"compare", comparison.seconds}};
  if (!nominal.note.empty()) facts.facts.emplace_back("Nominal", nominal.note);
  write_results(request, part, nominal.mesh, comparison, facts);
  return finish_output(show_comparison(request, nominal, comparison));
}

std::vector<ReportCollision> collisions_of(const JobResult& result) {
  const Program& program = result.program;
  std::vector<double> seconds(program.motions.size());  // before each motion
  for (std::size_t i = 1; i < std::min(seconds.size(), result.cycle.seconds.size() + 1); ++i)
    seconds[i] = seconds[i - 1] + result.cycle.seconds[i - 1];
  std::vector<ReportCollision> out;
  for (const Collision& c : result.collisions.lines) {
    const Motion& m = program.motions[c.motion];
    ReportCollision shown;
    shown.part = tool_part_name(c.part);
    shown.tool = program.tools[static_cast<std::size_t>(m.tool)].id;
    shown.file = program.files[static_cast<std::size_t>(m.file)];
    shown.line = m.line;
    shown.rapid = m.kind == MotionKind::rapid;
    shown.depth = c.depth;
    shown.volume = c.volume;
    shown.seconds = seconds[c.motion];
    shown.place = c.place;
    shown.motion = c.motion + 1;
    shown.motions = c.motions;
    for (const Diagnostic& d : program.diagnostics)
      if (d.place.line == m.line && d.place.file == shown.file && !d.source_line.empty())
        shown.text = d.source_line;
    out.push_back(shown);
  }
  std::stable_sort(out.begin(), out.end(), [](const ReportCollision& a, const ReportCollision& b) {
    return a.depth > b.depth;
  });
  return out;
}

ReportFacts facts_of(const JobResult& result, const std::string& program) {
  ReportFacts out;
  out.title = std::filesystem::path(program).filename().string();
  out.facts = {{"Program", program},
               {"Machine", tool_kind(result.program.machine)},
               {"Stock", result.stock.description},
               {"Voxel", fmt::format("{:.4g} mm, {}", result.voxel, result.voxel_reason)},
               {"Moves", fmt::format("{} rapids, {} lines, {} arcs", result.rapid_motions,
                                     result.line_motions, result.arc_motions)},
               {"Volume", grouped(result.volume, 3) + " mm³"},
               {"Removed", grouped(result.removed_volume, 3) + " mm³"},
               {"Cycle", duration(result.cycle.total)},
               {"Memory", fmt::format("{:.0f} MB", double(result.peak_memory) / 1e6)}};
  if (result.stock_repair.wrapped)
    out.facts.emplace_back("Stock's repair",
                           fmt::format("wrapped, at most {:.3g} mm beside its surface, {} openings "
                                       "closed",
                                       result.stock_repair.most, result.stock_repair.openings));
  if (result.mesh_bound > 0)
    out.facts.emplace_back("Mesh",
                           fmt::format("within {:.4g} mm of the exact part{}", result.mesh_bound,
                                       result.mesh_sampled > 0 ? ", by samples in places" : ""));
  out.times = result.stage_seconds;
  out.tools = result.program.tools;
  out.diagnostics = result.program.diagnostics;
  out.collisions = collisions_of(result);
  out.more_collisions = result.collisions.more;
  out.run = {&result.program, &result.cycle, &result.stock, &result.play};
  return out;
}

}  // namespace mrsim::cli
