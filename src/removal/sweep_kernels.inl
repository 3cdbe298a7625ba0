// Loops over the forms of sweep_lanes.inl; included once per instruction set by sweep_kernels.cpp,
// with kLanes, V and load_line, load_arc, load_points, store in scope. The rest of a list that does
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
  static void form##_points(const Record& record, const Vec3* points, std::size_t n,             \
                            double* out) {                                                       \
    V c[kColumns];                                                                               \
    for (std::size_t i = 0; i < kColumns; ++i) c[i] = splat(record.c[i]);                        \
    V x, y, z;                                                                                   \
    std::size_t k = 0;                                                                           \
    for (; k + kLanes <= n; k += kLanes) {                                                       \
      load_points(points + k, x, y, z);                                                          \
      store(out + k, form(c, x, y, z));                                                          \
    }                                                                                            \
    if (k == n) return;                                                                          \
    Vec3 rest[kLanes];                                                                           \
    for (std::size_t j = 0; j < kLanes; ++j) rest[j] = points[k + j < n ? k + j : n - 1];        \
    load_points(rest, x, y, z);                                                                  \
    store_some(out + k, form(c, x, y, z), n - k);                                                \
  }                                                                                              \
  static void form##_nearest(const Record* records, const std::uint32_t* rows, std::size_t n,    \
                             const Vec3& p, const NearestColumns& out) {                         \
    const V x = splat(p.x), y = splat(p.y), z = splat(p.z);                                      \
    V c[kColumns];                                                                               \
    for (std::size_t k = 0; k < n; k += kLanes) {                                                \
      std::uint32_t some[kLanes];                                                                \
      pick(rows, k, n, some);                                                                    \
      load(records, some, c);                                                                    \
      const Near f = form##_near(c, x, y, z);                                                    \
      const std::size_t left = n - k < kLanes ? n - k : kLanes;                                  \
      store_some(out.distance + k, f.distance, left);                                            \
      store_some(out.squared + k, f.squared, left);                                              \
      store_some(out.x + k, f.x, left);                                                          \
      store_some(out.y + k, f.y, left);                                                          \
      store_some(out.z + k, f.z, left);                                                          \
    }                                                                                            \
  }

MRSIM_FORM(ball_line, LineRecord, load_line, 8)
MRSIM_FORM(plane_line, LineRecord, load_line, 8)
MRSIM_FORM(plane_arc, ArcRecord, load_arc, 11)
#undef MRSIM_FORM

static const SweepKernels kKernels = {
    kName,
    {ball_line_list, ball_line_points, ball_line_nearest},
    {plane_line_list, plane_line_points, plane_line_nearest},
    {plane_arc_list, plane_arc_points, plane_arc_nearest},
};
