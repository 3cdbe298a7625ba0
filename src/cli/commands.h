// The commands of the program: arguments in, text out, exit code back. They throw what the library
// throws; main turns that into text and an exit code.
#pragma once

#include "cli/arguments.h"
#include "core/output_place.h"

#include <string>
#include <vector>

namespace mrsim::cli {

/// Exit codes: docs/reliability.md, table 1.
inline constexpr int kDone = 0, kFailed = 1, kUsage = 2, kInternal = 3, kRejected = 4,
                     kCollision = 5;

/// What an Error that reaches main ends with; where the user stopped the run, that code.
int exit_code_of(const Error& error);

/// --json and --junit of a command that has failed: where to, or empty, and what.
struct LastWords {
  std::string json_path, json, junit_path, junit;
};
/// Writes them: no failure of its own, and none of the files in `kept` is replaced. Of one name for
/// both the JSON has it; one file by two names has neither.
void write_last_words(const LastWords& words, const std::vector<NamedPath>& kept);

int run_simulate(const Arguments& arguments);
/// `result` has what was found.
int run_simulate(const Arguments& arguments, JobResult& result);
/// Writes --json and --junit of a run whose command line, tools or job were refused with `error`.
void tell_refused(const Arguments& refused, const Error& error);
/// run_simulate() for each of arguments.frames moments.
int run_frames(const Arguments& arguments);
/// A picture of the part at each of arguments.frames moments.
int run_picture_frames(const Arguments& arguments);
int run_trace(const Arguments& arguments);
int run_check(const Arguments& arguments);
int run_render(const Arguments& arguments);

}  // namespace mrsim::cli
