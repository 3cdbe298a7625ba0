#include "removal/tool/polygon.h"

#include "core/numbers/rounding.h"

#include <algorithm>

namespace mrsim {
namespace {

using Side = ConvexPolygon::Side;

constexpr double kNoWidth = 1e-12;  // mm

// Convex hull, counter-clockwise (Andrew's monotone chain), points on its sides left out.
std::vector<Vec2> hull(std::vector<Vec2> p) {
  std::sort(p.begin(), p.end(),
            [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  p.erase(std::unique(p.begin(), p.end(), [](Vec2 a, Vec2 b) { return length(b - a) < kNoWidth; }),
          p.end());
  if (p.size() < 3) return p;
  std::vector<Vec2> h;
  const auto add = [&h](Vec2 q, std::size_t keep) {
    while (h.size() > keep) {
      const Vec2 in = h.back() - h[h.size() - 2], on = q - h.back();
      if (cross(in, on) > kNoWidth * (length(in) + length(on))) break;
      h.pop_back();
    }
    h.push_back(q);
  };
  for (Vec2 q : p) add(q, 1);
  const std::size_t lower = h.size();
  for (std::size_t i = p.size() - 1; i-- > 0;) add(p[i], lower);
  h.pop_back();
  return h;
}

}  // namespace

ConvexPolygon make_polygon(std::span<const Vec2> points) {
  const std::vector<Vec2> h = hull({points.begin(), points.end()});
  ConvexPolygon polygon;
  polygon.point = h.front();
  if (h.size() < 2) return polygon;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const Vec2 d = h[(i + 1) % h.size()] - h[i];
    const double n = length(d);
    polygon.sides.push_back({h[i], (1 / n) * d, n});
    // A segment has ends, or the whole line through it would count as inside.
    if (h.size() == 2) polygon.sides.push_back({h[1 - i], (-1 / n) * right_of(d), 0});
  }
  return polygon;
}

double polygon_distance(const ConvexPolygon& polygon, Vec2 q) {
  if (polygon.sides.empty()) return length(q - polygon.point);
  double most = -kInfinity, least = kInfinity;
  for (const Side& s : polygon.sides) {
    const double n = side_of(s, q);
    if (n > most) most = n;
    if (n <= 0) continue;
    const double d = side_distance(s, q);
    if (d < least) least = d;
  }
  return most > 0 ? least : most;
}

// Outside of a corner, the one that looks at the point more directly.
std::int32_t polygon_side(const ConvexPolygon& polygon, Vec2 q) {
  double most = -kInfinity;
  std::int32_t found = 0;
  for (std::size_t i = 0; i < polygon.sides.size(); ++i) {
    const double n = side_of(polygon.sides[i], q);
    if (n > most) most = n, found = static_cast<std::int32_t>(i);
  }
  return found;
}

Vec2 polygon_gradient(const ConvexPolygon& polygon, Vec2 q) {
  if (polygon.sides.empty()) {
    const Vec2 off = q - polygon.point;
    const double n = length(off);
    return n > 0 ? (1 / n) * off : Vec2{1, 0};
  }
  Vec2 g = right_of(polygon.sides[static_cast<std::size_t>(polygon_side(polygon, q))].direction);
  if (polygon_distance(polygon, q) <= kNoWidth) return g;
  double least = kInfinity;
  for (const Side& e : polygon.sides) {
    if (side_of(e, q) <= 0) continue;
    const Vec2 off = q - foot_on(e, q);
    const double n = length(off);
    if (n < least && n > 0) least = n, g = (1 / n) * off;
  }
  return g;
}

}  // namespace mrsim
