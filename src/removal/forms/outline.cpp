#include "removal/forms/outline.h"

#include <cstddef>

namespace mrsim {
namespace {

OutlineEdge::End::Corner kind_of(Profile::Corner corner) {
  using Kind = OutlineEdge::End::Corner;
  if (corner == Profile::Corner::smooth) return Kind::smooth;
  return corner == Profile::Corner::convex ? Kind::convex : Kind::reflex;
}

// The end of `own` at corner `i`, which `other` shares; on the axis nothing but `own` does.
OutlineEdge::End end_of(const Profile& tool, std::size_t i, const ProfileEdge& own, Vec2 at,
                        const ProfileEdge* other) {
  const Vec2 here = outward(own, at), there = other != nullptr ? outward(*other, at) : here;
  return {kind_of(tool.corner(i)), here.x, here.y, there.x, there.y};
}

}  // namespace

void append_outline(const Profile& tool, std::vector<OutlineEdge>& out) {
  const std::vector<ProfileEdge>& edges = tool.edges();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const ProfileEdge& e = edges[i];
    OutlineEdge o{.ax = e.a.x, .ay = e.a.y, .bx = e.b.x, .by = e.b.y};
    o.dx = e.direction.x, o.dy = e.direction.y, o.length = e.length;
    o.cx = e.center.x, o.cy = e.center.y, o.radius = e.radius, o.is_convex = e.convex;
    if (e.is_arc()) {
      const Vec2 from = (e.convex ? e.a : e.b) - e.center, to = (e.convex ? e.b : e.a) - e.center;
      o.sx = from.x, o.sy = from.y, o.tx = to.x, o.ty = to.y;
      o.is_below_half_turn = cross(from, to) >= 0;
    }
    o.at_a = end_of(tool, i, e, e.a, i > 0 ? &edges[i - 1] : nullptr);
    o.at_b = end_of(tool, i + 1, e, e.b, i + 1 < edges.size() ? &edges[i + 1] : nullptr);
    out.push_back(o);
  }
}

}  // namespace mrsim
