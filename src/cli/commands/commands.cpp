#include "cli/commands/commands.h"

#include "cli/commands/compare_command.h"
#include "cli/console/figures.h"
#include "cli/console/shortage.h"
#include "cli/console/standard_streams.h"
#include "cli/console/stop.h"
#include "cli/console/terminal.h"
#include "cli/report/findings.h"
#include "cli/report/report.h"
#include "core/output/output_place.h"
#include "core/output/publish.h"
#include "core/text/ascii.h"
#include "core/text/text_io.h"
#include <mrsim/report_html.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

namespace mrsim::cli {

namespace {

// Checks the output of a command that writes one picture; called before any work.
void check_picture(const Arguments& arguments, const char* input_role) {
  if (arguments.outputs.empty()) return;
  const std::array<NamedPath, 1> picture{{{arguments.outputs[0], "-o"}}};
  std::vector<NamedPath> inputs = arguments.named_inputs;
  inputs.push_back({arguments.input, input_role});
  prepare_outputs(picture, inputs);
}

// Throws unless the file may be replaced although not all inputs are known: there is none, it is a
// device, or it begins as a JSON or JUnit of mrsim does.
void require_result(const std::string& path) {
  const OutputPlace place = output_place(path);
  std::error_code none;
  if (place.kind != OutputPlace::Kind::file || !std::filesystem::exists(place.path, none)) return;
  std::array<char, 128> bytes{};
  std::ifstream file(place.path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  const std::string_view begin(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (begin.empty() || begin.starts_with("{\n \"schema\": ") ||
      (begin.starts_with("<?xml ") && begin.find("<testsuites ") != begin.npos))
    return;
  throw Error("output-is-input",
              path + " holds something else than an earlier result of this kind; name another file",
              Error::Kind::usage);
}

// The page of a run without a stock.
void write_path_page(const Program& program, const Arguments& arguments) {
  const CycleTime cycle = cycle_time(program, arguments.machine);
  const Play play = path_play(program);
  ReportFacts facts;
  facts.title = std::filesystem::path(arguments.input).filename().string();
  facts.facts = {{"Program", arguments.input},
                 {"Machine", machine_name(program.machine)},
                 {"Moves", grouped(static_cast<double>(program.motions.size()), 0)},
                 {"Cycle", duration(cycle.total)}};
  facts.tools = program.tools;
  facts.diagnostics = program.diagnostics;
  facts.run = {&program, &cycle, nullptr, &play};
  Comparison shown;
  shown.part_name = arguments.input;
  shown.origin.files = program.files;
  shown.text = read_program_lines(shown.origin, arguments.input);
  const std::string html = report_html({}, {}, shown, facts);
  write_file_atomically(arguments.outputs[0],
                        [&](const ByteSink& sink) { sink(html.data(), html.size()); });
}

}  // namespace

int exit_code_of(const Error& error) {
  if (error.code() == "cancelled" && stop_code() != 0) return stop_code();
  return error.kind() == Error::Kind::usage ? kUsage : kFailed;
}

void protect_program(const std::vector<std::string>& files, const std::vector<NamedPath>& outputs) {
  std::vector<NamedPath> inputs;
  for (const std::string& file : files) inputs.push_back({file, "the program"});
  refuse_overwrites(outputs, inputs);
}

int run_told(const std::function<int()>& work, const std::function<void(const Failure&)>& tell) {
  set_last_words([&tell](int code) { tell({"cancelled", "the run was stopped", code, true}); });
  const auto fail = [&](const Failure& failure) {
    set_last_words({});
    tell(failure);
  };
  try {
    const int code = work();
    set_last_words({});
    return code;
  } catch (const Error& error) {
    fail({error.code(), error.what(), exit_code_of(error)});
    throw;
  } catch (const std::exception& error) {
    if (const Shortage* shortage = find_shortage(error))
      fail({shortage->code, shortage->text, kFailed});
    else
      fail({"internal", error.what(), kInternal});
    throw;
  }
}

Arguments typed_arguments(int argc, const char* const* argv) {
  Arguments refused;
  try {
    return parse_arguments(argc, argv, &refused);
  } catch (const Error& error) {
    if (refused.command == Command::simulate)
      tell_refused(refused, error);
    else if (refused.json)
      Findings(refused).add(error);
    throw;
  }
}

void write_last_words(const LastWords& words, const std::vector<NamedPath>& kept) {
  const NamedPath json{words.json_path, "--json"}, junit{words.junit_path, "--junit"};
  const auto write = [&](const NamedPath& file, const NamedPath& other, const std::string& text) {
    if (file.path.empty()) return;
    std::vector<NamedPath> all = kept;
    if (file.path != other.path) all.push_back(other);
    try {
      refuse_overwrites({&file, 1}, all);
      require_result(file.path);
      write_file_atomically(file.path,
                            [&](const ByteSink& sink) { sink(text.data(), text.size()); });
    } catch (const Error& error) {
      say(fmt::format("mrsim: {} is not written: {}\n", file.role, printable(error.what())));
    }
  };
  if (json.path != junit.path) write(junit, json, words.junit);
  write(json, junit, words.json);
}

namespace {

int trace_program(const Arguments& arguments, Findings& findings) {
  check_picture(arguments, "the program");
  TraceSink sink;
  if (!arguments.quiet) sink.line = [](const std::string& line) { print(line + "\n"); };
  sink.diagnostic = [&](const Diagnostic& diagnostic) { findings.add(diagnostic); };
  InterpOptions options = arguments.interp;
  options.require_tools = false;
  trace(arguments.input, options, arguments.json, sink);
  if (!findings.failed() && !arguments.outputs.empty()) {
    const Program program = interpret(arguments.input, options);
    protect_program(program.files, {{arguments.outputs[0], "-o"}});
    extension_of(arguments.outputs[0]) == ".html"
        ? write_path_page(program, arguments)
        : write_path_picture(program, arguments.outputs[0]);
  }
  return finish_output(findings.failed() ? kFailed : kDone);
}

}  // namespace

int run_trace(const Arguments& arguments) {
  tell_stop_as_finding(arguments);
  Findings findings(arguments);
  try {
    return trace_program(arguments, findings);
  } catch (const Error& error) {
    if (arguments.json) findings.add(error, arguments.input);
    throw;
  }
}

void require_png(const std::string& path) {
  if (const std::string extension = extension_of(path); !extension.empty() && extension != ".png")
    throw Error("output-format", fmt::format("{}: a picture is written as .png", path),
                Error::Kind::usage);
}

int run_render(const Arguments& arguments) {
  require_png(arguments.outputs[0]);
  check_picture(arguments, "the part");
  const int threads = arguments.render.threads;
  TriMesh mesh = read_solid(arguments.input, 0.001, threads);
  if (!arguments.compare.nominal.empty()) {
    CompareRequest request = arguments.compare;
    request.quiet = arguments.quiet;
    request.options.threads = threads;
    mesh = color_by_deviation(request, mesh);
  }
  if (arguments.render.color != ColorBy::none && mesh.owners.empty() && mesh.colors.empty())
    say(fmt::format(
        "{}: this file does not say which line cut which face, so --color shows nothing; "
        ".ply, .obj, .glb, .3mf and .vdb do\n",
        printable(arguments.input)));
  render(mesh, arguments.outputs[0], arguments.render);
  if (!arguments.quiet)
    print(fmt::format("{}: {} triangles drawn from {}\n", printable(arguments.outputs[0]),
                      grouped(static_cast<double>(mesh.triangles.size()), 0),
                      printable(arguments.input)));
  return finish_output(kDone);
}

}  // namespace mrsim::cli
