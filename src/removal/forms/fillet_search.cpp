// In the sector of a concave arc of radius R about c, outside, the distance is L = R - |q - c|,
// with q the place in the tool's section. Inside, the tool's distance is not less. |q - c| is
// convex in q, so that with w = |q - c|, on a straight path, L'' >= -|q'|^2 / w: the radius of q is
// convex as well, and c lies farther out. An arc adds what its position bends. So branch and bound
// needs some tens of values where the Lipschitz bound alone needs 1e5. Deep inside L is far below
// the distance; there planes that touch the tool where it is nearest (Profile::support) bound it.
#include "removal/forms/fillet_search.h"

#include "removal/forms/path_objective.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kDeep = 0.1;     // of the radius: deeper inside nothing more is looked for
constexpr int kMostInside = 40;   // values, once the place is known to lie inside: for its depth
constexpr double kArcBend = 1.5;  // >= sqrt(2): of the radius of the path, along r and z at once

class Fillet {
 public:
  Fillet(const ProfileEdge& arc, const ToolPath& path, const Vec3& p)
      : path_(path),
        p_(p),
        center_(arc.center),
        radius_(arc.radius),
        before_(across(arc.a, arc.b)),
        behind_(across(arc.b, arc.a)) {}

  struct Seen {
    double bound = kInfinity;  ///< no place of the arc is nearer within half of t on both sides
    bool in_sector = false;    ///< the place lies in the arc's sector at `at`
  };
  Seen seen(const PathPoint& at, double half) const {
    const Vec3 from = p_ - at.position;
    const double rho = std::sqrt(from.x * from.x + from.y * from.y), moved = path_.speed * half;
    const Vec2 q = Vec2{rho, from.z} - center_;
    const double off = std::max(dot(q, before_), dot(q, behind_));
    if (off > moved) return {};
    const double w = length(q), least = radius_ - w - moved;
    if (!(w > moved) || !(rho > 0)) return {least, off <= 0};
    const double turn = (from.x * at.direction.x + from.y * at.direction.y) / rho;
    const double slope = std::fabs(q.x * turn + q.y * at.direction.z) / w;
    const double bend =
        path_.speed * path_.speed / (w - moved) + (path_.arc ? kArcBend * path_.radius : 0);
    return {std::max(least, radius_ - w - slope * half - 0.5 * bend * half * half), off <= 0};
  }

 private:
  // Unit normal of the sector's side through `side`, away from `other`.
  Vec2 across(Vec2 side, Vec2 other) const {
    const Vec2 along = (1 / radius_) * (side - center_);
    const Vec2 n{-along.y, along.x};
    return dot(n, other - center_) > 0 ? -1.0 * n : n;
  }

  const ToolPath& path_;
  const Vec3 p_;
  const Vec2 center_;
  const double radius_;
  const Vec2 before_, behind_;
};

// The positions from which a place outside of the pieces may lie where the arc decides and not
// these: between the arc, its centre and the tangents at its ends. On lines and about Z the height
// above the tip says which; others are left out.
struct Span {
  double lo, hi;
};
Span positions_about(const ProfileEdge& arc, const ToolPath& path, const Vec3& p, Span all) {
  if (path.arc && !path.horizontal) return all;
  const Vec2 middle = 0.5 * (arc.a + arc.b) - arc.center;
  const Vec2 apex = arc.center + (arc.radius * arc.radius / dot(middle, middle)) * middle;
  const auto [low, high] = std::minmax({arc.a.y, arc.b.y, arc.center.y, apex.y});
  const double widest = std::max({arc.a.x, arc.b.x, arc.center.x, apex.x});
  if (path.arc) {
    const double x = p.x - path.center.x, y = p.y - path.center.y;
    if (std::fabs(std::sqrt(x * x + y * y) - path.radius) > widest) return {all.hi, all.lo};
  }
  const double z = p.z - (path.arc ? path.center.z : path.start.z);
  const double rise = path.arc ? path.rise.z : path.travel.z;
  if (rise == 0) return low <= z && z <= high ? all : Span{all.hi, all.lo};
  const auto [from, to] = std::minmax({(z - high) / rise, (z - low) / rise});
  return {std::max(all.lo, from), std::min(all.hi, to)};
}

}  // namespace

PathSample search_fillet(const Profile& tool, const ProfileEdge& arc, const ToolPath& path,
                         const Vec3& p, double begin, double end, PathSample best) {
  const Span all =
      best.distance > 0 ? positions_about(arc, path, p, {begin, end}) : Span{begin, end};
  if (!(all.lo <= all.hi)) return best;
  const Fillet fillet(arc, path, p);
  const PathObjective F(tool, path, p);
  const double deep = -kDeep * arc.radius;
  std::array<Span, 128> stack;
  std::size_t depth = 0;
  double finest = 0;
  stack[depth++] = all;
  const auto is_enough = [&](int values) {
    return best.distance <= deep || (best.distance <= 0 && values >= kMostInside);
  };
  for (int values = 0; depth > 0 && !is_enough(values); ++values) {
    const Span in = stack[--depth];
    const double half = 0.5 * (in.hi - in.lo), mid = 0.5 * (in.lo + in.hi);
    const PathPoint at = path_point(path, mid);
    const Fillet::Seen seen = fillet.seen(at, half);
    if (seen.bound >= best.distance - kPathError) continue;
    PathValue plane;
    const PathValue m = F.beside_plane(mid, at, plane);
    const double found = std::max(m.f, deep);
    if (seen.in_sector && found < best.distance) best = {found, mid}, finest = half;
    if (plane_bound(plane, half) >= best.distance - kPathError) continue;
    if (depth + 2 > stack.size()) continue;
    const Span low{in.lo, mid}, high{mid, in.hi};
    stack[depth++] = m.slope < 0 ? low : high;  // the downhill half is looked at first
    stack[depth++] = m.slope < 0 ? high : low;
  }
  if (finest == 0) return best;
  PathSample polished =
      descend(F, std::max(best.t - finest, begin), std::min(best.t + finest, end), best.t);
  polished.distance = std::max(polished.distance, deep);
  return polished.distance < best.distance ? polished : best;
}

}  // namespace mrsim
