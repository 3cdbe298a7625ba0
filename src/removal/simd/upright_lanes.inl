// An arc in an upright plane within a quarter of its circle, for one point (V = double) or several;
// included once per instruction set after falling_lanes.inl.
//
// In the arc's plane x lies on the ground and z up, both about the centre, the quarter at x >= 0.
// It is a stretch from the position nearest to p in plan towards its lower end: the other way the
// tool moves off and rises. Positions are unit vectors, by the tangent of half an angle: no sines.

// The columns of UprightRecord.
struct UprightColumn {
  enum : std::size_t {
    x,
    y,
    z,
    along_x,
    along_y,
    radius,
    high_x,
    high_y,
    low_x,
    low_y,
    core,
    round
  };
  static constexpr std::size_t half = round + 1, kCount = half + 1;
};

class UprightStretch {
 public:
  /// Where the least distance is above `limit`, the place is any one whose distance is above
  /// `limit`, too.
  UprightStretch(const V* c, V px, V py, V pz, V limit)
      : radius_(c[UprightColumn::radius]),
        core_(c[UprightColumn::core]),
        half_(c[UprightColumn::half]),
        below_(less(half_, splat(0.0))),
        last_step_(splat(kPlace) * core_ / (radius_ * radius_)),
        reach_(limit + c[UprightColumn::round]) {
    using C = UprightColumn;
    const V zero = splat(0.0), one = splat(1.0);
    const V wx = px - c[C::x], wy = py - c[C::y];
    x_ = wx * c[C::along_x] + wy * c[C::along_y];
    beside_ = vabs(wy * c[C::along_x] - wx * c[C::along_y]);
    z_ = pz - c[C::z] - c[C::round];
    // The position that looks at p, or the end that is nearer to it in plan.
    const V x = half_ * (x_ / radius_), u = vmin(vmax(x_ / radius_, zero), one);
    const M high = less_equal(x, half_ * c[C::high_x]), low = less_equal(half_ * c[C::low_x], x);
    const V facing_y = half_ * vsqrt(one - u * u);
    first_ = place(select(high, c[C::high_x], select(low, c[C::low_x], u)),
                   select(high, c[C::high_y], select(low, c[C::low_y], facing_y)));
    last_ = place(c[C::low_x], c[C::low_y]);
  }

  const Place& first() const { return first_; }
  const Place& last() const { return last_; }
  Place at(V t, const Place&, M) const { return at(t); }

  Place rim(const Place& a, const Place& b, M) const {
    const V zero = splat(0.0);
    const V reach = half_ * vsqrt(vmax(core_ * core_ - beside_ * beside_, zero));
    const V u = vmin(vmax((x_ + reach) / radius_, zero), splat(1.0));
    return within(a, b, u, half_ * vsqrt(splat(1.0) - u * u));
  }
  Place diagonal(const Place& a, const Place& b, M wanted) const {
    return crossing(*this, a, b, wanted);
  }
  Place ground(const Place& a, const Place& b, M) const {
    const V z = z_ / radius_;
    return within(a, b, vsqrt(vmax(splat(1.0) - z * z, splat(0.0))), z);
  }
  Place corner(const Place& a, const Place& b, M wanted) const {
    wanted = except(wanted, less(reach_, splat(0.0)));
    Place x = a;
    if (const M some = except(wanted, below_); any(some)) x = stationary_above(a, b, some);
    if (const M some = both(wanted, below_); any(some))
      x = choose(some, stationary_below(a, b, some), x);
    const Place end = choose(less(squared(a), squared(b)), a, b);
    return choose(less(squared(x), squared(end)), x, end);
  }

 private:
  // Grows on the way down: the tangent of half the angle from the highest place, or, below, less
  // that of half the angle from the lowest one.
  V parameter(V wx, V wy) const { return half_ * wx / (splat(1.0) + half_ * wy); }
  Place place(V wx, V wy, V t, V turning) const {
    const V zero = splat(0.0);
    const V x = radius_ * wx, z = radius_ * wy, away = x - x_;
    const V lateral = vsqrt(away * away + beside_ * beside_);
    const V slope = select(less(zero, lateral), turning * z * away / lateral, zero);
    return {t, lateral - core_, z - z_, slope, zero - turning * x, wx, wy};
  }
  Place place(V wx, V wy) const {
    const V t = parameter(wx, wy);
    return place(wx, wy, t, splat(2.0) / (splat(1.0) + t * t));
  }
  Place at(V t) const {
    const V one = splat(1.0), inverse = one / (one + t * t), cosine = (one - t * t) * inverse;
    return place(half_ * (splat(2.0) * t * inverse), half_ * cosine, t, splat(2.0) * inverse);
  }
  Place within(const Place& a, const Place& b, V wx, V wy) const {
    const V t = parameter(wx, wy);
    const Place x = place(wx, wy, t, splat(2.0) / (splat(1.0) + t * t));
    return choose(less(a.t, t), choose(less(t, b.t), x, b), a);
  }

  // dr^2 + dz^2, and half its slope.
  static V squared(const Place& at) { return at.dr * at.dr + at.dz * at.dz; }
  static V slope_at(const Place& at) { return at.dr * at.dr_slope + at.dz * at.dz_slope; }

  // How the corner leans: away / lateral, and its slope in x.
  struct Lean {
    V value, slope;
  };
  Lean lean(V away) const {
    const V zero = splat(0.0), lateral = vsqrt(away * away + beside_ * beside_);
    const M some = less(zero, lateral);
    const V inverse = splat(1.0) / select(some, lateral, splat(1.0)), across = beside_ * inverse;
    return {select(some, away * inverse, zero), select(some, across * across * inverse, zero)};
  }
  // x of p with core times the lean that the corner has where it touches p, or, where it cannot,
  // that of b. With this fixed lean G is zero in the direction (x, z), and nearly so with its own.
  V leaning(const Place& b) const {
    const V square = core_ * core_ - beside_ * beside_;
    const M touches = less(splat(0.0), square);
    return x_ + select(touches, half_ * vsqrt(vmax(square, splat(0.0))),
                       core_ * lean(radius_ * b.wx - x_).value);
  }

  // Above: half the slope of dr^2 + dz^2 by x is G = z T - x - core lean, with T the tangent of the
  // angle from the highest place. For p above the centre it is convex in T, and its last zero is
  // the minimum; Newton's method falls on it from above.
  struct Slope {
    V value, slope;  // by T
  };
  Slope slope_above(V tangent) const {
    const V one = splat(1.0), cosine = one / vsqrt(one + tangent * tangent);
    const Lean l = lean(radius_ * tangent * cosine - x_);
    return {z_ * tangent - x_ - core_ * l.value,
            z_ - core_ * l.slope * radius_ * cosine * cosine * cosine};
  }
  Place stationary_above(const Place& a, const Place& b, M wanted) const {
    const V zero = splat(0.0), one = splat(1.0);
    M active = both(wanted, less(zero, z_));
    V tangent = (x_ + core_ * lean(radius_ * b.wx - x_).value) / select(active, z_, one);
    M found = both(active, less(zero, tangent));
    const M at_end = both(found, less_equal(b.wx, tangent * b.wy));
    found = except(found, at_end);
    active = found;
    // The zero is mostly near that of a fixed lean. Before it a step leads beyond it, G being
    // convex.
    if (any(active)) {
      const V near = leaning(b) / z_;
      const Slope s = slope_above(near);
      const V step = near - vmin(s.value, zero) / select(less(zero, s.slope), s.slope, one);
      const M nearer = both(both(active, less(zero, s.slope)), between(zero, step, tangent));
      tangent = select(nearer, step, tangent);
    }
    for (int k = 0; k < 60 && any(active); ++k) {
      const Slope s = slope_above(tangent);
      active = both(active, both(less(zero, s.value), less(zero, s.slope)));
      const V step = s.value / s.slope;
      tangent = select(active, tangent - step, tangent);
      found = except(found, less_equal(tangent, zero));
      active = both(both(active, found),
                    less_equal(last_step_ * (one + tangent) * (one + tangent), step * step));
    }
    const V cosine = one / vsqrt(one + tangent * tangent), t = tangent * cosine / (one + cosine);
    Place x = choose(at_end, b, a);
    if (const M inner = both(found, less(a.t, t)); any(inner)) x = choose(inner, at(t), x);
    return x;
  }

  // Below, dr and dz are convex in x, and so is dr^2 + dz^2 where both are positive: one zero. It
  // is that of G in h = -t, which falls on the way down.
  Place stationary_below(const Place& a, const Place& b, M wanted) const {
    const V zero = splat(0.0), one = splat(1.0), two = splat(2.0);
    const M before = less_equal(zero, slope_at(a)), behind = less_equal(slope_at(b), zero);
    M active = except(except(wanted, before), behind);
    const M found = active;
    V low = zero - b.t, high = zero - a.t;
    const V near = leaning(b);
    V h = near / (vsqrt(near * near + z_ * z_) - z_);
    h = select(between(low, h, high), h, splat(0.5) * (low + high));
    for (int k = 0; k < 60 && any(active); ++k) {
      const V rest = one - h * h, size = one / (one + h * h);
      const Lean l = lean(radius_ * two * h * size - x_);
      const V reach = x_ + core_ * l.value, run = two * radius_ * rest * size * size;
      const V v = zero - two * z_ * h - rest * reach;
      const V s = two * h * reach - two * z_ - rest * core_ * l.slope * run;
      const M over = less(zero, v);
      high = select(over, h, high), low = select(over, low, h);
      V next = select(less(zero, s), h - v / s, low);
      next = select(between(low, next, high), next, splat(0.5) * (low + high));
      active = both(active, between(low, next, high));
      const V step = next - h;
      h = select(active, next, h);
      active = both(active, less_equal(last_step_, step * step));
    }
    return choose(found, at(zero - h), choose(before, a, b));
  }

  // mm: error of the place after the last step of Newton's method, whose square is left, times
  // about the radius over the core, along which the lean changes.
  static constexpr double kPlace = 1e-13;

  V radius_, core_, half_;
  M below_;
  V last_step_;       // squared
  V reach_;           // from the flat core
  V x_, beside_, z_;  // of p; z of the plane that bounds the flat core
  Place first_, last_;
};

struct UprightLeast {
  V distance;
  Place at;
};
/// The least distance and its place. A distance above `limit` only means *above limit*.
static inline UprightLeast upright_least(const V* c, V px, V py, V pz, V limit, M wanted) {
  limit = limit + splat(kBoundError);
  const UprightStretch stretch(c, px, py, pz, limit);
  const V round = c[UprightColumn::round];
  const V bound = lower_bound(stretch.first(), stretch.last(), round);
  const M active = both(wanted, less_equal(bound, limit));
  if (!any(active)) return {bound, stretch.last()};
  const Place x = best_place(stretch, active);
  return {select(active, value_of(x, round), bound), x};
}
