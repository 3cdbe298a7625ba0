// Angles within one turn.
#pragma once

#include "core/numbers/units.h"

namespace mrsim {

/// The angle in [0, 2 pi), radians. Cost: one step a turn.
inline double wrapped_angle(double angle) {
  while (angle < 0) angle += kTwoPi;
  while (angle >= kTwoPi) angle -= kTwoPi;
  return angle;
}

}  // namespace mrsim
