#include "interp/moves/length_switch.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

// Runs for every motion, so the depths of other modes are looked up only where tool or mode change.
bool LengthSwitch::contradicts(int tool, int mode, const Motion& motion, bool incremental) {
  if (mode != mode_ || tool != tool_) change(tool, mode);
  const double from = motion.start.z, to = motion.end.z;
  told_ = told_ || (!incremental && std::abs(to - from) > kRounding);
  if (!told_ || motion.kind == MotionKind::rapid || to > from + kRounding) return false;
  if (!own_) own_ = &cuts_[tool][mode];
  own_->low = std::min(own_->low, to);
  own_->top = std::max(own_->top, from);
  return std::any_of(others_.begin(), others_.end(),
                     [&](const Depths& other) { return other.low < from && to <= other.top; });
}

void LengthSwitch::change(int tool, int mode) {
  tool_ = tool;
  mode_ = mode;
  told_ = false;
  own_ = nullptr;
  others_.clear();
  const auto cuts = cuts_.find(tool);
  if (cuts == cuts_.end()) return;
  for (const auto& [other, depths] : cuts->second)
    if (other != mode) others_.push_back(depths);
}

}  // namespace mrsim
