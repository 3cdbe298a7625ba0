// Sizes without a name in a comment about a tool: which are its diameter, lengths and angles, by
// the kind of tool.
#pragma once

#include "interp/comments/tool_facts.h"

#include <vector>

namespace mrsim {

/// Fills diameters, width, corner and lengths of the hint. Gives the angles, degrees.
std::vector<double> settle_sizes(const ToolFacts& facts, ToolHint& hint);

/// Angles that points of this trade have, as whole numbers without a name.
bool is_usual_angle(ToolTrade trade, double degrees);

}  // namespace mrsim
