// Makes the description of a tool of what a comment says; the kind of tool decides what sizes
// without a name are. Private to src/interp.
#pragma once

#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Fills the hint; where the facts allow several tools it gets a doubt.
void settle_tool(const ToolFacts& facts, ToolHint& hint);

}  // namespace mrsim
