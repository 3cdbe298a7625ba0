// The closed forms of the commonest sweeps, for one point and one sweep (V = double) or for several
// at once (V = a SIMD register). Included once per instruction set by sweep_kernels.cpp with V, M
// (the mask of a comparison), splat, vmin, vmax, vsqrt, vabs, less_equal and select in scope.
//
// Only + - * / sqrt min max and comparisons, in one written order: every instruction set gives the
// same bits.

// Disc of radius `core` with its centre at height `low`, thickened by `round`, reaching up; seen
// at lateral distance rho.
MRSIM_LANE V rounded_quadrant(V rho, V z, V low, V core, V round) {
  const V zero = splat(0.0);
  const V dr = rho - core, dz = low - z;
  const V a = vmax(dr, zero), b = vmax(dz, zero);
  return vsqrt(a * a + b * b) + vmin(vmax(dr, dz), zero) - round;
}

// Ball end reaching up, any straight line: distance to the segment's upward strip, minus R.
// c = ax ay az (ball centre at the start), ux uy (unit horizontal direction), length in plan,
// slope, R.
struct StripFoot {
  V squared;  // distance to the strip, squared
  V along;    // horizontal parameter of the foot
  V z;        // height of the foot
};
MRSIM_LANE StripFoot strip_foot(const V* c, V px, V py, V pz) {
  const V zero = splat(0.0), one = splat(1.0);
  const V dx = px - c[0], dy = py - c[1], w = pz - c[2];
  const V u = dx * c[3] + dy * c[4], v = dx * c[4] - dy * c[3];
  const V uc = vmin(vmax(u, zero), c[5]), du = u - uc;
  const V t = vmin(vmax((u + c[6] * w) / (one + c[6] * c[6]), zero), c[5]);
  const V eu = u - t, ew = w - c[6] * t;
  const M above = less_equal(c[6] * uc, w);
  return {v * v + select(above, du * du, eu * eu + ew * ew), select(above, uc, t),
          select(above, pz, c[2] + c[6] * t)};
}
MRSIM_LANE V ball_line(const V* c, V px, V py, V pz) {
  return vsqrt(strip_foot(c, px, py, pz).squared) - c[7];
}

// Horizontal line: distance in plan to the segment.
// c = ax ay ux uy length, low core round.
MRSIM_LANE V line_rho(const V* c, V px, V py) {
  const V zero = splat(0.0);
  const V dx = px - c[0], dy = py - c[1];
  const V u = dx * c[2] + dy * c[3], v = dx * c[3] - dy * c[2];
  const V du = u - vmin(vmax(u, zero), c[4]);
  return vsqrt(du * du + v * v);
}
MRSIM_LANE V plane_line(const V* c, V px, V py, V pz) {
  return rounded_quadrant(line_rho(c, px, py), pz, c[5], c[6], c[7]);
}

// Horizontal arc of up to a full turn: distance in plan to the arc, folded about its middle.
// c = cx cy R mx my (unit vector to the middle) cos sin (of half the sweep), low core round.
MRSIM_LANE V arc_rho(const V* c, V px, V py) {
  const V dx = px - c[0], dy = py - c[1];
  const V a = dx * c[3] + dy * c[4], b = vabs(dx * c[4] - dy * c[3]);
  const V ea = a - c[2] * c[5], eb = b - c[2] * c[6];
  const V within = vabs(vsqrt(dx * dx + dy * dy) - c[2]);
  const V beyond = vsqrt(ea * ea + eb * eb);
  return select(less_equal(c[5] * b - c[6] * a, splat(0.0)), within, beyond);
}
MRSIM_LANE V plane_arc(const V* c, V px, V py, V pz) {
  return rounded_quadrant(arc_rho(c, px, py), pz, c[7], c[8], c[9]);
}
