// A flat, bull-nose or ball mill that reaches up, on a stretch of its path along which it moves
// away from p in plan and falls. The tool at rest is the set dr < 0, dz < 0 rounded by `round`,
// with dr = lateral distance - core and dz = round - height above the tip; its distance V(dr, dz)
// falls with neither. Along the stretch dr grows and dz falls, so V is least where dr = dz
// (inside), where dr = 0 or dz = 0, at an end, or where dr^2 + dz^2 is least between them
// (docs/sweeps.md).
//
// For one point (V = double) or several; included once per instruction set after sweep_lanes.inl.
// The result of a lane depends on its point alone. A mask says which lanes to compute; the others
// keep their values.

/// A position on a stretch: its parameter, dr and dz there, and their slopes.
struct Place {
  V t, dr, dz;
  V dr_slope, dz_slope;
  V wx, wy;  ///< direction from the path's axis, as the stretch counts it
};

MRSIM_LANE M is_corner(const Place& p) {
  return both(less(splat(0.0), p.dr), less(splat(0.0), p.dz));
}
MRSIM_LANE M is_wall(const Place& p) { return except(less_equal(p.dz, p.dr), is_corner(p)); }
MRSIM_LANE M is_floor(const Place& p) { return except(less_equal(p.dr, p.dz), is_corner(p)); }
MRSIM_LANE V value_of(const Place& p, V round) { return slab(p.dr, p.dz, round); }

MRSIM_LANE Place choose(M m, const Place& a, const Place& b) {
  return {select(m, a.t, b.t),
          select(m, a.dr, b.dr),
          select(m, a.dz, b.dz),
          select(m, a.dr_slope, b.dr_slope),
          select(m, a.dz_slope, b.dz_slope),
          select(m, a.wx, b.wx),
          select(m, a.wy, b.wy)};
}
MRSIM_LANE M between(V low, V t, V high) { return both(less(low, t), less(t, high)); }

/// No position between a and b has a lower value, nor is nearer or lower.
MRSIM_LANE V lower_bound(const Place& a, const Place& b, V round) {
  return slab(a.dr, b.dz, round);
}

/// mm or radians: Newton's method has found a least distance where its step is smaller. The next
/// step would be the square of it, and the distance changes by the square of that.
constexpr double kLastNewtonStep = 1e-6;
/// The square of the step at which Newton's method has found a crossing.
constexpr double kLastCrossingSquared = 1e-16;

/// The place in [a, b] where dr = dz, which grows from dr <= dz at a to dr >= dz at b. Newton's
/// method, halving where it leaves the bracket.
template <class Stretch>
static inline Place crossing(const Stretch& s, const Place& a, const Place& b, M wanted) {
  const V fa = a.dr - a.dz, fb = b.dr - b.dz;
  Place x = choose(less(fb, -fa), b, a);
  V low = a.t, high = b.t;
  const V secant = low - fa / (fb - fa) * (high - low);
  if (const M in = both(wanted, between(low, secant, high)); any(in))
    x = choose(in, s.at(secant, x, in), x);
  M active = wanted;
  for (int k = 0; k < 60; ++k) {
    const V v = x.dr - x.dz, slope = x.dr_slope - x.dz_slope;
    active = except(active, both(less_equal(v, splat(0.0)), less_equal(splat(0.0), v)));
    const M below = less(v, splat(0.0));
    low = select(below, x.t, low), high = select(below, high, x.t);
    V t = select(less(splat(0.0), slope), x.t - v / slope, low);
    const M newton = between(low, t, high);
    t = select(newton, t, splat(0.5) * (low + high));
    active = both(active, between(low, t, high));
    if (!any(active)) break;
    const V step = t - x.t;
    x = choose(active, s.at(t, x, active), x);
    // The next step is about the square of this one: below rounding.
    active = except(active, both(newton, less(step * step, splat(kLastCrossingSquared))));
  }
  return x;
}

/// The place of least value on a stretch. It has
///   first(), last()      its ends;
///   at(t, x, m)          any place, with the help of a near one;
///   rim(a, b, m)         where dr = 0, between a with dr <= 0 and b with dr > 0;
///   ground(a, b, m)      where dz = 0, between a with dz > 0 and b with dz < 0;
///   diagonal(a, b, m)    where dr = dz, between a with dr <= dz and b with dr >= dz;
///   corner(a, b, m)      the least of dr^2 + dz^2 between places with dr >= 0 and dz >= 0.
template <class Stretch>
static inline Place best_place(const Stretch& s, M wanted) {
  const V zero = splat(0.0);
  const Place first = s.first(), last = s.last();
  const M wall = is_wall(first);
  Place best = choose(wall, first, last);
  M active = except(except(wanted, wall), is_floor(last));
  if (!any(active)) return best;
  const M under = except(active, is_corner(first));  // the tool: dr <= 0
  M inside = both(under, less_equal(last.dr, zero));
  Place from = first, end = last;
  if (const M rim = except(under, inside); any(rim)) {
    from = choose(rim, s.rim(first, last, rim), first);
    const M below = both(rim, less_equal(from.dz, zero));
    end = choose(below, from, last);
    inside = either(inside, below);
  }
  if (any(inside)) best = choose(inside, s.diagonal(first, end, inside), best);
  active = except(active, inside);
  if (!any(active)) return best;
  if (const M ground = both(active, less(last.dz, zero)); any(ground))
    end = choose(ground, s.ground(from, last, ground), end);
  return choose(active, s.corner(from, end, active), best);
}
