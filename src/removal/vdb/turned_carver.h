// A block of a turned stock that turning sweeps alone have met: layer by layer, the columns of
// voxels in the order of their distance from the axis.
#pragma once

#include "removal/part/turn_layers.h"
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
    std::uint16_t leaf, offset;  // in a slab; of the lowest voxel in the leaf
  };
  // An interval of rho in each layer of a slab.
  struct Stretch {
    std::array<double, kLeafVoxels> from, to;
  };

  bool meets_surface(const openvdb::Coord& origin) const;
  void sort_columns(const openvdb::Coord& origin);
  void carve_layer(const openvdb::Coord& slab, int z);
  void evaluate(const openvdb::Coord& slab, int z, std::span<const Column> columns,
                const TurnLayers::Layer& layer, const Interval& in);
  void find_material(const openvdb::Coord& slab);
  void open_leaf(const openvdb::Coord& slab, std::size_t leaf);

  const TurnLayers& layers_;
  std::array<double, kColumns> rho_;
  std::array<Column, kColumns> columns_;
  std::array<LeafPair, kSlabSide * kSlabSide> slab_;  // the leaves of eight layers
  std::array<LeafView, kSlabSide * kSlabSide> views_;
  std::vector<Stretch> material_;  // of the slab
};

}  // namespace mrsim
