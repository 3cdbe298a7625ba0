// Radius compensation as LinuxCNC does it: an element sees the next one alone, so that nothing is
// left out, and an element that two inside corners use up is an error. Private to src/interp.
#pragma once

#include "interp/path/outside_corner.h"

namespace mrsim {

/// Longer than any program's paths, mm.
inline constexpr double kFarBack = 1e9;

/// A line, run from `from`, that its inside corners would turn round. LinuxCNC looks for that only
/// before an inside corner, before a line behind an outside one, and where compensation ends.
bool turns_round(const PlanePiece& piece, Vec2 from, Vec2 end);

/// Where `piece`, the moved element `first`, ends and what leads from there to `after`. A rapid
/// goes straight. `too_tight` is set where the tool does not fit into the corner.
CornerWay stepwise_way(const PathMove& first, const PlanePiece& piece, const PathMove& after,
                       Vec2 from, bool& too_tight);

/// Makes a moved arc begin at `start` and end where it does, in its direction: a line where that
/// leads there. False where the tool is there already.
bool lead_to_end(PlanePiece& piece, Vec2 start);

}  // namespace mrsim
