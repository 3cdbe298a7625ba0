// Regions of space as turning sweeps see them.
#pragma once

#include "removal/near_list.h"
#include "removal/turn_tree.h"

namespace mrsim {

/// The half plane's part of a region: it holds (rho, z) of all points of the region.
TurnRegion turn_region(const PruneRegion& region);

}  // namespace mrsim
