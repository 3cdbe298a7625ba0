// The OpenVDB side of a Stock. Private to src/removal and src/mesh/extract.cpp: the only header of
// ours that includes OpenVDB.
#pragma once

#include "removal/block_index.h"
#include "removal/lattice.h"
#include "removal/memory_plan.h"
#include "removal/part_field.h"

#include <memory>

#include <openvdb/openvdb.h>
#include <openvdb/tools/SignedFloodFill.h>

namespace mrsim {

struct StockGrid {
  double voxel = 0;  ///< mm
  MemoryPlan plan;
  std::size_t active = 0;            ///< voxels; 0 where none were sampled
  openvdb::FloatGrid::Ptr distance;  ///< narrow band of kBandVoxels voxels each way, mm, level set;
                                     ///< null where it was not to be kept
  openvdb::Int32Grid::Ptr owner;     ///< same topology; kStockOwner or the index of a motion
  std::unique_ptr<PartField> field;
  std::unique_ptr<BlockIndex> index;
};

}  // namespace mrsim
