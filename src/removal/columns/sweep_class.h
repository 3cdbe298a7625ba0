// What the sweeps of one class have in common. Sweeps of one class share a form and a tool, so that
// pruning reads their columns in one loop; sweeps of one group may be compared with each other.
#pragma once

#include "removal/simd/candidate_kernels.h"

#include <cstdint>

namespace mrsim {

/// Sweeps of one form and one tool; what they have in common.
struct SweepClass {
  /// How the distance is computed: the columns of candidate_kernels.h, sweep by sweep, or by the
  /// tree of turning sweeps, whose packs the list holds then. Of `segment` the list holds segments
  /// of paths, one or more a sweep, whose heights are bounded instead.
  enum class Form : std::uint8_t { strip, line, arc, other, turn, segment };
  /// What the dominance test may compare (SweepSkeleton::Kind).
  enum class Kind : std::uint8_t { none, solid, plan };
  Form form = Form::other;
  Kind kind = Kind::none;
  std::int32_t group = -1;  ///< equal groups may be compared; -1 = with nothing
  bool packs = false;  ///< entries are packs of such sweeps (sweep_packs.h), stored as their chords
  double spread = 0;   ///< of these packs, the largest, mm
  double expand_below = 0;  ///< the same
  ToolColumns tool;
  HeightTool heights;  ///< milling tools in the stock's frame
};

}  // namespace mrsim
