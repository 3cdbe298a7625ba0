// Tools in words, for people. Private to src/interp.
#pragma once

#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// The tool in a few words: "end mill 5 mm".
std::string tool_summary(const Tool& tool);
/// An example for --tool that contains what is known of the tool.
std::string tool_example(const Tool& known, bool lathe);

}  // namespace mrsim
