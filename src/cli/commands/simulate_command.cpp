// `mrsim PROGRAM`: from the command line to the part, with its comparison and its report.
#include "cli/commands/commands.h"
#include "cli/commands/compare_command.h"
#include "cli/console/shortage.h"
#include "cli/console/standard_streams.h"
#include "cli/console/stop.h"
#include "cli/console/terminal.h"
#include "cli/report/findings.h"
#include "cli/report/report.h"
#include "cli/report/rest_report.h"
#include "cli/report/run_facts.h"
#include "cli/report/run_json.h"
#include "core/output/output_place.h"
#include "core/process/memory_limit.h"
#include "core/text/text_io.h"
#include <mrsim/memory.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

namespace mrsim::cli {
namespace {

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
  }

  /// Whether the mesh is needed: for a comparison or for the page.
  bool is_wanted() const { return is_compared() || !request_.report.empty(); }

  void measure(const TriMesh& part) {
    if (!is_compared()) return;
    comparison_ = compare_named(request_, part, nominal_.mesh);
    if (!arguments_.rest.empty())
      rest_ = find_rest(part, nominal_.mesh, {.threads = request_.options.threads});
    is_measured_ = true;
  }

  /// The report and the other files, to be written with the part.
  std::vector<SideFile> files() {
    std::vector<SideFile> out;
    if (!request_.deviation.empty())
      out.push_back({{request_.deviation, "--deviation"},
                     [this](const JobResult& result, const ByteSink& sink) {
                       write_deviation(request_, result.mesh, nominal_.mesh, comparison_, sink);
                     }});
    const auto add = [&](const std::string& path, const char* role, auto text,
                         bool is_last = false) {
      if (path.empty()) return;
      out.push_back({{path, role},
                     [this, text](const JobResult& result, const ByteSink& sink) {
                       const std::string bytes = (this->*text)(result);
                       sink(bytes.data(), bytes.size());
                     },
                     is_last});
    };
    add(arguments_.rest, "--rest", &PartComparison::rest);
    add(request_.report, "--report", &PartComparison::report);
    add(request_.junit, "--junit", &PartComparison::junit, true);
    add(request_.json, "--json", &PartComparison::json, true);
    return out;
  }

  /// The comparison, once there is one.
  const Comparison* measured() const {
    return is_compared() && is_measured_ ? &comparison_ : nullptr;
  }

  /// Prints the comparison; the exit code.
  int finish() const {
    if (!is_compared()) return kDone;
    const int code = show_comparison(request_, nominal_, comparison_);
    if (rest_ && !request_.quiet && request_.json != "-" && request_.junit != "-")
      print(rest_text(*rest_));
    return code;
  }

 private:
  bool is_compared() const { return !request_.nominal.empty(); }
  std::string report(const JobResult& result) {
    ReportFacts facts = facts_of(result, arguments_.input);
    if (!nominal_.note.empty()) facts.facts.emplace_back("Nominal", nominal_.note);
    if (!is_compared()) {
      comparison_.origin = result.mesh.origin;
      comparison_.part_name = request_.part;
      comparison_.text = read_program_lines(result.mesh.origin, arguments_.input);
    }
    return report_html(result.mesh, nominal_.mesh, comparison_, facts, request_.options.threads);
  }
  RunRecord record(const JobResult& result) const {
    set_last_words({});  // from here on these are the words
    const bool rejected = !comparison_.accepted.value_or(true);
    return {&arguments_, &result, measured(), rejected ? kRejected : kDone, {}, {}, rest_json()};
  }
  std::string rest(const JobResult&) { return rest_json(); }
  std::string rest_json() const {
    return rest_ ? cli::rest_json(*rest_, request_.part, request_.nominal) : std::string();
  }
  std::string junit(const JobResult& result) { return run_junit(record(result)); }
  std::string json(const JobResult& result) { return run_json(record(result)); }

  const Arguments& arguments_;
  CompareRequest request_;
  NamedNominal nominal_;
  Comparison comparison_;
  bool is_measured_ = false;
  std::optional<Rest> rest_;  // where --rest asks for it
};

Job job_of(const Arguments& arguments) {
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
  job.inputs = arguments.named_inputs;
  job.hash_files = !arguments.compare.json.empty();
  job.keep = arguments.keep;
  job.max_triangles = arguments.max_triangles;
  job.until = arguments.until;
  if (arguments.history == "off")
    job.history = HistoryDetail::off;
  else if (!arguments.history.empty())
    job.history = HistoryDetail::full;
  job.machine = arguments.machine;
  job.strict = arguments.strict;
  job.play = !arguments.compare.report.empty();
  if (const auto& accept = arguments.compare.options.accept) job.accept = narrow_side(*accept);
  return job;
}

// The file of --history, to be written with the part.
void add_history_file(const Arguments& arguments, Job& job) {
  if (job.history != HistoryDetail::full) return;
  const bool json = arguments.history.ends_with(".json");
  job.side_files.push_back(
      {{arguments.history, "--history"}, [json](const JobResult& result, const ByteSink& sink) {
         const std::string text =
             (json ? history_json : history_csv)(result.program, result.cycle, result.history);
         sink(text.data(), text.size());
       }});
}

// Where nothing but collisions under --strict kept the run from its files, they have a code of
// their own.
int failed_code(const JobResult& result) {
  const auto& all = result.program.diagnostics;
  const bool wrong = std::any_of(all.begin(), all.end(),
                                 [](const Diagnostic& d) { return d.severity == Severity::error; });
  return !wrong && !result.collisions.lines.empty() ? kCollision : kFailed;
}

// --json and --junit of a run that wrote nothing else. They replace no input and no output either.
void tell_failure(const RunRecord& record) {
  const Arguments& arguments = *record.arguments;
  std::vector<NamedPath> kept = arguments.named_inputs;
  kept.push_back({arguments.input, "the program"});
  kept.push_back({arguments.stock, "the stock"});
  for (const std::string& path : arguments.outputs) kept.push_back({path, "-o"});
  for (const std::string& path :
       {arguments.compare.report, arguments.compare.deviation, arguments.history, arguments.rest})
    kept.push_back({path, "an output"});
  write_last_words(
      {arguments.compare.json, run_json(record), arguments.compare.junit, run_junit(record)}, kept);
}

// Runs the job: prepares its files and prints what was found. False: the run has failed.
bool prepare(const Arguments& arguments, Job& job, JobResult& result) {
  {
    ProgressBar bar(!arguments.quiet);
    job.stock_options.progress = job.carve.progress = job.collisions.progress = job.mesh.progress =
        bar.callback();
    simulate(job, result);
  }
  Findings findings(arguments);
  findings.add(result.program.diagnostics);
  if (!result.ok)
    say(fmt::format("{}: {}; nothing was cut or written\n", printable(arguments.input),
                    findings.summary()));
  return result.ok;
}

// Bytes of the process that are neither in use nor given back: pieces between what the moments
// before have left, into which a moment's large blocks do not fit.
std::size_t stranded_memory(std::size_t max_memory) {
  std::size_t mapped = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> mapped >> resident;
  const double held = double(resident) * double(::sysconf(_SC_PAGE_SIZE));
  return static_cast<std::size_t>(std::max(0.0, held - (double(max_memory) - memory_left())));
}

// What is left of a limit, if there is one, beside the whole run's program and sums, which are
// kept.
std::size_t beside(const JobResult& whole, std::size_t max_memory) {
  constexpr std::size_t kHeld = 450;  // bytes a motion, measured
  if (max_memory == 0) return 0;
  const std::size_t held = kHeld * whole.program.motions.size() + stranded_memory(max_memory);
  return std::max<std::size_t>(max_memory - std::min(held, max_memory), 1);
}

// Makes the frames, each the part at an earlier moment, whose files appear together with those of
// the whole run. `whole` lists the files of all; where a frame fails, its result replaces `whole`.
bool prepare_frames(const std::vector<Arguments>& frames, PreparedFiles& files, bool hash_files,
                    JobResult& whole) {
  std::vector<WrittenFile> written;
  for (const Arguments& frame : frames) {
    release_freed_memory();  // the whole run's, or the moment's before
    JobResult part;
    Job job = job_of(frame);
    job.prepared = &files;
    job.hash_files = hash_files;
    job.whole_mesh = false;
    job.carve.max_memory = beside(whole, job.carve.max_memory);
    if (!prepare(frame, job, part)) {
      whole = std::move(part);
      return false;
    }
    written.insert(written.end(), part.files.begin(), part.files.end());
  }
  whole.files.insert(whole.files.begin(), written.begin(), written.end());
  return true;
}

int simulate_and_tell(const Arguments& arguments, RunRecord& record, JobResult& result,
                      const FrameChoice& choose_frames, bool& is_written) {
  set_memory_limit(arguments.carve.max_memory);  // of the comparison and its report, too
  Job job = job_of(arguments);
  PreparedFiles files;  // of a run in frames
  PartComparison comparison(arguments);
  job.whole_mesh = comparison.is_wanted();
  job.side_files = comparison.files();
  add_history_file(arguments, job);
  if (job.whole_mesh) job.inspect = [&](const TriMesh& part) { comparison.measure(part); };
  if (choose_frames) job.prepared = &files;
  bool done = prepare(arguments, job, result);
  if (done && choose_frames) {
    result.mesh = {};
    done = prepare_frames(choose_frames(result), files, job.hash_files, result);
    if (done) files.publish(result);
  }
  if (!done) {
    record.exit_code = failed_code(result);
    tell_failure(record);
    return record.exit_code;
  }
  is_written = true;
  all_is_written();
  const bool talks =
      !arguments.quiet && arguments.compare.json != "-" && arguments.compare.junit != "-";
  if (talks) print(format_report(arguments, result, has_colours(stdout)));
  if (talks && result.files.empty())
    print("  nothing was written: no output given (-o part.stl)\n");
  return finish_output(comparison.finish());
}

}  // namespace

void tell_refused(const Arguments& refused, const Error& error) {
  if (refused.command == Command::simulate)
    tell_failure({&refused, nullptr, nullptr, exit_code_of(error), error.code(), error.what(), {}});
}

int run_simulate(const Arguments& arguments) {
  JobResult result;
  return run_simulate(arguments, result);
}

int run_simulate(const Arguments& arguments, JobResult& result, const FrameChoice& choose_frames) {
  RunRecord record{&arguments, &result, nullptr, kInternal, {}, {}, {}};
  bool is_written = false;
  return run_told(
      [&] { return simulate_and_tell(arguments, record, result, choose_frames, is_written); },
      [&](const Failure& failure) {
        if (!failure.at_work && is_written) return;
        RunRecord told{&arguments,   &result,      nullptr, failure.exit_code,
                       failure.code, failure.text, {}};
        if (failure.at_work) told.result = nullptr;
        tell_failure(told);
      });
}

}  // namespace mrsim::cli
