// The distance from a flat, ball or bull-nose mill on the lowest turn of a falling helix, without a
// search over its positions (docs/sweeps.md, Helices).
#pragma once

#include "removal/sweep_path.h"

#include <optional>

namespace mrsim {

/// The least distance over positions t in [begin, end] of a path with lowest_turn, the same as the
/// minimum of the tool's distance up to 1e-12 mm. None where there is no such form: another tool,
/// or a p so near the helix's axis that the corner's distance may have two minima. About six sines.
std::optional<PathSample> helix_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                        double begin, double end);

}  // namespace mrsim
