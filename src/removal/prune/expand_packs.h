// Replaces packs in lists of candidates by their children.
#pragma once

#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

namespace mrsim {

/// Copies `in` to `out` with children in place of three kinds of packs: those that are large beside
/// the region; all, if the region says so; and packs of paths, unless the list is pruned
/// `by_heights`. Returns false and copies nothing if `in` has no such packs.
bool expand_packs(const SweepTable& table, const PruneRegion& region, bool by_heights,
                  const CandidateList& in, CandidateList& out);

}  // namespace mrsim
