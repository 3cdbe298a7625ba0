// The bottom of a cutter that moves along a helix about Z: the least of the heights that it reaches
// at a place, found on the path itself. Private to src/removal.
#pragma once

#include "removal/forms/path_sweep.h"
#include "removal/tool/underside.h"

namespace mrsim {

/// The least height of the tool at (x, y), mm, up to 1e-9; infinite where it does not come there.
/// Requires: path.arc, path.horizontal, a tool whose heights are convex.
double arc_bottom(const Underside& tool, const ToolPath& path, double x, double y);

}  // namespace mrsim
