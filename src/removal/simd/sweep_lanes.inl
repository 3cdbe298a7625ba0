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
// c: BallSlot.
struct StripFoot {
  V squared;  // distance to the strip, squared
  V along;    // horizontal parameter of the foot
  V z;        // height of the foot
};
MRSIM_LANE V strip_scale(V slope) { return splat(1.0) / (splat(1.0) + slope * slope); }
MRSIM_LANE StripFoot strip_foot(const V* c, V scale, V px, V py, V pz) {
  const V zero = splat(0.0);
  const V dx = px - c[BallSlot::x], dy = py - c[BallSlot::y], w = pz - c[BallSlot::z];
  const V u = dx * c[BallSlot::ux] + dy * c[BallSlot::uy],
          v = dx * c[BallSlot::uy] - dy * c[BallSlot::ux];
  const V uc = vmin(vmax(u, zero), c[BallSlot::length]), du = u - uc;
  const V t = vmin(vmax((u + c[BallSlot::slope] * w) * scale, zero), c[BallSlot::length]);
  const V eu = u - t, ew = w - c[BallSlot::slope] * t;
  const M above = less_equal(c[BallSlot::slope] * uc, w);
  return {v * v + select(above, du * du, eu * eu + ew * ew), select(above, uc, t),
          select(above, pz, c[BallSlot::z] + c[BallSlot::slope] * t)};
}
MRSIM_LANE V ball_line(const V* c, V px, V py, V pz) {
  return vsqrt(strip_foot(c, strip_scale(c[BallSlot::slope]), px, py, pz).squared) -
         c[BallSlot::radius];
}

// Horizontal line: foot in plan on the segment, as a vector and the path's parameter in [0, 1].
// c: LineSlot. An upright move has dx = dy = 0.
struct PlanLineFoot {
  V squared, t;
};
MRSIM_LANE PlanLineFoot line_foot(const V* c, V px, V py) {
  const V zero = splat(0.0), one = splat(1.0);
  const V dx = px - c[LineSlot::x], dy = py - c[LineSlot::y];
  const V size = c[LineSlot::dx] * c[LineSlot::dx] + c[LineSlot::dy] * c[LineSlot::dy];
  const V t = vmin(
      vmax((dx * c[LineSlot::dx] + dy * c[LineSlot::dy]) / vmax(size, splat(kNoDivisor)), zero),
      one);
  const V ex = dx - t * c[LineSlot::dx], ey = dy - t * c[LineSlot::dy];
  return {ex * ex + ey * ey, t};
}
MRSIM_LANE V line_rho(const V* c, V px, V py) { return vsqrt(line_foot(c, px, py).squared); }
MRSIM_LANE V plane_line(const V* c, V px, V py, V pz) {
  return rounded_slab(line_rho(c, px, py), pz, c[LineSlot::low], c[LineSlot::core],
                      c[LineSlot::round], c[LineSlot::top]);
}

// Horizontal arc of up to a full turn: distance in plan to the arc, folded about its middle.
// c: ArcSlot.
MRSIM_LANE V arc_rho(const V* c, V px, V py) {
  const V dx = px - c[ArcSlot::x], dy = py - c[ArcSlot::y];
  const V a = dx * c[ArcSlot::mx] + dy * c[ArcSlot::my],
          b = vabs(dx * c[ArcSlot::my] - dy * c[ArcSlot::mx]);
  const V ea = a - c[ArcSlot::radius] * c[ArcSlot::cosine],
          eb = b - c[ArcSlot::radius] * c[ArcSlot::sine];
  const V within = vabs(vsqrt(dx * dx + dy * dy) - c[ArcSlot::radius]);
  const V beyond = vsqrt(ea * ea + eb * eb);
  return select(less_equal(c[ArcSlot::cosine] * b - c[ArcSlot::sine] * a, splat(0.0)), within,
                beyond);
}
MRSIM_LANE V plane_arc(const V* c, V px, V py, V pz) {
  return rounded_slab(arc_rho(c, px, py), pz, c[ArcSlot::low], c[ArcSlot::core], c[ArcSlot::round],
                      c[ArcSlot::top]);
}

// Lowest turn of a helix. The mill at the height of its lowest tip, all around the axis, holds what
// the turn cuts, so that no point is nearer to the turn than to that. Over a whole turn some
// position looks at p, and no other is nearer in plan: where the mill is as far from p at its
// highest tip as at its lowest one, that position is the best, whatever its height, and the bore's
// wall decides.
// c: BoreSlot.
struct Bore {
  V distance;  // a lower bound; the turn's own where `decided`
  M decided;
};
MRSIM_LANE Bore bore(const V* c, V px, V py, V pz) {
  const V dx = px - c[BoreSlot::x], dy = py - c[BoreSlot::y];
  const V dr = vabs(vsqrt(dx * dx + dy * dy) - c[BoreSlot::radius]) - c[BoreSlot::core];
  const V last = slab(dr, c[BoreSlot::last_low] - pz, c[BoreSlot::round]);
  const V first = slab(dr, c[BoreSlot::first_low] - pz, c[BoreSlot::round]);
  return {last, both(less_equal(first, last), less(splat(0.0), c[BoreSlot::whole]))};
}
