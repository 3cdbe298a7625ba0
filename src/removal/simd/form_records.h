// What the loops of the *_lanes.inl know of one sweep, form by form. Records of the commonest forms
// are plain columns of numbers (removal/field/record_slots.h); the others have named members.
#pragma once

#include "removal/field/record_slots.h"
#include "removal/tool/tool.h"

#include <cstddef>
#include <span>

namespace mrsim {

/// Coefficients of one sweep by BallSlot, LineSlot, BoreSlot or ArcSlot; whole cache lines.
struct alignas(64) LineRecord {
  double c[8] = {};
};
struct alignas(64) ArcRecord {
  double c[16] = {};
};

/// A straight move of an end mill that reaches up, from its lower end.
struct alignas(32) SlantRecord {
  double x = 0, y = 0, z = 0;  ///< of the lower end; z of the tool's flat core
  double ux = 1, uy = 0;       ///< direction in plan, unit
  double length = 0;           ///< mm
  double plan = 1, rise = 0;   ///< in plan and upwards for each mm of the length, not negative
  double core = 0, round = 0;  ///< of the tool
  bool falls = false;          ///< the move ends at the lower end
};

/// Its numbers, in their order.
struct SlantColumn {
  enum : std::size_t { x, y, z, ux, uy, length, plan, rise, core, round, kCount };
};

/// The part of an arc within a quarter of its circle, of an end mill that reaches up.
/// In the arc's plane x lies on the ground, from the centre towards the quarter, and z up.
struct alignas(64) UprightRecord {
  double x = 0, y = 0, z = 0;       ///< of the centre
  double along_x = 1, along_y = 0;  ///< direction of the plane's x
  double radius = 0;                ///< of the arc
  double high_x = 0, high_y = 0;    ///< directions of the ends from the centre, in the plane
  double low_x = 0, low_y = 0;
  double core = 0, round = 0;  ///< of the tool
  double half = 1;             ///< 1: above the centre, -1: below
};

/// The lowest turn of a falling helix about Z, or a part of it, of an end mill that reaches up.
struct HelixRecord {
  /// A position by its parameter and the direction from the helix's axis, in (u, v).
  struct End {
    double t = 0, sin = 0, cos = 1;
  };
  double x = 0, y = 0, z = 0;  ///< of the axis; of the first position's flat core
  double ux = 0, uy = 0, vx = 0, vy = 0;
  double radius = 0, fall = 0;  ///< mm; mm per radian
  double core = 0, round = 0;   ///< of the tool
  End begin, end;
};

inline constexpr std::size_t kMostFlanks = 4;  ///< others have neither planes nor guesses

/// A convex tool whose profile is a chain of lines and of arcs below half a turn.
struct ChainTool {
  /// A straight edge of the profile that draws a cone or a cylinder.
  struct Flank {
    std::size_t edge;
    double across, up;  ///< outward normal, from the axis and along it
    double offset;      ///< the tool lies in across r + up z <= offset
  };
  const ProfileEdge* edges = nullptr;  ///< the profile's
  std::size_t count = 0;               ///< 0: the tool is none
  bool tipped = false;  ///< its lower end is a disc about the axis, or a point, thickened by a ball
  double core = 0, tip = 0, ball = 0;  ///< the disc's radius and height, the ball's radius
  Vec2 last;                           ///< last normal of the lower end
  double radius = 0, bottom = 0, top = 0;
  std::size_t flank_count = 0;
  Flank flanks[kMostFlanks] = {};
};

/// A straight move. u and v are along and across it in plan, from its start, v >= 0; w is the
/// height above the start.
struct alignas(64) ChainLine {
  double x = 0, y = 0, z = 0;  ///< of the tip at the start
  double ux = 1, uy = 0;       ///< direction in plan, unit
  double plan = -1, rise = 0;  ///< of the whole move, in plan and upwards, mm; plan < 0: no move
  double per_plan = 0, per_way = 0;  ///< 1 / plan and 1 / length^2
  /// The move is tangent to a flank where the normal has `tilt` times as much along u as along v;
  /// infinity where it is steeper than the flank and tangent nowhere.
  double tilt[kMostFlanks] = {};
};

/// Its numbers, in their order; `tilt` is the first of kMostFlanks.
struct ChainColumn {
  enum : std::size_t { x, y, z, ux, uy, plan, rise, per_plan, per_way, tilt };
  static constexpr std::size_t kCount = tilt + kMostFlanks;
};

/// Moves side by side, number by number: ChainColumn.
struct ChainColumns {
  const double* base = nullptr;
  std::size_t stride = 0;
  const double* operator[](std::size_t i) const { return base + i * stride; }
};

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
