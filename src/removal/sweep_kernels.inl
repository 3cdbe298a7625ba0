// Loops over the forms of sweep_lanes.inl; included once per instruction set by sweep_kernels.cpp,
// with kLanes, V and read, load_line, load_arc,  store in scope. The rest of a list that does
// not fill a register repeats its last sweep and is not stored.

// Rows k .. k + kLanes - 1, the last one repeated.
MRSIM_LANE void pick(const std::uint32_t* rows, std::size_t k, std::size_t n, std::uint32_t* out) {
  for (std::size_t j = 0; j < kLanes; ++j) out[j] = rows[k + j < n ? k + j : n - 1];
}

#define MRSIM_FORM(form, Record, load, kColumns)                                                 \
  static void form##_list(const Record* records, const std::uint32_t* rows, std::size_t n,       \
                          const Vec3& p, double* out) {                                          \
    const V x = splat(p.x), y = splat(p.y), z = splat(p.z);                                      \
    V c[kColumns];                                                                               \
    std::size_t k = 0;                                                                           \
    for (; k + kLanes <= n; k += kLanes) {                                                       \
      load(records, rows + k, c);                                                                \
      store(out + k, form(c, x, y, z));                                                          \
    }                                                                                            \
    if (k == n) return;                                                                          \
    std::uint32_t rest[kLanes];                                                                  \
    pick(rows, k, n, rest);                                                                      \
    load(records, rest, c);                                                                      \
    store_some(out + k, form(c, x, y, z), n - k);                                                \
  }                                                                                              \
  static void form##_least(const Record* records, const std::uint32_t* rows,                     \
                           const std::uint32_t* ids, std::size_t n, PointColumns& points) {      \
    for (std::size_t k = 0; k < points.count; k += kLanes) {                                     \
      const V x = read(points.x + k), y = read(points.y + k), z = read(points.z + k);            \
      V least = read(points.least + k), nearest = read(points.nearest + k);                      \
      for (std::size_t i = 0; i < n; ++i) {                                                      \
        const double* r = records[rows[i]].c;                                                    \
        V c[kColumns];                                                                           \
        for (std::size_t j = 0; j < kColumns; ++j) c[j] = splat(r[j]);                           \
        const V d = form(c, x, y, z), id = splat(static_cast<double>(ids[i]));                   \
        const M closer = either(less(d, least), both(less_equal(d, least), less(id, nearest)));  \
        least = select(closer, d, least), nearest = select(closer, id, nearest);                 \
      }                                                                                          \
      store(points.least + k, least), store(points.nearest + k, nearest);                        \
    }                                                                                            \
  }

MRSIM_FORM(ball_line, LineRecord, load_line, 8)
MRSIM_FORM(plane_line, LineRecord, load_line, 8)
MRSIM_FORM(plane_arc, ArcRecord, load_arc, 11)
#undef MRSIM_FORM

static const SweepKernels kKernels = {
    kName,
    {ball_line_list, ball_line_least},
    {plane_line_list, plane_line_least},
    {plane_arc_list, plane_arc_least},
};
