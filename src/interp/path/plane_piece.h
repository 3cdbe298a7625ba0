// Lines and arcs of a contour in the coordinates of its plane: tangents, offsets, intersections.
#pragma once

#include "interp/path/corners.h"

#include <array>
#include <optional>

namespace mrsim {

/// A line or an arc; signed sweep, counter-clockwise (u towards v) positive.
struct PlanePiece {
  bool arc = false;
  Vec2 start, end;
  Vec2 center;
  double radius = 0;
  double sweep = 0;
};

/// The motion in the coordinates of the plane; what lies along its normal is left out.
PlanePiece to_plane(const Motion& motion, const Basis& basis);
/// Whether the motion has no travel in the plane (an infeed).
bool is_infeed(const PathMove& move);
/// Whether the move is an arc whose axis is not the plane's normal.
bool is_tilted(const PathMove& move);

/// Unit directions of travel at the start and at the end.
Vec2 start_tangent(const PlanePiece& piece);
Vec2 end_tangent(const PlanePiece& piece);
inline Vec2 left_of(Vec2 t) { return {-t.y, t.x}; }

/// The piece moved to its left by `distance`; the radius of an arc may become <= 0 (then it is
/// void).
PlanePiece offset_piece(const PlanePiece& piece, double distance);

/// Where the line through `a` along `d` meets the one through `b` along `e`; nothing if the sine
/// between them is at most `parallel`.
std::optional<Vec2> lines_meet(Vec2 a, Vec2 d, Vec2 b, Vec2 e, double parallel);

/// Up to two points common to the whole lines or circles of a and b.
int intersect(const PlanePiece& a, const PlanePiece& b, std::array<Vec2, 2>& out);

/// Signed distance along the piece from `from` to `to`, both on it: mm for lines, radians times the
/// direction of travel for arcs, in (-pi, pi].
double progress(const PlanePiece& piece, Vec2 from, Vec2 to);
/// progress() from the start of the piece, arcs in [0, 2 pi).
double position_on(const PlanePiece& piece, Vec2 p);
/// position_on() of the end of the piece.
double extent(const PlanePiece& piece);
/// The point of the piece at the value `along` of position_on().
Vec2 point_at(const PlanePiece& piece, double along);

/// Sets start, end, centre, radius and sweep of `motion` as in the piece, at these heights over the
/// plane, mm.
void from_piece(const PlanePiece& piece, const Basis& basis, double start_height, double end_height,
                Motion& motion);

/// The distance of a point from a piece, mm.
double distance_to(const PlanePiece& piece, Vec2 p);
/// The value of position_on(), from 0 to extent(), where the piece is nearest to a point.
double nearest_along(const PlanePiece& piece, Vec2 p);
/// The distance of a straight way from a piece, mm; 0 where they meet.
double distance_between(const PlanePiece& way, const PlanePiece& piece);

}  // namespace mrsim
