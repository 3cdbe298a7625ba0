// A slanted line, for one point (V = double) or several; included once per instruction set after
// falling_lanes.inl.
//
// Of the positions above the one nearest to p in plan none is better: they are higher and no
// nearer. From that position down to the lower end the tool moves away from p in plan and falls: a
// stretch. Its parameter is the way along the line, so that no slope is above 1.

/// A lower bound (up to 1e-8 mm) of the distance: the tool's core stays within its radius of the
/// line, in plan and across it, above its lower end, and above the plane along the line that its
/// rim touches at the back. Of both pairs the directions are at right angles. `c` are the columns
/// of SlantRecord.
MRSIM_LANE V slant_bound(const V* c, V px, V py, V pz) {
  using C = SlantColumn;
  const V ux = c[C::ux], uy = c[C::uy], length = c[C::length], plan = c[C::plan], rise = c[C::rise];
  const V core = c[C::core], round = c[C::round];
  const V zero = splat(0.0);
  const V dx = px - c[C::x], dy = py - c[C::y], below = c[C::z] - pz;
  const V along = dx * ux + dy * uy, off = dx * uy - dy * ux;
  const V beyond = along - vmin(vmax(along, zero), length * plan);
  const V aside = vsqrt(off * off + beyond * beyond) - core, across = vabs(off) - core;
  const V under = plan * below + rise * (along - core);
  const auto corner = [&](V lateral, V upright) {
    const V a = vmax(lateral, zero), b = vmax(upright, zero);
    return a * a + b * b;
  };
  const V square = vmax(corner(aside, below), corner(across, under));
  const V inside = vmax(vmax(aside, under), below);
  return select(less(zero, square), vsqrt(square), inside) - round;
}

class SlantStretch {
 public:
  SlantStretch(const SlantRecord& r, V px, V py, V pz)
      : core_(splat(r.core)), plan_(splat(r.plan)), rise_(splat(r.rise)) {
    const V zero = splat(0.0), end = splat(r.length * r.plan);
    const V dx = px - splat(r.x), dy = py - splat(r.y);
    const V along = dx * splat(r.ux) + dy * splat(r.uy);
    const V off = dx * splat(r.uy) - dy * splat(r.ux);
    const V foot = vmin(vmax(along, zero), end);
    square_ = off * off;
    way_ = select(less(along, end), foot / plan_, splat(r.length));
    from_ = along - foot;
    low_ = splat(r.z) - pz;
    high_ = low_ + rise_ * way_;
    first_ = place(zero, from_, high_);
    last_ = place(way_, along, low_);
  }

  const Place& first() const { return first_; }
  const Place& last() const { return last_; }
  /// Way from the lower end.
  V height_way(V t) const { return way_ - t; }

  Place at(V t) const { return place(t, from_ + plan_ * t, high_ - rise_ * t); }
  Place at(V t, const Place&, M) const { return at(t); }

  Place rim(const Place& a, const Place& b, M) const {
    const V zero = splat(0.0);
    const V t = (vsqrt(vmax(core_ * core_ - square_, zero)) - from_) / plan_;
    Place x = at(t);
    x.dr = zero;
    return choose(less(a.t, t), choose(less(t, b.t), x, b), a);
  }

  Place ground(const Place& a, const Place& b, M) const {
    const V t = a.t + a.dz / rise_;
    const V clamped = select(less(t, a.t), a.t, select(less(b.t, t), b.t, t));
    return choose(less(splat(0.0), rise_), at(clamped), b);
  }

  // lateral = core + dz is a quadratic equation of t, whose first root is wanted.
  Place diagonal(const Place& a, const Place& b, M) const {
    const V zero = splat(0.0), reach = core_ + high_;
    const V square = plan_ * plan_ - rise_ * rise_;
    const V half = from_ * plan_ + reach * rise_, rest = from_ * from_ + square_ - reach * reach;
    const V divisor = half + vsqrt(vmax(half * half - square * rest, zero));
    const V t = select(less(zero, divisor), (zero - rest) / divisor, a.t);
    return at(select(less(t, a.t), a.t, select(less(b.t, t), b.t, t)));
  }

  // dr^2 + dz^2 is convex where dr >= 0: Newton's method, halving where it leaves the bracket.
  Place corner(const Place& a, const Place& b, M wanted) const {
    const V zero = splat(0.0);
    Place x = choose(less(zero, slope(b)), a, b);
    M active = except(except(wanted, less_equal(zero, slope(a))), less_equal(slope(b), zero));
    x = choose(less_equal(zero, slope(a)), a, x);
    V low = a.t, high = b.t;
    for (int k = 0; k < 60 && any(active); ++k) {
      const V v = slope(x), s = bend(x);
      const M before = less(v, zero);
      low = select(before, x.t, low), high = select(before, high, x.t);
      V t = select(less(zero, s), x.t - v / s, high);
      const M newton = between(low, t, high);
      t = select(newton, t, splat(0.5) * (low + high));
      active = both(active, between(low, t, high));
      if (!any(active)) break;
      const V step = t - x.t;
      x = choose(active, at(t), x);
      active =
          except(active, both(newton, less(step * step, splat(kLastNewtonStep * kLastNewtonStep))));
    }
    return x;
  }

 private:
  Place place(V t, V along, V dz) const {
    const V zero = splat(0.0), lateral = vsqrt(along * along + square_);
    const V slope = select(less(zero, lateral), plan_ * along / lateral, zero);
    return {t, lateral - core_, dz, slope, zero - rise_, zero, zero};
  }
  V slope(const Place& x) const { return x.dr * x.dr_slope - rise_ * x.dz; }
  V bend(const Place& x) const {
    const V zero = splat(0.0), lateral = x.dr + core_;
    const V second =
        select(less(zero, lateral), (plan_ * plan_ - x.dr_slope * x.dr_slope) / lateral, zero);
    return x.dr_slope * x.dr_slope + x.dr * second + rise_ * rise_;
  }

  V core_, plan_, rise_;
  V square_;      // of the distance across the line in plan
  V way_;         // from the first position to the lower end
  V from_;        // how far p lies before the first position, in plan
  V low_, high_;  // dz at both ends
  Place first_, last_;
};

struct SlantLeast {
  V distance, way;  // way: from the lower end
};
static inline SlantLeast slant_least(const SlantStretch& s, V round, M wanted) {
  const Place x = best_place(s, wanted);
  return {value_of(x, round), s.height_way(x.t)};
}
