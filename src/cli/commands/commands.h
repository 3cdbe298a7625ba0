// The commands of the program: arguments in, text out, exit code back. They throw what the library
// throws; main turns that into text and an exit code.
#pragma once

#include "cli/console/exit_codes.h"
#include "cli/options/arguments.h"
#include "core/output/output_place.h"

#include <functional>
#include <string>
#include <vector>

namespace mrsim::cli {

/// The exit code for an Error that reaches main; where the user stopped the run, that of the stop.
int exit_code_of(const Error& error);

/// --json and --junit of a command that has failed: the paths, empty if not asked for, and the
/// texts.
struct LastWords {
  std::string json_path, json, junit_path, junit;
};
/// Writes both files. A file that cannot be written is named on the standard error; nothing is
/// thrown. Never replaces a file in `kept`. A refused command may have inputs that are not known,
/// so an existing file is replaced only if it begins like an earlier result. If both paths are the
/// same text, the JSON is written; if they are two names of one file, neither.
void write_last_words(const LastWords& words, const std::vector<NamedPath>& kept);

/// Throws Error "output-is-input" (usage) where an output is one of a program's files.
void protect_program(const std::vector<std::string>& files, const std::vector<NamedPath>& outputs);

/// What ended a command.
struct Failure {
  std::string code, text;
  int exit_code = 0;
  bool at_work = false;  ///< the user has stopped it, but it still goes on, on another thread
};
/// The exit code of `work`. Where it ends with an exception, or the user stops it, `tell` is
/// called first. Once `work` writes the file that says how it ended, set_last_words({}) keeps a
/// second one from following it.
int run_told(const std::function<int()>& work, const std::function<void(const Failure&)>& tell);

/// parse_arguments(); a refusal is written to --json and --junit of a run, and to the standard
/// output of trace and check with --json.
Arguments typed_arguments(int argc, const char* const* argv);

int run_simulate(const Arguments& arguments);
/// Chooses the runs to earlier moments, once the whole program has been run.
using FrameChoice = std::function<std::vector<Arguments>(const JobResult& whole)>;
/// Fills `result`. The files of the chosen frames appear together with those of the whole run.
int run_simulate(const Arguments& arguments, JobResult& result,
                 const FrameChoice& choose_frames = {});
/// Writes --json and --junit of a run whose command line, tools or job were refused with `error`.
void tell_refused(const Arguments& refused, const Error& error);
/// Writes the parts at arguments.frames moments: all of them or none.
int run_frames(const Arguments& arguments);
/// Draws the part at each of arguments.frames moments, as pictures or as a film of them.
int run_picture_frames(const Arguments& arguments);
/// Throws Error "output-format" for a name that promises another picture than a PNG.
void require_png(const std::string& path);
int run_trace(const Arguments& arguments);
int run_check(const Arguments& arguments);
int run_render(const Arguments& arguments);

/// Commands with options of their own; argv[0] is the command. They throw Errors of kind usage.
/// `mrsim rest`: what is left to cut of a part.
int run_rest(int argc, const char* const* argv);
/// `mrsim tools FILE`: what a tool table or library holds, listed and drawn.
int run_tools(int argc, const char* const* argv);
/// `mrsim view`: the page of a run or of a part, in a temporary file, opened.
int run_view(int argc, const char* const* argv);

}  // namespace mrsim::cli
