// Short lists of candidates for places on the surface.
//
// A cell that a floor passes stays large, and hundreds of passes may share that floor: each of them
// is in the cell's list, and each place would ask them all. So such cells are halved again for
// their lists alone, where the surface passes, until the lists are short.
#pragma once

#include "removal/field/field.h"

#include <cstdint>
#include <vector>

namespace mrsim::detail {

class SurfaceCells;

class SurfaceLists {
 public:
  /// None of any cell.
  SurfaceLists() = default;
  /// Of the cells whose own lists are long. The parts of a cell hold about eight times as many
  /// candidates as the cell at most, so that six halvings take some 400 looks at each of these.
  SurfaceLists(const ExactField& field, const SurfaceCells& cells, int threads);

  /// What can decide d at p, in the cell, if the surface passes p; if it does not, perhaps less.
  /// Null where the cell's own list will do, or no surface passes. Requires: not empty(). `box`:
  /// that of the cell.
  const Candidates* at(const Vec3& p, std::int32_t cell, const Box3& box) const;
  bool empty() const { return parts_.empty(); }
  std::size_t memory() const;  ///< bytes

 private:
  struct Part {
    std::int32_t child = -1;  ///< first of eight, in the order of octant()
    bool has_surface = true;
    Candidates list;  ///< of parts without children
  };
  using Parts = std::vector<Part>;  ///< the first one is the cell

  static void divide(const ExactField& field, const Box3& box, Parts& parts);

  std::vector<std::int32_t> of_cell_;  ///< index into parts_, -1 = the cell's own list will do
  std::vector<Parts> parts_;
};

}  // namespace mrsim::detail
