// Under which solid angle a triangle is seen, for the question whether a point is inside.
#pragma once

#include "core/numbers/trig.h"
#include "core/numbers/vec.h"

namespace mrsim {

/// Half of the solid angle of the triangle a b c from the origin, signed by its orientation [van
/// Oosterom and Strackee 1983]: the sum over a closed surface is 2 pi about a point inside, 0
/// outside.
inline double half_solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = length(a), lb = length(b), lc = length(c);
  return mrsim::atan2(dot(a, cross(b, c)),
                      la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

}  // namespace mrsim
