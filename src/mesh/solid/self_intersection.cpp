#include "mesh/solid/self_intersection.h"

#include "core/numbers/box_tree.h"
#include "core/process/parallel.h"
#include "mesh/solid/exact_predicates.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace mrsim::detail {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t kLeaf = 8;  // triangles
constexpr std::size_t kBlock = 8;   // triangles that go through the tree together
constexpr std::size_t kPart = 512;  // triangles of a task, whole blocks

bool on_segment(const Vec3& p, const Vec3& a, const Vec3& b, int axis) {
  for (const int i : {(axis + 1) % 3, (axis + 2) % 3}) {
    const double x = mrsim::component(p, i), y = mrsim::component(a, i), z = mrsim::component(b, i);
    if (x < std::min(y, z) || x > std::max(y, z)) return false;
  }
  return true;
}

bool segments_meet(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, int axis) {
  const int s = orientation2(p, q, a, axis), t = orientation2(p, q, b, axis);
  const int u = orientation2(a, b, p, axis), v = orientation2(a, b, q, axis);
  if (s * t < 0 && u * v < 0) return true;
  return (s == 0 && on_segment(a, p, q, axis)) || (t == 0 && on_segment(b, p, q, axis)) ||
         (u == 0 && on_segment(p, a, b, axis)) || (v == 0 && on_segment(q, a, b, axis));
}

int flat_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 2; ++axis)
    if (orientation2(a, b, c, axis) != 0) return axis;
  return 2;
}

bool segment_meets_coplanar(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b,
                            const Vec3& c) {
  const int axis = flat_axis(a, b, c);
  const int s = orientation2(a, b, p, axis), t = orientation2(b, c, p, axis),
            u = orientation2(c, a, p, axis);
  if ((s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0)) return true;
  return segments_meet(p, q, a, b, axis) || segments_meet(p, q, b, c, axis) ||
         segments_meet(p, q, c, a, axis);
}

bool segment_meets(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int above = orientation(a, b, c, p), below = orientation(a, b, c, q);
  if (above * below > 0) return false;
  if (above == 0 && below == 0) return segment_meets_coplanar(p, q, a, b, c);
  const int s = orientation(p, q, a, b), t = orientation(p, q, b, c);
  if (s * t < 0) return false;
  const int u = orientation(p, q, c, a);
  return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
}

class PairTest {
 public:
  PairTest(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
      : vertices_(vertices), triangles_(triangles) {}

  bool meet(std::uint32_t i, std::uint32_t j) const {
    const Triangle &s = triangles_[i], &t = triangles_[j];
    int shared = 0, a[3] = {-1, -1, -1}, b[3] = {-1, -1, -1};
    for (int k = 0; k < 3; ++k)
      for (int m = 0; m < 3; ++m)
        if (s[std::size_t(k)] == t[std::size_t(m)]) {
          a[shared] = k;
          b[shared] = m;
          ++shared;
        }
    if (shared == 0) return meet_apart(s, t);
    if (shared == 1)
      return !is_opposite_apart(s, t, b[0]) &&
             (opposite_meets(s, a[0], t) || opposite_meets(t, b[0], s));
    if (shared == 2) return folded(s, a, t, b);
    return true;
  }

 private:
  const Vec3& at(const Triangle& t, int k) const {
    return vertices_[t[static_cast<std::size_t>(k % 3)]];
  }
  bool edge_meets(const Triangle& s, int k, const Triangle& t) const {
    return segment_meets(at(s, k), at(s, k + 1), at(t, 0), at(t, 1), at(t, 2));
  }
  bool opposite_meets(const Triangle& s, int shared, const Triangle& t) const {
    return edge_meets(s, shared + 1, t);
  }
  // On one side of the other's plane: by far the most frequent case.
  bool is_apart(const Triangle& s, const Triangle& t) const {
    const int x = orientation(at(s, 0), at(s, 1), at(s, 2), at(t, 0));
    return x != 0 && x == orientation(at(s, 0), at(s, 1), at(s, 2), at(t, 1)) &&
           x == orientation(at(s, 0), at(s, 1), at(s, 2), at(t, 2));
  }
  // Does what is_apart() does, for two triangles that share a corner of t.
  bool is_opposite_apart(const Triangle& s, const Triangle& t, int shared) const {
    const int x = orientation(at(s, 0), at(s, 1), at(s, 2), at(t, shared + 1));
    return x != 0 && x == orientation(at(s, 0), at(s, 1), at(s, 2), at(t, shared + 2));
  }
  bool meet_apart(const Triangle& s, const Triangle& t) const {
    if (is_apart(s, t) || is_apart(t, s)) return false;
    for (int k = 0; k < 3; ++k)
      if (edge_meets(s, k, t) || edge_meets(t, k, s)) return true;
    return false;
  }
  bool folded(const Triangle& s, const int* a, const Triangle& t, const int* b) const {
    const Vec3 &p = at(s, a[0]), &q = at(s, a[1]);
    const Vec3 &x = at(s, 3 - a[0] - a[1]), &y = at(t, 3 - b[0] - b[1]);
    if (orientation(p, q, x, y) != 0) return false;
    const int axis = flat_axis(p, q, x);
    return orientation2(p, q, x, axis) == orientation2(p, q, y, axis);
  }

  std::span<const Vec3> vertices_;
  std::span<const Triangle> triangles_;
};

// Around a point, rounded outwards.
FloatBox box_of(const Vec3& p) {
  FloatBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = mrsim::component(p, static_cast<int>(k));
    const float near = static_cast<float>(x);
    box.lo[k] = near > x ? std::nextafter(near, -FloatBox::kFar) : near;
    box.hi[k] = near < x ? std::nextafter(near, FloatBox::kFar) : near;
  }
  return box;
}

// The boxes of all triangles.
std::vector<FloatBox> boxes_of(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                               int threads) {
  constexpr std::size_t kChunk = 4096;
  std::vector<FloatBox> boxes(triangles.size());
  parallel_for_chunks(triangles.size(), threads, kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      for (const std::uint32_t v : triangles[k]) boxes[k].extend(box_of(vertices[v]));
  });
  return boxes;
}

std::vector<std::uint32_t> chosen_of(std::size_t count, std::span<const char> chosen) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t k = 0; k < count; ++k)
    if (chosen.empty() || chosen[k]) out.push_back(k);
  return out;
}

// The boxes of the chosen triangles (none chosen: all) in a tree that many are looked up in.
class OverlapSearch {
 public:
  OverlapSearch(std::vector<FloatBox> boxes, std::span<const char> chosen)
      : boxes_(std::move(boxes)), tree_(boxes_, chosen_of(boxes_.size(), chosen), kLeaf) {
    for (const BoxTree::Node& node : tree_.nodes()) {
      leaf_of_.push_back(static_cast<std::uint32_t>(leaves_.size()));
      if (node.count > 0) add_leaf(node);
    }
  }

  /// The triangles of the tree, those that are near each other one after the other.
  const std::vector<std::uint32_t>& order() const { return tree_.order(); }

  /// Calls f(i, j) for the given triangles i, which are near each other in most meshes, and those
  /// of the tree whose boxes overlap theirs.
  template <class F>
  void visit(std::span<const std::uint32_t> some, F&& f) const {
    FloatBox all;
    for (const std::uint32_t i : some) all.extend(boxes_[i]);
    static thread_local std::vector<std::uint32_t> stack;
    stack.assign(tree_.nodes().empty() ? 0 : 1, 0);
    while (!stack.empty()) {
      const std::uint32_t at = stack.back();
      const BoxTree::Node& n = tree_.nodes()[at];
      stack.pop_back();
      if (!n.overlaps(all)) continue;
      if (n.count > 0) {
        for (const std::uint32_t i : some)
          if (n.overlaps(boxes_[i])) visit_leaf(n, leaves_[leaf_of_[at]], i, f);
      } else {
        stack.push_back(n.first);
        stack.push_back(at + 1);
      }
    }
  }

 private:
  // The boxes of a leaf by columns, so that they are tested together.
  struct Leaf {
    float lo[3][kLeaf], hi[3][kLeaf];
  };

  template <class F>
  void visit_leaf(const BoxTree::Node& n, const Leaf& leaf, std::uint32_t i, F& f) const {
    const FloatBox& b = boxes_[i];
    std::int32_t overlap[kLeaf];
    for (std::uint32_t k = 0; k < kLeaf; ++k)
      overlap[k] = (leaf.lo[0][k] <= b.hi[0]) & (b.lo[0] <= leaf.hi[0][k]) &
                   (leaf.lo[1][k] <= b.hi[1]) & (b.lo[1] <= leaf.hi[1][k]) &
                   (leaf.lo[2][k] <= b.hi[2]) & (b.lo[2] <= leaf.hi[2][k]);
    for (std::uint32_t k = 0; k < n.count; ++k)
      if (const std::uint32_t j = tree_.order()[n.first + k]; overlap[k] != 0 && j != i) f(i, j);
  }

  void add_leaf(const BoxTree::Node& node) {
    Leaf& leaf = leaves_.emplace_back();
    for (std::uint32_t k = 0; k < kLeaf; ++k) {
      const FloatBox box = k < node.count ? boxes_[tree_.order()[node.first + k]] : FloatBox();
      for (std::size_t a = 0; a < 3; ++a) leaf.lo[a][k] = box.lo[a], leaf.hi[a][k] = box.hi[a];
    }
  }

  std::vector<FloatBox> boxes_;
  BoxTree tree_;
  std::vector<std::uint32_t> leaf_of_;  ///< by node: its leaf
  std::vector<Leaf> leaves_;
};

// The pairs of triangles that meet.
class PairSearch {
 public:
  PairSearch(std::span<const Vec3> vertices, std::span<const Triangle> triangles, int threads,
             std::span<const char> chosen)
      : test_(vertices, triangles),
        search_(boxes_of(vertices, triangles, threads), chosen),
        chosen_(chosen),
        order_(chosen.empty() ? search_.order() : chosen_of(triangles.size(), {})) {}

  /// Calls take(i, j) for the pairs whose first triangle is at [begin, end) of an order, until it
  /// returns false. Every triangle looks for the chosen ones; two chosen ones meet once.
  template <class F>
  void visit(std::size_t begin, std::size_t end, F&& take) const {
    bool goes_on = true;
    const auto look = [&](std::uint32_t i, std::uint32_t j) {
      const bool is_chosen = chosen_.empty() || chosen_[i];
      if (goes_on && (j > i || !is_chosen) && test_.meet(i, j)) goes_on = take(i, j);
    };
    for (std::size_t first = begin; first < end && goes_on; first += kBlock)
      search_.visit(std::span(order_).subspan(first, std::min(kBlock, end - first)), look);
  }

 private:
  PairTest test_;
  OverlapSearch search_;
  std::span<const char> chosen_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> self_intersections(
    std::span<const Vec3> vertices, std::span<const Triangle> triangles, int threads,
    std::span<const char> chosen) {
  const PairSearch search(vertices, triangles, threads, chosen);
  const std::size_t count = triangles.size();
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> found((count + kPart - 1) /
                                                                          kPart);
  parallel_for_chunks(count, threads, kPart, [&](std::size_t begin, std::size_t end) {
    auto& pairs = found[begin / kPart];
    search.visit(begin, end, [&](std::uint32_t i, std::uint32_t j) {
      pairs.emplace_back(i, j);
      return true;
    });
  });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (const auto& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
  std::sort(all.begin(), all.end());
  return all;
}

bool is_sound(const TriMesh& mesh, int threads) {
  std::vector<Vec3> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) {
    vertices.push_back({v[0], v[1], v[2]});
    if (!is_vertex(vertices.back())) return false;
  }
  for (const Triangle& t : mesh.triangles)
    if (is_degenerate(vertices[t[0]], vertices[t[1]], vertices[t[2]])) return false;
  const PairSearch search(vertices, mesh.triangles, threads, {});
  std::atomic<bool> sound{true};
  parallel_for_chunks(mesh.triangles.size(), threads, kPart,
                      [&](std::size_t begin, std::size_t end) {
                        if (!sound) return;
                        search.visit(begin, end, [&](std::uint32_t, std::uint32_t) {
                          sound = false;
                          return false;
                        });
                      });
  return sound;
}

}  // namespace mrsim::detail
