// From what comments say to a tool, or to the reason why there is none. Private to src/interp.
#pragma once

#include "interp/comments/tool_comment.h"

#include <string>

namespace mrsim {

/// Adds what a second comment about the same tool says; a contradiction becomes a doubt.
void merge_hint(ToolHint& into, const ToolHint& more);

/// The tool that the hint describes in a program whose unit is `unit` mm. False when it says too
/// little or too much: `why` then completes "the comment ... ".
bool fill_tool(const ToolHint& hint, double unit, bool lathe, Tool& out, std::string& why);

/// What a hint leaves open, filled in by the documented defaults: a turning tool without data is a
/// sharp 35 degree finishing insert, lead angle 93 degrees, edge 16 mm.
void complete_turning_tool(Tool& tool);

}  // namespace mrsim
