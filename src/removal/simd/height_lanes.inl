// Heights of slanted moves over a region's square in plan (docs/removal.md, Heights); included by
// candidate_kernels.inl.
//
// Columns of a segment: start of the tip ax ay az (the lower end), unit direction ux uy and length
// L in plan, slope m >= 0, and how far the path may be from the segment (eps).
//
// The tool is a disc of radius C with a fillet of radius r, a cone above it and a wall at R. Over
// (u, v), seen from the start along and across the move, its height is the least of
// az + m s + g(D(s)), D = |(u - s, v)|, s in [0, L].

// Height of the tool's surface above its tip at radius rho.
MRSIM_LANE V profile_height(const HeightTool& t, V rho) {
  const V x = clamped(rho - splat(t.core), splat(0.0f), splat(t.reach));
  const V beyond = vmax(rho - splat(t.core + t.reach), splat(0.0f));
  return splat(t.round) - vsqrt(vmax(splat(t.round * t.round) - x * x, splat(0.0f))) +
         splat(t.slope) * beyond;
}

constexpr float kUprightSquare = 1e-12f;  // cosine squared: no slope is steeper than a million
constexpr float kFarAlong = 1e6f;         // mm: beyond the ends of every move

// The contact: where on the tool's surface the height is least, unless an end of the move comes
// first. On the fillet D = C + r sine and slope (u - s) = m D; where no point of the fillet meets
// that, the contact is on the cone.
struct HeightContact {
  V slope;  // of the surface at the contact
  V along;  // u - s
};
MRSIM_LANE HeightContact height_contact(const HeightTool& t, V m, V v) {
  const V one = splat(1.0f), zero = splat(0.0f);
  const V mm = m * m, vv = v * v;
  V low = zero, high = splat(t.sine);
  const V far = splat(t.core + t.round * t.sine), end = high * high;
  const M cone = less_equal((end - mm * (one - end)) * far * far, end * vv);
  for (int i = 0; i < 6; ++i) {
    const V middle = splat(0.5f) * (low + high), q = middle * middle;
    const V d = splat(t.core) + splat(t.round) * middle;
    const M beyond = less(q * vv, (q - mm * (one - q)) * d * d);
    high = select(beyond, middle, high), low = select(beyond, low, middle);
  }
  const V sine = splat(0.5f) * (low + high), d = splat(t.core) + splat(t.round) * sine;
  const V steepest = splat(t.steepest);
  const V on_fillet = vsqrt(vmax(d * d - vv, zero));
  const V on_cone = select(less(m, steepest),
                           v * m / vsqrt(vmax(steepest * steepest - mm, splat(kUprightSquare))),
                           splat(kFarAlong));
  return {select(cone, steepest, sine / vsqrt(vmax(one - sine * sine, splat(kUprightSquare)))),
          select(cone, on_cone, on_fillet)};
}

// What a tangent plane of the tool, widened by `wide`, with the gradient (gu, gv) of size `slope`
// says of the height over all positions in [s0, s1].
MRSIM_LANE V tangent_height(const HeightTool& t, V wide, V slope, V gu, V gv, V m, V s0, V s1, V u,
                            V v) {
  const V one = splat(1.0f), tilt = m - gu;
  const V s = select(less(tilt, splat(0.0f)), s1, s0);
  const V below =
      slope * (splat(t.core) + wide) + splat(t.round) * (vsqrt(one + slope * slope) - one);
  return m * s + gu * (u - s) + gv * v - below;
}

// Writes what the height of each segment is at least over the square to `lower`, and returns what
// the least one is at most.
static float segment_heights(const CandidateColumns& c, std::size_t n, const HeightArgs& a,
                             float* lower) {
  const HeightTool& t = a.tool;
  const V zero = splat(0.0f), infinite = splat(kFloatInfinity);
  V least = infinite;
  for (std::size_t k = 0; k < n; k += kLanes) {
    const V dx = splat(a.x) - load(c[BallSlot::x] + k), dy = splat(a.y) - load(c[BallSlot::y] + k),
            az = load(c[BallSlot::z] + k), ux = load(c[BallSlot::ux] + k),
            uy = load(c[BallSlot::uy] + k), end = load(c[BallSlot::length] + k),
            m = load(c[BallSlot::slope] + k), eps = load(c[BallSlot::error] + k);
    const V u = dx * ux + dy * uy, v = vabs(dx * uy - dy * ux), vv = v * v;
    const V wide = splat(a.wide) + splat(a.stray) * eps, error = splat(a.error) + eps;
    const M real = first_lanes(n - k);
    // The positions within reach of the widened tool.
    const V rw = splat(t.radius) + wide, ww = rw * rw - vv, w = vsqrt(vmax(ww, zero));
    const V s0 = vmax(u - w, zero), s1 = vmin(u + w, end);
    const M near = both(both(less_equal(zero, ww), less_equal(s0, s1)), real);
    if (!any(near)) {
      store(lower + k, infinite);
      continue;
    }
    const HeightContact contact = height_contact(t, m, v);
    const V at = u - contact.along;
    // The tangent plane at the contact, and that at the end of the move before or after it.
    const V gu = vmin(m, contact.slope);
    const V gv = vsqrt(vmax(contact.slope * contact.slope - gu * gu, zero));
    V low = vmax(m * s0, tangent_height(t, wide, contact.slope, gu, gv, m, s0, s1, u, v));
    const V e = u - clamped(at, s0, s1), d = vsqrt(e * e + vv);
    const V sine = clamped((d - splat(t.core)) * splat(t.per_round), zero, splat(t.sine));
    const V slope = select(less(splat(t.core + t.reach), d), splat(t.steepest),
                           sine / vsqrt(vmax(splat(1.0f) - sine * sine, splat(kUprightSquare))));
    const V share = slope / vmax(d, splat(kNoDivisor));
    low = vmax(low, tangent_height(t, wide, slope, share * e, share * v, m, s0, s1, u, v));
    store(lower + k, select(near, az + low - error, infinite));
    // A position of the narrowed tool.
    const V rn = splat(t.radius) - wide, nn = rn * rn - vv, wn = vsqrt(vmax(nn, zero));
    const V n0 = vmax(u - wn, zero), n1 = vmin(u + wn, end);
    const M inside = both(both(less_equal(zero, nn), less_equal(zero, rn)), less_equal(n0, n1));
    const M over = less_equal(splat(a.top), az - error + splat(t.top));
    const V s = clamped(at, n0, n1), du = u - s,
            rho = vmin(vsqrt(du * du + vv) + wide, splat(t.radius));
    const V high = az + m * s + profile_height(t, rho) + splat(t.lift) + error;
    least = vmin(least, select(both(both(inside, over), near), high, infinite));
  }
  return least_lane(least);
}

// The heights of horizontal moves, whose rows hold the squared distance in plan (infinite where it
// is not known) and the height of the tip.
static float horizontal_heights(const CandidateRows& rows, std::size_t n, const HeightArgs& a,
                                float* lower) {
  const HeightTool& t = a.tool;
  const V zero = splat(0.0f), infinite = splat(kFloatInfinity);
  V least = infinite;
  for (std::size_t k = 0; k < n; k += kLanes) {
    const V squared = load(rows.squared + k), z = load(rows.z + k);
    const M real = first_lanes(n - k), known = less(squared, infinite);
    const V rho = vsqrt(select(known, squared, zero));
    const V near = vmax(rho - splat(a.wide), zero), far = rho + splat(a.wide);
    const V low = z + profile_height(t, near) - splat(a.error);
    const V found = select(less_equal(near, splat(t.radius)), low, infinite);
    store(lower + k, select(known, found, zero - infinite));
    const M inside = both(both(real, known), less_equal(far, splat(t.radius)));
    const M over = less_equal(splat(a.top), z - splat(a.error) + splat(t.top));
    const V high = z + profile_height(t, far) + splat(t.lift) + splat(a.error);
    least = vmin(least, select(both(inside, over), high, infinite));
  }
  return least_lane(least);
}

static std::size_t keep_low(const float* lower, std::size_t n, float limit,
                            const CandidateColumns& in, std::size_t columns, float* out,
                            std::size_t out_stride) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < n; k += kLanes) {
    const M stay = both(less_equal(load(lower + k), splat(limit)), first_lanes(n - k));
    if (!any(stay)) continue;
    for (std::size_t i = 0; i < columns; ++i)
      compress(out + i * out_stride + kept, load(in[i] + k), stay);
    kept += compress(out + kIdColumn * out_stride + kept, load(in[kIdColumn] + k), stay);
  }
  return kept;
}
