// Lines of ball mills, at many points; included by sweep_kernels.inl.

// Balls of one radius: the least square is the nearest one's, so nothing waits for roots or
// branches. Roots are taken of those that rounding could make equal to it.
template <std::size_t kGroups>
static void ball_line_least_at(std::size_t first, double radius, const LineRecord* records,
                               const std::uint32_t* rows, const std::uint32_t* ids,
                               const double* scales, std::size_t n, PointColumns& points) {
  V squares[kSquares][kGroups], x[kGroups], y[kGroups], z[kGroups], lowest[kGroups];
  const V r = splat(radius);
  for (std::size_t g = 0; g < kGroups; ++g) {
    const std::size_t k = first + g * kLanes;
    x[g] = load(points.x + k), y[g] = load(points.y + k), z[g] = load(points.z + k);
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
    V least = load(points.least + k), nearest = load(points.nearest + k);
    const V root = vsqrt(lowest[g]), reach = root + splat(kNineHalfUlps) * (root + r);
    const V most = reach * reach * splat(1 + kNinetyHalfUlps);
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
    const double s = records[rows[i]].c[BallSlot::slope];
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
    const V x = load(points.x + k), y = load(points.y + k), z = load(points.z + k);
    V least = load(points.least + k), nearest = load(points.nearest + k);
    for (std::size_t i = 0; i < n; ++i) {
      const double* r = records[rows[i]].c;
      V c[8];
      for (std::size_t j = 0; j < 8; ++j) c[j] = splat(r[j]);
      const V scale = splat(1.0 / (1.0 + r[BallSlot::slope] * r[BallSlot::slope]));
      const V squared = strip_foot(c, scale, x, y, z).squared;
      const V reach = vmax(least + c[BallSlot::radius], splat(0.0));
      if (bits(less_equal(squared, reach * reach * splat(1 + kNinetyHalfUlps))) == 0) continue;
      take_closer(vsqrt(squared) - c[BallSlot::radius], splat(static_cast<double>(ids[i])), least,
                  nearest);
    }
    store(points.least + k, least), store(points.nearest + k, nearest);
  }
}

static void ball_line_least(const LineRecord* records, const std::uint32_t* rows,
                            const std::uint32_t* ids, std::size_t n, PointColumns& points) {
  for (std::size_t from = 0; from < n; from += kSquares) {
    const std::size_t some = n - from < kSquares ? n - from : kSquares;
    const double radius = records[rows[from]].c[BallSlot::radius];
    bool one = true;
    for (std::size_t i = from; i < from + some; ++i)
      one = one && records[rows[i]].c[BallSlot::radius] == radius;
    if (one)
      ball_line_least_of(radius, records, rows + from, ids + from, some, points);
    else
      ball_line_least_mixed(records, rows + from, ids + from, some, points);
  }
}
