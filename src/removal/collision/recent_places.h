// Rapids between places where the same cutter has just been: the way back to the next pass of an
// adaptive clearing touches the walls of all passes before it, without a collision
// (docs/collisions.md, Method).
#pragma once

#include "removal/tool/profile.h"
#include <mrsim/types.h>

#include <cstddef>
#include <span>

namespace mrsim {

/// Whether the cutter of motion `at`, a rapid, leaves no more than `touch` mm of material anywhere
/// beyond what it cleared on the cuts shortly before, which reach above `stock_top`. False also
/// where that is not known: of cutters other than upright flat, bull-nose and ball mills, for one.
/// Cost: some 10 microseconds where it is true, mostly less where it is not.
bool keeps_to_recent_places(std::span<const Motion> motions, std::size_t at, const Profile& cutter,
                            double stock_top, double touch);

}  // namespace mrsim
