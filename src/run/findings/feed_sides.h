// Which way the tools of a lathe feed: towards the main spindle, -Z, or towards a counter spindle.
#pragma once

#include <mrsim/mrsim.h>
#include <mrsim/types.h>

namespace mrsim {

/// Drills whose feeds from a rapid all lead towards +Z point there, for as long as they are in use.
void turn_drills_round(Program& program);

/// Warns of right-hand inserts that enter towards +Z and cut nothing towards -Z, as left-hand ones
/// do.
void warn_of_hands(JobResult& result);

/// Warns of blades that stand along X and plunge along Z, straight in and out, as those of face
/// grooves do.
void warn_of_blades(JobResult& result);

}  // namespace mrsim
