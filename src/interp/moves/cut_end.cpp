#include "interp/moves/cut_end.h"

#include "core/numbers/vec.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

void CutEnd::see(const Motion& motion, bool lathe) {
  const double start = motion.start.z, end = motion.end.z;
  if (motion.kind == MotionKind::rapid) {
    if (distance(motion.start, motion.end) <= kRounding) return;
    in_cut_ = false;
    const double way = std::hypot(motion.end.x - motion.start.x, motion.end.y - motion.start.y);
    if (way > kRounding && !motion.assumed_start) travel_ = std::min(start, end);
    approach_ = motion.end.x;
  } else {
    if (!motion.assumed_start) highest_ = std::max(highest_, start);
    in_cut_ = !leaves(motion, lathe);
    deepest_ = std::min(deepest_, end);
  }
  highest_ = std::max(highest_, end);
}

// A line straight up leaves the part, and so does a move that ends at a height where the tool has
// travelled before, or on a lathe at the diameter from which it went in.
bool CutEnd::leaves(const Motion& motion, bool lathe) const {
  if (motion.kind != MotionKind::line) return false;
  const Vec3 way = motion.end - motion.start;
  if (way.z > 0 && std::hypot(way.x, way.y) <= kRounding) return true;
  if (lathe) {
    const double before = approach_ ? motion.start.x - *approach_ : 0;
    return std::abs(before) > kRounding &&
           (motion.end.x - *approach_) * (before > 0 ? 1 : -1) <= kRounding;
  }
  return motion.end.z >= travel_.value_or(highest_) - kRounding &&
         motion.end.z > deepest_ + kRounding;
}

}  // namespace mrsim
