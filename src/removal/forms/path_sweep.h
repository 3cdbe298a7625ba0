// The least distance from the tool over its positions on a path, by the form that suits tool and
// path: in closed form, stretch by stretch, or by a search with a proven bracket (path_search.h).
#pragma once

#include "core/numbers/rounding.h"
#include "removal/forms/tool_path.h"
#include "removal/tool/profile.h"

#include <utility>

namespace mrsim {

/// Error bound: kPathError mm for arcs and helices and for lines of tools that are not convex,
/// 1e-12 of the size for lines of convex tools and where has_stretches(). Always from above:
/// distance(true) <= result. Above `limit` mm the distance may be any above it.
PathSample path_distance(const Profile& tool, const ToolPath& path, const Vec3& p,
                         double limit = kInfinity);

/// Whether the distance is found stretch by stretch (falling_lanes.inl), without a search.
inline bool has_stretches(const Profile& tool, const ToolPath& path) {
  return path.disc || path.upright || (path.lowest_turn && tool.is_end_mill());
}

/// The distance alone, the same bits: beside the wall of a bore at the cost of a line.
double path_value(const Profile& tool, const ToolPath& path, const Vec3& p,
                  double limit = kInfinity);

/// Branches of an arc, counted from its start: quarter turns, or the quarters of an upright circle.
/// The branch that holds t, its ends, and the least distance over one branch.
int path_branch(const ToolPath& path, double t);
std::pair<double, double> branch_ends(const ToolPath& path, int branch);  ///< not of upright arcs
PathSample branch_distance(const Profile& tool, const ToolPath& path, const Vec3& p, int branch);

/// Least distance of one of a tool's convex_pieces() alone, over a branch of an arc or over a line.
PathSample piece_distance(const Profile& piece, const ToolPath& path, const Vec3& p, int branch);

}  // namespace mrsim
