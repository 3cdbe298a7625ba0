// Pruning: drops the candidates that decide nothing in a region (docs/removal.md). Guarantees the
// same distances to the last bit; never drops more than that allows, and may keep more.
#pragma once

#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

namespace mrsim {

/// Copies to `out` the sweeps of `in` that can decide the least distance somewhere in the region. A
/// distance above `reach` less the region's radius is not wanted. Returns false and copies nothing
/// if the whole region lies deeper than that in one sweep. With `out` the least distance is the
/// same to the last bit as with `in`: in the whole region, or, with `band` > 0, only where it is
/// within +-band, so that more sweeps can be dropped. Packs that are large beside the region (all,
/// if it says so) are replaced by their sweeps.
bool prune(const SweepTable& table, const PruneRegion& region, double reach, double band,
           const CandidateList& in, CandidateList& out);

}  // namespace mrsim
