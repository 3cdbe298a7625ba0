// Makes lists of candidates from indices of sweeps and numbers of packs, and reads them again.
#pragma once

#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

#include <cstdint>
#include <span>

namespace mrsim {

/// The list of some sweeps and packs of a table, ascending. `origin` is a point of the block that
/// the list is for: single precision is good near it.
void list_candidates(const SweepTable& table, std::span<const std::uint32_t> ids,
                     const Vec3& origin, CandidateList& out);

/// Copies `in` to `out` with children in place of the packs that are large beside the region (of
/// all packs, if the region says so; of all packs of paths, unless the list is pruned
/// `by_heights`). False, and nothing, where there are none.
bool expand_packs(const SweepTable& table, const PruneRegion& region, bool by_heights,
                  const CandidateList& in, CandidateList& out);

/// Brings the least distances at `points` up to date with the sweeps of a list, the same bits as
/// SweepTable::distance.
void least_distances(const SweepTable& table, const CandidateList& list, PointColumns& points);

}  // namespace mrsim
