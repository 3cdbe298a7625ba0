// Turning sweeps in lists: packs of their tree, and the sweeps themselves where they are few.
#pragma once

#include "removal/columns/turn_tree.h"
#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

#include <cstdint>
#include <vector>

namespace mrsim {

/// The half plane's part of a region: it holds (rho, z) of all points of the region.
TurnRegion turn_region(const PruneRegion& region);

/// Puts those turning sweeps that prune() for this region and `reach` would leave in place of the
/// packs of a list, if they are at most `most`; false, and nothing, where they are more or where
/// packs of milling sweeps are left.
bool expand_turned(const SweepTable& table, const PruneRegion& region, double reach,
                   std::size_t most, std::vector<std::uint32_t>& ids);

}  // namespace mrsim
