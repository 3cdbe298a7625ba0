// The bottom of a cutter that moves along a helix about Z: the least of the heights that it reaches
// at a place, found on the path itself. Private to src/removal.
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/tool/underside.h"

#include <array>
#include <cstddef>

namespace mrsim {

/// A helix about Z, seen from a place in plan. At t radians downhill from where it is nearest, its
/// distance in plan is the root of near^2 + span sin(t / 2)^2.
struct HelixView {
  /// What lies within reach of the place on one turn: from <= t <= to, at most half a turn away;
  /// `height`: of the tip at t = 0, mm.
  struct Stretch {
    double height = 0, from = 0, to = 0;
  };
  double near = 0, span = 0;
  double fall = 0;  ///< mm per radian, not negative
  /// The last whole turn above the place is lower than all before it, so that there are three.
  std::array<Stretch, 3> stretches{};
  std::size_t count = 0;
};
/// Requires: path.arc, path.horizontal.
HelixView view_helix(const ToolPath& path, double x, double y, double reach);

/// The least height of the tool at (x, y), mm, up to 1e-9; infinite where it does not come there.
/// Requires: path.arc, path.horizontal, a tool whose heights are convex.
double arc_bottom(const Underside& tool, const ToolPath& path, double x, double y);

}  // namespace mrsim
