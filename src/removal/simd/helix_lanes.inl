// The lowest turn of a falling helix, for one point (V = double) or several; included once per
// instruction set after falling_lanes.inl.
//
// Seen from p, a position is turned by `delta` from the one that looks at p. Up to half a turn the
// lateral distance grows and the tool falls: a stretch. Behind it both fall up to the end of the
// path, or to the next position that looks at p.

// p in cylindrical coordinates about the helix.
struct HelixView {
  V core, fall;
  V off, area;  // how far p lies beyond the helix's circle; the product of both radii
  V low, along_u, along_v;

  HelixView(const HelixRecord& r, V px, V py, V pz)
      : core(splat(r.core)), fall(splat(r.fall)), low(splat(r.z) - pz) {
    const V x = px - splat(r.x), y = py - splat(r.y);
    const V rho = vsqrt(x * x + y * y);
    off = rho - splat(r.radius);
    area = rho * splat(r.radius);
    along_u = x * splat(r.ux) + y * splat(r.uy), along_v = x * splat(r.vx) + y * splat(r.vy);
  }

  V dz(V t) const { return low - t * fall; }
  // The position on the first turn that looks at p.
  V facing() const {
    const V a = vatan2(along_v, along_u);
    return select(less(a, splat(0.0)), a + splat(kTwoPi), a);
  }

  // The tool turned by `delta` from there, at t.
  Place place(V t, V delta, V sine, V cosine) const {
    const V zero = splat(0.0), one = splat(1.0);
    // rho^2 + R^2 - 2 area cos, without cancellation.
    const M near = less(zero, cosine);
    const V rise = select(near, sine * sine, one - cosine) / select(near, one + cosine, one);
    const V lateral = vsqrt(off * off + splat(2.0) * area * rise);
    const V slope = select(less(zero, lateral), area * sine / lateral, zero);
    return {delta, lateral - core, dz(t), slope, -fall, cosine, sine};
  }
  // The place at t; in lanes of `ends` it is an end of the path.
  Place place(V t, V delta, V sine, V cosine, const HelixRecord::End& end, M ends) const {
    if (any(ends)) {
      const V s = splat(end.sin), c = splat(end.cos);
      const M axis = less_equal(area, splat(0.0));
      t = select(ends, splat(end.t), t);
      sine = select(ends, select(axis, splat(0.0), (s * along_u - c * along_v) / area), sine);
      cosine = select(ends, select(axis, splat(1.0), (c * along_u + s * along_v) / area), cosine);
    }
    return place(t, delta, sine, cosine);
  }
};

// Half a turn from the position that looks at p, the parameter being the angle from it.
class FallingTurn {
 public:
  FallingTurn(const HelixView& helix, V facing, const Place& first, const Place& last)
      : h_(helix), facing_(facing), first_(first), last_(last) {}

  const Place& first() const { return first_; }
  const Place& last() const { return last_; }

  Place at(V delta) const {
    const VSinCos sc = vsincos(delta);
    return h_.place(facing_ + delta, delta, sc.sin, sc.cos);
  }
  Place at(V delta, const Place& x, M wanted) const {
    constexpr double kShort = 1.0 / 16;  // radians
    const V step = delta - x.t, square = step * step, one = splat(1.0);
    // Taylor series: what is left out is below 1e-16.
    const V k3 = splat(1.0 / 6), k4 = splat(1.0 / 12), k5 = splat(1.0 / 20), k6 = splat(1.0 / 30),
            k7 = splat(1.0 / 42);
    const V sine = step * (one - k3 * square * (one - k5 * square * (one - k7 * square)));
    // 1 - cosine
    const V less_one = splat(0.5) * square * (one - k4 * square * (one - k6 * square));
    VSinCos sc{x.wy - x.wy * less_one + x.wx * sine, x.wx - x.wx * less_one - x.wy * sine};
    const M far = less(splat(kShort * kShort), square);
    if (any(both(wanted, far))) {
      const VSinCos whole = vsincos(delta);
      sc = {select(far, whole.sin, sc.sin), select(far, whole.cos, sc.cos)};
    }
    return h_.place(facing_ + delta, delta, sc.sin, sc.cos);
  }

  // lateral = core: the law of cosines.
  Place rim(const Place& a, const Place& b, M) const {
    const V zero = splat(0.0), two = splat(2.0);
    const V lift = h_.core * h_.core - h_.off * h_.off;  // 2 area (1 - cos)
    const V cosine = splat(1.0) - lift / (two * h_.area);
    const V sine = vsqrt(vmax(lift * (splat(4.0) * h_.area - lift), zero)) / (two * h_.area);
    const V delta = vatan2(sine, cosine);
    Place x = h_.place(facing_ + delta, delta, sine, cosine);
    x.dr = zero;
    return choose(less(a.t, delta), choose(less(delta, b.t), x, b), a);
  }

  Place diagonal(const Place& a, const Place& b, M wanted) const {
    return crossing(*this, a, b, wanted);
  }

  Place ground(const Place& a, const Place& b, M) const {
    const V t = a.t + a.dz / h_.fall;
    const V clamped = select(less(t, a.t), a.t, select(less(b.t, t), b.t, t));
    return choose(less(splat(0.0), h_.fall), at(clamped), b);
  }

  // The slope of (dr^2 + dz^2) / 2, area sin (1 - core / lateral) - fall dz, grows up to a quarter
  // turn and is concave behind it: there is one minimum at most besides the end.
  Place corner(const Place& a, const Place& b, M wanted) const {
    const Place x = stationary(a, b, wanted);
    return choose(less_equal(x.dr * x.dr + x.dz * x.dz, b.dr * b.dr + b.dz * b.dz), x, b);
  }

 private:
  V slope(const Place& x) const { return x.dr * x.dr_slope - h_.fall * x.dz; }
  V bend(const Place& x) const {
    const V zero = splat(0.0), lateral = x.dr + h_.core;
    // area cos, from lateral^2.
    const V along = splat(0.5) * (h_.off * h_.off - lateral * lateral) + h_.area;
    const V second = select(less(zero, lateral), (along - x.dr_slope * x.dr_slope) / lateral, zero);
    return x.dr_slope * x.dr_slope + x.dr * second + h_.fall * h_.fall;
  }
  static M is_last(V step) { return less(step * step, splat(kLastNewtonStep * kLastNewtonStep)); }

  // First zero of the slope at or behind a; b if there is none.
  Place stationary(const Place& a, const Place& b, M wanted) const {
    const V zero = splat(0.0), quarter = splat(kPi / 2);
    M active = except(wanted, less_equal(zero, slope(a)));
    M late = both(active, less_equal(quarter, a.t));  // the zero lies behind a quarter turn
    active = except(active, late);
    Place x = a;
    V low = a.t, high = vmin(quarter, b.t);
    M known = except(active, active);  // slope(high) > 0
    for (int k = 0; k < 60 && any(active); ++k) {
      const V v = slope(x), s = bend(x);
      const M before = less(v, zero);
      low = select(before, x.t, low), high = select(before, high, x.t);
      known = either(known, except(active, before));
      V t = select(less(zero, s), x.t - v / s, high);
      if (const M unsure = except(except(active, less(t, high)), known); any(unsure)) {
        const M whole = less_equal(b.t, high);
        Place end = b;
        if (const M inner = except(unsure, whole); any(inner)) end = choose(inner, at(high), b);
        const M down = both(unsure, less(slope(end), zero));
        x = choose(down, end, x);
        late = either(late, except(down, whole));
        active = except(active, down);
        known = either(known, unsure);
      }
      const M newton = between(low, t, high);
      t = select(newton, t, splat(0.5) * (low + high));
      active = both(active, between(low, t, high));
      if (!any(active)) break;
      const V step = t - x.t;
      x = choose(active, at(t, x, active), x);
      active = except(active, both(newton, is_last(step)));
    }
    return any(late) ? behind(x, b, late) : x;
  }

  // Behind a quarter turn Newton's method climbs a concave slope towards its first zero.
  Place behind(Place x, const Place& b, M active) const {
    for (int k = 0; k < 60; ++k) {
      const V v = slope(x), s = bend(x), step = v / s;
      active = both(active, less(v, splat(0.0)));
      const M next = both(less(splat(0.0), s), less(x.t - step, b.t));
      x = choose(except(active, next), b, x);
      active = both(active, next);
      if (!any(active)) break;
      x = choose(active, at(x.t - step, x, active), x);
      active = except(active, is_last(step));
    }
    return x;
  }

  const HelixView& h_;
  const V facing_;
  const Place first_, last_;
};

struct HelixLeast {
  V distance, t;
};

// The least distance over all positions of the record, and where it lies. None to about five sines.
static inline HelixLeast helix_least(const HelixRecord& r, V px, V py, V pz, M wanted) {
  const V zero = splat(0.0), one = splat(1.0), half = splat(kPi), round = splat(r.round);
  const HelixView helix(r, px, py, pz);
  const V near = vabs(helix.off) - helix.core;
  // No position is lower than the last one.
  const Place last = helix.place(zero, zero, zero, one, r.end, less_equal(zero, zero));
  HelixLeast best{value_of(last, round), splat(r.end.t)};
  const M active =
      both(except(wanted, is_floor(last)), less(slab(near, last.dz, round), best.distance));
  if (!any(active)) return best;
  const V facing = helix.facing();
  for (const double back : {0.0, kTwoPi}) {
    const V look = facing - splat(back);
    const V from = vmax(splat(r.begin.t) - look, zero), to = vmin(half, splat(r.end.t) - look);
    const M found = both(both(active, less_equal(from, to)),
                         less(slab(near, helix.dz(look + to), round), best.distance));
    if (!any(found)) continue;
    const Place first = helix.place(look, from, zero, one, r.begin, less(zero, from));
    const Place stop = helix.place(look + half, to, zero, -one, r.end, less(to, half));
    const Place x = best_place(FallingTurn(helix, look, first, stop), found);
    const V value = value_of(x, round);
    const M closer = both(found, less(value, best.distance));
    best = {select(closer, value, best.distance), select(closer, look + x.t, best.t)};
  }
  return best;
}
