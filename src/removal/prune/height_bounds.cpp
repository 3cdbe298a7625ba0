#include "removal/prune/height_bounds.h"

#include "removal/prune/region_args.h"

#include <algorithm>

namespace mrsim {

void HeightBounds::begin(const RegionArgs& at, float lateral) {
  const auto band = static_cast<float>(kWider * band_);
  const float tall = at.tall + 2 * at.delta;
  args_.x = at.x, args_.y = at.y;
  args_.wide = static_cast<float>(kWider) * lateral + band + 4 * at.delta;
  args_.error = 2 * at.delta;
  args_.top = at.z + tall + 2 * band + 4 * at.delta;
  swept_ = at.z - tall - band - 4 * at.delta;
  above_ = at.z + tall + band + 4 * at.delta;
  twice_ = 2 * band + 4 * at.delta;
}

HeightArgs HeightBounds::args(const SweepClass& type) const {
  HeightArgs a = args_;
  a.tool = type.heights;
  a.error *= 1 + a.tool.steepest / 8;  // heights err with the slope
  if (type.packs) a.wide += static_cast<float>(kWiderSpread * type.spread), a.stray = 0;
  return a;
}

float HeightBounds::limit() const { return std::min(above_, least_ + twice_); }

}  // namespace mrsim
