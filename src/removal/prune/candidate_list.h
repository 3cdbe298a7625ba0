// The sweeps that can matter in a region, as columns of floats about the region's place: the data
// that pruning works on. Packs of sweeps stand for their sweeps in large regions. A list of a large
// region is made once; the lists of its parts are what is left of it (prune.h), copied, so that
// every loop works on whole registers.
//
// Single precision decides nothing but what may be dropped, with a proven slack (docs/removal.md):
// distances that reach the grid are always those of SweepTable::distance.
#pragma once

#include "core/numbers/aligned_vector.h"
#include "removal/simd/candidate_kernels.h"
#include <mrsim/types.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim {

/// Where a list is to hold: a box, square in plan, or a ball.
struct PruneRegion {
  static constexpr double kRoundedUp = 1 + 1e-15;  ///< above the rounding of a root

  Vec3 center;
  double half = 0;    ///< of the edges of a box in plan; of a ball, its radius; mm
  double tall = 0;    ///< half of a box's height, the same
  double radius = 0;  ///< of the ball about all of it, mm
  bool box = false;
  bool expand_packs = false;  ///< no packs may be left: distances are evaluated next

  static PruneRegion ball(const Vec3& center, double radius) {
    return {center, radius, radius, radius, false};
  }
  static PruneRegion cube(const Vec3& center, double half) {
    return {center, half, half, half * 1.7320508075688774, true};
  }
  static PruneRegion column(const Vec3& center, double half, double tall) {
    return {center, half, tall, std::sqrt(2 * half * half + tall * tall) * kRoundedUp, true};
  }
};

class CandidateList {
 public:
  /// Sweeps or packs of one class in slots [first, first + count); first is a multiple of kPad.
  struct Slice {
    std::uint32_t class_index = 0;  ///< into SweepColumns::classes
    std::size_t first = 0, count = 0;
    std::size_t numbers = kIdColumn;  ///< column of what the list holds: sweeps, or packs
  };

  const std::vector<Slice>& slices() const { return slices_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// Entry k of a slice: index of the sweep, or number of the pack.
  std::uint32_t number(const Slice& slice, std::size_t k) const {
    return std::bit_cast<std::uint32_t>(column(slice.numbers)[slice.first + k]);
  }
  float* column(std::size_t i) { return numbers_.data() + i * stride_; }
  const float* column(std::size_t i) const { return numbers_.data() + i * stride_; }
  std::size_t stride() const { return stride_; }
  CandidateColumns columns(std::size_t slot) const { return {column(0) + slot, stride_}; }

  /// Empty, with room for `slots`.
  void reset(std::size_t slots, const Vec3& origin);
  /// Begins a slice of a class; its first slot. `numbers`: Slice::numbers.
  std::size_t begin_slice(std::uint32_t class_index, std::size_t numbers = kIdColumn);
  void close_slice(std::size_t count);
  /// Slots that `count` sweeps in `slices` slices need.
  static std::size_t room(std::size_t count, std::size_t slices) { return count + slices * kPad; }

  Vec3 origin;
  double extent = 0;   ///< largest coordinate or size in any column, mm
  bool closed = true;  ///< all sweeps have closed forms

  static constexpr std::size_t kPad = 16;

 private:
  AlignedVector<float> numbers_ = AlignedVector<float>(kCandidateColumns * kPad);
  std::size_t stride_ = kPad, size_ = 0;
  std::vector<Slice> slices_;
};

}  // namespace mrsim
