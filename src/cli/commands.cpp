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

// The part just cut against --nominal, while its owners are at hand: measured before anything is
// written, so that a nominal that does not fit leaves no files.
class PartComparison {
 public:
  explicit PartComparison(const Arguments& arguments)
      : arguments_(arguments),
        request_(arguments.compare),
        nominal_(prepare_comparison(arguments.compare)) {
    request_.part = arguments.outputs.empty() ? arguments.input : arguments.outputs[0];
    request_.quiet = arguments.quiet;
    request_.options.threads = arguments.carve.threads;
    request_.folders.push_back(std::filesystem::path(arguments.input).parent_path().string());
    const auto& accept = request_.options.accept;
    if (accept && arguments.mesh.tolerance > narrow_side(*accept) / 4)
      fmt::print(stderr,
                 "warning: --tolerance {:g} is coarse for --accept: use a quarter or less\n",
                 arguments.mesh.tolerance);
  }

  /// Whether anything is to be told of the mesh.
  bool is_wanted() const { return !request_.nominal.empty() || !request_.report.empty(); }

  void measure(const TriMesh& part) {
    if (!request_.nominal.empty()) comparison_ = compare_named(request_, part, nominal_.mesh);
  }

  /// The report and the other files; the exit code.
  int finish(const JobResult& result) {
    const ReportFacts facts = facts_of(result, arguments_.input);
    if (!request_.nominal.empty())
      return finish_comparison(request_, result.mesh, nominal_, comparison_, facts);
    if (request_.report.empty()) return kDone;
    comparison_.origin = result.mesh.origin;
    comparison_.part_name = request_.part;
    comparison_.text = read_program_lines(result.mesh.origin, arguments_.input);
    const std::string page =
        report_html(result.mesh, {}, comparison_, facts, request_.options.threads);
    write_file_atomically(request_.report,
                          [&](const ByteSink& out) { out(page.data(), page.size()); });
    return kDone;
  }

 private:
  const Arguments& arguments_;
  CompareRequest request_;
  NamedNominal nominal_;
  Comparison comparison_;
};

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
  if (const auto& accept = arguments.compare.options.accept) job.accept = narrow_side(*accept);
  PartComparison comparison(arguments);
  job.whole_mesh = comparison.is_wanted();
  if (job.whole_mesh) job.inspect = [&](const TriMesh& part) { comparison.measure(part); };
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
  const bool talks = !arguments.quiet && arguments.compare.json != "-";
  if (talks) print(format_report(arguments, result, has_colours(stdout)));
  if (talks && arguments.outputs.empty())
    print("  nothing was written: no output given (-o part.stl)\n");
  return finish_output(comparison.finish(result));
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
  const int threads = arguments.render.threads;
  TriMesh mesh = read_solid(arguments.input, 0.001, threads);
  if (!arguments.compare.nominal.empty()) {
    CompareRequest request = arguments.compare;
    request.quiet = arguments.quiet;
    request.options.threads = threads;
    mesh = color_by_deviation(request, mesh);
  }
  render(mesh, arguments.outputs[0], arguments.render);
  if (!arguments.quiet)
    print(fmt::format("{}: {} triangles drawn from {}\n", arguments.outputs[0],
                      grouped(static_cast<double>(mesh.triangles.size()), 0), arguments.input));
  return finish_output(kDone);
}

}  // namespace mrsim::cli
