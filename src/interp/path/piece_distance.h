// Distances of points and of straight ways from lines and arcs in the plane.
#pragma once

#include "interp/path/plane_piece.h"

namespace mrsim {

/// Of a point from a piece, mm.
double distance_to(const PlanePiece& piece, Vec2 p);
/// Where along the piece, from 0 to extent(), it is nearest to a point.
double place_nearest(const PlanePiece& piece, Vec2 p);
/// Of a straight way from a piece, mm; 0 where they meet.
double distance_between(const PlanePiece& way, const PlanePiece& piece);

}  // namespace mrsim
