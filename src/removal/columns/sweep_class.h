// What the sweeps of one class have in common. Sweeps of one class share a form and a tool, so that
// pruning reads their columns in one loop; sweeps of one group may be compared with each other.
#pragma once

#include "removal/simd/candidate_kernels.h"

#include <cstdint>

namespace mrsim {

/// What sweeps of one form and one tool have in common.
struct SweepClass {
  /// Which kernel computes the distance: those of candidate_kernels.h for `strip`, `line` and
  /// `arc`, none (sweep by sweep) for `other`. `turn`: the list holds packs of the tree of turning
  /// sweeps. `segment`: the list holds straight segments of paths, one or more for each sweep, and
  /// only their heights are bounded.
  enum class Form : std::uint8_t { strip, line, arc, other, turn, segment };
  /// What the dominance test compares: nothing, skeletons in space (`solid`), or paths in plan
  /// (`plan`).
  enum class Kind : std::uint8_t { none, solid, plan };
  Form form = Form::other;
  Kind kind = Kind::none;
  std::int32_t group = -1;  ///< equal groups may be compared; -1 = with nothing
  bool packs = false;  ///< entries are packs of such sweeps (sweep_packs.h), stored as their chords
  double spread = 0;   ///< mm: the largest spread of these packs
  double expand_below = 0;  ///< mm: packs are expanded in regions of a smaller radius
  ToolColumns tool;
  HeightTool heights;  ///< milling tools in the stock's frame
};

}  // namespace mrsim
