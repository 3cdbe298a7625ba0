// One tool by words: "4=endmill:d=5", or "endmill:d=10" for the tool of a program that names none.
#pragma once

#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// The tool that `spec` describes: [id=]type:key=value,key=value. Keys are those of tools.toml or
/// their short forms (d diameter, r corner or nose radius, l flute or edge length, a angle); mm and
/// degrees. Throws Error "tool-spec" of kind usage that says what is wrong.
Tool parse_tool_spec(const std::string& spec);

}  // namespace mrsim
