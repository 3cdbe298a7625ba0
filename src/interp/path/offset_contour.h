// Elements of a contour moved aside by the tool radius: corners and meeting points.
#pragma once

#include "interp/path/plane_piece.h"

namespace mrsim {

inline constexpr double kTouch = 1e-6;  ///< mm

/// The element as the tool's centre runs it; an arc whose radius is used up is void.
PlanePiece moved(const PathMove& move);
inline bool is_void(const PlanePiece& offset) { return offset.arc && offset.radius <= kTouch; }
/// A void arc whose radius is the tool's, but for a program's last digit: the tool stands at its
/// centre and cuts all of it.
inline bool is_point(const PlanePiece& offset) { return is_void(offset) && offset.radius > -5e-4; }

/// False for infeeds, tilted arcs, suspended and uncompensated moves.
bool takes_part(const PathMove& move);

/// The programmed end, in the plane.
inline Vec2 corner_of(const PathMove& move) { return in_plane(move.basis, move.motion.end); }
inline double height(const PathMove& move, const Vec3& p) { return dot(p, move.basis.w); }

/// Inside: where two moved elements meet, nearest to the corner. `from` is where the first begins.
bool meeting(const PlanePiece& a, const PlanePiece& b, Vec2 from, Vec2 corner, Vec2& out);

enum class Corner { smooth, inside, outside };
Corner corner_kind(const PathMove& a, const PathMove& b);

/// A tangent transition but for the last digits of the program: its moved elements need not meet.
bool nearly_tangent(const PathMove& a, const PathMove& b);

}  // namespace mrsim
