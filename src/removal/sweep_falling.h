// A flat, bull-nose or ball mill that reaches up, on a stretch of its path along which it moves
// away from p in plan and falls. The tool at rest is the set dr < 0, dz < 0 rounded by `round`,
// with dr = lateral distance - core and dz = round - height above the tip; its distance V(dr, dz)
// falls with neither. Along the stretch dr grows and dz falls, so V is least where dr = dz
// (inside), where dr = 0 or dz = 0, at an end, or where dr^2 + dz^2 is least between them
// (docs/sweeps.md).
#pragma once

#include "core/vec.h"
#include "removal/sweep_lane_scalar.h"

namespace mrsim {

/// A position on a stretch: its parameter, dr and dz there, and their slopes.
struct Place {
  double t = 0, dr = 0, dz = 0;
  double dr_slope = 0, dz_slope = 0;
  Vec2 w;  ///< direction from the path's axis, as the stretch counts it

  bool is_corner() const { return dr > 0 && dz > 0; }
  bool is_wall() const { return dr >= dz && !is_corner(); }
  bool is_floor() const { return dz >= dr && !is_corner(); }
  double value(double round) const { return lane::slab(dr, dz, round); }
};

/// No position between a and b has a lower value, nor is nearer or lower.
inline double lower_bound(const Place& a, const Place& b, double round) {
  return lane::slab(a.dr, b.dz, round);
}

/// The place in [a, b] where f = 0; f grows from f(a) <= 0 to f(b) >= 0. Newton's method, halving
/// where it leaves the bracket; at(t, x) makes a place, from a near one.
template <class At, class F, class Slope>
Place zero_between(Place a, Place b, At at, F f, Slope slope) {
  const double rise = f(b) - f(a);
  Place x = f(b) < -f(a) ? b : a;
  if (const double t = a.t - f(a) / rise * (b.t - a.t); t > a.t && t < b.t) x = at(t, x);
  for (int k = 0; k < 60; ++k) {
    const double v = f(x), s = slope(x);
    if (v == 0) break;
    (v < 0 ? a : b) = x;
    double t = s > 0 ? x.t - v / s : a.t;
    const bool newton = t > a.t && t < b.t;
    if (!newton) t = 0.5 * (a.t + b.t);
    if (!(t > a.t && t < b.t)) break;
    const double step = t - x.t;
    x = at(t, x);
    if (newton && step * step < 1e-16) break;  // the next one would be below rounding
  }
  return x;
}

/// The place of least value on a stretch. It has
///   first(), last()    its ends;
///   at(t, x)           any place, with the help of a near one;
///   rim(a, b)          where dr = 0, between a with dr <= 0 and b with dr > 0;
///   ground(a, b)       where dz = 0, between a with dz > 0 and b with dz < 0;
///   corner(a, b)       the least of dr^2 + dz^2 between places with dr >= 0 and dz >= 0.
template <class Stretch>
Place best_place(const Stretch& s) {
  const Place first = s.first(), last = s.last();
  if (first.is_wall()) return first;
  if (last.is_floor()) return last;
  const auto crossing = [&s](const Place& a, const Place& b) {
    return zero_between(
        a, b, [&s](double t, const Place& x) { return s.at(t, x); },
        [](const Place& x) { return x.dr - x.dz; },
        [](const Place& x) { return x.dr_slope - x.dz_slope; });
  };
  Place from = first;
  if (!first.is_corner()) {  // under the tool: dr <= 0
    if (last.dr <= 0) return crossing(first, last);
    from = s.rim(first, last);
    if (from.dz <= 0) return crossing(first, from);
  }
  return s.corner(from, last.dz < 0 ? s.ground(from, last) : last);
}

}  // namespace mrsim
