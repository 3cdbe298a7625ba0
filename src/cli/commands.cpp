#include "cli/commands.h"

#include "cli/compare_command.h"
#include "cli/findings.h"
#include "cli/report.h"
#include "cli/stop.h"
#include "cli/terminal.h"
#include "core/output_place.h"
#include "core/publish.h"
#include "core/text_io.h"

#include <array>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

namespace mrsim::cli {

namespace {

// Of commands that write one picture: before any work.
void check_picture(const Arguments& arguments, const char* input_role) {
  if (arguments.outputs.empty()) return;
  const std::array<NamedPath, 1> picture{{{arguments.outputs[0], "-o"}}};
  std::vector<NamedPath> inputs = arguments.named_inputs;
  inputs.push_back({arguments.input, input_role});
  check_writable(arguments.outputs[0]);
  refuse_overwrites(picture, inputs);
  recover_outputs(arguments.outputs);
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

void write_last_words(const LastWords& words, const std::vector<NamedPath>& kept) {
  const NamedPath json{words.json_path, "--json"}, junit{words.junit_path, "--junit"};
  const auto write = [&](const NamedPath& file, const NamedPath& other, const std::string& text) {
    if (file.path.empty()) return;
    std::vector<NamedPath> all = kept;
    if (file.path != other.path) all.push_back(other);
    try {
      refuse_overwrites({&file, 1}, all);
      write_file_atomically(file.path,
                            [&](const ByteSink& sink) { sink(text.data(), text.size()); });
    } catch (const Error& error) {
      fmt::print(stderr, "mrsim: {} is not written: {}\n", file.role, error.what());
    }
  };
  if (json.path != junit.path) write(junit, json, words.junit);
  write(json, junit, words.json);
}

int run_trace(const Arguments& arguments) {
  check_picture(arguments, "the program");
  Findings findings(arguments);
  TraceSink sink;
  if (!arguments.quiet) sink.line = [](const std::string& line) { print(line + "\n"); };
  sink.diagnostic = [&](const Diagnostic& diagnostic) { findings.add(diagnostic); };
  InterpOptions options = arguments.interp;
  options.require_tools = false;
  trace(arguments.input, options, arguments.json, sink);
  if (!findings.failed() && !arguments.outputs.empty()) {
    const Program program = interpret(arguments.input, options);
    arguments.outputs[0].ends_with(".html") ? write_path_page(program, arguments)
                                            : write_path_picture(program, arguments.outputs[0]);
  }
  return finish_output(findings.failed() ? kFailed : kDone);
}

int run_render(const Arguments& arguments) {
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
    fmt::print(stderr,
               "{}: this file does not say which line cut which face, so --color shows nothing; "
               ".ply, .obj, .glb, .3mf and .vdb do\n",
               arguments.input);
  render(mesh, arguments.outputs[0], arguments.render);
  if (!arguments.quiet)
    print(fmt::format("{}: {} triangles drawn from {}\n", arguments.outputs[0],
                      grouped(static_cast<double>(mesh.triangles.size()), 0), arguments.input));
  return finish_output(kDone);
}

}  // namespace mrsim::cli
