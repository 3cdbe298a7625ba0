// What a Stock holds. Private to src/removal.
#pragma once

#include "removal/part/block_index.h"
#include "removal/part/memory_plan.h"
#include "removal/part/part_field.h"
#include "removal/part/voxel_grid.h"

#include <memory>

namespace mrsim {

struct StockGrid {
  double voxel = 0;  ///< mm
  CarvePlan asked;   ///< as it was decided
  std::size_t motions = 0;
  MemoryPlan plan;
  std::unique_ptr<PartField> field;
  std::unique_ptr<BlockIndex> index;
  std::unique_ptr<VoxelGrid> voxels;  ///< null where none were to be kept
};

}  // namespace mrsim
