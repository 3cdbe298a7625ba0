// Packs of milling sweeps: up to eight short moves of one tool that follow one another along a
// nearly straight path, and packs of packs above them. Long lists hold packs for the sweeps in
// them, and pruning treats a pack as one sweep along its chord whose distance is known up to its
// spread (docs/removal.md). Where a region is small beside a pack, its members take its place.
#pragma once

#include "core/process/heap.h"
#include "removal/simd/sweep_kernels.h"
#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Numbers of packs in lists of sweeps: this and above.
inline constexpr std::uint32_t kFirstPack = 1u << 31;

/// mm^2: in place of the squared length in plan of an upright move, as a divisor.
inline constexpr double kLeastSquare = 1e-30;

struct SweepPack {
  std::uint32_t first = 0, last = 0;   ///< sweeps of the pack, inclusive
  std::uint32_t child = 0, count = 0;  ///< child packs; count = 0: the children are the sweeps
  std::uint32_t class_index = 0;       ///< into SweepColumns::classes
  /// mm: largest distance between path and chord; for packs of paths, in plan (the vertical part is
  /// stored with the chord).
  float spread = 0;
  float length = 0;        ///< of the chord, mm
  float expand_below = 0;  ///< mm: radius of regions that are to see its children

  /// Its children.
  std::size_t size() const { return count == 0 ? last - first + 1 : count; }
};

/// The children of a pack as a list has them (candidate_kernels.h), less what they have in common:
/// strip, segment and line about the start of the chord; of a line, tip and height number are 0.
/// Unused lanes hold nothing of use.
struct PackColumns {
  static constexpr std::size_t kColumns = 8, kLanes = 8;
  alignas(32) float c[kColumns][kLanes] = {};
};

struct SweepColumns;

/// The packs of a table. Memory: some 50 bytes a sweep.
class SweepPacks {
 public:
  SweepPacks() = default;
  /// Packs the sweeps of `columns` along lines that have a closed form or a segment; the same for
  /// any number of threads. Their classes are not yet known.
  SweepPacks(const SweepColumns& columns, int threads);

  std::size_t size() const { return packs_.size(); }
  std::size_t memory() const {  ///< bytes
    return bytes_of(packs_) + bytes_of(chords_) + bytes_of(children_) + bytes_of(roots_) +
           bytes_of(leaf_of_);
  }
  const SweepPack& operator[](std::uint32_t number) const { return packs_[number - kFirstPack]; }
  std::vector<SweepPack>& all() { return packs_; }
  /// The sweep along the chord, in the form of the members; of paths, a segment with their spread.
  const LineRecord& chord(std::uint32_t number) const { return chords_[number - kFirstPack]; }
  const PackColumns& children(std::uint32_t number) const { return children_[number - kFirstPack]; }
  /// Prefetches the memory of chord() and children(), which is far from that of other packs.
  void prefetch_children(std::uint32_t number) const {
    prefetch(children(number)), prefetch(chord(number));
  }
  /// The smallest pack that holds a sweep; 0 where there is none.
  std::uint32_t leaf_of(std::uint32_t sweep) const {
    return sweep < leaf_of_.size() ? leaf_of_[sweep] : 0;
  }
  /// Packs that are in no other, ascending.
  std::span<const std::uint32_t> roots() const { return roots_; }

  /// Calls body(number) for each child of a pack, ascending: packs, or sweeps.
  template <typename Body>
  void for_each_child(std::uint32_t number, Body body) const {
    const SweepPack& pack = (*this)[number];
    if (pack.count == 0)
      for (std::uint32_t i = pack.first; i <= pack.last; ++i) body(i);
    else
      for (std::uint32_t k = 0; k < pack.count; ++k) body(kFirstPack + pack.child + k);
  }

 private:
  class Builder;
  void append(const SweepPacks& part, std::size_t sweeps);
  std::vector<SweepPack> packs_;
  std::vector<LineRecord> chords_;
  std::vector<PackColumns> children_;
  std::vector<std::uint32_t> roots_;
  std::vector<std::uint32_t> leaf_of_;  ///< by sweep; empty without packs
};

}  // namespace mrsim
