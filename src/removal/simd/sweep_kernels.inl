// Loops over the forms of sweep_lanes.inl; included once per instruction set by sweep_kernels.cpp,
// with the registers V of kLanes doubles in scope. The rest of a list that does not fill a register
// repeats its last sweep and is not stored.

// Numbers `from` to `from` + 7 of records[rows[j]], a lane each.
template <class Record>
MRSIM_LANE void load_columns(const Record* records, std::size_t from, const std::uint32_t* rows,
                             V* c) {
  const double* numbers[kLanes];
  for (std::size_t j = 0; j < kLanes; ++j) numbers[j] = numbers_of(records, rows[j]) + from;
  load_eight(numbers, c);
}
MRSIM_LANE void load_line(const LineRecord* records, const std::uint32_t* rows, V* c) {
  load_columns(records, 0, rows, c);
}
// Three numbers more than eight: one by one they cost less than another eight.
MRSIM_LANE void load_arc(const ArcRecord* records, const std::uint32_t* rows, V* c) {
  const double* numbers[kLanes];
  for (std::size_t j = 0; j < kLanes; ++j) numbers[j] = records[rows[j]].c;
  load_eight(numbers, c);
  c[ArcSlot::core] = gather(numbers, ArcSlot::core);
  c[ArcSlot::round] = gather(numbers, ArcSlot::round);
  c[ArcSlot::top] = gather(numbers, ArcSlot::top);
}

// Rows k .. k + kLanes - 1, the last one repeated.
MRSIM_LANE void pick(const std::uint32_t* rows, std::size_t k, std::size_t n, std::uint32_t* out) {
  for (std::size_t j = 0; j < kLanes; ++j) out[j] = rows[k + j < n ? k + j : n - 1];
}

MRSIM_LANE void take_closer(V d, V id, V& least, V& nearest) {
  const M closer = either(less(d, least), both(less_equal(d, least), less(id, nearest)));
  least = select(closer, d, least), nearest = select(closer, id, nearest);
}

constexpr std::size_t kSquares = 64;  // kept at once

// Relative margins around values that are rounded a few times: a half ulp is 1.11e-16.
constexpr double kNineHalfUlps = 1e-15, kNinetyHalfUlps = 1e-14;

#define MRSIM_LIST(form, Record, fetch, kColumns)                                          \
  static void form##_list(const Record* records, const std::uint32_t* rows, std::size_t n, \
                          const Vec3& p, double* out) {                                    \
    const V x = splat(p.x), y = splat(p.y), z = splat(p.z);                                \
    V c[kColumns];                                                                         \
    std::size_t k = 0;                                                                     \
    for (; k + kLanes <= n; k += kLanes) {                                                 \
      fetch(records, rows + k, c);                                                         \
      store(out + k, form(c, x, y, z));                                                    \
    }                                                                                      \
    if (k == n) return;                                                                    \
    std::uint32_t rest[kLanes];                                                            \
    pick(rows, k, n, rest);                                                                \
    fetch(records, rest, c);                                                               \
    store_some(out + k, form(c, x, y, z), n - k);                                          \
  }
MRSIM_LIST(ball_line, LineRecord, load_line, 8)
MRSIM_LIST(plane_line, LineRecord, load_line, 8)
MRSIM_LIST(plane_arc, ArcRecord, load_arc, 11)
#undef MRSIM_LIST

#include "removal/simd/plan_kernels.inl"
//
#include "removal/simd/ball_kernels.inl"

static std::uint64_t bore_least(const LineRecord& record, std::uint32_t id, PointColumns& points) {
  V c[8];
  for (std::size_t j = 0; j < 8; ++j) c[j] = splat(record.c[j]);
  const V own = splat(static_cast<double>(id));
  std::uint64_t active = 0;
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const Bore b = bore(c, load(points.x + k), load(points.y + k), load(points.z + k));
    const V least = load(points.least + k), nearest = load(points.nearest + k);
    const M closer = both(
        b.decided,
        either(less(b.distance, least), both(less_equal(b.distance, least), less(own, nearest))));
    store(points.least + k, select(closer, b.distance, least));
    store(points.nearest + k, select(closer, own, nearest));
    const M open = less_equal(b.distance, least + splat(kBoundError));
    active |= std::uint64_t(bits(open) & ~bits(b.decided)) << k;
  }
  return active;
}

static void bore_bounds(const LineRecord* records, const std::uint32_t* rows, std::size_t n,
                        const Vec3& p, double* out, std::uint8_t* decided) {
  const V x = splat(p.x), y = splat(p.y), z = splat(p.z);
  std::uint32_t some[kLanes];
  V c[8];
  for (std::size_t k = 0; k < n; k += kLanes) {
    pick(rows, k, n, some);
    load_line(records, some, c);
    const Bore b = bore(c, x, y, z);
    store(out + k, b.distance);
    for (std::size_t j = 0; j < kLanes; ++j)
      decided[k + j] = static_cast<std::uint8_t>(bits(b.decided) >> j & 1);
  }
}

// The last of the points is repeated where they do not fill a register.
static void helix_least_of(const HelixRecord& record, std::uint32_t id, std::uint64_t active,
                           PointColumns& points) {
  const M all = less_equal(splat(0.0), splat(0.0));
  while (active != 0) {
    alignas(64) double x[kLanes], y[kLanes], z[kLanes], distance[kLanes];
    std::size_t at[kLanes], n = 0;
    for (; active != 0 && n < kLanes; active &= active - 1)
      at[n++] = static_cast<std::size_t>(std::countr_zero(active));
    for (std::size_t k = 0; k < kLanes; ++k) {
      const std::size_t i = at[k < n ? k : n - 1];
      x[k] = points.x[i], y[k] = points.y[i], z[k] = points.z[i];
    }
    store(distance, helix_least(record, load(x), load(y), load(z), all).distance);
    for (std::size_t k = 0; k < n; ++k) {
      const double d = distance[k];
      double &least = points.least[at[k]], &nearest = points.nearest[at[k]];
      if (d < least || (d == least && id < nearest)) least = d, nearest = id;
    }
  }
}

static void slant_bounds(const SlantRecord* records, const std::uint32_t* rows, std::size_t n,
                         const Vec3& p, double* out) {
  const V x = splat(p.x), y = splat(p.y), z = splat(p.z);
  std::uint32_t some[kLanes];
  V c[16];
  for (std::size_t k = 0; k < n; k += kLanes) {
    pick(rows, k, n, some);
    load_columns(records, 0, some, c);
    load_columns(records, 4, some, c + 4);
    store(out + k, slant_bound(c, x, y, z));
  }
}

static void upright_list(const UprightRecord* records, const std::uint32_t* rows, std::size_t n,
                         const Vec3& p, double limit, bool nearest, double* out) {
  const V x = splat(p.x), y = splat(p.y), z = splat(p.z);
  const M all = less_equal(splat(0.0), splat(0.0));
  std::uint32_t some[kLanes];
  V c[16];
  for (std::size_t k = 0; k < n; k += kLanes) {
    pick(rows, k, n, some);
    load_columns(records, 0, some, c);
    load_columns(records, 8, some, c + 8);
    store(out + k, upright_least(c, x, y, z, splat(limit), all).distance);
    for (std::size_t j = k; nearest && j < k + kLanes; ++j) limit = std::min(limit, out[j]);
  }
}

static void upright_least_of(const UprightRecord* quarters, std::size_t count, std::uint32_t id,
                             PointColumns& points) {
  const M all = less_equal(splat(0.0), splat(0.0));
  const V own = splat(static_cast<double>(id));
  V c[UprightColumn::kCount];
  for (std::uint32_t quarter = 0; quarter < count; ++quarter) {
    const double* numbers = numbers_of(quarters, quarter);
    for (std::size_t j = 0; j < UprightColumn::kCount; ++j) c[j] = splat(numbers[j]);
    for (std::size_t k = 0; k < points.count; k += kLanes) {
      const V x = load(points.x + k), y = load(points.y + k), z = load(points.z + k);
      V least = load(points.least + k), nearest = load(points.nearest + k);
      take_closer(upright_least(c, x, y, z, least, all).distance, own, least, nearest);
      store(points.least + k, least);
      store(points.nearest + k, nearest);
    }
  }
}

static void chain_bounds(const ChainTool& tool, const ChainLine* lines, const std::uint32_t* rows,
                         std::size_t n, const Vec3& p, double limit, double* out) {
  const V x = splat(p.x), y = splat(p.y), z = splat(p.z);
  std::uint32_t some[kLanes];
  EachChain move;
  for (std::size_t k = 0; k < n; k += kLanes) {
    pick(rows, k, n, some);
    load_columns(lines, 0, some, move.c);
    load_columns(lines, 8, some, move.c + 8);
    store(out + k, chain_bound(tool, move, chain_view(move, x, y, z), splat(limit)));
  }
}

// Moves side by side, from `k` on.
struct ChainsBeside {
  const ChainColumns& c;
  std::size_t k;
  V x() const { return load(c[ChainColumn::x] + k); }
  V y() const { return load(c[ChainColumn::y] + k); }
  V z() const { return load(c[ChainColumn::z] + k); }
  V ux() const { return load(c[ChainColumn::ux] + k); }
  V uy() const { return load(c[ChainColumn::uy] + k); }
  V plan() const { return load(c[ChainColumn::plan] + k); }
  V rise() const { return load(c[ChainColumn::rise] + k); }
  V per_plan() const { return load(c[ChainColumn::per_plan] + k); }
  V per_way() const { return load(c[ChainColumn::per_way] + k); }
  V tilt(std::size_t i) const { return load(c[ChainColumn::tilt + i] + k); }
};

static void chain_bounds_beside(const ChainTool& tool, const ChainColumns& lines, std::size_t n,
                                const Vec3& p, double limit, double* out) {
  const V x = splat(p.x), y = splat(p.y), z = splat(p.z);
  for (std::size_t k = 0; k < n; k += kLanes) {
    const ChainsBeside move{lines, k};
    store(out + k, chain_bound(tool, move, chain_view(move, x, y, z), splat(limit)));
  }
}

static void slant_least_of(const SlantRecord& record, std::uint32_t id, PointColumns& points) {
  const V round = splat(record.round), own = splat(static_cast<double>(id));
  const double numbers[] = {record.x,      record.y,    record.z,    record.ux,   record.uy,
                            record.length, record.plan, record.rise, record.core, record.round};
  V c[SlantColumn::kCount];
  for (std::size_t j = 0; j < SlantColumn::kCount; ++j) c[j] = splat(numbers[j]);
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V least = load(points.least + k), nearest = load(points.nearest + k);
    const V x = load(points.x + k), y = load(points.y + k), z = load(points.z + k);
    const M wanted = less_equal(slant_bound(c, x, y, z), least + splat(kBoundError));
    if (!any(wanted)) continue;
    const V d = slant_least(SlantStretch(record, x, y, z), round, wanted).distance;
    const M closer =
        both(wanted, either(less(d, least), both(less_equal(d, least), less(own, nearest))));
    store(points.least + k, select(closer, d, least));
    store(points.nearest + k, select(closer, own, nearest));
  }
}

static void chain_least_of(const ChainTool& tool, const ChainLine& line, std::uint32_t id,
                           PointColumns& points) {
  const V own = splat(static_cast<double>(id));
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V least = load(points.least + k), nearest = load(points.nearest + k);
    const V limit = least + splat(kBoundError);
    const OneChain move{line};
    const ChainView at =
        chain_view(move, load(points.x + k), load(points.y + k), load(points.z + k));
    const M wanted = less_equal(chain_bound(tool, move, at, limit), limit);
    if (!any(wanted)) continue;
    const V d = chain_least({tool, line, at}, limit, wanted).f;
    const M closer =
        both(wanted, either(less(d, least), both(less_equal(d, least), less(own, nearest))));
    store(points.least + k, select(closer, d, least));
    store(points.nearest + k, select(closer, own, nearest));
  }
}

static void outline_list(const OutlineTool& tool, const ProfileRow* paths,
                         const std::uint32_t* rows, std::size_t n, const Vec3& p, double limit,
                         double* out) {
  const V x = splat(p.x), y = splat(p.y), z = splat(p.z);
  const bool is_arc = paths[rows[0]].arc;
  std::uint32_t some[kLanes];
  V c[ArcSlot::low + 1];
  for (std::size_t k = 0; k < n; k += kLanes) {
    pick(rows, k, n, some);
    load_columns(paths, 1, some, c);
    const V rho = is_arc ? arc_rho(c, x, y) : line_rho(c, x, y), above = z - c[ArcSlot::low];
    const V bound = vmax(rho - splat(tool.radius), splat(tool.bottom) - above);
    const bool counts = any(less_equal(bound, splat(limit + kBoundError)));
    store(out + k, counts ? outline_distance(tool.edges, rho, above) : bound);
  }
}

static void outline_least(const OutlineTool& tool, const ProfileRow& row, std::uint32_t id,
                          PointColumns& points) {
  const V own = splat(static_cast<double>(id)), tip = splat(row.z);
  const V radius = splat(tool.radius), bottom = splat(row.z + tool.bottom);
  V c[ArcSlot::low];
  for (std::size_t j = 0; j < ArcSlot::low; ++j) c[j] = splat(row.c[j]);
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V x = load(points.x + k), y = load(points.y + k), z = load(points.z + k);
    V least = load(points.least + k), nearest = load(points.nearest + k);
    const V rho = row.arc ? arc_rho(c, x, y) : line_rho(c, x, y);
    const V bound = vmax(rho - radius, bottom - z);
    if (!any(less_equal(bound, least + splat(kBoundError)))) continue;
    take_closer(outline_distance(tool.edges, rho, z - tip), own, least, nearest);
    store(points.least + k, least);
    store(points.nearest + k, nearest);
  }
}

// polygon_distance side by side. The least root is the root of the least.
struct SideSum {
  V most, least;
};
MRSIM_LANE SideSum no_sides() {
  const double infinity = std::numeric_limits<double>::infinity();
  return {splat(-infinity), splat(infinity)};
}
MRSIM_LANE void add_side(SideSum& s, V wx, V wy, V dx, V dy, V length) {
  const V zero = splat(0.0);
  const V n = dy * wx - dx * wy, t = dx * wx + dy * wy;
  const V over = vmax(vmax(t - length, zero - t), zero);
  s.most = vmax(n, s.most);
  s.least = select(less(zero, n), vmin(n * n + over * over, s.least), s.least);
}
MRSIM_LANE V distance_of(const SideSum& s) {
  return select(less(splat(0.0), s.most), vsqrt(s.least), s.most);
}

static void polygons(const PolygonSides* sides, std::size_t count, const double* round, double px,
                     double py, double* out) {
  const V x = splat(px), y = splat(py);
  for (std::size_t k = 0; k < PolygonSides::kLanes; k += kLanes) {
    SideSum sum = no_sides();
    for (std::size_t i = 0; i < count; ++i) {
      const PolygonSides& s = sides[i];
      add_side(sum, x - load(s.ax + k), y - load(s.ay + k), load(s.dx + k), load(s.dy + k),
               load(s.length + k));
    }
    store(out + k, distance_of(sum) - load(round + k));
  }
}

static void polygon_least(const ConvexPolygon::Side* sides, std::size_t count, double round,
                          bool mirrored, std::uint32_t sweep, PointColumns& points) {
  const V sign = splat(mirrored ? -1.0 : 1.0), id = splat(static_cast<double>(sweep));
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V x = sign * load(points.x + k), y = load(points.z + k);
    SideSum sum = no_sides();
    for (std::size_t i = 0; i < count; ++i) {
      const ConvexPolygon::Side& s = sides[i];
      add_side(sum, x - splat(s.a.x), y - splat(s.a.y), splat(s.direction.x), splat(s.direction.y),
               splat(s.length));
    }
    const V d = distance_of(sum) - splat(round);
    const V least = load(points.least + k), nearest = load(points.nearest + k);
    const M closer = either(less(d, least), both(less_equal(d, least), less(id, nearest)));
    store(points.least + k, select(closer, d, least));
    store(points.nearest + k, select(closer, id, nearest));
  }
}

static std::uint32_t ball_heights(const LineRecord& move, const PlanPoints& points, double* out) {
  std::uint32_t below = 0;
  for (std::size_t k = 0; k < PlanPoints::kCount; k += kLanes) {
    const V z = ball_low(move.c, ball_view(move.c, load(points.x + k), load(points.y + k)));
    store(out + k, z);
    below |= bits(less(z, load(points.low + k))) << k;
  }
  return below;
}

static std::uint32_t ball_bounds(const LineRecord& move, double r, PlanPoints& points,
                                 double* least) {
  std::uint32_t below = 0;
  for (std::size_t k = 0; k < PlanPoints::kCount; k += kLanes) {
    const BallView at = ball_view(move.c, load(points.x + k), load(points.y + k));
    const V low = load(points.low + k), lower = ball_least(move.c, at, r);
    const std::uint32_t found = bits(less(lower, low));
    if (found == 0) continue;
    below |= found << k;
    store(least + k, vmin(load(least + k), lower));
    store(points.low + k, vmin(low, ball_most(move.c, at, r)));
  }
  return below;
}

static const SweepKernels kKernels = {
    kName,
    {ball_line_list, ball_line_least},
    {plane_line_list, plan_least<LineRecord>},
    {plane_arc_list, plan_least<ArcRecord>},
    bore_least,
    bore_bounds,
    helix_least_of,
    slant_bounds,
    slant_least_of,
    upright_list,
    upright_least_of,
    chain_bounds,
    chain_bounds_beside,
    chain_least_of,
    outline_list,
    outline_least,
    polygons,
    polygon_least,
    ball_heights,
    ball_bounds,
};
