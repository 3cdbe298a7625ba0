#include "removal/columns/height_segments.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "removal/columns/sweep_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr double kSteepest = 60;       // largest slope of a tangent
constexpr double kSteepFillet = 7;     // the same where the fillet ends upright
constexpr double kArcError = 0.01;     // mm: wanted distance of an arc from its segments
constexpr double kMostSegments = 256;  // of one path
constexpr double kUprightSlope = 64;   // slope from which a move is cut at kShortInPlan mm in plan
constexpr double kShortInPlan = 0.02;
constexpr double kFloatShare = 1e-6;  // slopes are widened by more than floats are rounded (6e-8)

bool is_horizontal(const ProfileEdge& e) { return e.radius == 0 && e.direction.y == 0; }
bool is_upright(const ProfileEdge& e) { return e.radius == 0 && e.direction.x == 0; }

// Disc, fillet and cone, where the profile begins with them; what comes after them.
std::size_t read_underside(const std::vector<ProfileEdge>& edges, HeightTool& t) {
  std::size_t next = 0;
  double core = 0, steepest = 0;
  if (is_horizontal(edges[0])) core = edges[0].b.x, next = 1;
  t.core = static_cast<float>(core);
  if (next < edges.size() && edges[next].radius > 0) {
    const ProfileEdge& arc = edges[next];
    const double across = arc.b.x - arc.center.x;
    if (!arc.convex || std::fabs(arc.center.x - core) > kRounding ||
        std::fabs(arc.center.y - arc.radius) > kRounding || arc.b.y > arc.center.y + kRounding ||
        across <= 0)
      return edges.size();
    t.round = static_cast<float>(arc.radius), t.per_round = static_cast<float>(1 / arc.radius);
    t.reach = static_cast<float>(std::min(across, arc.radius));
    const double up = std::max(arc.center.y - arc.b.y, 0.0);
    steepest = std::min(up > 0 ? across / up : kSteepFillet, kSteepFillet);
    ++next;
  }
  if (next < edges.size() && edges[next].radius == 0 && edges[next].direction.x > 0 &&
      edges[next].direction.y > 0) {
    const double slope = edges[next].direction.y / edges[next].direction.x;
    t.slope = static_cast<float>(slope * (1 + kFloatShare));
    steepest = std::min(slope, kSteepest);
    ++next;
  }
  t.steepest = static_cast<float>(steepest * (1 - kFloatShare));
  t.sine = static_cast<float>(steepest / std::sqrt(1 + steepest * steepest) * (1 - kFloatShare));
  return next;
}

template <typename At>
void add_all(std::vector<LineRecord>& out, int count, double eps, At at) {
  Vec3 from = at(0.0);
  for (int k = 1; k <= count; ++k) {
    const Vec3 to = at(static_cast<double>(k) / count);
    out.push_back(segment_record(from, to, eps));
    from = to;
  }
}

// Segments of an arc of `sweep` radians that come within kArcError of it; 0 where they are too
// many.
int arc_segments(double radius, double sweep) {
  const double count = std::ceil(sweep * std::sqrt(radius / (8 * kArcError)));
  return count > kMostSegments ? 0 : std::max(2, static_cast<int>(count));
}
// A chord differs from its arc, at equal parameters, by at most a^2 R / 8 for an angle a.
double arc_error(double radius, double sweep, int count) {
  const double angle = sweep / count;
  return angle * angle * radius / 8;
}

}  // namespace

bool has_heights(const Profile& tool) { return !tool.empty() && tool.bottom() >= 0; }

HeightTool height_tool(const Profile& tool) {
  const std::vector<ProfileEdge>& edges = tool.edges();
  HeightTool t;
  std::size_t next =
      tool.is_convex() && tool.bottom() == 0 ? read_underside(edges, t) : edges.size();
  t.radius = static_cast<float>(tool.max_radius());
  // What follows has to be the wall, or the flat top.
  const bool ends = next < edges.size() && (is_upright(edges[next]) || is_horizontal(edges[next]));
  double widest = tool.widest();
  if (!ends) {
    t = HeightTool{.core = t.radius, .radius = t.radius};
    t.lift = static_cast<float>(widest);
  }
  for (const ProfileEdge& e : edges)  // upwards, as far as no gap between two teeth comes first
    if (is_upright(e) && e.a.x >= tool.max_radius() && e.a.y <= widest)
      widest = std::max(widest, e.b.y);
  t.top = static_cast<float>(widest);
  return t;
}

LineRecord segment_record(const Vec3& a, const Vec3& b, double eps) {
  const Vec3 &low = b.z < a.z ? b : a, &high = b.z < a.z ? a : b;
  const double dx = high.x - low.x, dy = high.y - low.y, length = std::sqrt(dx * dx + dy * dy);
  const bool point = length < kRounding || high.z - low.z > kUprightSlope * length;
  LineRecord record;
  record.c[BallSlot::x] = low.x, record.c[BallSlot::y] = low.y, record.c[BallSlot::z] = low.z;
  record.c[BallSlot::ux] = length > 0 ? dx / length : 1,
  record.c[BallSlot::uy] = length > 0 ? dy / length : 0;
  record.c[BallSlot::length] = point ? 0 : length;
  record.c[BallSlot::slope] = point ? 0 : (high.z - low.z) / length;
  record.c[BallSlot::error] = eps + (point ? length : 0);
  return record;
}

bool append_segments(const ToolPath& path, std::vector<LineRecord>& out) {
  if (!path.arc) {
    const double plan = std::sqrt(path.travel.x * path.travel.x + path.travel.y * path.travel.y);
    const bool steep = std::fabs(path.travel.z) > kUprightSlope * plan;
    const double count = steep ? std::clamp(std::ceil(plan / kShortInPlan), 1.0, 16.0) : 1;
    add_all(out, static_cast<int>(count), 0,
            [&](double t) { return path.start + t * path.travel; });
    return true;
  }
  const int count = arc_segments(path.radius, path.sweep);
  if (count == 0) return false;
  add_all(out, count, arc_error(path.radius, path.sweep, count),
          [&](double t) { return path_point(path, t * path.sweep).position; });
  return true;
}

bool append_segments(const ProfileRow& row, std::vector<LineRecord>& out) {
  const double* c = row.c;
  if (!row.arc) {
    out.push_back(segment_record(
        {c[LineSlot::x], c[LineSlot::y], row.z},
        {c[LineSlot::x] + c[LineSlot::dx], c[LineSlot::y] + c[LineSlot::dy], row.z}, 0));
    return true;
  }
  const double sweep = c[ArcSlot::radius] > 0 ? row.length / c[ArcSlot::radius] : 0;
  const int count = arc_segments(c[ArcSlot::radius], sweep);
  if (count == 0) return false;
  add_all(out, count, arc_error(c[ArcSlot::radius], sweep, count), [&](double t) {
    const SinCos at = sincos((t - 0.5) * sweep);
    return Vec3{
        c[ArcSlot::x] + c[ArcSlot::radius] * (at.cos * c[ArcSlot::mx] - at.sin * c[ArcSlot::my]),
        c[ArcSlot::y] + c[ArcSlot::radius] * (at.cos * c[ArcSlot::my] + at.sin * c[ArcSlot::mx]),
        row.z};
  });
  return true;
}

}  // namespace mrsim
