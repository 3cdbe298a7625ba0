// The distance from a flat or bull-nose mill on an arc in an upright plane (G18, G19 and between),
// without a search over its positions (docs/sweeps.md, Flat, bull-nose and ball on helices and
// upright arcs).
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/simd/form_records.h"
#include "removal/tool/profile.h"

#include <vector>

namespace mrsim {

/// Describes an arc without rise in an upright plane: along, begin, end and its quarters; turns its
/// sweep into one turn at most. Requires: center, u, v and radius > 0 of the path.
void set_upright_plane(ToolPath& path);
/// The quarters alone, after begin, end or sweep has changed.
void set_quarters(ToolPath& path);

/// Appends the quarters of an arc for the loops of upright_lanes.inl. Requires: path.upright,
/// an end mill that reaches up.
void append_quarters(const Profile& tool, const ToolPath& path, std::vector<UprightRecord>& out);

/// Direction, from the centre in the arc's plane, of the position at which a mill of any `core` and
/// `round` that reaches up is nearest to p.
Vec2 upright_place(double core, double round, const ToolPath& path, const Vec3& p);

/// The least distance over all positions, up to 1e-12 mm. Requires: path.upright, an end mill
/// that reaches up. No sines.
double upright_value(const Profile& tool, const ToolPath& path, const Vec3& p);
/// upright_value() with its place.
PathSample upright_minimum(const Profile& tool, const ToolPath& path, const Vec3& p);

/// Branches of the arc between its ends, its extremes and its lowest and highest place, counted
/// from the start: which one holds t, and the least distance over one of them.
int upright_branch(const ToolPath& path, double t);
PathSample upright_branch_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                  int branch);
/// The place of that on the path.
PathPoint upright_branch_point(const Profile& tool, const ToolPath& path, const Vec3& p,
                               int branch);

}  // namespace mrsim
