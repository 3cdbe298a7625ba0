// Chords of straight moves of a convex tool that follow one another nearly on a line: the smallest
// packs of sweep_packs.h, and two of them that are neighbours.
#pragma once

#include "core/process/heap.h"
#include "removal/simd/form_records.h"

#include <cstdint>
#include <vector>

namespace mrsim {

struct SweepColumns;

class RunChords {
 public:
  /// Where the moves between two sweeps lie: beside a chord.
  struct Run {
    std::uint32_t first = 0, last = 0;  ///< sweeps
    double spread = 0;  ///< mm: how far they leave the chord, with room for rounding
    ChainLine chord;
    bool pair = false;  ///< of this pack and the next
  };
  RunChords() = default;
  /// The chords of finished packs. There are none where no sweep has a chain_minimum().
  explicit RunChords(const SweepColumns& columns);

  /// The run of the smallest pack that holds a sweep; if that pack is the first of two, the run of
  /// both stands behind it. Null where there is none.
  const Run* of(std::uint32_t sweep) const {
    return run_of_.empty() || run_of_[sweep] == kNone ? nullptr : &runs_[run_of_[sweep]];
  }
  std::size_t memory() const { return bytes_of(runs_) + bytes_of(run_of_); }  ///< bytes

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<Run> runs_;
  std::vector<std::uint32_t> run_of_;  ///< by sweep
};

}  // namespace mrsim
