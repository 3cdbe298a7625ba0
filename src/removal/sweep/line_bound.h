// A lower bound of the distance of a convex tool on a straight path, by planes: cheaper than the
// search by far, and mostly enough to tell that another sweep is nearer.
#pragma once

#include "removal/sweep/path_sweep.h"

namespace mrsim {

/// The distance of p from the sweep is no less than this, mm, but for rounding (1e-9 mm within 10 m
/// of the origin). Requires: !path.arc, tool.is_convex().
double line_bound(const Profile& tool, const ToolPath& path, const Vec3& p);

}  // namespace mrsim
