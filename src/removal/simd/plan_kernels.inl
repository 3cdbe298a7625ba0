// Horizontal moves at many points; included by sweep_kernels.inl.
//
// The distance is a function of two numbers, g(rho, z): rho is the distance in plan from the path,
// and g the distance from the tool's section (docs/removal.md, Distances in plan). Points above
// each other share rho, so it is found once for a column of points, and the least rho gives the
// least distance.

// The columns of a record before `low` give the distance in plan; `low`, `core`, `round` and `top`
// are the tool's section at its height.
MRSIM_LANE V plan_rho(const LineRecord& r, V x, V y) {
  V c[LineSlot::low];
  for (std::size_t j = 0; j < LineSlot::low; ++j) c[j] = splat(r.c[j]);
  return line_rho(c, x, y);
}
MRSIM_LANE V plan_rho(const ArcRecord& r, V x, V y) {
  V c[ArcSlot::low];
  for (std::size_t j = 0; j < ArcSlot::low; ++j) c[j] = splat(r.c[j]);
  return arc_rho(c, x, y);
}

// rounded_slab of one section at heights z.
struct Section {
  V low, core, round, top;
};
template <class Slot>
MRSIM_LANE Section section_in(const double* c) {
  return {splat(c[Slot::low]), splat(c[Slot::core]), splat(c[Slot::round]), splat(c[Slot::top])};
}
MRSIM_LANE Section section_of(const LineRecord& r) { return section_in<LineSlot>(r.c); }
MRSIM_LANE Section section_of(const ArcRecord& r) { return section_in<ArcSlot>(r.c); }

template <class Slot>
static bool same_section_in(const double* a, const double* b) {
  return a[Slot::low] == b[Slot::low] && a[Slot::core] == b[Slot::core] &&
         a[Slot::round] == b[Slot::round] && a[Slot::top] == b[Slot::top];
}
static bool same_section(const LineRecord& a, const LineRecord& b) {
  return same_section_in<LineSlot>(a.c, b.c);
}
static bool same_section(const ArcRecord& a, const ArcRecord& b) {
  return same_section_in<ArcSlot>(a.c, b.c);
}

// Distances in plan up to which all give the same distance at height z; less 90 half ulps of the
// radius, where the sums below round by three.
MRSIM_LANE V saturation(const Section& s, V z) {
  const SlabSide side = slab_side(z, s.low, s.core, s.round, s.top);
  return side.core + vmin(side.dz, splat(0.0)) - splat(kNinetyHalfUlps) * (s.core + s.round);
}

MRSIM_LANE V section_distance(const Section& s, V rho, V z) {
  return rounded_slab(rho, z, s.low, s.core, s.round, s.top);
}

// An upper bound of the distances in plan that give, after rounding, the same distance as `rho` at
// heights z: each margin is nine half ulps or more of a value that is rounded once or twice.
MRSIM_LANE V farthest_equal(const Section& s, V rho, V z) {
  const V zero = splat(0.0), unit = splat(kNineHalfUlps);
  const SlabSide side = slab_side(z, s.low, s.core, s.round, s.top);
  const V core = side.core, dr = rho - core, dz = side.dz;
  const V inner = vmax(dr, vmin(dz, zero));
  const V a = vmax(dr, zero), b = vmax(dz, zero);
  const V root = vsqrt(a * a + b * b), reach = root + unit * (root + s.round);
  const V outer = vsqrt(vmax(reach * reach * splat(1 + kNinetyHalfUlps) - b * b, zero));
  const V flat = inner + unit * (vabs(inner) + s.round);
  const V most = select(less(zero, root), vmax(flat, outer), flat);
  return most + core + splat(4 * kNineHalfUlps) * (most + core + core);
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

constexpr std::size_t kFewRecords = 3;  // fewer are evaluated point by point

template <class Record>
static void plan_least_of_each(const Record* records, const std::uint32_t* rows,
                               const std::uint32_t* ids, std::size_t n, PointColumns& points) {
  for (std::size_t k = 0; k < points.count; k += kLanes) {
    const V x = load(points.x + k), y = load(points.y + k), z = load(points.z + k);
    V least = load(points.least + k), nearest = load(points.nearest + k);
    for (std::size_t i = 0; i < n; ++i) {
      const Record& r = records[rows[i]];
      take_closer(section_distance(section_of(r), plan_rho(r, x, y), z),
                  splat(static_cast<double>(ids[i])), least, nearest);
    }
    store(points.least + k, least), store(points.nearest + k, nearest);
  }
}

// Distances grow with the distance in plan, rounded as they are: that is found once for a column,
// and the least of them gives the least distance at each height. Of those that come to no more the
// first is the owner.
template <class Record>
static void plan_least_of(const Record* records, const std::uint32_t* rows,
                          const std::uint32_t* ids, std::size_t n, const PlanColumns& columns,
                          PointColumns& points) {
  const Section section = section_of(records[rows[0]]);
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
      return load(z);
    };
    V enough = splat(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < columns.depth; ++k)
      enough = vmin(saturation(section, heights(k)), enough);
    V rho[kSquares], lowest = splat(std::numeric_limits<double>::infinity());
    std::size_t count = 0;
    while (count < n && bits(less(enough, lowest)) != 0) {
      rho[count] = plan_rho(records[rows[count]], load(x), load(y));
      lowest = vmin(rho[count++], lowest);
    }
    for (std::size_t k = 0; k < columns.depth; ++k) {
      for (std::size_t l = 0; l < kLanes; ++l)
        least[l] = points.least[at[l] + k], nearest[l] = points.nearest[at[l] + k];
      const V height = heights(k), d = section_distance(section, lowest, height);
      V own_least = load(least), own_nearest = load(nearest);
      M active =
          either(less(d, own_least), both(less_equal(d, own_least), less(own_first, own_nearest)));
      if (bits(active) == 0) continue;
      const V most = farthest_equal(section, lowest, height);
      for (std::size_t i = 0; i < count && bits(active) != 0; ++i) {
        const M likely = both(active, less_equal(rho[i], most));
        if (bits(likely) == 0) continue;
        const M found = both(likely, less_equal(section_distance(section, rho[i], height), d));
        const V id = splat(static_cast<double>(ids[i]));
        const M closer = both(found, either(less(d, own_least), less(id, own_nearest)));
        own_least = select(closer, d, own_least), own_nearest = select(closer, id, own_nearest);
        active = except(active, found);
      }
      store(least, own_least), store(nearest, own_nearest);
      for (std::size_t l = 0; l < kLanes; ++l)
        points.least[at[l] + k] = least[l], points.nearest[at[l] + k] = nearest[l];
    }
  }
}

// Sweeps are measured in runs of one section whose ids ascend; so many points as fit one register
// are measured sweep by sweep.
template <class Record>
static void plan_least(const Record* records, const std::uint32_t* rows, const std::uint32_t* ids,
                       std::size_t n, PointColumns& points) {
  if (points.count <= kLanes || n < kFewRecords)
    return plan_least_of_each(records, rows, ids, n, points);
  const PlanColumns columns = plan_columns(points);
  for (std::size_t from = 0, end = 0; from < n; from = end) {
    const Record& own = records[rows[from]];
    for (end = from + 1; end < n && end < from + kSquares; ++end)
      if (ids[end] < ids[end - 1] || !same_section(own, records[rows[end]])) break;
    plan_least_of(records, rows + from, ids + from, end - from, columns, points);
  }
}
