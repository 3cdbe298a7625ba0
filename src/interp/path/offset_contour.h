// Elements of a contour offset by the tool radius: corners, and the points where they meet.
#pragma once

#include "interp/path/plane_piece.h"

namespace mrsim {

inline constexpr double kTouch = 1e-6;      ///< mm: elements nearer than this meet
inline constexpr double kLastDigit = 5e-4;  ///< mm: half a unit of the last digit of a program

/// The element on which the tool's centre runs. An arc whose radius is not above 0 then is void.
PlanePiece moved(const PathMove& move);
inline bool is_void(const PlanePiece& offset) { return offset.arc && offset.radius <= kTouch; }
/// A void arc that has the tool's radius, up to the rounding of a program's last digit: the tool
/// stands at its centre and cuts all of it.
inline bool is_point(const PlanePiece& offset) {
  return is_void(offset) && offset.radius > -kLastDigit;
}

/// Whether the move belongs to the contour. False for infeeds, tilted arcs, suspended and
/// uncompensated moves.
bool takes_part(const PathMove& move);

/// The programmed end, in the plane.
inline Vec2 corner_of(const PathMove& move) { return in_plane(move.basis, move.motion.end); }
inline double height(const PathMove& move, const Vec3& p) { return dot(p, move.basis.w); }

/// At an inside corner: the point nearest to the corner where two offset elements meet. `from` is
/// where the first begins. False: they do not meet.
bool meeting(const PlanePiece& a, const PlanePiece& b, Vec2 from, Vec2 corner, Vec2& out);

enum class Corner { smooth, inside, outside };
/// The kind of the corner between two compensated moves, seen from the side of the tool.
Corner corner_kind(const PathMove& a, const PathMove& b);

/// Whether the transition is tangent up to the rounding of the program, so that its offset elements
/// need not meet.
bool nearly_tangent(const PathMove& a, const PathMove& b);

}  // namespace mrsim
