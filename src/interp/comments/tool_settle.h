// From facts to a tool: the kind says how sizes without a name are to be read. Private to
// src/interp.
#pragma once

#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Makes a tool's data of the facts, or a doubt.
void settle_tool(const ToolFacts& facts, ToolHint& hint);

}  // namespace mrsim
