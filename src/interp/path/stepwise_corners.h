// Radius compensation as LinuxCNC does it: an element depends only on the next one. So no element
// is left out, and one that two inside corners use up is an error. Private to src/interp.
#pragma once

#include "interp/path/outside_corner.h"

namespace mrsim {

/// Longer than any program's paths, mm.
inline constexpr double kFarBack = 1e9;

/// Whether inside corners reverse a line that is run from `from` to `end`. LinuxCNC checks that
/// only before an inside corner, before a line behind an outside one, and where compensation ends.
bool turns_round(const PlanePiece& piece, Vec2 from, Vec2 end);

/// Where `piece`, the offset element of `first`, ends, and what leads from there to `after`. A
/// rapid goes straight. `too_tight` is set where the tool does not fit into the corner.
CornerWay stepwise_way(const PathMove& first, const PlanePiece& piece, const PathMove& after,
                       Vec2 from, bool& too_tight);

/// Makes an offset arc begin at `start` and keep its end and its direction; it becomes a line where
/// a line leads there. False: the tool is at its end already.
bool lead_to_end(PlanePiece& piece, Vec2 start);

}  // namespace mrsim
