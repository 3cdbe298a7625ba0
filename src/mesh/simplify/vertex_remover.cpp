#include "mesh/simplify/vertex_remover.h"

#include "mesh/simplify/triangle_bounds.h"
#include "mesh/solid/exact_predicates.h"
#include "mesh/surface/input_hash.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

namespace mrsim::detail {
namespace {

constexpr double kGrowth = 1.6;       ///< of the length of new edges, from pass to pass
constexpr double kFineCosine = 0.98;  ///< between a new triangle and the exact surface: 11 degrees
constexpr double kLeastCosine = 0.3;  ///< where the triangles before lie no better
constexpr double kNoSquare = 1e-30;   ///< mm^2: in place of the length of two equal places, squared
constexpr double kStraightCosine = 1 - 1e-9;

// What is known of a triangle: outside the tolerance, or within it, and then steep if its angle
// with the surface is not small by itself.
constexpr std::int32_t kOutside = 0, kFine = 1, kSteep = 2;

// One place of the fan about a vertex: the triangle (vertex, next, last).
struct Spoke {
  std::uint32_t triangle, next, last;
};

class VertexRemover {
 public:
  VertexRemover(const ExactField& field, const CellOctree& tree, const SimplifyLimits& limits,
                CollapsedMesh& mesh, FlatMap& measured)
      : field_(field),
        tree_(tree),
        limits_(limits),
        mesh_(mesh),
        from_(mesh.from),
        measured_(measured) {}

  /// Removes what it can of these vertices, short edges first, up to `most` mm.
  void run(std::span<const std::uint32_t> vertices, double most) {
    for (double longest = tree_.lattice().voxel() / 4;; longest *= kGrowth) {
      pass(vertices, longest);
      if (longest > most) break;
    }
  }

 private:
  // Vertices that failed for another reason than length are not tried again until something near
  // them has changed.
  void pass(std::span<const std::uint32_t> vertices, double longest) {
    for (const std::uint32_t v : vertices)
      if (!mesh_.around[v].empty() && !mesh_.locked[v] && !mesh_.tried[v] &&
          mesh_.wanted[v] <= longest)
        try_remove(v, longest);
  }

  Spoke spoke(std::uint32_t v, std::uint32_t t) const {
    const CollapsedMesh::Triangle& x = mesh_.triangles[t];
    const std::size_t k = x[0] == v ? 0 : x[1] == v ? 1 : 2;
    return {t, x[(k + 1) % 3], x[(k + 2) % 3]};
  }

  // The spokes of v in turn; false for a vertex that is not simple enough to be removed.
  bool ring(std::uint32_t v) {
    const std::vector<std::uint32_t>& fan = mesh_.around[v];
    if (fan.size() > 64) return false;
    ring_.clear();
    for (const std::uint32_t t : fan) ring_.push_back(spoke(v, t));
    for (std::size_t k = 0; k + 1 < ring_.size(); ++k) {
      std::size_t m = k + 1;
      while (m < ring_.size() && ring_[m].next != ring_[k].last) ++m;
      if (m == ring_.size()) return false;
      std::swap(ring_[k + 1], ring_[m]);
    }
    return ring_.back().last == ring_.front().next;
  }

  std::uint32_t label(std::size_t k) const {
    return from_.labels[ring_[k % ring_.size()].triangle];
  }

  // Vertices at a block's border are left for the whole.
  bool is_inside(std::uint32_t v) const {
    const auto& block = mesh_.block;
    return block.empty() || std::all_of(ring_.begin(), ring_.end(),
                                        [&](const Spoke& s) { return block[s.next] == block[v]; });
  }

  void try_remove(std::uint32_t v, double longest) {
    const bool is_simple = ring(v);
    if (!is_inside(v)) return;
    mesh_.tried[v] = 1;
    if (!is_simple) return;
    creases_.clear();
    for (std::size_t k = 0; k < ring_.size(); ++k)
      if (label(k) != label(k + ring_.size() - 1)) creases_.push_back(k);
    if (creases_.size() > 2) return;
    targets_.clear();
    if (creases_.empty())
      for (std::size_t k = 0; k < ring_.size(); ++k) add_target(v, k);
    else
      for (const std::size_t k : creases_) add_target(v, k);
    std::sort(targets_.begin(), targets_.end());
    mesh_.wanted[v] = std::numeric_limits<double>::infinity();
    for (const auto& [size, k] : targets_) {
      const double needed = longest_edge(k);
      if (needed > longest) {
        mesh_.wanted[v] = std::min(mesh_.wanted[v], needed);
        mesh_.tried[v] = 0;
      } else if (may_collapse(v, k)) {
        collapse(v, k);
        return;
      }
    }
  }

  void add_target(std::uint32_t v, std::size_t k) {
    targets_.emplace_back(distance(from_.vertices[v], from_.vertices[ring_[k].next]), k);
  }

  // Length of the longest edge that collapsing v along spoke k would make, mm.
  double longest_edge(std::size_t k) const {
    const Vec3& target = from_.vertices[ring_[k].next];
    double most = 0;
    for (const Spoke& s : ring_) most = std::max(most, distance(target, from_.vertices[s.next]));
    return most;
  }

  bool may_collapse(std::uint32_t v, std::size_t k) const {
    const std::uint32_t to = ring_[k].next;
    if (!keeps_manifold(to, k) || !keeps_crease(v, k)) return false;
    const std::size_t n = ring_.size();
    std::optional<double> least;  // cosine of the triangles before, found when needed
    for (std::size_t m = 1; m + 1 < n; ++m)
      if (!may_become(v, ring_[(k + m) % n], to, least)) return false;
    return true;
  }

  // Whether the triangle that is to take the place of the spoke's lies along the surface and within
  // the tolerance.
  bool may_become(std::uint32_t v, const Spoke& s, std::uint32_t to,
                  std::optional<double>& least) const {
    InputHash triangle;
    triangle.add(std::uint64_t(to) << 32 | s.next);
    triangle.add(std::uint64_t(s.last) << 32 | from_.labels[s.triangle]);
    const int known = measured_.find(triangle.value());
    if (known == kOutside || known == kFine) return known == kFine;
    const double cosine = cosine_to_face(s, from_.vertices[to]);
    const bool is_fine = cosine > kFineCosine;
    if (!is_fine) {
      if (!least) least = std::max(least_cosine(v), kLeastCosine);
      if (!(cosine >= *least) || known == kSteep) return cosine >= *least;
    }
    const bool is_good = good_triangle(s, from_.vertices[to]);
    measured_.insert(triangle.value(), !is_good ? kOutside : is_fine ? kFine : kSteep);
    return is_good;
  }

  // Cosine between the triangle that is to take the place of the spoke's and the exact surface at
  // its middle; -1 for one that has no area.
  double cosine_to_face(const Spoke& s, const Vec3& target) const {
    const Vec3 &a = target, &b = from_.vertices[s.next], &c = from_.vertices[s.last];
    const Vec3 n = cross(b - a, c - a);
    const double area = length(n);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    if (!(area > kLeastHeight * longest)) return -1;
    return dot(n, field_.gradient((1.0 / 3) * (a + b + c), from_.faces[from_.labels[s.triangle]])) /
           area;
  }

  // The least cosine of the triangles about v.
  double least_cosine(std::uint32_t v) const {
    double least = 1;
    for (const Spoke& s : ring_) least = std::min(least, cosine_to_face(s, from_.vertices[v]));
    return least;
  }

  // Link condition: the ends of the edge have exactly the two opposite vertices as common
  // neighbours.
  bool keeps_manifold(std::uint32_t to, std::size_t k) const {
    const std::size_t n = ring_.size();
    if (n <= 3) return false;
    const std::uint32_t left = ring_[k].last, right = ring_[(k + n - 1) % n].next;
    for (const std::uint32_t t : mesh_.around[to]) {
      const Spoke s = spoke(to, t);
      for (const Spoke& r : ring_)
        if (r.next == s.next && r.next != left && r.next != right) return false;
    }
    return mesh_.around[left].size() > 3 && mesh_.around[right].size() > 3;
  }

  bool keeps_crease(std::uint32_t v, std::size_t k) const {
    if (creases_.empty()) return true;
    const std::size_t other = creases_[0] == k ? creases_[1] : creases_[0];
    const Vec3 &a = from_.vertices[ring_[k].next], &b = from_.vertices[ring_[other].next];
    const FieldSample &f = from_.faces[label(other)],
                      &g = from_.faces[label(other + ring_.size() - 1)];
    if (join_smoothly({field_, {}, 0}, from_.vertices[v], f, g, 1)) {
      const Vec3 u = b - a;
      const double t = dot(from_.vertices[v] - a, u) / std::max(dot(u, u), kNoSquare);
      const double room = is_straight(f, a, b) ? limits_.straight : limits_.lateral;
      if (distance(from_.vertices[v], lerp(a, b, t)) > room) return false;
    }
    // The middle, and the quarters for a curve that bends both ways.
    const Vec3 m = 0.5 * (a + b);
    return crease_bound(distances_, f, g, a, b) <= limits_.tolerance &&
           crease_bound(distances_, f, g, a, m) <= limits_.tolerance &&
           crease_bound(distances_, f, g, m, b) <= limits_.tolerance;
  }

  // The face does not bend from a to b: there, vertices lie on the borders of owners.
  bool is_straight(const FieldSample& f, const Vec3& a, const Vec3& b) const {
    return dot(field_.gradient(a, f), field_.gradient(b, f)) > kStraightCosine;
  }

  bool good_triangle(const Spoke& s, const Vec3& target) const {
    const Vec3 &a = target, &b = from_.vertices[s.next], &c = from_.vertices[s.last];
    const FieldSample& face = from_.faces[from_.labels[s.triangle]];
    const double off = triangle_bound(distances_, face, a, b, c, limits_.tolerance).distance;
    if (off > limits_.tolerance) return false;
    return largest_distance(distances_, tree_, face, a, b, c, limits_.tolerance, cell_) <=
           limits_.tolerance;
  }

  void collapse(std::uint32_t v, std::size_t k) {
    const std::uint32_t to = ring_[k].next;
    const std::size_t n = ring_.size();
    const std::uint32_t gone[2] = {ring_[k].triangle, ring_[(k + n - 1) % n].triangle};
    for (const std::uint32_t t : gone) {
      mesh_.alive[t] = 0;
      for (const std::uint32_t w : mesh_.triangles[t])
        if (w != v) std::erase(mesh_.around[w], t);
    }
    for (const Spoke& s : ring_) {
      mesh_.tried[s.next] = 0;
      mesh_.wanted[s.next] = 0;
      if (!mesh_.alive[s.triangle]) continue;
      for (std::uint32_t& w : mesh_.triangles[s.triangle])
        if (w == v) w = to;
      mesh_.around[to].push_back(s.triangle);
    }
    mesh_.around[v].clear();
  }

  const ExactField& field_;
  const CellOctree& tree_;
  SimplifyLimits limits_;
  CollapsedMesh& mesh_;
  const LabelledMesh& from_;
  FlatMap& measured_;
  std::vector<Spoke> ring_;
  std::vector<std::size_t> creases_;
  std::vector<std::pair<double, std::size_t>> targets_;
  mutable FaceDistances distances_{field_};
  mutable std::int32_t cell_ = 0;  ///< of the tree, where the last triangle was measured
};

}  // namespace

CollapsedMesh::CollapsedMesh(const LabelledMesh& mesh)
    : from(mesh),
      triangles(mesh.triangles),
      alive(mesh.triangles.size(), 1),
      around(mesh.vertices.size()),
      locked(mesh.vertices.size(), 0),
      tried(mesh.vertices.size(), 0),
      wanted(mesh.vertices.size(), 0) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t v : triangles[t]) around[v].push_back(t);
}

void CollapsedMesh::restore(const std::vector<char>& blocks) {
  const auto is_anew = [&](std::uint32_t v) { return blocks[block[v]] != 0; };
  if (std::ranges::find(blocks, 1) == blocks.end()) return;
  for (std::uint32_t v = 0; v < around.size(); ++v)
    if (is_anew(v)) around[v].clear(), tried[v] = 0, wanted[v] = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Triangle& x = from.triangles[t];
    if (std::ranges::all_of(x, is_anew)) triangles[t] = x, alive[t] = 1;
    for (const std::uint32_t v : x)
      if (is_anew(v)) around[v].push_back(t);
  }
}

LabelledMesh CollapsedMesh::compact() const {
  LabelledMesh out;
  out.faces = from.faces;
  std::vector<std::uint32_t> id(from.vertices.size());
  for (std::size_t v = 0; v < from.vertices.size(); ++v)
    if (!around[v].empty()) {
      id[v] = static_cast<std::uint32_t>(out.vertices.size());
      out.vertices.push_back(from.vertices[v]);
    }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (alive[t]) {
      const Triangle& x = triangles[t];
      out.triangles.push_back({id[x[0]], id[x[1]], id[x[2]]});
      out.labels.push_back(from.labels[t]);
    }
  return out;
}

void remove_vertices(const ExactField& field, const CellOctree& tree, const SimplifyLimits& limits,
                     std::span<const std::uint32_t> vertices, double most, CollapsedMesh& mesh,
                     FlatMap& measured) {
  VertexRemover(field, tree, limits, mesh, measured).run(vertices, most);
}

}  // namespace mrsim::detail
