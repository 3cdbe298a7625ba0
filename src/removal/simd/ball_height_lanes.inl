// How low a ball's straight move reaches above a place in plan (V = double), or several: the height
// of its bottom, as Underside has it (docs/history.md, Heights); included once per instruction set.
//
// c: BallSlot, of the lower end of the tip's path; slope >= 0.

struct BallView {
  V u, v;  ///< the place along and across the move, v >= 0
};
MRSIM_LANE BallView ball_view(const double* c, V x, V y) {
  const V dx = x - splat(c[BallSlot::x]), dy = y - splat(c[BallSlot::y]);
  return {dx * splat(c[BallSlot::ux]) + dy * splat(c[BallSlot::uy]),
          vabs(dx * splat(c[BallSlot::uy]) - dy * splat(c[BallSlot::ux]))};
}

/// Where the ball touches, along and before the place: within `reach` of the path.
struct BallContact {
  V e, square;  ///< square: of half the chord of the ball there
  M meets;
};
MRSIM_LANE BallContact ball_touch(const double* c, const BallView& at, double reach) {
  const V zero = splat(0.0);
  const double rise = c[BallSlot::slope] * c[BallSlot::slope];
  const V square = splat(reach * reach) - at.v * at.v, wide = vsqrt(vmax(square, zero));
  const V low = vmax(at.u - splat(c[BallSlot::length]), zero - wide), high = vmin(at.u, wide);
  const V free = vsqrt(splat(rise / (1 + rise)) * vmax(square, zero));
  return {vmin(vmax(free, low), high), square,
          both(less_equal(zero, square), less_equal(low, high))};
}

/// Infinite where the ball does not come.
MRSIM_LANE V ball_low(const double* c, const BallView& at) {
  const BallContact x = ball_touch(c, at, c[BallSlot::radius]);
  const V up = vsqrt(vmax(x.square - x.e * x.e, splat(0.0)));
  return select(
      x.meets,
      splat(c[BallSlot::z] + c[BallSlot::radius]) + splat(c[BallSlot::slope]) * (at.u - x.e) - up,
      splat(std::numeric_limits<double>::infinity()));
}

/// A lower bound of the bottom everywhere within r of the place.
MRSIM_LANE V ball_least(const double* c, const BallView& at, double r) {
  const V zero = splat(0.0), length = splat(c[BallSlot::length]);
  const V lowest = c[BallSlot::slope] > 0 ? zero : vmin(vmax(at.u, zero), length);
  const V near = vmin(vmax(lowest, at.u - splat(r)), at.u + splat(r));
  return ball_low(c, {near, vmax(at.v - splat(r), zero)}) - splat(kRounding);
}

/// An upper bound: the position that touches at the far side of the disc.
MRSIM_LANE V ball_most(const double* c, const BallView& at, double r) {
  const V infinity = splat(std::numeric_limits<double>::infinity());
  if (c[BallSlot::radius] < r) return infinity;
  const BallContact x = ball_touch(c, at, c[BallSlot::radius] - r);
  const V rho = vsqrt(x.e * x.e + at.v * at.v) + splat(r);
  const V up =
      vsqrt(vmax(splat(c[BallSlot::radius] * c[BallSlot::radius]) - rho * rho, splat(0.0)));
  return select(x.meets,
                splat(c[BallSlot::z] + c[BallSlot::radius]) +
                    splat(c[BallSlot::slope]) * (at.u - x.e) - up + splat(kRounding),
                infinity);
}
