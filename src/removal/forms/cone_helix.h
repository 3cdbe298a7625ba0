// The distance from a convex tool with conical flanks (V tool, drill, taper) on a helix about Z
// or an arc in a horizontal plane, where one of its flanks is what is nearest: closed, without a
// search (docs/sweeps.md, Cones on helices).
#pragma once

#include "removal/forms/path_sweep.h"

#include <optional>

namespace mrsim {

/// The least distance over the positions from `begin` to `end` of the path, up to 1e-12 of the
/// size; none where a corner, a ball or a torus may be nearest. Requires: path.horizontal,
/// tool.is_convex(), at most one turn from `begin` to `end`.
std::optional<PathSample> cone_helix_minimum(const Profile& tool, const ToolPath& path,
                                             const Vec3& p, double begin, double end);

}  // namespace mrsim
