// Tools in words, for people. Private to src/interp.
#pragma once

#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// "end mill 5 mm"
std::string tool_summary(const Tool& tool);
/// Words for --tool with what is known of the tool already.
std::string tool_example(const Tool& known, bool lathe);

}  // namespace mrsim
