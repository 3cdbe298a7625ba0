// The program mrsim: arguments to a command, faults to text and an exit code. The only place that
// catches.
#include "cli/commands/commands.h"
#include "cli/commands/compare_command.h"
#include "cli/console/shortage.h"
#include "cli/console/standard_streams.h"
#include "cli/console/stop.h"
#include "cli/console/terminal.h"
#include "cli/options/arguments.h"
#include "cli/report/findings.h"
#include "core/process/heap.h"

#include <csignal>
#include <cstdio>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

int run(const Arguments& arguments) {
  switch (arguments.command) {
    case Command::simulate:
      return arguments.frames > 0 ? run_frames(arguments) : run_simulate(arguments);
    case Command::trace:
      return run_trace(arguments);
    case Command::check:
      return run_check(arguments);
    case Command::render:
      return arguments.frames > 0 ? run_picture_frames(arguments) : run_render(arguments);
    case Command::help:
      print(arguments.help);
      return finish_output(kDone);
    case Command::version:
      print(fmt::format("mrsim {}\n", version()));
      return finish_output(kDone);
  }
  return kInternal;
}

int run_of_job(const Arguments& arguments) {
  try {
    return run(arguments);
  } catch (const PlacedError&) {
    throw;
  } catch (const Error& fault) {
    show_in_job(fault, arguments.job);
    throw;
  }
}

int fail(const std::string& text, const char* code, int exit_code) {
  say(format_error(text, code, has_colours(stderr)));
  return exit_code;
}

int run_guarded(int argc, const char* const* argv) {
  try {
    require_stack();
    if (argc > 1 && std::string_view(argv[1]) == "compare") return run_compare(argc - 1, argv + 1);
    if (argc > 1 && std::string_view(argv[1]) == "tools") return run_tools(argc - 1, argv + 1);
    if (argc > 1 && std::string_view(argv[1]) == "rest") return run_rest(argc - 1, argv + 1);
    if (argc > 1 && std::string_view(argv[1]) == "view") return run_view(argc - 1, argv + 1);
    return run_of_job(typed_arguments(argc, argv));
  } catch (const PlacedError& error) {
    say(format_diagnostic(error.diagnostic(), has_colours(stderr)));
    return exit_code_of(error);
  } catch (const Error& error) {
    const int code = fail(error.what(), error.code().c_str(), exit_code_of(error));
    if (error.code() == "usage") say("Try: mrsim --help\n");
    return code;
  } catch (const std::exception& error) {
    if (const Shortage* shortage = find_shortage(error))
      return fail(shortage->text, shortage->code, kFailed);
    if (dynamic_cast<const std::system_error*>(&error))
      return fail(error.what(), "system", kFailed);
    return fail(error.what(), "internal", kInternal);
  }
}

}  // namespace
}  // namespace mrsim::cli

int main(int argc, char** argv) {
  mrsim::cli::keep_standard_streams();
  mrsim::cli::catch_shortages();
  mrsim::grow_heap_in_large_steps();
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the limit of its size is an error like a full disk
  mrsim::cli::watch_signals();    // before there are other threads
  return mrsim::cli::run_guarded(argc, argv);
}
