// How low a ball's straight move reaches above a place in plan (V = double), or several: the height
// of its bottom, as Underside has it (docs/history.md, Heights); included once per instruction set.
//
// c: lower end of the tip's path x y z, unit direction ux uy and length in plan, slope >= 0,
// radius.

struct BallView {
  V u, v;  ///< the place along and across the move, v >= 0
};
MRSIM_LANE BallView ball_view(const double* c, V x, V y) {
  const V dx = x - splat(c[0]), dy = y - splat(c[1]);
  return {dx * splat(c[3]) + dy * splat(c[4]), vabs(dx * splat(c[4]) - dy * splat(c[3]))};
}

/// Where the ball touches, along and before the place: within `reach` of the path.
struct BallContact {
  V e, square;  ///< square: of half the chord of the ball there
  M meets;
};
MRSIM_LANE BallContact ball_touch(const double* c, const BallView& at, double reach) {
  const V zero = splat(0.0);
  const double rise = c[6] * c[6];
  const V square = splat(reach * reach) - at.v * at.v, wide = vsqrt(vmax(square, zero));
  const V low = vmax(at.u - splat(c[5]), zero - wide), high = vmin(at.u, wide);
  const V free = vsqrt(splat(rise / (1 + rise)) * vmax(square, zero));
  return {vmin(vmax(free, low), high), square,
          both(less_equal(zero, square), less_equal(low, high))};
}

/// Infinite where the ball does not come.
MRSIM_LANE V ball_low(const double* c, const BallView& at) {
  const BallContact x = ball_touch(c, at, c[7]);
  const V up = vsqrt(vmax(x.square - x.e * x.e, splat(0.0)));
  return select(x.meets, splat(c[2] + c[7]) + splat(c[6]) * (at.u - x.e) - up,
                splat(std::numeric_limits<double>::infinity()));
}

/// Not above the bottom anywhere within r of the place.
MRSIM_LANE V ball_least(const double* c, const BallView& at, double r) {
  const V zero = splat(0.0), length = splat(c[5]);
  const V lowest = c[6] > 0 ? zero : vmin(vmax(at.u, zero), length);
  const V near = vmin(vmax(lowest, at.u - splat(r)), at.u + splat(r));
  return ball_low(c, {near, vmax(at.v - splat(r), zero)}) - splat(1e-9);
}

/// Not below it: the position that touches at the far side of the disc.
MRSIM_LANE V ball_most(const double* c, const BallView& at, double r) {
  const V infinity = splat(std::numeric_limits<double>::infinity());
  if (c[7] < r) return infinity;
  const BallContact x = ball_touch(c, at, c[7] - r);
  const V rho = vsqrt(x.e * x.e + at.v * at.v) + splat(r);
  const V up = vsqrt(vmax(splat(c[7] * c[7]) - rho * rho, splat(0.0)));
  return select(x.meets, splat(c[2] + c[7]) + splat(c[6]) * (at.u - x.e) - up + splat(1e-9),
                infinity);
}
