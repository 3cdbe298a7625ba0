// The commands of the program: arguments in, text out, exit code back. They throw what the library
// throws; main turns that into text and an exit code.
#pragma once

#include "cli/arguments.h"

namespace mrsim::cli {

inline constexpr int kDone = 0, kFailed = 1, kUsage = 2, kInternal = 3;

int run_simulate(const Arguments& arguments);
int run_trace(const Arguments& arguments);
int run_check(const Arguments& arguments);
int run_render(const Arguments& arguments);

}  // namespace mrsim::cli
