// Turning sweeps in lists of candidates: packs of their tree, or the sweeps themselves if they are
// few.
#pragma once

#include "removal/columns/turn_tree.h"
#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

#include <cstdint>
#include <vector>

namespace mrsim {

/// A rectangle of the half plane that holds (rho, z) of all points of the region.
TurnRegion turn_region(const PruneRegion& region);

/// Replaces the packs of a list by those of their turning sweeps that prune() would leave for this
/// region and `reach`. Returns false and changes nothing if these are more than `most`, or if the
/// list has packs of milling sweeps.
bool expand_turned(const SweepTable& table, const PruneRegion& region, double reach,
                   std::size_t most, std::vector<std::uint32_t>& ids);

}  // namespace mrsim
