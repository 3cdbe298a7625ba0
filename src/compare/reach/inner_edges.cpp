#include "compare/reach/inner_edges.h"

#include "core/numbers/vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace mrsim {
namespace {

// Neighbouring triangles bend inwards by more than this (its sine): an inner edge.
constexpr double kInner = 0.25;
constexpr std::size_t kMostPlaces = 256;

// Points by the cubes of edge `size` that they lie in.
class NearPoints {
 public:
  NearPoints(std::span<const Vec3> points, double size) : size_(size) {
    for (const Vec3& p : points) points_.push_back({cube_of(p), p});
    std::sort(points_.begin(), points_.end(),
              [](const Point& a, const Point& b) { return a.cube < b.cube; });
  }

  /// Whether one is within the cubes' edge.
  bool any_at(const Vec3& p) const {
    const Cube cube = cube_of(p);
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const Cube first{cube[0] + dx, cube[1] + dy, cube[2] - 1};
        auto at = std::lower_bound(points_.begin(), points_.end(), first,
                                   [](const Point& a, const Cube& b) { return a.cube < b; });
        for (const Cube last{first[0], first[1], cube[2] + 1};
             at != points_.end() && at->cube <= last; ++at)
          if (distance(at->point, p) <= size_) return true;
      }
    return false;
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  struct Point {
    Cube cube;
    Vec3 point;
  };
  Cube cube_of(const Vec3& p) const {
    return {std::int64_t(std::floor(p.x / size_)), std::int64_t(std::floor(p.y / size_)),
            std::int64_t(std::floor(p.z / size_))};
  }

  double size_;
  std::vector<Point> points_;
};

Box3 box_of(std::span<const Vec3> points, double margin) {
  Box3 box{points[0], points[0]};
  for (const Vec3& p : points) extend(box, Box3{p, p});
  const Vec3 grown{margin, margin, margin};
  return {box.lo - grown, box.hi + grown};
}

bool overlap(const Box3& box, const Vec3& a, const Vec3& b) {
  return std::max(a.x, b.x) >= box.lo.x && std::min(a.x, b.x) <= box.hi.x &&
         std::max(a.y, b.y) >= box.lo.y && std::min(a.y, b.y) <= box.hi.y &&
         std::max(a.z, b.z) >= box.lo.z && std::min(a.z, b.z) <= box.hi.z;
}

}  // namespace

std::vector<SurfacePlace> inner_edge_places(const NominalSurface& solid,
                                            std::span<const Vec3> points, double near) {
  std::vector<SurfacePlace> places;
  if (points.empty()) return places;
  const TriangleTree& tree = solid.tree();
  const NearPoints covered(points, near);
  const Box3 box = box_of(points, near);
  for (std::uint32_t t = 0; t < tree.size(); ++t) {
    const TriangleTree::Corners k = tree.corners(t);
    const Vec3 corners[3] = {k.a, k.b, k.c};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t other = tree.neighbors(t)[i];
      if (other >= tree.size() || other < t) continue;  // each edge once
      const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
      if (dot(cross(tree.normal(other), tree.normal(t)), normalized(b - a)) < kInner) continue;
      if (!overlap(box, a, b)) continue;
      const auto steps = std::max(2.0, std::ceil(distance(a, b) / near));
      for (double step = 0.5; step < steps; ++step) {
        const Vec3 on = a + (step / steps) * (b - a);
        if (!covered.any_at(on)) continue;
        places.push_back({on, normalized(tree.normal(other) + tree.normal(t))});
        break;
      }
    }
  }
  const std::size_t stride = (places.size() + kMostPlaces - 1) / kMostPlaces;
  if (stride > 1) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < places.size(); i += stride) places[kept++] = places[i];
    places.resize(kept);
  }
  return places;
}

}  // namespace mrsim
