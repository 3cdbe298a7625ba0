// Puts the children of packs in their place in lists of candidates.
#pragma once

#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

namespace mrsim {

/// Copies `in` to `out` with children in place of the packs that are large beside the region (of
/// all packs, if the region says so; of all packs of paths, unless the list is pruned
/// `by_heights`). False, and nothing, where there are none.
bool expand_packs(const SweepTable& table, const PruneRegion& region, bool by_heights,
                  const CandidateList& in, CandidateList& out);

}  // namespace mrsim
