// Turns of a helix by one mill about one axis have one wall: of those whose wall decides in all of
// a region only the first one is needed.
#pragma once

#include "removal/columns/sweep_columns.h"
#include "removal/prune/candidate_list.h"

#include <cstdint>
#include <vector>

namespace mrsim {

/// Drops whole turns from ascending indices that are, everywhere in the region, as near as one with
/// a lower index.
void drop_later_turns(const SweepColumns& columns, const PruneRegion& region,
                      std::vector<std::uint32_t>& sweeps);

}  // namespace mrsim
