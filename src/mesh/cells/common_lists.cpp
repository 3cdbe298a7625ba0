#include "mesh/cells/common_lists.h"

namespace mrsim::detail {

bool CommonLists::add(const LatticePoint& cell) {
  const auto [entry, is_new] = lists_.try_emplace({cell.x, cell.y, cell.z});
  if (!is_new) return false;
  const std::int32_t unit = lattice_.per_voxel();
  const Box3 box{
      lattice_.position({cell.x * unit, cell.y * unit, cell.z * unit}),
      lattice_.position({(cell.x + 1) * unit, (cell.y + 1) * unit, (cell.z + 1) * unit})};
  const Candidates all = field_.all();
  field_.restrict_to(reach_of(box, lattice_.voxel()), kSurfaceBand, all, entry->second);
  return true;
}

const Candidates* CommonLists::of(const LatticePoint& cell) const {
  const auto found = lists_.find({cell.x, cell.y, cell.z});
  return found == lists_.end() || found->second.empty() ? nullptr : &found->second;
}

}  // namespace mrsim::detail
