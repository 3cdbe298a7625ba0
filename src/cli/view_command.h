// `mrsim view`: the page of a run or of a part, in a temporary file, opened.
#pragma once

namespace mrsim::cli {

/// argv[0] is "view".
int run_view(int argc, const char* const* argv);

}  // namespace mrsim::cli
