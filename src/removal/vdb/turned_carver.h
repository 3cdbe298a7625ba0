// A block of a turned stock that turning sweeps alone have met: layer by layer, the columns of
// voxels in the order of their distance from the axis.
#pragma once

#include "removal/turn_layers.h"
#include "removal/vdb/leaf_writer.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

class TurnedCarver : LeafWriter {
 public:
  TurnedCarver(const PartField& field, double voxel, const TurnLayers& layers)
      : LeafWriter(field, voxel), layers_(layers) {}

  /// The leaves of the block whose first voxel is at `origin` that hold active voxels.
  std::vector<LeafPair> carve(const std::array<std::int32_t, 3>& origin);

 private:
  static constexpr std::size_t kSide = kBlockVoxels, kColumns = kSide * kSide;
  static constexpr std::size_t kSlabSide = kSide / kLeafVoxels;
  using Interval = TurnLayers::Interval;
  struct Column {
    double rho;
    std::uint32_t at;  // x * kSide + y
  };

  bool meets_surface(const openvdb::Coord& origin) const;
  void sort_columns(const openvdb::Coord& origin);
  void carve_layer(const openvdb::Coord& slab, int z);
  void evaluate(const openvdb::Coord& slab, int z, std::span<const Column> columns,
                std::span<const TurnTree::Member> members, bool in_stock);
  LeafPair signed_leaf(const openvdb::Coord& slab, std::size_t x0, std::size_t y0) const;

  const TurnLayers& layers_;
  std::array<double, kColumns> rho_;
  std::array<Column, kColumns> columns_;
  std::array<LeafPair, kSlabSide * kSlabSide> slab_;  // the leaves of eight layers
};

}  // namespace mrsim
