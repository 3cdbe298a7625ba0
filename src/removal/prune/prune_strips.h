// The last step of pruning long lists of one ball's lines, where nothing but their indices is
// wanted. Faster than prune(), for such lists only.
#pragma once

#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mrsim {

/// The list holds nothing but lines of one ball, and no packs.
bool is_of_strips(const SweepTable& table, const CandidateList& list);

/// Slots of strips near the four parts of a region, `beside` mm from its centre both ways in plan
/// (CandidateKernels::strip_quarters); the nearest ones where that is 0.
std::array<std::size_t, kStripQuarters> nearest_strips(const PruneRegion& region, double beside,
                                                       const CandidateList& in);

/// Does what prune() does, for a list with is_of_strips() and a region that is not divided further:
/// writes the indices of the sweeps that are left, in the order of the list. `near`: slot of a
/// strip near the region; the nearer it is, the more sweeps are dropped.
bool prune_strips(const SweepTable& table, const PruneRegion& region, double reach,
                  const CandidateList& in, std::size_t near, std::vector<std::uint32_t>& out);

}  // namespace mrsim
