// What a sweep answers about a point: how far away it is, and which of its faces is nearest.
#pragma once

#include <cstdint>

namespace mrsim {

struct SweepSample {
  double distance = 0;
  /// Smooth face of the sweep: equal for two points whose surfaces join without a crease.
  std::int32_t patch = 0;
};

}  // namespace mrsim
