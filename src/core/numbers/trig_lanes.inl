// Sines and arc tangents for one number (V = double) or for several at once (V = a SIMD register).
// Included once per instruction set, with V, M and the functions of lane_scalar.h in scope.
//
// Only + - * / min max floor and comparisons, in one written order: every instruction set gives the
// same bits.

struct VSinCos {
  V sin, cos;
};

// Taylor series on |x| <= pi/4: the first term left out is below 1e-18.
MRSIM_LANE V sin_poly(V x) {
  const V q = x * x;
  V s = splat(1.0 / 355687428096000.0);  // 17!
  s = s * q - splat(1.0 / 1307674368000.0);
  s = s * q + splat(1.0 / 6227020800.0);
  s = s * q - splat(1.0 / 39916800.0);
  s = s * q + splat(1.0 / 362880.0);
  s = s * q - splat(1.0 / 5040.0);
  s = s * q + splat(1.0 / 120.0);
  s = s * q - splat(1.0 / 6.0);
  return x + x * q * s;
}

MRSIM_LANE V cos_poly(V x) {
  const V q = x * x;
  V c = splat(1.0 / 20922789888000.0);  // 16!
  c = c * q - splat(1.0 / 87178291200.0);
  c = c * q + splat(1.0 / 479001600.0);
  c = c * q - splat(1.0 / 3628800.0);
  c = c * q + splat(1.0 / 40320.0);
  c = c * q - splat(1.0 / 720.0);
  c = c * q + splat(1.0 / 24.0);
  c = c * q - splat(0.5);
  return splat(1.0) + q * c;
}

// Sine and cosine of reduced + k pi/2. Requires: |reduced| <= pi/4, k whole.
MRSIM_LANE VSinCos quadrant(V reduced, V k) {
  const V s = sin_poly(reduced), c = cos_poly(reduced);
  const V q = k - splat(4.0) * vfloor(splat(0.25) * k);  // 0 to 3
  const M odd = less(vfloor(splat(0.5) * q), splat(0.5) * q);
  const M lower = less_equal(splat(2.0), q), left = less_equal(vabs(q - splat(1.5)), splat(0.5));
  const V sine = select(odd, c, s), cosine = select(odd, s, c);
  return {select(lower, -sine, sine), select(left, -cosine, cosine)};
}

MRSIM_LANE VSinCos vsincos(V angle) {
  // pi/2 in three parts of 33, 33 and 53 bits: k * part is exact for |k| < 2^20 (Cody and Waite).
  constexpr double kPart1 = 1.57079632673412561417e+00, kPart2 = 6.07710050630396597660e-11,
                   kPart3 = 2.02226624879595063154e-21;
  const V k = vfloor(angle / splat(kPi / 2) + splat(0.5));
  return quadrant(((angle - k * splat(kPart1)) - k * splat(kPart2)) - k * splat(kPart3), k);
}

// atan on |t| <= tan(pi/16).
MRSIM_LANE V atan_poly(V t) {
  const V q = t * t;
  V s = splat(0.0);
  for (int n = 23; n >= 3; n -= 2) s = splat((1.0 / n) * ((n / 2) % 2 ? -1.0 : 1.0)) + s * q;
  return t + t * q * s;
}

// atan on [0, 1], shifted to the nearest of 0, pi/8, pi/4 by the addition theorem.
MRSIM_LANE V atan_unit(V t) {
  constexpr double kTan8 = 0.41421356237309504880;
  const V zero = splat(0.0), one = splat(1.0);
  const M low = less(t, splat(0.19891236737965800691)),
          mid = less(t, splat(0.66817863791929891999));
  const V shift = select(low, zero, select(mid, splat(kTan8), one));
  const V base = select(low, zero, select(mid, splat(kPi / 8), splat(kPi / 4)));
  return base + atan_poly((t - shift) / (one + t * shift));
}

MRSIM_LANE V vatan2(V y, V x) {
  const V zero = splat(0.0), ax = select(less(x, zero), -x, x), ay = select(less(y, zero), -y, y);
  const M flat = less_equal(ay, ax);
  const V most = vmax(ax, ay);
  const V unit = atan_unit(select(flat, ay, ax) / most);
  V a = select(flat, unit, splat(kPi / 2) - unit);
  a = select(less(x, zero), splat(kPi) - a, a);
  a = select(less(y, zero), -a, a);
  return select(less(zero, most), a, zero);
}
