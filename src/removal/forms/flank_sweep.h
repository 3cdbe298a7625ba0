// The distance from a tool with a conical flank (V tool, drill, taper) on an arc in an upright
// plane (G18, G19 and between), without a search over all of its positions (docs/sweeps.md, Cones
// on upright arcs).
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/tool/profile.h"

#include <optional>

namespace mrsim {

/// Whether the tool is convex, reaches up and has a conical flank next to its tip.
bool has_flank(const Profile& tool);

/// The least distance over the positions from angle `begin` to `end` of the path, up to 1e-12 mm;
/// none where the edge above the flank may be nearest. Requires: path.flanked.
std::optional<PathSample> flank_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                        double begin, double end);
/// The least distance over all positions, without its place.
std::optional<double> flank_value(const Profile& tool, const ToolPath& path, const Vec3& p);

}  // namespace mrsim
