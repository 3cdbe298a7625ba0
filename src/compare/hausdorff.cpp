#include "compare/hausdorff.h"

#include "core/parallel.h"
#include "core/vec.h"
#include "mesh/half_edges.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace mrsim {
namespace {

constexpr std::uint32_t kUnknown = ~0u;

struct Piece {
  std::array<Vec3, 3> corners;
  double upper = 0;
  std::uint32_t hint = 0, crease_hint = 0;  // where searches for its parent ended
  std::array<std::uint32_t, 3> nearest{kUnknown, kUnknown, kUnknown};  // to the corners
};

struct Verdict {
  double upper = 0, lower = 0;
  Vec3 place;
  std::uint32_t hint = 0, crease_hint = 0;
  std::array<std::uint32_t, 3> nearest{};
};

// Distances to a convex set are convex, so no point of the piece is farther from t.
double farthest_corner(const TriangleTree::Corners& t, const Piece& s) {
  double most = 0;
  for (const Vec3& p : s.corners)
    most = std::max(most, nearest_on_triangle(p, t.a, t.b, t.c).distance2);
  return std::sqrt(most);
}

Vec3 centre_of(const Piece& s) { return (1.0 / 3) * (s.corners[0] + s.corners[1] + s.corners[2]); }

double flat_bound(const FlatPatches& patches, const Piece& s, const TriangleTree::Hit& hit,
                  double radius, std::uint32_t& crease_hint) {
  if (hit.feature != kTriangleFace || !patches.is_joined(hit.triangle) ||
      patches.crease_distance(hit.point, crease_hint) <= radius)
    return std::numeric_limits<double>::infinity();
  double most = 0;
  for (const Vec3& p : s.corners) most = std::max(most, std::abs(patches.height(hit.triangle, p)));
  return most + 2 * patches.flatness();
}

// Bounds on the distances of all points of the piece, cheapest first; stops once below `enough`.
Verdict judge(const NominalSurface& to, const FlatPatches& patches, const Piece& s, double enough) {
  const TriangleTree& tree = to.tree();
  const Vec3 centre = centre_of(s);
  double radius = 0;
  for (const Vec3& p : s.corners) radius = std::max(radius, distance(p, centre));
  const TriangleTree::Hit hit = tree.nearest(centre, s.hint);
  Verdict out{0, std::sqrt(hit.distance2), centre, hit.triangle, s.crease_hint};
  out.upper = std::min(s.upper, out.lower + radius);
  if (out.upper <= enough) return out;
  out.upper = std::min(out.upper, farthest_corner(tree.corners(hit.triangle), s));
  if (out.upper <= enough) return out;
  out.upper = std::min(out.upper, flat_bound(patches, s, hit, radius, out.crease_hint));
  if (out.upper <= enough) return out;
  out.nearest = s.nearest;
  for (std::size_t k = 0; k < 3; ++k) {
    if (out.nearest[k] != kUnknown) continue;  // counted when its parent was judged
    const TriangleTree::Hit at = tree.nearest(s.corners[k], hit.triangle);
    out.nearest[k] = at.triangle;
    const double d = std::sqrt(at.distance2);
    if (d > out.lower) {
      out.lower = d;
      out.place = s.corners[k];
    }
  }
  for (const std::uint32_t t : out.nearest)
    out.upper = std::min(out.upper, farthest_corner(tree.corners(t), s));
  return out;
}

// Across its longest side, so that slivers become compact before they become many.
void halve(const Piece& s, const Verdict& v, std::vector<Piece>& out) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = distance(s.corners[k], s.corners[(k + 1) % 3]);
    if (side > most) {
      most = side;
      longest = k;
    }
  }
  const std::size_t i = longest, j = (i + 1) % 3, k = (i + 2) % 3;
  const Vec3 &a = s.corners[i], &b = s.corners[j], &c = s.corners[k], middle = lerp(a, b, 0.5);
  const std::array<std::uint32_t, 3>& n = v.nearest;
  out.push_back({{a, middle, c}, v.upper, v.hint, v.crease_hint, {n[i], kUnknown, n[k]}});
  out.push_back({{middle, b, c}, v.upper, v.hint, v.crease_hint, {kUnknown, n[j], n[k]}});
}

// In rounds: the pieces with the largest bounds are judged against the lower bound of the round
// before, so that the result does not depend on threads, and what the budget leaves undecided has
// the smallest bounds.
class Search {
 public:
  Search(const NominalSurface& to, const FlatPatches& patches, HausdorffBound known, double error,
         int threads)
      : to_(to), patches_(patches), bound_(known), error_(error), threads_(threads) {}

  HausdorffBound run(std::vector<Piece> pieces, std::size_t budget) {
    while (!pieces.empty()) {
      const auto chosen = choose(pieces);
      const auto count = static_cast<std::size_t>(pieces.end() - chosen);
      if (count > budget) break;
      budget -= count;
      const std::vector<Piece> round(chosen, pieces.end());
      pieces.erase(chosen, pieces.end());
      judge_round(round, pieces);
      drop_decided(pieces);
    }
    bound_.upper = std::max(bound_.lower, decided_);
    for (const Piece& s : pieces) bound_.upper = std::max(bound_.upper, s.upper);
    return bound_;
  }

 private:
  // Moves the pieces with at least half of the largest bound to the end.
  static std::vector<Piece>::iterator choose(std::vector<Piece>& pieces) {
    double most = 0;
    for (const Piece& s : pieces) most = std::max(most, s.upper);
    return std::stable_partition(pieces.begin(), pieces.end(),
                                 [&](const Piece& s) { return s.upper < most / 2; });
  }

  void judge_round(const std::vector<Piece>& round, std::vector<Piece>& rest) {
    std::vector<Verdict> verdicts(round.size());
    const double enough = bound_.lower + error_;
    parallel_for(
        round.size(), threads_,
        [&](std::size_t i) { verdicts[i] = judge(to_, patches_, round[i], enough); }, 256);
    for (const Verdict& v : verdicts)
      if (v.lower > bound_.lower) {
        bound_.lower = v.lower;
        bound_.place = v.place;
      }
    for (std::size_t i = 0; i < round.size(); ++i) {
      if (verdicts[i].upper <= bound_.lower + error_)
        decided_ = std::max(decided_, verdicts[i].upper);
      else
        halve(round[i], verdicts[i], rest);
    }
  }

  // A higher lower bound decides pieces that wait, too.
  void drop_decided(std::vector<Piece>& pieces) {
    std::erase_if(pieces, [&](const Piece& s) {
      if (s.upper > bound_.lower + error_) return false;
      decided_ = std::max(decided_, s.upper);
      return true;
    });
  }

  const NominalSurface& to_;
  const FlatPatches& patches_;
  HausdorffBound bound_;
  double error_, decided_ = 0;
  int threads_;
};

}  // namespace

FlatPatches::FlatPatches(const TriMesh& mesh) {
  constexpr std::uint32_t kNone = ~0u;
  double allowed = 0;
  for (const auto& v : mesh.vertices)
    for (const float x : v)
      allowed = std::max(allowed, 2e-7 * std::abs(double(x)));  // float's steps
  const std::vector<std::uint32_t> opposite = find_opposites(mesh);
  seed_.assign(mesh.triangles.size(), kNone);
  joined_.assign(seed_.size(), false);
  origins_.resize(seed_.size());
  normals_.resize(seed_.size());
  for (std::uint32_t f = 0; f < seed_.size(); ++f) {
    origins_[f] = corner(mesh, f, 0);
    normals_[f] = normalized(area_normal(mesh, f));
  }
  std::deque<std::uint32_t> front;
  const auto joins = [&](std::uint32_t f, std::uint32_t seed) {
    if (dot(normals_[f], normals_[seed]) < 0.999) return false;
    double stray = 0;
    for (int k = 0; k < 3; ++k)
      stray = std::max(stray, std::abs(dot(normals_[seed], corner(mesh, f, k) - origins_[seed])));
    if (stray > allowed) return false;
    flatness_ = std::max(flatness_, stray);
    return true;
  };
  for (std::uint32_t f = 0; f < seed_.size(); ++f) {
    if (seed_[f] != kNone) continue;
    seed_[f] = f;
    for (front.push_back(f); !front.empty(); front.pop_front())
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t across = opposite[3 * front.front() + k];
        if (!is_half_edge(across) || seed_[across / 3] != kNone || !joins(across / 3, f)) continue;
        seed_[across / 3] = f;
        joined_[f] = joined_[across / 3] = true;
        front.push_back(across / 3);
      }
  }
  TriMesh creases;  // a crease is a triangle without area; lone triangles are not asked for theirs
  creases.vertices = mesh.vertices;
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    const bool inner = is_half_edge(opposite[h]) && seed_[opposite[h] / 3] == seed_[h / 3];
    const std::uint32_t from = origin_of(mesh, h), to = target_of(mesh, h);
    const bool asked = joined_[h / 3] || (is_half_edge(opposite[h]) && joined_[opposite[h] / 3]);
    if (!inner && asked && (from < to || !is_half_edge(opposite[h])))
      creases.triangles.push_back({from, to, to});
  }
  if (!creases.triangles.empty()) creases_ = std::make_unique<TriangleTree>(creases);
}

double FlatPatches::height(std::uint32_t triangle, const Vec3& p) const {
  const std::uint32_t seed = seed_[triangle];
  return dot(normals_[seed], p - origins_[seed]);
}

double FlatPatches::crease_distance(const Vec3& p, std::uint32_t& hint) const {
  if (!creases_) return std::numeric_limits<double>::infinity();
  const TriangleTree::Hit hit = creases_->nearest(p, hint);
  hint = hit.triangle;
  return std::sqrt(hit.distance2);
}

std::size_t FlatPatches::memory() const {
  return seed_.capacity() * 4 + 2 * origins_.capacity() * sizeof(Vec3) +
         (creases_ ? creases_->memory() : 0);
}

HausdorffBound directed_hausdorff(const TriMesh& from, const NominalSurface& to,
                                  const FlatPatches& patches, double known, const Vec3& place,
                                  double error, std::size_t budget, int threads) {
  std::vector<Piece> pieces(from.triangles.size());
  for (std::size_t f = 0; f < pieces.size(); ++f)
    pieces[f] = {.corners = {corner(from, f, 0), corner(from, f, 1), corner(from, f, 2)},
                 .upper = std::numeric_limits<double>::infinity()};
  return Search(to, patches, {known, known, place}, error, threads).run(std::move(pieces), budget);
}

}  // namespace mrsim
