// A "register" of one number. Numeric code that is written once for any number of lanes
// (trig_lanes.inl, removal/simd/*.inl) uses it for a single point, and as the reference that
// the SIMD versions must equal.
#pragma once

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"

#include <cmath>

namespace mrsim::lane {

using V = double;
using M = bool;  ///< mask of a comparison
inline V splat(double a) { return a; }
inline V vmin(V a, V b) { return a < b ? a : b; }
inline V vmax(V a, V b) { return a > b ? a : b; }
inline V vabs(V a) { return vmax(a, -a); }
inline V vsqrt(V a) { return std::sqrt(a); }
/// Requires: |a| < 2^62. A conversion there and back; std::floor is a call where SSE2 is all.
inline V vfloor(V a) {
  const V whole = static_cast<V>(static_cast<long long>(a));
  return whole > a ? whole - 1 : whole;
}
inline M less(V a, V b) { return a < b; }
inline M less_equal(V a, V b) { return a <= b; }
inline M both(M a, M b) { return a && b; }
inline M either(M a, M b) { return a || b; }
inline M except(M a, M b) { return a && !b; }
inline unsigned bits(M m) { return m ? 1 : 0; }
inline bool any(M m) { return m; }
inline V select(M m, V a, V b) { return m ? a : b; }

#define MRSIM_LANE inline
#include "core/numbers/trig_lanes.inl"
#undef MRSIM_LANE

}  // namespace mrsim::lane
