// The bottom of any cutter that nowhere narrows, convex or not, on a straight move or a helix about
// Z: the least of the heights that it reaches at a place, by branch and bound on the path.
// Private to src/removal.
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/tool/underside.h"

namespace mrsim {

/// Height above the lower end of the tip's path (Slant) or at all (helix) at a place, mm, up to
/// 1e-9; may be infinite if the true one is at least `below`.
/// Requires: helix.arc, helix.horizontal.
double rising_bottom(const Underside& tool, const Underside::Slant& at, double below);
double rising_bottom(const Underside& tool, const ToolPath& helix, double x, double y,
                     double below);

/// Bounds of that over all places within r of this one: the bottoms of the tool widened and
/// narrowed by r. `upper` is infinite where `lower` is not below `below`.
Underside::Bounds rising_bounds(const Underside& tool, const Underside::Slant& at, double r,
                                double below);
Underside::Bounds rising_bounds(const Underside& tool, const ToolPath& helix, double x, double y,
                                double r, double below);

}  // namespace mrsim
