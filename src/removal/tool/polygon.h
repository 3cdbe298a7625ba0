// Convex polygons in the plane with exact signed distances: what inserts are made of.
#pragma once

#include "core/numbers/vec.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Counter-clockwise convex polygon: one point, two points (a rectangle without width) or more.
struct ConvexPolygon {
  struct Side {
    Vec2 a, direction;
    double length = 0;
  };
  std::vector<Side> sides;  ///< empty for a point
  Vec2 point;               ///< the point, or the first corner
};
/// The convex hull of the points, mm. Requires: at least one.
ConvexPolygon make_polygon(std::span<const Vec2> points);

/// Two points: both directions of one segment, each followed by its end.
inline bool is_segment(const ConvexPolygon& polygon) {
  return polygon.sides.size() == 4 && polygon.sides[1].length == 0;
}

/// Signed distance, exact inside and outside.
double polygon_distance(const ConvexPolygon& polygon, Vec2 q);
/// The side that decides the sign of the distance.
std::int32_t polygon_side(const ConvexPolygon& polygon, Vec2 q);
/// Unit gradient of the distance.
Vec2 polygon_gradient(const ConvexPolygon& polygon, Vec2 q);

/// d turned by a quarter clockwise.
inline Vec2 right_of(Vec2 d) { return {d.y, -d.x}; }

/// mm: how far q lies outside of the line of the side.
inline double side_of(const ConvexPolygon::Side& s, Vec2 q) {
  return dot(right_of(s.direction), q - s.a);
}

/// The nearest point of the side.
inline Vec2 foot_on(const ConvexPolygon::Side& s, Vec2 q) {
  const double t = dot(s.direction, q - s.a);
  return s.a + (t < 0 ? 0 : t > s.length ? s.length : t) * s.direction;
}

/// Distance along the normal and beyond the ends, so that points near the line keep all digits.
inline double side_distance(const ConvexPolygon::Side& s, Vec2 q) {
  const double t = dot(s.direction, q - s.a), n = side_of(s, q);
  const double over = t < 0 ? t : t > s.length ? t - s.length : 0;
  return std::sqrt(n * n + over * over);
}

}  // namespace mrsim
