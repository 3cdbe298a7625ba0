#include "core/numbers/trig.h"

#include "core/numbers/lane_scalar.h"
#include "core/numbers/units.h"

#include <cmath>

namespace mrsim {
SinCos sincos(double angle) {
  const lane::VSinCos sc = lane::vsincos(angle);
  return {sc.sin, sc.cos};
}

SinCos sincos_deg(double angle) {
  const double k = std::floor(angle / 90.0 + 0.5);
  const lane::VSinCos sc = lane::quadrant(radians(angle - k * 90.0), k);
  return {sc.sin, sc.cos};
}

double atan2(double y, double x) { return lane::vatan2(y, x); }

}  // namespace mrsim
