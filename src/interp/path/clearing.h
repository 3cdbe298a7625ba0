// Closed loops by which a cutter clears an area, in the coordinates of the plane: round pockets,
// slots, spigots. Pure geometry: what is a pocket, and which cutter clears it, the cycles know.
#pragma once

#include "interp/path/plane_piece.h"

#include <vector>

namespace mrsim {

using Loop = std::vector<PlanePiece>;

/// About the origin, counter-clockwise, from (half_length, 0) back to it. A half_width of 0 is the
/// line there and back. Requires: 0 <= radius <= half_width <= half_length, or the same turned.
Loop rounded_rectangle(double half_length, double half_width, double radius);

/// About the origin, counter-clockwise, from (radius, 0); no pieces for a radius of 0.
Loop circle_loop(double radius);

/// About the arc of radius `middle` and `angle` radians from the positive u axis about the origin,
/// `aside` from it: from (middle + aside, 0), counter-clockwise. Requires: aside < middle.
Loop arc_slot(double middle, double angle, double aside);

/// The loop the other way round.
Loop reversed(const Loop& loop);

/// Turned by `degrees` about the origin, then moved by `shift`.
Loop transformed(const Loop& loop, Vec2 shift, double degrees);

/// Into how many equal steps of at most `step` a length goes; at least 1. A step of 0: 1.
int steps_of(double length, double step);

}  // namespace mrsim
