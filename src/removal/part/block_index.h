// Sweeps binned into cubes of 64 voxels, those of the run or larger ones: who can matter where.
#pragma once

#include "removal/part/part_field.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Edge of a block in voxels.
inline constexpr int kBlockVoxels = 64;

class BlockIndex {
 public:
  /// Covers the stock and `band` mm around it; sweeps (SweepTable::all) are listed in every block
  /// that they come within `band` of. Same result for any number of threads. Memory: 4 bytes per
  /// sweep and block that it reaches. Throws Error "memory" when the blocks alone would exceed
  /// `max_memory` bytes.
  BlockIndex(const PartField& field, double voxel, double band, std::size_t max_memory,
             int threads = 1);

  /// Lists other sweeps in the blocks of `blocks`, each in every block that its bounds meet.
  BlockIndex(const BlockIndex& blocks, const SweepTable& sweeps);

  std::size_t size() const { return start_.size() - 1; }
  /// What block b covers, mm.
  Box3 box(std::size_t b) const;
  /// Lattice coordinates of the first voxel of block b; a multiple of kBlockVoxels.
  std::array<std::int32_t, 3> origin(std::size_t b) const;
  /// Sweeps of block b, ascending.
  std::span<const std::uint32_t> sweeps(std::size_t b) const {
    return {ids_.data() + start_[b], start_[b + 1] - start_[b]};
  }
  /// The blocks that a box meets, ascending.
  std::vector<std::size_t> blocks_of(const Box3& box) const;
  /// The block that holds p; size() when none does.
  std::size_t find(const Vec3& p) const;
  std::size_t memory() const {
    return ids_.capacity() * sizeof(ids_[0]) + start_.capacity() * sizeof(start_[0]);
  }

 private:
  struct Range {
    std::array<std::int32_t, 3> low{1, 1, 1}, high{};  // empty
  };
  void fill(const SweepTable& sweeps, std::span<const std::uint32_t> ids, double band, int threads);
  std::int32_t block_of(double x, int axis) const;
  bool range_of(const Box3& box, Range& range) const;
  template <typename Body>
  void for_each_block(const Range& range, Body body) const;

  double voxel_;
  std::array<std::int32_t, 3> first_{}, count_{};
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace mrsim
