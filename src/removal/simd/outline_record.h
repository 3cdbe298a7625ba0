// What the loops of outline_lanes.inl know of a tool of any profile on a level path.
#pragma once

#include "removal/field/record_slots.h"

#include <cstddef>
#include <span>

namespace mrsim {

/// An edge of a tool's outline in (r, z), with what decides on which side of its ends a point lies.
struct OutlineEdge {
  /// An end at which the outline has a corner: the outward directions there of this edge and of the
  /// neighbour. At a convex corner a point is outside that is before either of them, at a reflex
  /// one a point that is before both.
  struct End {
    enum class Corner : char { smooth, convex, reflex } corner = Corner::smooth;
    double own_x = 0, own_y = 0, other_x = 0, other_y = 0;
  };
  double ax = 0, ay = 0, bx = 0, by = 0;  ///< ends; `by` is infinite on a ray towards the shank
  double dx = 0, dy = 0, length = 0;      ///< line: unit direction from a to b
  double cx = 0, cy = 0, radius = 0;      ///< arc; radius 0 = line
  bool is_convex = true;                  ///< arc: it bulges out of the solid
  double sx = 0, sy = 0, tx = 0, ty = 0;  ///< arc: its sector counter-clockwise, from the centre
  bool is_below_half_turn = true;         ///< of the sector
  End at_a, at_b;
};

struct OutlineTool {
  std::span<const OutlineEdge> edges;
  double radius = 0, bottom = 0;  ///< the largest r and the least z of the outline
};

/// A horizontal path in plan: the slots of LineSlot or ArcSlot before `low`. Loops read c and z as
/// one run of eight numbers.
struct ProfileRow {
  bool arc = false;
  double c[ArcSlot::low] = {};
  double z = 0;       ///< height of the tip
  double length = 0;  ///< of the path in plan, mm
};
static_assert(offsetof(ProfileRow, c) == sizeof(double) &&
              offsetof(ProfileRow, z) == (1 + ArcSlot::low) * sizeof(double));

}  // namespace mrsim
