#include "mesh/simplify/simplify_apart.h"

#include "core/numbers/vec.h"
#include "mesh/solid/self_intersection.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

namespace mrsim::detail {
namespace {

constexpr int kLockRounds = 7;
constexpr double kMarginGrowth = 3;  ///< of the margin, from round to round

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// The vertices of a mesh by x, to find those in a box.
class SortedVertices {
 public:
  explicit SortedVertices(const std::vector<Vec3>& vertices)
      : vertices_(vertices), order_(vertices.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return vertices[a].x < vertices[b].x; });
  }
  void mark(const Box3& box, std::vector<char>& marks) const {
    auto at = std::lower_bound(order_.begin(), order_.end(), box.lo.x,
                               [&](std::uint32_t v, double x) { return vertices_[v].x < x; });
    for (; at != order_.end() && vertices_[*at].x <= box.hi.x; ++at) {
      const Vec3& p = vertices_[*at];
      if (p.y >= box.lo.y && p.y <= box.hi.y && p.z >= box.lo.z && p.z <= box.hi.z) marks[*at] = 1;
    }
  }

 private:
  const std::vector<Vec3>& vertices_;
  std::vector<std::uint32_t> order_;
};

// A box about the part of a triangle that lies in the plane of another one; about all of it where
// they lie in one plane.
Box3 box_in_plane(const Corners3& t, const Corners3& other) {
  const Vec3 normal = cross(other[1] - other[0], other[2] - other[0]);
  double height[3];
  for (std::size_t k = 0; k < 3; ++k) height[k] = dot(normal, t[k] - other[0]);
  Box3 box;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (height[k] == 0) extend(box, t[k]);
    if ((height[k] < 0) != (height[next] < 0))
      extend(box, lerp(t[k], t[next], height[k] / (height[k] - height[next])));
  }
  if (box.lo.x <= box.hi.x) return box;
  for (const Vec3& p : t) extend(box, p);  // by rounding
  return box;
}

// Locks the vertices of the first mesh about the places where triangles of the small mesh meet.
// Where two triangles meet is bounded by the line in which their planes meet, so that long
// triangles lock no more vertices than necessary.
void lock_about(const LabelledMesh& small, const Pairs& pairs, double margin,
                const SortedVertices& vertices, std::vector<char>& locked) {
  for (const auto& [i, j] : pairs) {
    const Corners3 first = corners_of(small, i), second = corners_of(small, j);
    const Box3 a = box_in_plane(first, second), b = box_in_plane(second, first);
    const Box3 common{max(a.lo, b.lo), min(a.hi, b.hi)};
    vertices.mark(inflated(common, margin), locked);
  }
}

}  // namespace

ApartMesh simplify_apart(const LabelledMesh& mesh, double margin, int threads,
                         const std::function<LabelledMesh(const std::vector<char>&)>& simplify) {
  std::vector<char> locked(mesh.vertices.size(), 0);
  const SortedVertices vertices(mesh.vertices);
  for (int round = 1;;) {
    LabelledMesh small = simplify(locked);
    const Pairs pairs = self_intersections(small.vertices, small.triangles, threads);
    if (pairs.empty())
      return {std::move(small),
              static_cast<std::size_t>(std::count(locked.begin(), locked.end(), 1))};
    // With the same vertices locked, the same triangles would meet again.
    for (const std::vector<char> before = locked; locked == before; ++round) {
      if (round == kLockRounds) return {mesh, mesh.vertices.size()};
      lock_about(small, pairs, margin, vertices, locked);
      margin *= kMarginGrowth;
    }
  }
}

}  // namespace mrsim::detail
