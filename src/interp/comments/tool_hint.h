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

/// Whether two comments can not be about one tool in a program whose unit is `unit` mm.
bool contradict(const ToolHint& first, const ToolHint& second, double unit, bool lathe);

/// The length as a comment gives it, with its unit.
std::string as_written(const ToolLength& length);

}  // namespace mrsim
