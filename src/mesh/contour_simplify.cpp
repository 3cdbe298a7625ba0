#include "mesh/contour_simplify.h"

#include "mesh/contour_certify.h"
#include "mesh/exact_predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim::detail {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr double kGrowth = 1.6;          ///< of the length of new edges, from pass to pass
constexpr double kLeastAltitude = 2e-5;  ///< mm: of a new triangle
constexpr double kLeastCosine = 0.3;     ///< between a new triangle and the exact surface

// One place of the fan about a vertex: the triangle (vertex, next, last).
struct Spoke {
  std::uint32_t triangle, next, last;
};

class Simplifier {
 public:
  Simplifier(const ExactField& field, const ContourOctree& tree, const LabelledMesh& mesh,
             const SimplifyLimits& limits, const std::vector<char>& locked)
      : field_(field),
        tree_(tree),
        limits_(limits),
        mesh_(mesh),
        locked_(locked),
        alive_(mesh.triangles.size(), 1),
        around_(mesh.vertices.size()),
        tried_(mesh.vertices.size(), 0),
        wanted_(mesh.vertices.size(), 0) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const std::uint32_t v : mesh_.triangles[t]) around_[v].push_back(t);
  }

  LabelledMesh run() {
    double longest = 0, most = 0;
    Box3 box;
    for (const Vec3& p : mesh_.vertices) extend(box, p);
    if (!mesh_.vertices.empty()) most = length(box.hi - box.lo);
    longest = tree_.lattice().voxel() / 4;
    for (;; longest *= kGrowth) {
      pass(longest);
      if (longest > most) break;
    }
    return compact();
  }

 private:
  // Vertices that failed for another reason than length are not tried again until something near
  // them has changed.
  void pass(double longest) {
    for (std::uint32_t v = 0; v < around_.size(); ++v)
      if (!around_[v].empty() && !locked_[v] && !tried_[v] && wanted_[v] <= longest)
        try_remove(v, longest);
  }

  Spoke spoke(std::uint32_t v, std::uint32_t t) const {
    const Triangle& x = mesh_.triangles[t];
    const std::size_t k = x[0] == v ? 0 : x[1] == v ? 1 : 2;
    return {t, x[(k + 1) % 3], x[(k + 2) % 3]};
  }

  // The spokes of v in turn; false for a vertex that is not simple enough to be removed.
  bool ring(std::uint32_t v) {
    const std::vector<std::uint32_t>& fan = around_[v];
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

  void try_remove(std::uint32_t v, double longest) {
    tried_[v] = 1;
    if (!ring(v)) return;
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
    wanted_[v] = std::numeric_limits<double>::infinity();
    for (const auto& [size, k] : targets_) {
      const double needed = longest_edge(k);
      if (needed > longest) {
        wanted_[v] = std::min(wanted_[v], needed);
        tried_[v] = 0;
      } else if (may_collapse(v, k)) {
        collapse(v, k);
        return;
      }
    }
  }

  void add_target(std::uint32_t v, std::size_t k) {
    targets_.emplace_back(distance(mesh_.vertices[v], mesh_.vertices[ring_[k].next]), k);
  }

  // Of the edges that collapsing v along spoke k would make.
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
    for (std::size_t m = 1; m + 1 < n; ++m)
      if (!good_triangle(ring_[(k + m) % n], mesh_.vertices[to])) return false;
    return true;
  }

  // Link condition: the ends of the edge have exactly the two opposite vertices as common
  // neighbours.
  bool keeps_manifold(std::uint32_t to, std::size_t k) const {
    const std::size_t n = ring_.size();
    if (n <= 3) return false;
    const std::uint32_t left = ring_[k].last, right = ring_[(k + n - 1) % n].next;
    for (const std::uint32_t t : around_[to]) {
      const Spoke s = spoke(to, t);
      for (const Spoke& r : ring_)
        if (r.next == s.next && r.next != left && r.next != right) return false;
    }
    return around_[left].size() > 3 && around_[right].size() > 3;
  }

  bool keeps_crease(std::uint32_t v, std::size_t k) const {
    if (creases_.empty()) return true;
    const std::size_t other = creases_[0] == k ? creases_[1] : creases_[0];
    const Vec3 &a = mesh_.vertices[ring_[k].next], &b = mesh_.vertices[ring_[other].next];
    const FieldSample &f = mesh_.faces[label(other)],
                      &g = mesh_.faces[label(other + ring_.size() - 1)];
    if (join_smoothly({field_, {}, 0}, mesh_.vertices[v], f, g, 1)) {
      const Vec3 u = b - a;
      const double t = dot(mesh_.vertices[v] - a, u) / std::max(dot(u, u), 1e-30);
      if (distance(mesh_.vertices[v], lerp(a, b, t)) > limits_.lateral) return false;
    }
    // The middle, and the quarters for a curve that bends both ways.
    const Vec3 m = 0.5 * (a + b);
    return crease_bound(field_, f, g, a, b) <= limits_.tolerance &&
           crease_bound(field_, f, g, a, m) <= limits_.tolerance &&
           crease_bound(field_, f, g, m, b) <= limits_.tolerance;
  }

  bool good_triangle(const Spoke& s, const Vec3& target) const {
    const Vec3 &a = target, &b = mesh_.vertices[s.next], &c = mesh_.vertices[s.last];
    const Vec3 n = cross(b - a, c - a);
    const double area = length(n);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    if (!(area > kLeastAltitude * longest)) return false;
    const FieldSample& face = mesh_.faces[mesh_.labels[s.triangle]];
    const Vec3 center = (1.0 / 3) * (a + b + c);
    if (!(dot(n, field_.gradient(center, face)) > kLeastCosine * area)) return false;
    if (triangle_bound(field_, face, a, b, c, limits_.tolerance) > limits_.tolerance) return false;
    return largest_distance(field_, tree_, face, a, b, c, limits_.tolerance) <= limits_.tolerance;
  }

  void collapse(std::uint32_t v, std::size_t k) {
    const std::uint32_t to = ring_[k].next;
    const std::size_t n = ring_.size();
    const std::uint32_t gone[2] = {ring_[k].triangle, ring_[(k + n - 1) % n].triangle};
    for (const std::uint32_t t : gone) {
      alive_[t] = 0;
      for (const std::uint32_t w : mesh_.triangles[t])
        if (w != v) std::erase(around_[w], t);
    }
    for (const Spoke& s : ring_) {
      tried_[s.next] = 0;
      wanted_[s.next] = 0;
      if (!alive_[s.triangle]) continue;
      for (std::uint32_t& w : mesh_.triangles[s.triangle])
        if (w == v) w = to;
      around_[to].push_back(s.triangle);
    }
    around_[v].clear();
  }

  LabelledMesh compact() const {
    LabelledMesh out;
    out.faces = mesh_.faces;
    std::vector<std::uint32_t> id(mesh_.vertices.size());
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
      if (!around_[v].empty()) {
        id[v] = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(mesh_.vertices[v]);
      }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (alive_[t]) {
        const Triangle& x = mesh_.triangles[t];
        out.triangles.push_back({id[x[0]], id[x[1]], id[x[2]]});
        out.labels.push_back(mesh_.labels[t]);
      }
    return out;
  }

  const ExactField& field_;
  const ContourOctree& tree_;
  SimplifyLimits limits_;
  LabelledMesh mesh_;
  const std::vector<char>& locked_;
  std::vector<char> alive_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<char> tried_;
  std::vector<double> wanted_;  ///< length of edges without which a vertex can not be removed
  std::vector<Spoke> ring_;
  std::vector<std::size_t> creases_;
  std::vector<std::pair<double, std::size_t>> targets_;
};

}  // namespace

LabelledMesh simplify(const ExactField& field, const ContourOctree& tree, const LabelledMesh& mesh,
                      const SimplifyLimits& limits, const std::vector<char>& locked) {
  return Simplifier(field, tree, mesh, limits, locked).run();
}

}  // namespace mrsim::detail
