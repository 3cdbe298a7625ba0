// What the carvers of blocks share: samples at some points, and the leaves they are written to.
#pragma once

#include "removal/block_index.h"
#include "removal/lattice.h"
#include "removal/part_field.h"
#include "removal/sweep_kernels.h"

#include <algorithm>
#include <limits>
#include <memory>

#include <openvdb/openvdb.h>

namespace mrsim {

using FloatLeaf = openvdb::FloatTree::LeafNodeType;
using OwnerLeaf = openvdb::Int32Tree::LeafNodeType;

inline constexpr int kLeafVoxels = 8;

struct LeafPair {
  std::unique_ptr<FloatLeaf> distance;
  std::unique_ptr<OwnerLeaf> owner;
};

class LeafWriter {
 public:
  LeafWriter(const PartField& field, double voxel)
      : field_(field), voxel_(voxel), band_(kBandVoxels * voxel) {}

 protected:
  LeafPair new_leaf(const openvdb::Coord& origin) const {
    return {std::make_unique<FloatLeaf>(origin, static_cast<float>(band_), false),
            std::make_unique<OwnerLeaf>(origin, kStockOwner, false)};
  }

  // Deep in the stock it never decides within the band.
  void combine_stock(bool in_stock) {
    if (in_stock)
      std::fill_n(stock_, points_.count, -std::numeric_limits<double>::infinity());
    else
      field_.solid().distances(points_.count, points_.x, points_.y, points_.z, stock_);
    for (std::size_t k = 0; k < points_.count; ++k) {
      const double cut = -points_.least[k];
      from_stock_[k] = stock_[k] >= cut;
      points_.least[k] = stock_[k] >= cut ? stock_[k] : cut;
    }
  }

  void store(LeafPair& leaf, std::size_t k, openvdb::Index offset) const {
    const double d = points_.least[k];
    leaf.distance->buffer().data()[offset] = static_cast<float>(std::clamp(d, -band_, band_));
    if (d >= band_ || d <= -band_) return;
    leaf.distance->getValueMask().setOn(offset);
    leaf.owner->getValueMask().setOn(offset);
    if (!from_stock_[k])
      leaf.owner->buffer().data()[offset] =
          field_.sweeps().motion(static_cast<std::size_t>(points_.nearest[k]));
  }

  const PartField& field_;
  double voxel_, band_;
  PointColumns points_;

 private:
  double stock_[PointColumns::kMost];
  bool from_stock_[PointColumns::kMost];
};

}  // namespace mrsim
