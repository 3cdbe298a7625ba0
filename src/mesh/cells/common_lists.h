// Lists of candidates that depend on a cell's place alone (docs/mesh.md, Tiles).
//
// What a list leaves out decides nothing at the surface, but it may decide d farther off, where
// searches for vertices pass. Tiles reach the cells that they share by different ways down, so
// their lists differ; once in millions of cells a vertex does, too. For those cells the list is
// made from all sweeps at once.
#pragma once

#include "mesh/cells/cells.h"

#include <map>
#include <tuple>

namespace mrsim::detail {

class CommonLists {
 public:
  CommonLists(const ExactField& field, const Lattice& lattice) : field_(field), lattice_(lattice) {}
  /// A cell by its place in voxels. False where it is known already. Costs a look at all sweeps.
  bool add(const LatticePoint& cell);
  bool empty() const { return lists_.empty(); }
  /// Null where the cell was not added, or no surface passes it.
  const Candidates* of(const LatticePoint& cell) const;
  /// The list of the cell that holds a place in fine units.
  const Candidates* at(const LatticePoint& p) const {
    const std::int32_t unit = lattice_.per_voxel();
    return of({p.x / unit, p.y / unit, p.z / unit});
  }
  /// The cells with lists in the cube of that many from `first`: calls take(cell, list).
  template <class Take>
  void each_in(const LatticePoint& first, std::int32_t size, const Take& take) const {
    for (const auto& [place, list] : lists_) {
      const auto [x, y, z] = place;
      const LatticePoint p{x - first.x, y - first.y, z - first.z};
      const auto in = [&](std::int32_t i) { return i >= 0 && i < size; };
      if (!list.empty() && in(p.x) && in(p.y) && in(p.z)) take(p, list);
    }
  }

 private:
  using Place = std::tuple<std::int32_t, std::int32_t, std::int32_t>;
  const ExactField& field_;
  const Lattice lattice_;
  std::map<Place, Candidates> lists_;  ///< empty where no surface passes
};

}  // namespace mrsim::detail
