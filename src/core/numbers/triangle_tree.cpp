#include "core/numbers/triangle_tree.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr std::uint32_t kNoNeighbor = 0xFFFFFFFFu;
constexpr double kPieceLength = 0.5;  ///< of the mean length of the triangles' boxes, or more
constexpr double kNeedle = 1e-12;     ///< squared sine of an angle: the triangle is its sides

Vec3 to_vec(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

TrianglePoint at(const Vec3& p, const Vec3& point, TriangleFeature feature) {
  const Vec3 d = p - point;
  return {point, dot(d, d), feature};
}

// The point in plan of the part of a triangle above p.z that is nearest to p.
TrianglePoint nearest_in_plan_on(const TriangleTree::Corners& k, const Vec3& p) {
  const std::array<Vec3, 3> corners{k.a, k.b, k.c};
  std::array<Vec3, 4> above;
  std::size_t count = 0;
  const auto add = [&](const Vec3& v) { above[count++] = {v.x, v.y, 0}; };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
    if (a.z > p.z) add(a);
    if ((a.z > p.z) != (b.z > p.z)) add(a + ((p.z - a.z) / (b.z - a.z)) * (b - a));
  }
  if (count < 3) return {};
  const Vec3 plan{p.x, p.y, 0};
  const TrianglePoint first = nearest_on_triangle(plan, above[0], above[1], above[2]);
  if (count == 3) return first;
  const TrianglePoint second = nearest_on_triangle(plan, above[0], above[2], above[3]);
  return second.distance2 < first.distance2 ? second : first;
}

// Voronoi regions of the corners, edges and the face in turn (Ericson, Real-Time Collision
// Detection, 5.1.5). Infinitely far or no number for some points about a triangle without area.
TrianglePoint nearest_by_regions(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return at(p, a, 0);
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return at(p, b, 1);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return at(p, a + (d1 / (d1 - d3)) * ab, 3);
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return at(p, c, 2);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return at(p, a + (d2 / (d2 - d6)) * ac, 5);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return at(p, b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b), 4);
  const double square = va + vb + vc;  // of the normal
  if (!(square > kNeedle * dot(ab, ab) * dot(ac, ac))) return {};
  const double scale = 1 / square;
  return at(p, a + (vb * scale) * ab + (vc * scale) * ac, kTriangleFace);
}

TrianglePoint nearest_on_sides(const Vec3& p, const std::array<Vec3, 3>& corners) {
  TrianglePoint best;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned next = (i + 1) % 3;
    const Vec3 way = corners[next] - corners[i];
    const double square = dot(way, way), along = dot(p - corners[i], way);
    const TrianglePoint point =
        !(along > 0)      ? at(p, corners[i], TriangleFeature(i))
        : along >= square ? at(p, corners[next], TriangleFeature(next))
                          : at(p, corners[i] + (along / square) * way, TriangleFeature(3 + i));
    if (point.distance2 < best.distance2) best = point;
  }
  return best;
}

double extent(const FloatBox& box, std::size_t axis) {
  return static_cast<double>(box.hi[axis]) - box.lo[axis];
}

// Rounded outwards, by more than the rounding of p.
void extend_to(FloatBox& box, const Vec3& p) {
  const std::array<float, 3> at{static_cast<float>(p.x), static_cast<float>(p.y),
                                static_cast<float>(p.z)};
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::min(box.lo[k], std::nextafter(at[k], -FloatBox::kFar));
    box.hi[k] = std::max(box.hi[k], std::nextafter(at[k], FloatBox::kFar));
  }
}

// The box about what a triangle has between two planes across an axis.
FloatBox box_between(const TriangleTree::Corners& k, std::size_t axis, double from, double to) {
  const std::array<Vec3, 3> corners{k.a, k.b, k.c};
  const auto along = [&](const Vec3& p) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; };
  FloatBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
    const double first = along(a), last = along(b);
    if (first >= from && first <= to) extend_to(box, a);
    for (const double plane : {from, to})
      if ((first < plane) != (last < plane))
        extend_to(box, a + ((plane - first) / (last - first)) * (b - a));
  }
  return box;
}

// The boxes of a triangle's pieces of about that length, across its longest extent.
void add_pieces(const TriangleTree::Corners& corners, const FloatBox& whole, double length,
                std::vector<FloatBox>& boxes) {
  const std::size_t axis = whole.longest_axis();
  const double low = whole.lo[axis], all = extent(whole, axis);
  const double count = length > 0 ? std::ceil(all / length) : 1;
  if (count < 2) {
    boxes.push_back(whole);
    return;
  }
  for (double k = 0; k < count; ++k)
    boxes.push_back(box_between(corners, axis, low + k / count * all, low + (k + 1) / count * all));
}

}  // namespace

TrianglePoint nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const TrianglePoint found = nearest_by_regions(p, a, b, c);
  return found.distance2 < std::numeric_limits<double>::infinity() ? found
                                                                   : nearest_on_sides(p, {a, b, c});
}

TriangleTree::TriangleTree(const TriMesh& mesh, Boxes boxes) : triangles_(mesh.triangles) {
  MRSIM_ASSERT(!triangles_.empty());
  for (const auto& v : mesh.vertices) extend(bounds_, to_vec(v));
  corners_.reserve(triangles_.size());
  for (const auto& t : triangles_)
    corners_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  build_boxes(boxes);
  build_normals(mesh.vertices.size());
}

// The boxes of long triangles side by side overlap everywhere; those of their pieces do not.
void TriangleTree::build_boxes(Boxes kind) {
  std::vector<FloatBox> whole(triangles_.size());
  double sum = 0;
  for (std::size_t t = 0; t < whole.size(); ++t) {
    for (const auto& v : corners_[t]) whole[t].extend({v, v});
    sum += extent(whole[t], whole[t].longest_axis());
  }
  const double piece =
      kind == Boxes::pieces ? kPieceLength * sum / static_cast<double>(whole.size()) : kInfinity;
  std::vector<FloatBox> boxes;
  std::vector<std::uint32_t> owners;
  for (std::uint32_t t = 0; t < whole.size(); ++t) {
    add_pieces(corners(t), whole[t], piece, boxes);
    owners.resize(boxes.size(), t);
  }
  boxes_ = WideBoxTree(boxes, owners);
}

TriangleTree::Corners TriangleTree::corners(std::uint32_t triangle) const {
  const auto& k = corners_[triangle];
  return {to_vec(k[0]), to_vec(k[1]), to_vec(k[2])};
}

Vec3 TriangleTree::normal(std::uint32_t triangle) const {
  const Corners k = corners(triangle);
  return normalized(cross(k.b - k.a, k.c - k.a));
}

double TriangleTree::area(std::uint32_t triangle) const {
  const Corners k = corners(triangle);
  return length(cross(k.b - k.a, k.c - k.a)) / 2;
}

void TriangleTree::build_normals(std::size_t vertices) {
  vertex_normals_.assign(vertices, {});
  neighbors_.assign(triangles_.size(), {kNoNeighbor, kNoNeighbor, kNoNeighbor});
  struct Edge {
    std::uint32_t low, high, triangle, corner;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const Vec3 n = normal(t);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t v = triangles_[t][i], next = triangles_[t][(i + 1) % 3];
      const Vec3 corner = to_vec(corners_[t][i]), u = to_vec(corners_[t][(i + 1) % 3]) - corner,
                 w = to_vec(corners_[t][(i + 2) % 3]) - corner;
      vertex_normals_[v] += mrsim::atan2(length(cross(u, w)), dot(u, w)) * n;
      edges.push_back({std::min(v, next), std::max(v, next), t, i});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.low != b.low     ? a.low < b.low
           : a.high != b.high ? a.high < b.high
                              : a.triangle < b.triangle;
  });
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const Edge &a = edges[i - 1], &b = edges[i];
    if (a.low != b.low || a.high != b.high) continue;
    neighbors_[a.triangle][a.corner] = b.triangle;
    neighbors_[b.triangle][b.corner] = a.triangle;
  }
}

TriangleTree::Hit TriangleTree::nearest(const Vec3& p, std::uint32_t hint) const {
  Hit best;
  // Pieces of one triangle lie in many leaves: those that were tested last are not tested again.
  constexpr std::size_t kRecent = 8;
  std::array<std::uint32_t, kRecent> recent;
  recent.fill(kNoNeighbor);
  std::size_t tested = 0;
  const auto test = [&](std::uint32_t t) {
    for (const std::uint32_t r : recent)
      if (r == t) return best.distance2;
    recent[tested++ % kRecent] = t;
    const Corners k = corners(t);
    const TrianglePoint point = nearest_on_triangle(p, k.a, k.b, k.c);
    if (point.distance2 < best.distance2 ||
        (point.distance2 == best.distance2 && t < best.triangle)) {
      static_cast<TrianglePoint&>(best) = point;
      best.triangle = t;
    }
    return best.distance2;
  };
  test(hint < triangles_.size() ? hint : 0);
  boxes_.search(p, best.distance2, test);
  return best;
}

bool TriangleTree::is_near(const Vec3& p, double most) const {
  bool found = false;
  boxes_.search(p, most * most, [&](std::uint32_t t) {
    const Corners k = corners(t);
    found = found || nearest_on_triangle(p, k.a, k.b, k.c).distance2 <= most * most;
    return found ? -1.0 : most * most;
  });
  return found;
}

TrianglePoint TriangleTree::nearest_in_plan(const Vec3& p, double most) const {
  TrianglePoint best;
  double best2 = most * most;
  boxes_.search_in_plan(p, best2, [&](std::uint32_t t) {
    const TrianglePoint point = nearest_in_plan_on(corners(t), p);
    if (point.distance2 < best2) best = point, best2 = point.distance2;
    return best2;
  });
  return best;
}

Vec3 TriangleTree::pseudonormal(const Hit& hit) const {
  const Vec3 face = normal(hit.triangle);
  if (hit.feature == kTriangleFace) return face;
  if (hit.feature < 3) return vertex_normals_[triangles_[hit.triangle][hit.feature]];
  const std::uint32_t other = neighbors_[hit.triangle][hit.feature - 3u];
  return other == kNoNeighbor ? face : face + normal(other);
}

double TriangleTree::signed_distance(const Vec3& p, const Hit& hit) const {
  const double d = std::sqrt(hit.distance2);
  return dot(p - hit.point, pseudonormal(hit)) < 0 ? -d : d;
}

std::size_t TriangleTree::memory() const {
  return corners_.capacity() * sizeof(corners_[0]) + triangles_.capacity() * sizeof(triangles_[0]) +
         boxes_.memory() + neighbors_.capacity() * sizeof(neighbors_[0]) +
         vertex_normals_.capacity() * sizeof(Vec3);
}

}  // namespace mrsim
