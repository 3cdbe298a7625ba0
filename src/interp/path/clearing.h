// Closed loops by which a cutter clears an area, in the coordinates of the plane: round pockets,
// slots, spigots. Pure geometry: the cycles know what is a pocket, and which cutter clears it.
#pragma once

#include "interp/path/plane_piece.h"

#include <vector>

namespace mrsim {

using Loop = std::vector<PlanePiece>;

/// A loop about the origin, counter-clockwise, from (half_length, 0) back to it. A half_width of 0
/// is a line to and fro. Requires: 0 <= radius <= half_width <= half_length, or the same turned.
Loop rounded_rectangle(double half_length, double half_width, double radius);

/// A circle about the origin, counter-clockwise, from (radius, 0); no pieces for a radius of 0.
Loop circle_loop(double radius);

/// A slot about an arc: the loop at the distance `aside` from the arc about the origin that has the
/// radius `middle` and begins at the positive u axis, `angle` radians long. It begins at
/// (middle + aside, 0), counter-clockwise. Requires: aside < middle.
Loop arc_slot(double middle, double angle, double aside);

/// The loop the other way round.
Loop reversed(const Loop& loop);

/// The loop turned by `degrees` about the origin, then moved by `shift`.
Loop transformed(const Loop& loop, Vec2 shift, double degrees);

/// How many equal steps of at most `step` a length has; at least 1, and 1 for a step of 0.
int steps_of(double length, double step);

}  // namespace mrsim
