// The distance from a flat, ball or bull-nose mill on the lowest turn of a falling helix, without a
// search over its positions (docs/sweeps.md, Flat, bull-nose and ball on helices and upright arcs).
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/simd/form_records.h"
#include "removal/tool/profile.h"

namespace mrsim {

/// The whole path for the loops of helix_lanes.inl. Requires: lowest_turn, an end mill.
HelixRecord helix_record(const Profile& tool, const ToolPath& path);

/// What lane::bore (sweep_lanes.inl) knows of a turn. Requires: lowest_turn, an end mill.
LineRecord bore_record(const Profile& tool, const ToolPath& path);

/// The least distance over all positions, up to 1e-12 mm. Requires: lowest_turn, an end mill.
/// Cost: zero to five sines.
PathSample helix_minimum(const Profile& tool, const ToolPath& path, const Vec3& p);
/// helix_minimum() over one quarter turn, counted from the start.
PathSample helix_branch_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                int branch);

}  // namespace mrsim
