#include "mesh/simplify/simplify.h"

#include "core/process/parallel.h"
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

using Triangle = std::array<std::uint32_t, 3>;

constexpr double kGrowth = 1.6;       ///< of the length of new edges, from pass to pass
constexpr double kFineCosine = 0.98;  ///< between a new triangle and the exact surface: 11 degrees
constexpr double kLeastCosine = 0.3;  ///< where the triangles before lie no better
constexpr double kNoSquare = 1e-30;   ///< mm^2: in place of the length of two equal places, squared
constexpr double kStraightCosine = 1 - 1e-9;
constexpr std::size_t kBlocks = 8;        ///< parts of the mesh that are worked on at once
constexpr std::size_t kLeastBlock = 256;  ///< vertices that are worth a block

// One place of the fan about a vertex: the triangle (vertex, next, last).
struct Spoke {
  std::uint32_t triangle, next, last;
};

// The mesh from which vertices are removed. Blocks share it: a block removes a vertex only if the
// vertex and all its neighbours are its own, so nothing changes that another block reads or writes.
struct Simplified {
  Simplified(const LabelledMesh& from, const std::vector<char>& locked_vertices)
      : mesh(from),
        locked(locked_vertices),
        alive(from.triangles.size(), 1),
        around(from.vertices.size()),
        tried(from.vertices.size(), 0),
        wanted(from.vertices.size(), 0) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::uint32_t v : mesh.triangles[t]) around[v].push_back(t);
  }

  LabelledMesh mesh;
  const std::vector<char>& locked;
  std::vector<char> alive;  ///< by triangle
  std::vector<std::vector<std::uint32_t>> around;
  std::vector<char> tried;
  std::vector<double> wanted;       ///< length of edges without which a vertex can not be removed
  std::vector<std::uint8_t> block;  ///< by vertex; empty: all are one
};

class Simplifier {
 public:
  Simplifier(const ExactField& field, const CellOctree& tree, const SimplifyLimits& limits,
             Simplified& shared, FlatMap& measured)
      : field_(field),
        tree_(tree),
        limits_(limits),
        shared_(shared),
        mesh_(shared.mesh),
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
      if (!shared_.around[v].empty() && !shared_.locked[v] && !shared_.tried[v] &&
          shared_.wanted[v] <= longest)
        try_remove(v, longest);
  }

  Spoke spoke(std::uint32_t v, std::uint32_t t) const {
    const Triangle& x = mesh_.triangles[t];
    const std::size_t k = x[0] == v ? 0 : x[1] == v ? 1 : 2;
    return {t, x[(k + 1) % 3], x[(k + 2) % 3]};
  }

  // The spokes of v in turn; false for a vertex that is not simple enough to be removed.
  bool ring(std::uint32_t v) {
    const std::vector<std::uint32_t>& fan = shared_.around[v];
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
    return mesh_.labels[ring_[k % ring_.size()].triangle];
  }

  // Vertices at a block's border are left for the whole.
  bool is_inside(std::uint32_t v) const {
    const auto& block = shared_.block;
    return block.empty() || std::all_of(ring_.begin(), ring_.end(),
                                        [&](const Spoke& s) { return block[s.next] == block[v]; });
  }

  void try_remove(std::uint32_t v, double longest) {
    const bool is_simple = ring(v);
    if (!is_inside(v)) return;
    shared_.tried[v] = 1;
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
    shared_.wanted[v] = std::numeric_limits<double>::infinity();
    for (const auto& [size, k] : targets_) {
      const double needed = longest_edge(k);
      if (needed > longest) {
        shared_.wanted[v] = std::min(shared_.wanted[v], needed);
        shared_.tried[v] = 0;
      } else if (may_collapse(v, k)) {
        collapse(v, k);
        return;
      }
    }
  }

  void add_target(std::uint32_t v, std::size_t k) {
    targets_.emplace_back(distance(mesh_.vertices[v], mesh_.vertices[ring_[k].next]), k);
  }

  // Length of the longest edge that collapsing v along spoke k would make, mm.
  double longest_edge(std::size_t k) const {
    const Vec3& target = mesh_.vertices[ring_[k].next];
    double most = 0;
    for (const Spoke& s : ring_) most = std::max(most, distance(target, mesh_.vertices[s.next]));
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
    triangle.add(std::uint64_t(s.last) << 32 | mesh_.labels[s.triangle]);
    if (const int known = measured_.find(triangle.value()); known >= 0) return known == 1;
    const double cosine = cosine_to_face(s, mesh_.vertices[to]);
    if (!(cosine > kFineCosine)) {
      if (!least) least = std::max(least_cosine(v), kLeastCosine);
      return cosine >= *least && good_triangle(s, mesh_.vertices[to]);
    }
    const bool is_good = good_triangle(s, mesh_.vertices[to]);
    measured_.insert(triangle.value(), is_good);
    return is_good;
  }

  // Cosine between the triangle that is to take the place of the spoke's and the exact surface at
  // its middle; -1 for one that has no area.
  double cosine_to_face(const Spoke& s, const Vec3& target) const {
    const Vec3 &a = target, &b = mesh_.vertices[s.next], &c = mesh_.vertices[s.last];
    const Vec3 n = cross(b - a, c - a);
    const double area = length(n);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    if (!(area > kLeastHeight * longest)) return -1;
    return dot(n, field_.gradient((1.0 / 3) * (a + b + c), mesh_.faces[mesh_.labels[s.triangle]])) /
           area;
  }

  // The least cosine of the triangles about v.
  double least_cosine(std::uint32_t v) const {
    double least = 1;
    for (const Spoke& s : ring_) least = std::min(least, cosine_to_face(s, mesh_.vertices[v]));
    return least;
  }

  // Link condition: the ends of the edge have exactly the two opposite vertices as common
  // neighbours.
  bool keeps_manifold(std::uint32_t to, std::size_t k) const {
    const std::size_t n = ring_.size();
    if (n <= 3) return false;
    const std::uint32_t left = ring_[k].last, right = ring_[(k + n - 1) % n].next;
    for (const std::uint32_t t : shared_.around[to]) {
      const Spoke s = spoke(to, t);
      for (const Spoke& r : ring_)
        if (r.next == s.next && r.next != left && r.next != right) return false;
    }
    return shared_.around[left].size() > 3 && shared_.around[right].size() > 3;
  }

  bool keeps_crease(std::uint32_t v, std::size_t k) const {
    if (creases_.empty()) return true;
    const std::size_t other = creases_[0] == k ? creases_[1] : creases_[0];
    const Vec3 &a = mesh_.vertices[ring_[k].next], &b = mesh_.vertices[ring_[other].next];
    const FieldSample &f = mesh_.faces[label(other)],
                      &g = mesh_.faces[label(other + ring_.size() - 1)];
    if (join_smoothly({field_, {}, 0}, mesh_.vertices[v], f, g, 1)) {
      const Vec3 u = b - a;
      const double t = dot(mesh_.vertices[v] - a, u) / std::max(dot(u, u), kNoSquare);
      const double room = is_straight(f, a, b) ? limits_.straight : limits_.lateral;
      if (distance(mesh_.vertices[v], lerp(a, b, t)) > room) return false;
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
    const Vec3 &a = target, &b = mesh_.vertices[s.next], &c = mesh_.vertices[s.last];
    const FieldSample& face = mesh_.faces[mesh_.labels[s.triangle]];
    const double off = triangle_bound(distances_, face, a, b, c, limits_.tolerance).distance;
    if (off > limits_.tolerance) return false;
    return largest_distance(field_, tree_, face, a, b, c, limits_.tolerance, cell_) <=
           limits_.tolerance;
  }

  void collapse(std::uint32_t v, std::size_t k) {
    const std::uint32_t to = ring_[k].next;
    const std::size_t n = ring_.size();
    const std::uint32_t gone[2] = {ring_[k].triangle, ring_[(k + n - 1) % n].triangle};
    for (const std::uint32_t t : gone) {
      shared_.alive[t] = 0;
      for (const std::uint32_t w : mesh_.triangles[t])
        if (w != v) std::erase(shared_.around[w], t);
    }
    for (const Spoke& s : ring_) {
      shared_.tried[s.next] = 0;
      shared_.wanted[s.next] = 0;
      if (!shared_.alive[s.triangle]) continue;
      for (std::uint32_t& w : mesh_.triangles[s.triangle])
        if (w == v) w = to;
      shared_.around[to].push_back(s.triangle);
    }
    shared_.around[v].clear();
  }

  const ExactField& field_;
  const CellOctree& tree_;
  SimplifyLimits limits_;
  Simplified& shared_;
  LabelledMesh& mesh_;
  FlatMap& measured_;
  std::vector<Spoke> ring_;
  std::vector<std::size_t> creases_;
  std::vector<std::pair<double, std::size_t>> targets_;
  mutable FaceDistances distances_{field_};
  mutable std::int32_t cell_ = 0;  ///< of the tree, where the last triangle was measured
};

LabelledMesh compact(const Simplified& s) {
  LabelledMesh out;
  out.faces = s.mesh.faces;
  std::vector<std::uint32_t> id(s.mesh.vertices.size());
  for (std::size_t v = 0; v < s.mesh.vertices.size(); ++v)
    if (!s.around[v].empty()) {
      id[v] = static_cast<std::uint32_t>(out.vertices.size());
      out.vertices.push_back(s.mesh.vertices[v]);
    }
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t)
    if (s.alive[t]) {
      const Triangle& x = s.mesh.triangles[t];
      out.triangles.push_back({id[x[0]], id[x[1]], id[x[2]]});
      out.labels.push_back(s.mesh.labels[t]);
    }
  return out;
}

// Slices of equally many vertices across the longest side, in the order of the vertices.
std::vector<std::vector<std::uint32_t>> slices(const std::vector<Vec3>& vertices, const Box3& box,
                                               std::size_t count) {
  const Vec3 size = box.hi - box.lo;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::vector<double> places;
  for (const Vec3& p : vertices) places.push_back(component(p, axis));
  std::vector<double> sorted = places;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> bounds;
  for (std::size_t k = 1; k < count; ++k) bounds.push_back(sorted[k * sorted.size() / count]);
  std::vector<std::vector<std::uint32_t>> out(count);
  for (std::uint32_t v = 0; v < places.size(); ++v)
    out[static_cast<std::size_t>(std::upper_bound(bounds.begin(), bounds.end(), places[v]) -
                                 bounds.begin())]
        .push_back(v);
  return out;
}

}  // namespace

LabelledMesh simplify(const ExactField& field, const CellOctree& tree, const LabelledMesh& mesh,
                      const SimplifyLimits& limits, const std::vector<char>& locked,
                      MeasuredTriangles& measured, int threads) {
  Simplified shared(mesh, locked);
  Box3 box;
  for (const Vec3& p : mesh.vertices) extend(box, p);
  const double most = mesh.vertices.empty() ? 0 : length(box.hi - box.lo);
  const std::size_t blocks = std::min(kBlocks, mesh.vertices.size() / kLeastBlock);
  measured.of_block.resize(kBlocks + 1);
  if (blocks > 1) {
    const auto parts = slices(mesh.vertices, box, blocks);
    shared.block.resize(mesh.vertices.size());
    for (std::size_t k = 0; k < blocks; ++k)
      for (const std::uint32_t v : parts[k]) shared.block[v] = static_cast<std::uint8_t>(k);
    parallel_for(blocks, threads, [&](std::size_t k) {
      Simplifier(field, tree, limits, shared, measured.of_block[k]).run(parts[k], most);
    });
    shared.block.clear();
  }
  std::vector<std::uint32_t> all(mesh.vertices.size());
  std::iota(all.begin(), all.end(), 0u);
  Simplifier(field, tree, limits, shared, measured.of_block[kBlocks]).run(all, most);
  return compact(shared);
}

}  // namespace mrsim::detail
