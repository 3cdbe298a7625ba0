// The distance from a tool's outline, for one point (V = double) or several. Goes edge by edge, as
// Profile::distance does, and gives the same bits. Included once per instruction set after
// falling_lanes.inl.

MRSIM_LANE M select_mask(M m, M a, M b) { return either(both(m, a), except(b, m)); }

// Whether a point at (x, y) from an end of the edge, where it is nearest, lies outside.
MRSIM_LANE M beyond_end(const OutlineEdge::End& end, V x, V y, M smooth) {
  if (end.corner == OutlineEdge::End::Corner::smooth) return smooth;
  const V zero = splat(0.0);
  const M own = less(zero, splat(end.own_x) * x + splat(end.own_y) * y);
  const M other = less(zero, splat(end.other_x) * x + splat(end.other_y) * y);
  return end.corner == OutlineEdge::End::Corner::convex ? either(own, other) : both(own, other);
}

struct OutlineFoot {
  V distance;  // not below 0
  M outside;
};

// `side` is the signed distance from the edge's whole line or circle. It counts where the point
// lies between both ends of the edge (`inside`). Elsewhere an end counts: a where `at_a`, else b.
MRSIM_LANE OutlineFoot outline_foot(const OutlineEdge& e, V ax, V ay, V bx, V by, V side, M inside,
                                    M at_a) {
  const V to_a = ax * ax + ay * ay, to_b = bx * bx + by * by;
  const M beside = less(splat(0.0), side);
  const M ends =
      select_mask(at_a, beyond_end(e.at_a, ax, ay, beside), beyond_end(e.at_b, bx, by, beside));
  return {select(inside, vabs(side), vsqrt(select(at_a, to_a, to_b))),
          select_mask(inside, beside, ends)};
}

MRSIM_LANE OutlineFoot line_foot_of(const OutlineEdge& e, V r, V z) {
  const V ax = r - splat(e.ax), ay = z - splat(e.ay), dx = splat(e.dx), dy = splat(e.dy);
  const V t = ax * dx + ay * dy;
  const M at_a = less_equal(t, splat(0.0)), at_b = less_equal(splat(e.length), t);
  const M all = less_equal(splat(0.0), splat(0.0));
  return outline_foot(e, ax, ay, r - splat(e.bx), z - splat(e.by), -(dx * ay - dy * ax),
                      except(except(all, at_a), at_b), at_a);
}

MRSIM_LANE OutlineFoot arc_foot_of(const OutlineEdge& e, V r, V z) {
  const V zero = splat(0.0);
  const V ax = r - splat(e.ax), ay = z - splat(e.ay), bx = r - splat(e.bx), by = z - splat(e.by);
  const V x = r - splat(e.cx), y = z - splat(e.cy);
  const V side = vsqrt(x * x + y * y) - splat(e.radius);
  const M after = less_equal(zero, splat(e.sx) * y - splat(e.sy) * x);
  const M before = less_equal(zero, x * splat(e.ty) - y * splat(e.tx));
  return outline_foot(e, ax, ay, bx, by, e.is_convex ? side : -side,
                      e.is_below_half_turn ? both(after, before) : either(after, before),
                      less_equal(vsqrt(ax * ax + ay * ay), vsqrt(bx * bx + by * by)));
}

MRSIM_LANE V outline_distance(std::span<const OutlineEdge> edges, V r, V z) {
  V best = splat(std::numeric_limits<double>::infinity());
  M outside = less(best, best);
  for (const OutlineEdge& e : edges) {
    const OutlineFoot foot = e.radius > 0 ? arc_foot_of(e, r, z) : line_foot_of(e, r, z);
    const M closer = less(foot.distance, best);
    best = select(closer, foot.distance, best);
    outside = select_mask(closer, foot.outside, outside);
  }
  return select(outside, best, -best);
}
