#include "interp/moves/length_switch.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

bool LengthSwitch::contradicts(const std::string& tool, int mode, const Motion& motion,
                               bool incremental) {
  if (tool != tool_ || mode != mode_) {
    tool_ = tool;
    mode_ = mode;
    told_ = false;
  }
  told_ = told_ || (!incremental && std::abs(motion.end.z - motion.start.z) > kRounding);
  if (!told_ || motion.kind == MotionKind::rapid) return false;
  std::map<int, double>& tops = tops_[tool];
  const auto own = tops.try_emplace(mode, motion.start.z).first;
  own->second = std::max(own->second, motion.start.z);
  return std::any_of(tops.begin(), tops.end(), [&](const auto& other) {
    return other.first != mode && motion.end.z < other.second;
  });
}

}  // namespace mrsim
