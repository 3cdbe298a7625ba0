// The closed forms of the commonest sweeps, for one point and one sweep (V = double) or for several
// at once (V = a SIMD register). Included once per instruction set by sweep_kernels.cpp with V, M
// (the mask of a comparison), splat, vmin, vmax, vsqrt, vabs, less_equal and select in scope.
//
// Only + - * / sqrt min max and comparisons, in one written order: every instruction set gives the
// same bits.

// Cutter with a flat, rounded or ball end and a flat top: a disc of radius `core` with its centre
// at height `low`, thickened by `round`, cut off at `top` (infinite: reaching up); seen at lateral
// distance rho. Requires: height >= 2 round, so that the upper half knows only wall and top.
MRSIM_LANE V slab(V dr, V dz, V round) {
  const V zero = splat(0.0);
  const V a = vmax(dr, zero), b = vmax(dz, zero);
  return vsqrt(a * a + b * b) + vmin(vmax(dr, dz), zero) - round;
}
struct SlabSide {
  V core, dz, round;  // of the half that is nearer in height
};
MRSIM_LANE SlabSide slab_side(V z, V low, V core, V round, V top) {
  const M upper = less_equal(splat(0.5) * (low - round + top), z);
  return {select(upper, core + round, core), select(upper, z - top, low - z),
          select(upper, splat(0.0), round)};
}
MRSIM_LANE V rounded_slab(V rho, V z, V low, V core, V round, V top) {
  const SlabSide side = slab_side(z, low, core, round, top);
  return slab(rho - side.core, side.dz, side.round);
}

// Ball end reaching up, any straight line: distance to the segment's upward strip, minus R.
// c = ax ay az (ball centre at the start), ux uy (unit horizontal direction), length in plan,
// slope, R.
struct StripFoot {
  V squared;  // distance to the strip, squared
  V along;    // horizontal parameter of the foot
  V z;        // height of the foot
};
MRSIM_LANE V strip_scale(V slope) { return splat(1.0) / (splat(1.0) + slope * slope); }
MRSIM_LANE StripFoot strip_foot(const V* c, V scale, V px, V py, V pz) {
  const V zero = splat(0.0);
  const V dx = px - c[0], dy = py - c[1], w = pz - c[2];
  const V u = dx * c[3] + dy * c[4], v = dx * c[4] - dy * c[3];
  const V uc = vmin(vmax(u, zero), c[5]), du = u - uc;
  const V t = vmin(vmax((u + c[6] * w) * scale, zero), c[5]);
  const V eu = u - t, ew = w - c[6] * t;
  const M above = less_equal(c[6] * uc, w);
  return {v * v + select(above, du * du, eu * eu + ew * ew), select(above, uc, t),
          select(above, pz, c[2] + c[6] * t)};
}
MRSIM_LANE V ball_line(const V* c, V px, V py, V pz) {
  return vsqrt(strip_foot(c, strip_scale(c[6]), px, py, pz).squared) - c[7];
}

// Horizontal line: foot in plan on the segment, as a vector and the path's parameter in [0, 1].
// c = ax ay dx dy (from start to end), low core round top. An upright move has d = 0.
struct PlanLineFoot {
  V squared, t;
};
MRSIM_LANE PlanLineFoot line_foot(const V* c, V px, V py) {
  const V zero = splat(0.0), one = splat(1.0);
  const V dx = px - c[0], dy = py - c[1];
  const V size = c[2] * c[2] + c[3] * c[3];
  const V t = vmin(vmax((dx * c[2] + dy * c[3]) / vmax(size, splat(1e-300)), zero), one);
  const V ex = dx - t * c[2], ey = dy - t * c[3];
  return {ex * ex + ey * ey, t};
}
MRSIM_LANE V line_rho(const V* c, V px, V py) { return vsqrt(line_foot(c, px, py).squared); }
MRSIM_LANE V plane_line(const V* c, V px, V py, V pz) {
  return rounded_slab(line_rho(c, px, py), pz, c[4], c[5], c[6], c[7]);
}

// Horizontal arc of up to a full turn: distance in plan to the arc, folded about its middle.
// c = cx cy R mx my (unit vector to the middle) cos sin (of half the sweep), low core round top.
MRSIM_LANE V arc_rho(const V* c, V px, V py) {
  const V dx = px - c[0], dy = py - c[1];
  const V a = dx * c[3] + dy * c[4], b = vabs(dx * c[4] - dy * c[3]);
  const V ea = a - c[2] * c[5], eb = b - c[2] * c[6];
  const V within = vabs(vsqrt(dx * dx + dy * dy) - c[2]);
  const V beyond = vsqrt(ea * ea + eb * eb);
  return select(less_equal(c[5] * b - c[6] * a, splat(0.0)), within, beyond);
}
MRSIM_LANE V plane_arc(const V* c, V px, V py, V pz) {
  return rounded_slab(arc_rho(c, px, py), pz, c[7], c[8], c[9], c[10]);
}

// Lowest whole turn of a helix: over it some position looks at p, and no other is nearer in plan.
// Where the mill is as far from p at its highest tip as at its lowest one, that position is the
// best, whatever its height: the bore's wall decides.
// c = cx cy R core round, low at the first and at the last position.
struct Bore {
  V distance;
  M decided;
};
MRSIM_LANE Bore bore(const V* c, V px, V py, V pz) {
  const V dx = px - c[0], dy = py - c[1];
  const V dr = vabs(vsqrt(dx * dx + dy * dy) - c[2]) - c[3];
  const V last = slab(dr, c[6] - pz, c[4]);
  return {last, less_equal(slab(dr, c[5] - pz, c[4]), last)};
}
