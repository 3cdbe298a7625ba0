// Pruning: drops the candidates that decide nothing in a region (docs/removal.md). Guarantees the
// same distances to the last bit; never drops more than that allows, and may keep more.
#pragma once

#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

namespace mrsim {

/// Copies to `out` the sweeps of `in` that can decide the least distance somewhere in the region,
/// where that is at most `reach` less the region's radius; false, and nothing, where all of the
/// region is deeper than that in a sweep. Results stay the same to the last bit in the whole
/// region; with `band` > 0 only where the least distance is within +-band, and more sweeps go.
/// Packs that are large beside the region (all, if it says so) give way to their sweeps.
bool prune(const SweepTable& table, const PruneRegion& region, double reach, double band,
           const CandidateList& in, CandidateList& out);

}  // namespace mrsim
