// `mrsim tools FILE`: what a tool table or library holds.
#pragma once

namespace mrsim::cli {

/// Lists and draws tools; argv[0] is "tools". Throws Error of kind usage.
int run_tools(int argc, const char* const* argv);

}  // namespace mrsim::cli
