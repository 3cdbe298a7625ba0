// Decides, by the kind of tool, which of the sizes without a name are its diameter, lengths and
// angles.
#pragma once

#include "interp/comments/tool_facts.h"

#include <vector>

namespace mrsim {

/// Fills diameters, width, corner and lengths of the hint. Returns the angles, degrees.
std::vector<double> settle_sizes(const ToolFacts& facts, ToolHint& hint);

/// Whether tools of this trade usually have that angle, so that a number without a name may be it.
bool is_usual_angle(ToolTrade trade, double degrees);

}  // namespace mrsim
