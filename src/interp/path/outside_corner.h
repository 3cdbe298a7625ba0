// The way round an outside corner of a contour under radius compensation.
#pragma once

#include "core/numbers/units.h"
#include "interp/path/plane_piece.h"

namespace mrsim {

/// Beyond this turn, radians, DISC has no effect: the intersection would lie more than two radii
/// away.
inline constexpr double kSharpestDisc = 2 * kPi / 3;

/// The way from one offset element to the next: where the first ends, the pieces between, where the
/// second begins. Both may be extended beyond their own ends, lines straight on and arcs on their
/// circle.
struct CornerWay {
  Vec2 end, entry;
  std::array<PlanePiece, 6> between;
  std::size_t count = 0;

  void add(const PlanePiece& piece) { between[count++] = piece; }
  /// Adds a straight piece, unless it has no length.
  void add_line(Vec2 from, Vec2 to);
};

/// The way that `comp` asks for: by the meeting point of the whole lines and circles (G451); that
/// of the tangents, or two points a radius beyond the ends (FANUC); else an arc about `corner`,
/// sharpened by DISC: of radius (1 - DISC) r between the tangents, so that its vertex lies that
/// share of the way from the circle to the tangents' meeting point, and never nearer to the corner
/// than r.
CornerWay outside_corner(const Compensation& comp, Vec2 corner, const PlanePiece& piece,
                         const PlanePiece& next);

/// The line between `outer` and the circle of the tool's radius about `corner` that touches it on
/// the tool's side: towards the corner, or away from it when `leaving`. False: `outer` lies within.
bool touching_line(const Compensation& comp, Vec2 corner, Vec2 outer, bool leaving,
                   PlanePiece& line);

}  // namespace mrsim
