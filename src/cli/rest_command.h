// `mrsim rest`: what is left to cut of a part.
#pragma once

namespace mrsim::cli {

/// The command: argv[0] is "rest".
int run_rest(int argc, const char* const* argv);

}  // namespace mrsim::cli
