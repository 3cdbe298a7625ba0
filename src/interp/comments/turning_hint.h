// What comments say of a lathe's tool, as a tool. Private to src/interp.
#pragma once

#include "interp/comments/tool_comment.h"

#include <string>

namespace mrsim {

/// Sets the insert or the blade in a program whose unit is `unit` mm.
void fill_turning(const ToolHint& hint, double unit, Tool& out);

/// Why the tool that fill_turning() made is in doubt, as it completes "the comment ... "; empty: it
/// is not.
std::string doubt_of_turning(const ToolHint& hint, double unit, const Tool& out);

/// What a hint leaves open, filled in by the documented defaults: a turning tool without data is a
/// sharp 35 degree finishing insert, lead angle 93 degrees, edge 16 mm.
void complete_turning_tool(Tool& tool);

}  // namespace mrsim
