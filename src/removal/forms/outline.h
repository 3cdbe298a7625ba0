// Outlines of tools as the loops of outline_lanes.inl read them.
#pragma once

#include "removal/simd/form_records.h"
#include "removal/tool/profile.h"

#include <vector>

namespace mrsim {

/// Appends a tool's edges: outline_distance() of them is tool.distance().
void append_outline(const Profile& tool, std::vector<OutlineEdge>& out);

}  // namespace mrsim
