// Enclosures of the faces of a tool at rest: chains of lines and arcs that join smoothly.
#include "removal/face_range.h"
#include "removal/tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

bool is_arc(const ProfileEdge& e) { return e.radius > 0; }

FaceRange edge_range(const ProfileEdge& e, const Section& s) {
  if (!is_arc(e)) {
    const auto side = [&e](Vec2 q) { return -cross(e.direction, q - e.a); };
    return widened(range_of({side(s.at[0]), side(s.at[1]), side(s.at[2])}), s,
                   {e.direction.y, e.direction.y});
  }
  const FaceRange circle = convex_section_range(
      s, e.radius, [&](Vec2 q) { return length(q - e.center) - e.radius; },
      [&](Vec2 q) {
        const double n = length(q - e.center);
        return n > 0 ? (1 / n) * (q - e.center) : Vec2{};
      });
  return e.convex ? circle : negated(circle);
}

bool same_circle(const ProfileEdge& e, const ProfileEdge& f) {
  return is_arc(e) && e.center == f.center && e.radius == f.radius && e.convex == f.convex;
}

}  // namespace

FaceRange Profile::face_range(const Section& s, std::int32_t patch) const {
  const auto of_patch = [patch](const ProfileEdge& e) { return e.patch == patch; };
  const auto first = std::find_if(edges_.begin(), edges_.end(), of_patch);
  if (first == edges_.end()) return {};
  const auto last = std::find_if_not(first, edges_.end(), of_patch);
  if (std::all_of(first, last,
                  [&](const ProfileEdge& e) { return &e == &*first || same_circle(*first, e); }))
    return edge_range(*first, s);
  return {};
}

double Profile::support(Vec2 n) const {
  if (open_top_ && n.y > 0) return std::numeric_limits<double>::infinity();
  const double size = length(n);
  double most = -std::numeric_limits<double>::infinity();
  for (const ProfileEdge& e : edges_) {
    most = std::max(most, dot(n, e.a));
    if (!std::isinf(e.b.y)) most = std::max(most, dot(n, e.b));
    if (!is_arc(e) || !e.convex || size == 0) continue;
    // What a whole circle has only where its point in this direction is the arc's.
    const Vec2 far = e.center + (e.radius / size) * n;
    if (far.y >= e.a.y && far.y <= e.b.y) most = std::max(most, dot(n, far));
  }
  return most;
}

}  // namespace mrsim
