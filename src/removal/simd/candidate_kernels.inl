// The loops of candidate_kernels.h; included once per instruction set by candidate_kernels.cpp,
// with V (floats), M (mask), kLanes and the operations on them in scope.

struct Row {
  V distance, squared, x, y, z, rest, height_number;
};

constexpr float kNoDivisor = 1e-20f;  // that of rounding.h is 0 as a float

MRSIM_LANE V clamped(V x, V low, V high) { return vmin(vmax(x, low), high); }

// The largest product of the vector with any offset from the region's centre.
MRSIM_LANE V reach_of(const RegionArgs& a, V x, V y) {
  if (a.box) return splat(a.half) * (vabs(x) + vabs(y));
  return splat(a.radius) * vsqrt(x * x + y * y);
}
MRSIM_LANE V reach_of(const RegionArgs& a, V x, V y, V z) {
  if (a.box) return splat(a.half) * (vabs(x) + vabs(y)) + splat(a.tall) * vabs(z);
  return splat(a.radius) * vsqrt(x * x + y * y + z * z);
}

// Bounds are rounded up.
MRSIM_LANE V above(V x) { return x * splat(1.00001f); }

// Whether the region comes within a distance of a convex skeleton whose nearest point is at (x, y,
// z): the distance is convex, so that it falls by no more than its slope says.
MRSIM_LANE M comes_within(const RegionArgs& a, float within, V squared, V x, V y, V z) {
  return less_equal(squared - above(reach_of(a, x, y, z)), splat(within) * vsqrt(squared));
}

MRSIM_LANE V margin(const RegionArgs& a, V squared, V root) {
  return splat(a.fixed) + splat(a.per_root) * root + splat(kTieMargin) * squared;
}
// On a segment of direction d (|d|^2 = size) and length `end` d, whose nearest point lies at `t`
// and would at `raw` on the whole line: the most that a step from there on the segment gains,
// towards an offset whose product with d is up to g. Beyond an end the segment leads away from the
// region.
MRSIM_LANE V short_rest(const RegionArgs& a, V g, V raw, V t, V inverse, V size, V end) {
  const V away = vabs(raw - t) * size - splat(2 * a.delta) * (splat(1.0f) + size);
  const V gain = vmax(g - vmax(away, splat(0.0f)), splat(0.0f));
  const V step = vmin(gain * inverse, vmax(t, end - t));
  return step * (gain + gain - step * size);
}

MRSIM_LANE Row strip_row(const CandidateColumns& c, std::size_t k, const RegionArgs& a) {
  const V zero = splat(0.0f), one = splat(1.0f);
  const V ux = load(c[StripColumn::ux] + k), uy = load(c[StripColumn::uy] + k),
          end = load(c[StripColumn::length] + k), s = load(c[StripColumn::slope] + k),
          inverse = load(c[StripColumn::inverse] + k), az = load(c[StripColumn::z] + k);
  const V dx = splat(a.x) - load(c[StripColumn::x] + k),
          dy = splat(a.y) - load(c[StripColumn::y] + k), w = splat(a.z) - az;
  const V u = dx * ux + dy * uy, v = dx * uy - dy * ux;
  const V uc = clamped(u, zero, end), du = u - uc;
  const V raw = (u + s * w) * inverse, t = clamped(raw, zero, end);
  const V eu = u - t, ew = w - s * t;
  const M over = less_equal(s * uc, w);
  const V along = select(over, uc, t);
  Row r;
  r.squared = v * v + select(over, du * du, eu * eu + ew * ew);
  const V root = vsqrt(r.squared);
  r.distance = root - splat(a.tool.round);
  r.x = ux * along - dx, r.y = uy * along - dy, r.z = select(over, zero, zero - ew);
  // Across the strip's plane a point of the region moves no distance.
  const V plan = reach_of(a, ux, uy);
  const V wide = a.box ? plan * plan + splat(a.tall * a.tall) : splat(a.radius * a.radius);
  // Below all of the path the nearest points lie on its segment.
  const M below = less_equal(splat(a.z + a.tall + 2 * a.delta), az + vmin(zero, s * end));
  const V segment = short_rest(a, reach_of(a, ux, uy, s), raw, t, inverse, one + s * s, end);
  r.rest = above(select(below, vmin(segment, wide), wide)) + margin(a, r.squared, root);
  r.height_number = zero;
  return r;
}

// rounded_slab of sweep_lanes.inl.
MRSIM_LANE V slab(const RegionArgs& a, V rho, V tip) {
  const V zero = splat(0.0f), z = splat(a.z), low = tip + splat(a.tool.round),
          top = tip + splat(a.tool.height);
  const M upper = less_equal(splat(0.5f) * (tip + top), z);
  const V r = select(upper, zero, splat(a.tool.round));
  const V dr = rho - select(upper, splat(a.tool.core + a.tool.round), splat(a.tool.core));
  const V dz = select(upper, z - top, low - z);
  const V p = vmax(dr, zero), q = vmax(dz, zero);
  return vsqrt(p * p + q * q) + vmin(vmax(dr, dz), zero) - r;
}

MRSIM_LANE Row line_row(const CandidateColumns& c, std::size_t k, const RegionArgs& a) {
  const V zero = splat(0.0f), one = splat(1.0f);
  const V px = load(c[LineColumn::dx] + k), py = load(c[LineColumn::dy] + k),
          inverse = load(c[LineColumn::inverse] + k);
  const V dx = splat(a.x) - load(c[LineColumn::x] + k),
          dy = splat(a.y) - load(c[LineColumn::y] + k);
  const V raw = (dx * px + dy * py) * inverse, t = clamped(raw, zero, one);
  Row r;
  r.x = t * px - dx, r.y = t * py - dy, r.z = load(c[LineColumn::z] + k),
  r.height_number = load(c[LineColumn::height_number] + k);
  r.squared = r.x * r.x + r.y * r.y;
  const V root = vsqrt(r.squared);
  r.distance = slab(a, root, r.z);
  const V size = px * px + py * py;
  r.rest = above(short_rest(a, reach_of(a, px, py), raw, t, inverse, size, one)) +
           margin(a, r.squared, root);
  return r;
}

MRSIM_LANE Row arc_row(const CandidateColumns& c, std::size_t k, const RegionArgs& a) {
  const V zero = splat(0.0f), infinite = splat(kFloatInfinity);
  const V radius = load(c[ArcColumn::radius] + k), mx = load(c[ArcColumn::mx] + k),
          my = load(c[ArcColumn::my] + k);
  const V cosine = load(c[ArcColumn::cosine] + k), sine = load(c[ArcColumn::sine] + k);
  const V dx = splat(a.x) - load(c[ArcColumn::x] + k), dy = splat(a.y) - load(c[ArcColumn::y] + k);
  const V along = dx * mx + dy * my, off = dy * mx - dx * my, side = vabs(off);
  const V n = vsqrt(dx * dx + dy * dy);
  const M facing = less_equal(cosine * side - sine * along, zero);
  const V scale = radius / vmax(n, splat(kNoDivisor)) - splat(1.0f);
  const V ea = radius * cosine, eb = radius * sine;
  const V signed_eb = select(less_equal(off, zero), zero - eb, eb);
  const V ex = ea * mx - signed_eb * my - dx, ey = ea * my + signed_eb * mx - dy;
  const V root = select(facing, vabs(n - radius), vsqrt(ex * ex + ey * ey));
  Row r;
  r.x = select(facing, scale * dx, ex), r.y = select(facing, scale * dy, ey);
  r.z = load(c[ArcColumn::z] + k), r.height_number = load(c[ArcColumn::height_number] + k);
  r.distance = slab(a, root, r.z);
  // Facing the arc, |c - s|^2 = s_i^2 + n / R |s - q|^2 on the whole circle; beyond an end of at
  // most half a turn, the end is the nearest point of the arc's hull. Near the centre the nearest
  // point is not known well enough.
  const V wide = splat(a.box ? 2 * a.half * a.half : a.radius * a.radius);
  const M clear = less_equal(radius, splat(4.0f) * n);
  const V round = (wide + splat(8 * a.delta * a.radius)) * radius /
                  vmax(n - splat(2 * a.delta), splat(kNoDivisor));
  const M end = both(less_equal(zero, cosine), less_equal(eb + splat(2 * a.delta), side));
  r.squared = select(facing, select(clear, root * root, infinite), root * root);
  r.rest = above(select(facing, select(clear, round, infinite), select(end, wide, infinite))) +
           margin(a, root * root, root);
  return r;
}

#define MRSIM_NEAR(form)                                                                          \
  static LeastDistance near_##form(const CandidateColumns& c, std::size_t n, const RegionArgs& a, \
                                   const CandidateRows& out) {                                    \
    const V infinite = splat(kFloatInfinity);                                                     \
    V distance = infinite, squared = infinite, z = infinite;                                      \
    for (std::size_t k = 0; k < n; k += kLanes) {                                                 \
      Row r = form##_row(c, k, a);                                                                \
      const M real = first_lanes(n - k);                                                          \
      r.distance = select(real, r.distance, infinite);                                            \
      r.squared = select(real, r.squared, infinite);                                              \
      r.z = select(real, r.z, infinite);                                                          \
      store(out.distance + k, r.distance), store(out.squared + k, r.squared);                     \
      store(out.x + k, r.x), store(out.y + k, r.y), store(out.z + k, r.z);                        \
      store(out.rest + k, r.rest), store(out.height_number + k, r.height_number);                 \
      distance = vmin(distance, r.distance), squared = vmin(squared, r.squared);                  \
      z = vmin(z, r.z);                                                                           \
    }                                                                                             \
    return {least_lane(distance), least_lane(squared), least_lane(z)};                            \
  }

MRSIM_NEAR(strip)
MRSIM_NEAR(line)
MRSIM_NEAR(arc)
#undef MRSIM_NEAR

static std::size_t find(const float* column, std::size_t n, float value) {
  const V wanted = splat(value);
  for (std::size_t k = 0; k < n; k += kLanes) {
    const std::size_t lane = first_set(equal(load(column + k), wanted));
    if (lane < kLanes && k + lane < n) return k + lane;
  }
  return n;
}

static PlanBeaters plan_beaters(const CandidateRows& rows, std::size_t n,
                                const LeastDistance& least, float inside) {
  const V infinite = splat(kFloatInfinity), tip = splat(least.z), limit = splat(inside);
  V low = infinite, cover = infinite;
  for (std::size_t k = 0; k < n; k += kLanes) {
    const V squared = load(rows.squared + k), z = load(rows.z + k);
    low = vmin(low, select(equal(z, tip), squared, infinite));
    cover = vmin(cover, select(less(squared, limit), z, infinite));
  }
  const V low_squared = splat(least_lane(low)), cover_z = splat(least_lane(cover));
  PlanBeaters found = {find(rows.squared, n, least.squared), n, n};
  for (std::size_t k = 0; k < n && (found.lowest == n || found.cover == n); k += kLanes) {
    const V squared = load(rows.squared + k), z = load(rows.z + k);
    const std::size_t l = first_set(both(equal(z, tip), equal(squared, low_squared)));
    const std::size_t c = first_set(both(less(squared, limit), equal(z, cover_z)));
    if (found.lowest == n && l < kLanes && k + l < n) found.lowest = k + l;
    if (found.cover == n && c < kLanes && k + c < n) found.cover = k + c;
  }
  return found;
}

// Whether j may beat a plan sweep: its tip is lower, or as high and the index is lower or the walls
// differ strictly.
MRSIM_LANE M tip_allows(const KeepArgs& a, const Beater& j, V z, V number, M first) {
  const M lower = both(splat_mask(a.rising), less(splat(j.z), z));
  return either(lower, both(equal(number, splat(j.height_number)), first));
}

static std::size_t keep(const KeepArgs& a, const CandidateRows& rows, const CandidateColumns& in,
                        std::size_t n, std::size_t columns, float* out, std::size_t out_stride,
                        bool& reaches) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < n; k += kLanes) {
    M stay = less_equal(load(rows.distance + k), splat(a.limit));
    if (!any(stay)) continue;
    const V squared = load(rows.squared + k), x = load(rows.x + k), y = load(rows.y + k),
            z = load(rows.z + k), number = load(rows.height_number + k),
            id = load(in[kIdColumn] + k);
    const V gap = squared - load(rows.rest + k);
    for (int i = 0; i < a.beaters; ++i) {
      const Beater& j = a.beater[i];
      const V dx = x - splat(j.x), dy = y - splat(j.y);
      const V far = a.plan ? reach_of(a.at, dx, dy) : reach_of(a.at, dx, dy, z - splat(j.z));
      M beaten = less(above(far + far), gap - splat(j.squared));
      if (a.plan) {
        const M first = either(less(splat(j.id), id), less(splat(a.beyond), squared));
        beaten = both(beaten, tip_allows(a, j, z, number, first));
      }
      stay = except(stay, beaten);
    }
    if (a.has_cover)
      stay = except(stay, tip_allows(a, a.cover, z, number, less(splat(a.cover.id), id)));
    if (!reaches)
      reaches = any(both(stay, a.plan ? less_equal(z, splat(a.within))
                                      : comes_within(a.at, a.within, squared, x, y, z)));
    for (std::size_t i = 0; i < columns; ++i)
      compress(out + i * out_stride + kept, load(in[i] + k), stay);
    kept += compress(out + kIdColumn * out_stride + kept, id, stay);
  }
  return kept;
}

// |q - c - v|^2 = |q - c|^2 - 2 v.(q - c) + |v|^2, the last the same for all.
static void strip_quarters(const CandidateColumns& c, std::size_t n, const RegionArgs& a, float b,
                           StripAt* out) {
  constexpr std::size_t kParts = kStripQuarters;
  const V infinite = splat(kFloatInfinity), twice = splat(b + b);
  V least[kParts] = {infinite, infinite, infinite, infinite};
  V slots[kParts] = {infinite, infinite, infinite, infinite};
  for (std::size_t k = 0; k < n; k += kLanes) {
    const Row r = strip_row(c, k, a);
    const V squared = select(first_lanes(n - k), r.squared, infinite);
    const V x = twice * r.x, y = twice * r.y, low = squared + x, high = squared - x;
    const V own[kParts] = {low + y, low - y, high + y, high - y};
    const V slot = splat(static_cast<float>(k)) + load(kLaneNumbers);
    for (std::size_t part = 0; part < kParts; ++part) {
      slots[part] = select(less(own[part], least[part]), slot, slots[part]);
      least[part] = vmin(own[part], least[part]);
    }
  }
  for (std::size_t part = 0; part < kParts; ++part) {
    const float found = least_lane(least[part]);
    const V first = select(equal(least[part], splat(found)), slots[part], infinite);
    out[part] = {found, static_cast<std::size_t>(least_lane(first))};
  }
}

static Beater strip_beater(const CandidateColumns& c, std::size_t k, const RegionArgs& a) {
  const Row r = strip_row(c, k, a);
  float slots[4][kLanes];
  store(slots[0], r.squared), store(slots[1], r.x), store(slots[2], r.y), store(slots[3], r.z);
  return {slots[0][0], slots[1][0], slots[2][0], slots[3][0], 0, 0};
}

static std::size_t strip_ids(const CandidateColumns& c, std::size_t n, const RegionArgs& a,
                             const Beater& j, float limit, float within, float* ids,
                             bool& reaches) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < n; k += kLanes) {
    const Row r = strip_row(c, k, a);
    const M near = both(first_lanes(n - k), less_equal(r.squared, splat(limit)));
    if (!any(near)) continue;
    const V far = reach_of(a, r.x - splat(j.x), r.y - splat(j.y), r.z - splat(j.z));
    const M beaten = less(above(far + far), r.squared - r.rest - splat(j.squared));
    const M stay = except(near, beaten);
    if (!reaches) reaches = any(both(stay, comes_within(a, within, r.squared, r.x, r.y, r.z)));
    kept += compress(ids + kept, load(c[kIdColumn] + k), stay);
  }
  return kept;
}

#include "removal/simd/height_lanes.inl"

static const CandidateKernels kKernels = {
    near_strip,      near_line,          near_arc, find,           plan_beaters, keep,
    segment_heights, horizontal_heights, keep_low, strip_quarters, strip_beater, strip_ids};
