#include "interp/moves/length_switch.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {

// Runs for every motion: what others have cut is looked up where tool or mode change.
bool LengthSwitch::contradicts(int tool, int mode, const Motion& motion, bool incremental) {
  if (mode != mode_ || tool != tool_) change(tool, mode);
  told_ = told_ || (!incremental && std::abs(motion.end.z - motion.start.z) > kRounding);
  if (!told_ || motion.kind == MotionKind::rapid) return false;
  if (!top_) top_ = &tops_[tool].try_emplace(mode, motion.start.z).first->second;
  *top_ = std::max(*top_, motion.start.z);
  return motion.end.z < others_;
}

void LengthSwitch::change(int tool, int mode) {
  tool_ = tool;
  mode_ = mode;
  told_ = false;
  top_ = nullptr;
  others_ = -std::numeric_limits<double>::infinity();
  const auto cuts = tops_.find(tool);
  if (cuts == tops_.end()) return;
  for (const auto& [other, top] : cuts->second)
    if (other != mode) others_ = std::max(others_, top);
}

}  // namespace mrsim
