// The closed forms of sweep_lanes.inl for one sweep and one point: the reference of the SIMD ones.
#pragma once

#include <cmath>

namespace mrsim::lane {

using V = double;
using M = bool;
#define MRSIM_LANE inline
inline V splat(double a) { return a; }
inline V vmin(V a, V b) { return a < b ? a : b; }
inline V vmax(V a, V b) { return a > b ? a : b; }
inline V vabs(V a) { return vmax(a, -a); }
inline V vsqrt(V a) { return std::sqrt(a); }
inline M less_equal(V a, V b) { return a <= b; }
inline V select(M m, V a, V b) { return m ? a : b; }
#include "removal/sweep_lanes.inl"
#undef MRSIM_LANE

}  // namespace mrsim::lane
