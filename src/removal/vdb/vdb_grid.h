// The grids of a stock, as OpenVDB holds them.
#pragma once

#include "removal/part/voxel_grid.h"
#include "removal/vdb/grids.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

using FloatLeaf = openvdb::FloatTree::LeafNodeType;
using OwnerLeaf = openvdb::Int32Tree::LeafNodeType;

struct VdbGrid final : VoxelGrid {
  openvdb::FloatGrid::Ptr distance;  ///< narrow band of kBandVoxels voxels each way, mm, level set
  openvdb::Int32Grid::Ptr owner;     ///< same topology; kStockOwner or the index of a motion
  std::size_t active = 0;            ///< voxels
  int threads = 0;                   ///< for taking the grid down, 0 = all cores
  /// What the two trees own, in the order in which it was made.
  std::vector<std::pair<FloatLeaf*, OwnerLeaf*>> leaves;

  VdbGrid() = default;
  VdbGrid(const VdbGrid&) = delete;
  VdbGrid& operator=(const VdbGrid&) = delete;
  ~VdbGrid() override;

  std::size_t active_voxels() const override { return active; }
  std::size_t memory() const override;
  void write(const PartField& field, const BlockIndex& index, const std::string& recipe,
             std::ostream& out) const override;
};

}  // namespace mrsim
