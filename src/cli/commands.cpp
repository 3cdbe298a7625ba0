#include "cli/commands.h"

#include "cli/compare_command.h"
#include "cli/diagnostics.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/text_io.h"

#include <array>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

// Prints findings to stderr (JSON: to stdout) as they come and counts them.
class Findings {
 public:
  explicit Findings(const Arguments& arguments)
      : quiet_(arguments.quiet),
        strict_(arguments.strict),
        json_(arguments.json),
        colours_(has_colours(stderr)) {}

  void add(const Diagnostic& diagnostic) {
    ++count_[static_cast<std::size_t>(diagnostic.severity)];
    if (json_) return print(diagnostic_json(diagnostic) + "\n");
    if (quiet_ && !fails(diagnostic.severity)) return;
    std::fflush(stdout);  // keeps motions and findings in order where both go to one place
    const std::string text = format_diagnostic(diagnostic, colours_);
    std::fputs(text.c_str(), stderr);
  }
  void add(const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) add(diagnostic);
  }

  std::size_t errors() const { return count_[static_cast<std::size_t>(Severity::error)]; }
  std::size_t warnings() const { return count_[static_cast<std::size_t>(Severity::warning)]; }
  std::size_t notes() const { return count_[static_cast<std::size_t>(Severity::note)]; }
  bool failed() const { return errors() > 0 || (strict_ && warnings() > 0); }
  std::string summary() const {
    const auto part = [](std::size_t n, const char* word) {
      return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
    };
    return fmt::format("{}, {}, {}", part(errors(), "error"), part(warnings(), "warning"),
                       part(notes(), "note"));
  }

 private:
  bool fails(Severity severity) const {
    return severity == Severity::error || (strict_ && severity == Severity::warning);
  }
  bool quiet_, strict_, json_, colours_;
  std::array<std::size_t, 3> count_{};
};

// A full disk or a closed pipe is a failure, not a short answer.
int finish_output(int code) {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error("output-unwritable", "cannot write to the standard output");
  return code;
}

// The part just cut against --nominal, while its owners are at hand.
int compare_part(const Arguments& arguments, const JobResult& result, const NamedNominal& nominal) {
  CompareRequest request = arguments.compare;
  const ReportFacts facts = facts_of(result, arguments.input);
  if (request.nominal.empty()) {
    if (request.report.empty()) return kDone;
    Comparison plain;
    plain.origin = result.mesh.origin;
    plain.part_name = arguments.outputs.empty() ? arguments.input : arguments.outputs[0];
    plain.text = read_program_lines(result.mesh.origin, arguments.input);
    const std::string page = report_html(result.mesh, {}, plain, facts, arguments.carve.threads);
    write_file_atomically(request.report,
                          [&](const ByteSink& out) { out(page.data(), page.size()); });
    return kDone;
  }
  if (request.options.accept && arguments.mesh.tolerance > 0 &&
      arguments.mesh.tolerance > (request.options.accept->hi - request.options.accept->lo) / 8)
    fmt::print(stderr, "warning: --tolerance {:g} is coarse for --accept: use a quarter or less\n",
               arguments.mesh.tolerance);
  request.part = arguments.outputs.empty() ? arguments.input : arguments.outputs[0];
  request.quiet = arguments.quiet;
  request.options.threads = arguments.carve.threads;
  request.folders.push_back(std::filesystem::path(arguments.input).parent_path().string());
  return run_comparison(request, result.mesh, nominal, facts);
}

}  // namespace

int run_simulate(const Arguments& arguments) {
  Job job;
  job.program = arguments.input;
  job.interp = arguments.interp;
  job.stock = arguments.stock;
  job.stock_options = arguments.stock_options;
  job.carve = arguments.carve;
  job.mesh = arguments.mesh;
  job.collisions.threads = arguments.carve.threads;
  job.outputs = arguments.outputs;
  job.files = arguments.files;
  job.keep = arguments.keep;
  job.strict = arguments.strict;
  const NamedNominal nominal = prepare_comparison(arguments.compare);
  JobResult result;
  {
    ProgressBar bar(!arguments.quiet);
    catch_interrupt();
    job.stock_options.progress = job.carve.progress = job.collisions.progress = job.mesh.progress =
        bar.callback();
    result = simulate(job);
  }
  Findings findings(arguments);
  findings.add(result.program.diagnostics);
  if (!result.ok) {
    fmt::print(stderr, "{}: {}; nothing was cut or written\n", arguments.input, findings.summary());
    return kFailed;
  }
  if (!arguments.quiet) print(format_report(arguments, result, has_colours(stdout)));
  if (!arguments.quiet && arguments.outputs.empty())
    print("  nothing was written: no output given (-o part.stl)\n");
  return finish_output(compare_part(arguments, result, nominal));
}

int run_trace(const Arguments& arguments) {
  Findings findings(arguments);
  TraceSink sink;
  sink.line = [](const std::string& line) { print(line + "\n"); };
  sink.diagnostic = [&](const Diagnostic& diagnostic) { findings.add(diagnostic); };
  InterpOptions options = arguments.interp;
  options.require_tools = false;
  trace(arguments.input, options, arguments.json, sink);
  if (!findings.failed() && !arguments.outputs.empty())
    write_path_picture(interpret(arguments.input, options), arguments.outputs[0]);
  return finish_output(findings.failed() ? kFailed : kDone);
}

int run_check(const Arguments& arguments) {
  Findings findings(arguments);
  std::size_t motions = 0;
  TraceSink sink;
  sink.motion = [&](const Motion&) { ++motions; };
  sink.diagnostic = [&](const Diagnostic& diagnostic) { findings.add(diagnostic); };
  InterpOptions options = arguments.interp;
  options.require_tools = false;
  const Program program = trace(arguments.input, options, arguments.json, sink);
  if (!arguments.quiet && !arguments.json) {
    print(format_program(program, arguments.verbose, has_colours(stdout)));
    print(fmt::format("  {:<11}{}\n", "motions", grouped(static_cast<double>(motions), 0)));
    print(fmt::format("  {:<11}{}\n", "result", findings.summary()));
  }
  return finish_output(findings.failed() ? kFailed : kDone);
}

int run_render(const Arguments& arguments) {
  const TriMesh mesh = read_mesh(arguments.input);
  render(mesh, arguments.outputs[0], arguments.render);
  if (!arguments.quiet)
    print(fmt::format("{}: {} triangles drawn from {}\n", arguments.outputs[0],
                      grouped(static_cast<double>(mesh.triangles.size()), 0), arguments.input));
  return finish_output(kDone);
}

}  // namespace mrsim::cli
