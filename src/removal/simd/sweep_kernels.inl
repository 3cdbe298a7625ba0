// Loops over the forms of sweep_lanes.inl; included once per instruction set by sweep_kernels.cpp,
// with kLanes, V and read, load_line, load_arc,  store in scope. The rest of a list that does
// not fill a register repeats its last sweep and is not stored.

// Rows k .. k + kLanes - 1, the last one repeated.
MRSIM_LANE void pick(const std::uint32_t* rows, std::size_t k, std::size_t n, std::uint32_t* out) {
  for (std::size_t j = 0; j < kLanes; ++j) out[j] = rows[k + j < n ? k + j : n - 1];
}

MRSIM_LANE void take_closer(V d, V id, V& least, V& nearest) {
  const M closer = either(less(d, least), both(less_equal(d, least), less(id, nearest)));
  least = select(closer, d, least), nearest = select(closer, id, nearest);
}

constexpr std::size_t kSquares = 64;  // kept at once

#define MRSIM_LIST(form, Record, load, kColumns)                                           \
  static void form##_list(const Record* records, const std::uint32_t* rows, std::size_t n, \
                          const Vec3& p, double* out) {                                    \
    const V x = splat(p.x), y = splat(p.y), z = splat(p.z);                                \
    V c[kColumns];                                                                         \
    std::size_t k = 0;                                                                     \
    for (; k + kLanes <= n; k += kLanes) {                                                 \
      load(records, rows + k, c);                                                          \
      store(out + k, form(c, x, y, z));                                                    \
    }                                                                                      \
    if (k == n) return;                                                                    \
    std::uint32_t rest[kLanes];                                                            \
    pick(rows, k, n, rest);                                                                \
    load(records, rest, c);                                                                \
    store_some(out + k, form(c, x, y, z), n - k);                                          \
  }
MRSIM_LIST(ball_line, LineRecord, load_line, 8)
MRSIM_LIST(plane_line, LineRecord, load_line, 8)
MRSIM_LIST(plane_arc, ArcRecord, load_arc, 11)
#undef MRSIM_LIST

// Horizontal moves. The first columns of a record tell the distance in plan, the four after them
// the tool's section at its height.
MRSIM_LANE V plan_rho(const LineRecord& r, V x, V y) {
  V c[4];
  for (std::size_t j = 0; j < 4; ++j) c[j] = splat(r.c[j]);
  return line_rho(c, x, y);
}
MRSIM_LANE V plan_rho(const ArcRecord& r, V x, V y) {
  V c[7];
  for (std::size_t j = 0; j < 7; ++j) c[j] = splat(r.c[j]);
  return arc_rho(c, x, y);
}
static const double* section_of(const LineRecord& r) { return r.c + 4; }
static const double* section_of(const ArcRecord& r) { return r.c + 7; }

// rounded_slab of one section at heights z.
struct Section {
  V low, core, round, top;
};
// Distances in plan up to which all give the same distance at height z; less 90 half ulps of the
// radius, where the sums below round by three.
MRSIM_LANE V saturation(const Section& s, V z) {
  const SlabSide side = slab_side(z, s.low, s.core, s.round, s.top);
  return side.core + vmin(side.dz, splat(0.0)) - splat(1e-14) * (s.core + s.round);
}

MRSIM_LANE V section_distance(const Section& s, V rho, V z) {
  return rounded_slab(rho, z, s.low, s.core, s.round, s.top);
}

// Above every distance in plan that could, rounded, give the distance `rho` does at heights z: each
// margin is nine half ulps or more of what is rounded there, by one or two.
MRSIM_LANE V farthest_equal(const Section& s, V rho, V z) {
  const V zero = splat(0.0), unit = splat(1e-15);
  const SlabSide side = slab_side(z, s.low, s.core, s.round, s.top);
  const V core = side.core, dr = rho - core, dz = side.dz;
  const V inner = vmax(dr, vmin(dz, zero));
  const V a = vmax(dr, zero), b = vmax(dz, zero);
  const V root = vsqrt(a * a + b * b), reach = root + unit * (root + s.round);
  const V outer = vsqrt(vmax(reach * reach * splat(1 + 1e-14) - b * b, zero));
  const V flat = inner + unit * (vabs(inner) + s.round);
  const V most = select(less(zero, root), vmax(flat, outer), flat);
  return most + core + splat(4e-15) * (most + core + core);
}

// The points of one height each in columns of equal x and y: the k-th of a column is `k` behind it.
struct PlanColumns {
  std::size_t depth = 1;  // points in each
  std::size_t count = 0;
};
static PlanColumns plan_columns(const PointColumns& points) {
  const auto same = [&](std::size_t i, std::size_t k) {
    return points.x[i] == points.x[k] && points.y[i] == points.y[k];
  };
  std::size_t depth = 1;
  while (depth < points.count && same(0, depth)) ++depth;
  if (depth == 1 || points.count % depth != 0) return {1, points.count};
  for (std::size_t first = depth; first < points.count; first += depth)
    for (std::size_t k = 1; k < depth; ++k)
      if (!same(first, first + k)) return {1, points.count};
  return {depth, points.count / depth};
}

constexpr std::size_t kFewRecords = 3;  // fewer are asked point by point

template <class Record>
static void plan_least_of_each(const Record* records, const std::uint32_t* rows,
                               const std::uint32_t* ids, std::size_t n, PointColumns& points) {
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V x = read(points.x + k), y = read(points.y + k), z = read(points.z + k);
    V least = read(points.least + k), nearest = read(points.nearest + k);
    for (std::size_t i = 0; i < n; ++i) {
      const Record& r = records[rows[i]];
      const double* c = section_of(r);
      const Section section{splat(c[0]), splat(c[1]), splat(c[2]), splat(c[3])};
      take_closer(section_distance(section, plan_rho(r, x, y), z),
                  splat(static_cast<double>(ids[i])), least, nearest);
    }
    store(points.least + k, least), store(points.nearest + k, nearest);
  }
}

// Distances grow with the distance in plan, rounded as they are: that is found once for a column,
// and the least of them tells the least distance at each height. Of those that come to no more the
// first is the owner.
template <class Record>
static void plan_least_of(const Record* records, const std::uint32_t* rows,
                          const std::uint32_t* ids, std::size_t n, const PlanColumns& columns,
                          PointColumns& points) {
  const double* c = section_of(records[rows[0]]);
  const Section section{splat(c[0]), splat(c[1]), splat(c[2]), splat(c[3])};
  for (std::size_t first = 0; first < columns.count; first += kLanes) {
    alignas(64) double x[kLanes], y[kLanes], z[kLanes], least[kLanes], nearest[kLanes];
    std::size_t at[kLanes];
    for (std::size_t l = 0; l < kLanes; ++l) {
      at[l] = (first + l < columns.count ? first + l : columns.count - 1) * columns.depth;
      x[l] = points.x[at[l]], y[l] = points.y[at[l]];
    }
    const V own_first = splat(static_cast<double>(ids[0]));
    const auto heights = [&](std::size_t k) {
      for (std::size_t l = 0; l < kLanes; ++l) z[l] = points.z[at[l] + k];
      return read(z);
    };
    V enough = splat(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < columns.depth; ++k)
      enough = vmin(saturation(section, heights(k)), enough);
    V rho[kSquares], lowest = splat(std::numeric_limits<double>::infinity());
    std::size_t count = 0;
    while (count < n && bits(less(enough, lowest)) != 0) {
      rho[count] = plan_rho(records[rows[count]], read(x), read(y));
      lowest = vmin(rho[count++], lowest);
    }
    for (std::size_t k = 0; k < columns.depth; ++k) {
      for (std::size_t l = 0; l < kLanes; ++l)
        least[l] = points.least[at[l] + k], nearest[l] = points.nearest[at[l] + k];
      const V height = heights(k), d = section_distance(section, lowest, height);
      V own_least = read(least), own_nearest = read(nearest);
      M open =
          either(less(d, own_least), both(less_equal(d, own_least), less(own_first, own_nearest)));
      if (bits(open) == 0) continue;
      const V most = farthest_equal(section, lowest, height);
      for (std::size_t i = 0; i < count && bits(open) != 0; ++i) {
        const M likely = both(open, less_equal(rho[i], most));
        if (bits(likely) == 0) continue;
        const M found = both(likely, less_equal(section_distance(section, rho[i], height), d));
        const V id = splat(static_cast<double>(ids[i]));
        const M closer = both(found, either(less(d, own_least), less(id, own_nearest)));
        own_least = select(closer, d, own_least), own_nearest = select(closer, id, own_nearest);
        open = except(open, found);
      }
      store(least, own_least), store(nearest, own_nearest);
      for (std::size_t l = 0; l < kLanes; ++l)
        points.least[at[l] + k] = least[l], points.nearest[at[l] + k] = nearest[l];
    }
  }
}

// In runs of one section whose ids ascend; points that fill no more than a register are asked
// alone.
template <class Record>
static void plan_least(const Record* records, const std::uint32_t* rows, const std::uint32_t* ids,
                       std::size_t n, PointColumns& points) {
  if (points.count <= kLanes || n < kFewRecords)
    return plan_least_of_each(records, rows, ids, n, points);
  const PlanColumns columns = plan_columns(points);
  for (std::size_t from = 0, end = 0; from < n; from = end) {
    const double* own = section_of(records[rows[from]]);
    const auto alike = [&](const double* other) {
      return own[0] == other[0] && own[1] == other[1] && own[2] == other[2] && own[3] == other[3];
    };
    for (end = from + 1; end < n && end < from + kSquares; ++end)
      if (ids[end] < ids[end - 1] || !alike(section_of(records[rows[end]]))) break;
    plan_least_of(records, rows + from, ids + from, end - from, columns, points);
  }
}

// Balls of one radius: the least square tells the nearest one, so nothing waits for roots or
// branches. Roots are taken of those that rounding could make equal to it.
template <std::size_t kGroups>
static void ball_line_least_at(std::size_t first, double radius, const LineRecord* records,
                               const std::uint32_t* rows, const std::uint32_t* ids,
                               const double* scales, std::size_t n, PointColumns& points) {
  V squares[kSquares][kGroups], x[kGroups], y[kGroups], z[kGroups], lowest[kGroups];
  const V r = splat(radius);
  for (std::size_t g = 0; g < kGroups; ++g) {
    const std::size_t k = first + g * kLanes;
    x[g] = read(points.x + k), y[g] = read(points.y + k), z[g] = read(points.z + k);
    lowest[g] = splat(std::numeric_limits<double>::infinity());
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double* record = records[rows[i]].c;
    V c[8];
    for (std::size_t j = 0; j < 8; ++j) c[j] = splat(record[j]);
    const V scale = splat(scales[i]);
    for (std::size_t g = 0; g < kGroups; ++g) {
      squares[i][g] = strip_foot(c, scale, x[g], y[g], z[g]).squared;
      lowest[g] = vmin(squares[i][g], lowest[g]);
    }
  }
  for (std::size_t g = 0; g < kGroups; ++g) {
    const std::size_t k = first + g * kLanes;
    V least = read(points.least + k), nearest = read(points.nearest + k);
    const V root = vsqrt(lowest[g]), reach = root + splat(1e-15) * (root + r);
    const V most = reach * reach * splat(1 + 1e-14);
    for (std::size_t i = 0; i < n; ++i)
      if (bits(less_equal(squares[i][g], most)) != 0)
        take_closer(vsqrt(squares[i][g]) - r, splat(static_cast<double>(ids[i])), least, nearest);
    store(points.least + k, least), store(points.nearest + k, nearest);
  }
}

static void ball_line_least_of(double radius, const LineRecord* records, const std::uint32_t* rows,
                               const std::uint32_t* ids, std::size_t n, PointColumns& points) {
  double scales[kSquares];
  for (std::size_t i = 0; i < n; ++i) {
    const double s = records[rows[i]].c[6];
    scales[i] = 1.0 / (1.0 + s * s);
  }
  std::size_t k = 0;
  for (; k + kLanes < points.count; k += 2 * kLanes)
    ball_line_least_at<2>(k, radius, records, rows, ids, scales, n, points);
  if (k < points.count) ball_line_least_at<1>(k, radius, records, rows, ids, scales, n, points);
}

// The root is taken only where the square leaves room for a least distance: most sweeps go without.
static void ball_line_least_mixed(const LineRecord* records, const std::uint32_t* rows,
                                  const std::uint32_t* ids, std::size_t n, PointColumns& points) {
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V x = read(points.x + k), y = read(points.y + k), z = read(points.z + k);
    V least = read(points.least + k), nearest = read(points.nearest + k);
    for (std::size_t i = 0; i < n; ++i) {
      const double* r = records[rows[i]].c;
      V c[8];
      for (std::size_t j = 0; j < 8; ++j) c[j] = splat(r[j]);
      const V scale = splat(1.0 / (1.0 + r[6] * r[6]));
      const V squared = strip_foot(c, scale, x, y, z).squared;
      const V reach = vmax(least + c[7], splat(0.0));
      if (bits(less_equal(squared, reach * reach * splat(1 + 1e-14))) == 0) continue;
      take_closer(vsqrt(squared) - c[7], splat(static_cast<double>(ids[i])), least, nearest);
    }
    store(points.least + k, least), store(points.nearest + k, nearest);
  }
}

static void ball_line_least(const LineRecord* records, const std::uint32_t* rows,
                            const std::uint32_t* ids, std::size_t n, PointColumns& points) {
  for (std::size_t from = 0; from < n; from += kSquares) {
    const std::size_t some = n - from < kSquares ? n - from : kSquares;
    const double radius = records[rows[from]].c[7];
    bool one = true;
    for (std::size_t i = from; i < from + some; ++i) one = one && records[rows[i]].c[7] == radius;
    if (one)
      ball_line_least_of(radius, records, rows + from, ids + from, some, points);
    else
      ball_line_least_mixed(records, rows + from, ids + from, some, points);
  }
}

static std::uint64_t bore_least(const LineRecord& record, std::uint32_t id, PointColumns& points) {
  V c[8];
  for (std::size_t j = 0; j < 8; ++j) c[j] = splat(record.c[j]);
  const V own = splat(static_cast<double>(id));
  std::uint64_t open = 0;
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const Bore b = bore(c, read(points.x + k), read(points.y + k), read(points.z + k));
    const V least = read(points.least + k), nearest = read(points.nearest + k);
    const M closer = both(
        b.decided,
        either(less(b.distance, least), both(less_equal(b.distance, least), less(own, nearest))));
    store(points.least + k, select(closer, b.distance, least));
    store(points.nearest + k, select(closer, own, nearest));
    open |= std::uint64_t(bits(b.decided) ^ ((1u << kLanes) - 1)) << k;
  }
  return open;
}

// The last of the points is repeated where they do not fill a register.
static void helix_least_of(const HelixRecord& record, std::uint32_t id, std::uint64_t open,
                           PointColumns& points) {
  const M all = less_equal(splat(0.0), splat(0.0));
  while (open != 0) {
    alignas(64) double x[kLanes], y[kLanes], z[kLanes], distance[kLanes];
    std::size_t at[kLanes], n = 0;
    for (; open != 0 && n < kLanes; open &= open - 1)
      at[n++] = static_cast<std::size_t>(std::countr_zero(open));
    for (std::size_t k = 0; k < kLanes; ++k) {
      const std::size_t i = at[k < n ? k : n - 1];
      x[k] = points.x[i], y[k] = points.y[i], z[k] = points.z[i];
    }
    store(distance, helix_least(record, read(x), read(y), read(z), all).distance);
    for (std::size_t k = 0; k < n; ++k) {
      const double d = distance[k];
      double &least = points.least[at[k]], &nearest = points.nearest[at[k]];
      if (d < least || (d == least && id < nearest)) least = d, nearest = id;
    }
  }
}

constexpr double kBoundError = 1e-8;  // mm: rounding of bounds, with room

static void slant_least_of(const SlantRecord& record, std::uint32_t id, PointColumns& points) {
  const V round = splat(record.round), own = splat(static_cast<double>(id));
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V least = read(points.least + k), nearest = read(points.nearest + k);
    const V x = read(points.x + k), y = read(points.y + k), z = read(points.z + k);
    const M wanted = less_equal(slant_bound(record, x, y, z), least + splat(kBoundError));
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
    const V least = read(points.least + k), nearest = read(points.nearest + k);
    const V limit = least + splat(kBoundError);
    const ChainView at =
        chain_view(line, read(points.x + k), read(points.y + k), read(points.z + k));
    const M wanted = less_equal(chain_bound(tool, line, at), limit);
    if (!any(wanted)) continue;
    const V d = chain_least({tool, line, at}, limit, wanted).f;
    const M closer =
        both(wanted, either(less(d, least), both(less_equal(d, least), less(own, nearest))));
    store(points.least + k, select(closer, d, least));
    store(points.nearest + k, select(closer, own, nearest));
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
      add_side(sum, x - read(s.ax + k), y - read(s.ay + k), read(s.dx + k), read(s.dy + k),
               read(s.length + k));
    }
    store(out + k, distance_of(sum) - read(round + k));
  }
}

static void polygon_least(const ConvexPolygon::Side* sides, std::size_t count, double round,
                          bool mirrored, std::uint32_t sweep, PointColumns& points) {
  const V sign = splat(mirrored ? -1.0 : 1.0), id = splat(static_cast<double>(sweep));
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V x = sign * read(points.x + k), y = read(points.z + k);
    SideSum sum = no_sides();
    for (std::size_t i = 0; i < count; ++i) {
      const ConvexPolygon::Side& s = sides[i];
      add_side(sum, x - splat(s.a.x), y - splat(s.a.y), splat(s.direction.x), splat(s.direction.y),
               splat(s.length));
    }
    const V d = distance_of(sum) - splat(round);
    const V least = read(points.least + k), nearest = read(points.nearest + k);
    const M closer = either(less(d, least), both(less_equal(d, least), less(id, nearest)));
    store(points.least + k, select(closer, d, least));
    store(points.nearest + k, select(closer, id, nearest));
  }
}

static const SweepKernels kKernels = {
    kName,
    {ball_line_list, ball_line_least},
    {plane_line_list, plan_least<LineRecord>},
    {plane_arc_list, plan_least<ArcRecord>},
    bore_least,
    helix_least_of,
    slant_least_of,
    chain_least_of,
    polygons,
    polygon_least,
};
