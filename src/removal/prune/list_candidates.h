// Makes lists of candidates from indices of sweeps and numbers of packs, and reads them again.
#pragma once

#include "removal/prune/candidate_list.h"
#include "removal/sweep/sweep_table.h"

#include <cstdint>
#include <span>

namespace mrsim {

/// The list of some sweeps and packs of a table, ascending. `origin` is a point of the region that
/// the list is for: single precision is good near it.
void list_candidates(const SweepTable& table, std::span<const std::uint32_t> ids,
                     const Vec3& origin, CandidateList& out);

/// Brings the least distances at `points` up to date with the sweeps of a list, the same bits as
/// SweepTable::distance.
void least_distances(const SweepTable& table, const CandidateList& list, PointColumns& points);

}  // namespace mrsim
