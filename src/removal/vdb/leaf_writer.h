// Samples at some points and the leaves that they are written to: shared by the carvers of blocks.
#pragma once

#include "removal/field/lattice.h"
#include "removal/part/block_index.h"
#include "removal/part/part_field.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/vdb/vdb_grid.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>

namespace mrsim {

inline constexpr int kLeafVoxels = 8;

struct LeafPair {
  std::unique_ptr<FloatLeaf> distance;
  std::unique_ptr<OwnerLeaf> owner;
};

/// The memory of a pair of leaves. Kept, because asking a leaf for it costs as much as a write.
struct LeafView {
  LeafView() = default;
  explicit LeafView(const LeafPair& leaf)
      : distance(leaf.distance->buffer().data()),
        owner(leaf.owner->buffer().data()),
        active(&leaf.distance->getValueMask().getWord<std::uint64_t>(0)),
        owned(&leaf.owner->getValueMask().getWord<std::uint64_t>(0)) {}
  float* distance = nullptr;
  std::int32_t* owner = nullptr;
  std::uint64_t *active = nullptr, *owned = nullptr;  // the masks, 64 voxels a word
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

  // What each of the points is to hold, from the sweep nearest to it. Deep in the stock this never
  // decides within the band.
  void combine_stock(bool in_stock) {
    double stock[PointColumns::kMost];
    if (in_stock)
      std::fill_n(stock, points_.count, -std::numeric_limits<double>::infinity());
    else
      field_.solid().distances(points_.count, points_.x, points_.y, points_.z, stock);
    active_ = cut_ = 0;
    for (std::size_t k = 0; k < points_.count; ++k) {
      const double cut = -points_.least[k], d = std::max(stock[k], cut);
      distance_[k] = static_cast<float>(std::clamp(d, -band_, band_));
      const bool is_active = -band_ < d && d < band_;
      active_ |= std::uint64_t(is_active) << k;
      cut_ |= std::uint64_t(is_active && stock[k] < cut) << k;
    }
  }

  // Points k, k + 1, ... of a row along z.
  void store(const LeafView& leaf, std::size_t k, std::size_t offset, std::size_t count) const {
    std::copy_n(distance_ + k, count, leaf.distance + offset);
    const std::uint64_t row = (std::uint64_t(1) << count) - 1, active = active_ >> k & row;
    if (active == 0) return;
    const std::size_t word = offset / 64, bit = offset % 64;
    leaf.active[word] |= active << bit;
    leaf.owned[word] |= active << bit;
    for (std::uint64_t cut = cut_ >> k & row; cut != 0; cut &= cut - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(cut));
      leaf.owner[offset + i] =
          field_.sweeps().motion(static_cast<std::size_t>(points_.nearest[k + i]));
    }
  }

  const PartField& field_;
  double voxel_, band_;
  PointColumns points_;

 private:
  static_assert(PointColumns::kMost <= 64);
  float distance_[PointColumns::kMost];  // within the band
  std::uint64_t active_ = 0;             // bit k: point k lies in the band
  std::uint64_t cut_ = 0;                // and a sweep decides there, not the stock
};

}  // namespace mrsim
