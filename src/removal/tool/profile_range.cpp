#include "removal/tool/profile_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

FaceRange edge_range(const ProfileEdge& e, const Section& s) {
  if (!e.is_arc()) {
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
  return e.is_arc() && e.center == f.center && e.radius == f.radius && e.convex == f.convex;
}

// Direction of travel at the ends of an edge that is a line or bulges out.
Vec2 along(const ProfileEdge& e, Vec2 at) {
  return e.is_arc() ? (1 / e.radius) * Vec2{e.center.y - at.y, at.x - e.center.x} : e.direction;
}
Vec2 start_of(const ProfileEdge& e) { return along(e, e.a); }
Vec2 end_of(const ProfileEdge& e) { return along(e, e.b); }

}  // namespace

// Arcs that bulge out and lines that join smoothly, and never go down, bound a convex region of the
// plane when the ends are continued: the distance is that from the region, a convex function. True
// where the nearest point of its border is not on what is added: between the normals at the ends,
// less deep than an arc's centre.
FaceRange profile_face_range(const Profile& profile, const Section& s, std::int32_t patch) {
  const std::vector<ProfileEdge>& edges = profile.edges();
  const auto of_patch = [patch](const ProfileEdge& e) { return e.patch == patch; };
  const auto first = std::find_if(edges.begin(), edges.end(), of_patch);
  if (first == edges.end()) return {};
  const auto last = std::prev(std::find_if_not(first, edges.end(), of_patch));
  if (std::all_of(first, last + 1,
                  [&](const ProfileEdge& e) { return &e == &*first || same_circle(*first, e); }))
    return edge_range(*first, s);
  double least_radius = std::numeric_limits<double>::infinity();
  for (auto e = first; e <= last; ++e) {
    if (e->is_arc() && !e->convex) return {};
    if (e->is_arc()) least_radius = std::min(least_radius, e->radius);
  }
  const bool from_axis = first->a.x == 0 && start_of(*first).y == 0;
  for (const Vec2& q : s.hull) {
    if (!from_axis && dot(q - first->a, start_of(*first)) < -kBorder) return {};
    if (!std::isinf(last->b.y) && dot(q - last->b, end_of(*last)) > kBorder) return {};
  }
  const FaceRange range = convex_section_range(
      s, least_radius, [&](Vec2 q) { return profile.face_distance(q, patch); },
      [&](Vec2 q) { return profile.gradient(q, patch); });
  return range.lo > -least_radius ? range : FaceRange{};
}

}  // namespace mrsim
