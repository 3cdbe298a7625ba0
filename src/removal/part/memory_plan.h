// How much memory a run takes, told before it, and whether it is done in one piece or in slabs.
// What a mesh with a tolerance takes besides is told by its first cells
// (mesh/surface/mesh_memory.h).
#pragma once

#include "removal/part/part_field.h"
#include <mrsim/options.h>

#include <cstddef>

namespace mrsim {

struct MemoryPlan {
  std::size_t limit = 0;  ///< bytes
  double expected = 0;    ///< bytes at the peak, as planned; without a mesh that has a tolerance
  double whole = 0;       ///< the same in one piece
  bool in_slabs = false;
};

/// Of a run whose program has that many motions. Throws Error "voxel-invalid"; "voxel-too-small"
/// where the stock's surface has too many voxels; "memory" where the run does not fit, with what
/// would.
MemoryPlan plan_memory(const PartField& field, std::size_t motions, const CarveOptions& options);

}  // namespace mrsim
