// Lists of candidates for one cell each, made where cells share a long one: a vertex takes several
// samples in its cell, each over all of the list.
#pragma once

#include "mesh/cells/cells.h"

#include <cstdint>
#include <span>

namespace mrsim::detail {

class CellLists {
 public:
  CellLists(const ExactField& field, const SurfaceCells& cells) : field_(field), cells_(cells) {}
  /// Before the first question about cells that have changed.
  void restart();
  /// What can matter in a cell and within kCellReach of it; valid until the thread's next call.
  std::span<const std::uint32_t> of(std::int32_t cell) const;

 private:
  const ExactField& field_;
  const SurfaceCells& cells_;
  std::uint64_t round_ = 0;  ///< no two objects have the same at any time
};

}  // namespace mrsim::detail
