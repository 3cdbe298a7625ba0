// SweepTable over lists: sorts a list by the form of its sweeps and hands each part to the kernels.
#include "removal/sweep_columns.h"
#include "removal/sweep_lane_scalar.h"

#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kChunk = 128;

// The sweeps of one form in a chunk of a list: their rows, and where their results go.
struct Part {
  std::size_t n = 0;
  std::uint32_t rows[kChunk];
  std::uint32_t places[kChunk];
  void add(std::uint32_t row, std::size_t place) {
    rows[n] = row;
    places[n++] = static_cast<std::uint32_t>(place);
  }
};

struct Parts {
  Part forms[3];  // ball_line, plane_line, plane_arc
  /// False where the sweep has to be asked on its own.
  bool add(std::uint32_t tag, std::size_t place) {
    const std::uint32_t form = tag >> kTagShift;
    if (form == kOtherForm) return false;
    forms[form].add(tag & kTagRow, place);
    return true;
  }
};

// A chunk of one form needs no scattering: its results go where they belong at once.
template <class Record>
void run(const FormKernels<Record>& kernels, const Record* records, const Part& part,
         std::size_t whole, const Vec3& p, double* out) {
  if (part.n == 0) return;
  if (part.n == whole) return kernels.list(records, part.rows, part.n, p, out);
  double values[kChunk];
  kernels.list(records, part.rows, part.n, p, values);
  for (std::size_t k = 0; k < part.n; ++k) out[part.places[k]] = values[k];
}

template <class Record>
void run_nearest(const FormKernels<Record>& kernels, const Record* records, const Part& part,
                 std::size_t whole, const Vec3& p, const NearestColumns& out) {
  if (part.n == 0) return;
  if (part.n == whole) return kernels.nearest(records, part.rows, part.n, p, out);
  double d[kChunk], s[kChunk], x[kChunk], y[kChunk], z[kChunk];
  kernels.nearest(records, part.rows, part.n, p, {d, s, x, y, z});
  for (std::size_t k = 0; k < part.n; ++k) {
    const std::size_t to = part.places[k];
    out.distance[to] = d[k], out.squared[to] = s[k];
    out.x[to] = x[k], out.y[to] = y[k], out.z[to] = z[k];
  }
}

// Height range and length of a path.
void measure(SweepSkeleton& s, double z0, double z1, double plan_length) {
  s.low = z0 < z1 ? z0 : z1;
  s.high = z0 < z1 ? z1 : z0;
  s.length = std::sqrt(plan_length * plan_length + (z1 - z0) * (z1 - z0));
}

}  // namespace

void SweepTable::distances(std::span<const std::uint32_t> ids, const Vec3& p, double* out) const {
  const SweepKernels& kernels = sweep_kernels();
  const Columns& c = *columns_;
  // A program of one form alone needs no sorting: its rows are its indices.
  if (c.uniform && c.refs.front().kind == SweepKind::ball_line)
    return kernels.ball_line.list(c.ball_lines.data(), ids.data(), ids.size(), p, out);
  if (c.uniform && c.refs.front().kind == SweepKind::plane_line)
    return kernels.plane_line.list(c.plane_lines.data(), ids.data(), ids.size(), p, out);
  for (std::size_t from = 0; from < ids.size(); from += kChunk) {
    const std::size_t n = ids.size() - from < kChunk ? ids.size() - from : kChunk;
    Parts parts;
    for (std::size_t k = 0; k < n; ++k)
      if (!parts.add(c.tags[ids[from + k]], k)) out[from + k] = distance(ids[from + k], p);
    run(kernels.ball_line, c.ball_lines.data(), parts.forms[0], n, p, out + from);
    run(kernels.plane_line, c.plane_lines.data(), parts.forms[1], n, p, out + from);
    run(kernels.plane_arc, c.plane_arcs.data(), parts.forms[2], n, p, out + from);
  }
}

void SweepTable::distances(std::size_t i, std::span<const Vec3> points, double* out) const {
  const SweepKernels& kernels = sweep_kernels();
  const Columns& c = *columns_;
  const SweepRef& ref = c.refs[i];
  const SweepKind kind = ref.frame == 0 ? ref.kind : SweepKind::profile;
  if (kind == SweepKind::ball_line)
    return kernels.ball_line.points(c.ball_lines[ref.row], points.data(), points.size(), out);
  if (kind == SweepKind::plane_line)
    return kernels.plane_line.points(c.plane_lines[ref.row], points.data(), points.size(), out);
  if (kind == SweepKind::plane_arc)
    return kernels.plane_arc.points(c.plane_arcs[ref.row], points.data(), points.size(), out);
  for (std::size_t k = 0; k < points.size(); ++k) out[k] = distance(i, points[k]);
}

SweepSkeleton SweepTable::skeleton(std::size_t i) const {
  const Columns& c = *columns_;
  const SweepRef& ref = c.refs[i];
  SweepSkeleton s;
  if (ref.kind == SweepKind::turn) return c.turn_skeleton(ref);
  if (ref.frame != 0 || ref.kind == SweepKind::path) return s;
  const Profile& tool = c.cutter(ref);
  s.kind = SweepSkeleton::Kind::plan;
  s.rising = tool.is_rising();
  s.radius = tool.max_radius();
  s.flat = tool.is_rounded() ? tool.core() : 0;
  // Two groups a tool: strips and plans are never compared.
  s.group = 2 * ref.shape + (ref.kind == SweepKind::ball_line ? 1 : 0);
  if (ref.kind == SweepKind::ball_line) {
    const double* r = c.ball_lines[ref.row].c;
    s.kind = SweepSkeleton::Kind::strip;
    measure(s, r[2], r[2] + r[6] * r[5], r[5]);
  } else if (ref.kind == SweepKind::ball_arc) {
    const BallArc& b = c.ball_arcs[ref.row];
    s.kind = SweepSkeleton::Kind::strip;
    s.group = 2 * ref.shape + 1;
    s.convex = false;
    measure(s, b.center.z - b.whole.radius, b.center.z + b.whole.radius, 0);
    s.length = b.length;
  } else if (ref.kind == SweepKind::plane_line) {
    const double* r = c.plane_lines[ref.row].c;
    measure(s, r[4] - r[6], r[4] - r[6], std::sqrt(r[2] * r[2] + r[3] * r[3]));
  } else if (ref.kind == SweepKind::plane_arc) {
    const double* r = c.plane_arcs[ref.row].c;
    s.convex = false;
    measure(s, r[7] - r[9], r[7] - r[9], r[11]);
  } else {
    const ProfileRow& row = c.profiles[ref.row];
    s.convex = !row.arc;
    measure(s, row.z, row.z, row.length);
  }
  return s;
}

void SweepTable::nearest(std::span<const std::uint32_t> ids, const Vec3& p,
                         const NearestColumns& out) const {
  const SweepKernels& kernels = sweep_kernels();
  const Columns& c = *columns_;
  if (c.uniform && c.refs.front().kind == SweepKind::ball_line)
    return kernels.ball_line.nearest(c.ball_lines.data(), ids.data(), ids.size(), p, out);
  if (c.uniform && c.refs.front().kind == SweepKind::plane_line)
    return kernels.plane_line.nearest(c.plane_lines.data(), ids.data(), ids.size(), p, out);
  for (std::size_t from = 0; from < ids.size(); from += kChunk) {
    const std::size_t n = ids.size() - from < kChunk ? ids.size() - from : kChunk;
    Parts parts;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t to = from + k;
      if (parts.add(c.tags[ids[to]], k)) continue;
      out.distance[to] = distance(ids[to], p);
      c.other_nearest(c.refs[ids[to]], p, out.squared[to], out.x[to], out.y[to], out.z[to]);
    }
    const NearestColumns at = {out.distance + from, out.squared + from, out.x + from, out.y + from,
                               out.z + from};
    run_nearest(kernels.ball_line, c.ball_lines.data(), parts.forms[0], n, p, at);
    run_nearest(kernels.plane_line, c.plane_lines.data(), parts.forms[1], n, p, at);
    run_nearest(kernels.plane_arc, c.plane_arcs.data(), parts.forms[2], n, p, at);
  }
}

SweepSkeleton SweepColumns::turn_skeleton(const SweepRef& ref) const {
  const TurnSweep& t = turns[ref.row];
  SweepSkeleton s;
  if (t.arc || !t.one_sided) return s;
  s.kind = SweepSkeleton::Kind::section;
  s.group = 2 * ref.shape;
  s.radius = t.round;
  s.low = t.lo.y, s.high = t.hi.y;
  return s;
}

void SweepColumns::other_nearest(const SweepRef& ref, const Vec3& p, double& squared, double& x,
                                 double& y, double& z) const {
  squared = kInfinity, x = p.x, y = p.y, z = p.z;
  if (ref.kind == SweepKind::ball_arc && ref.frame == 0) {
    const BallArcFoot f = ball_arc_foot(ball_arcs[ref.row], ball_arcs[ref.row].whole, p);
    squared = f.squared, x = f.point.x, y = f.point.y, z = f.point.z;
  }
  if (ref.kind == SweepKind::turn && !turns[ref.row].arc && turns[ref.row].one_sided) {
    const Vec2 q = {std::sqrt(p.x * p.x + p.y * p.y), p.z};
    const Vec2 foot = polygon_foot(turns[ref.row].polygon, q);
    squared = dot(q - foot, q - foot), x = foot.x, y = 0, z = foot.y;
  }
  if (ref.kind != SweepKind::profile || ref.frame != 0) return;
  const ProfileRow& row = profiles[ref.row];
  double c[11] = {};
  for (int i = 0; i < 7; ++i) c[i] = row.c[i];
  const lane::Near f =
      row.arc ? lane::plane_arc_near(c, p.x, p.y, p.z) : lane::plane_line_near(c, p.x, p.y, p.z);
  squared = f.squared, x = f.x, y = f.y, z = row.z;
}

}  // namespace mrsim
