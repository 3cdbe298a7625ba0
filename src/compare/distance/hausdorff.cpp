#include "compare/distance/hausdorff.h"

#include "core/numbers/vec.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr std::uint32_t kUnknown = ~0u;
constexpr std::size_t kMostParts = 3;  // of a piece that is split

struct Piece {
  TrianglePiece corners;
  double upper = std::numeric_limits<double>::infinity();
  std::uint32_t hint = 0;                                              // nearest to its parent
  std::array<std::uint32_t, 3> nearest{kUnknown, kUnknown, kUnknown};  // to the corners
};

struct Verdict {
  double upper = 0, lower = 0;
  Vec3 place;
  std::uint32_t hint = 0;
  std::array<std::uint32_t, 3> nearest{kUnknown, kUnknown, kUnknown};
  std::optional<CutPlane> cut;  // where to split the piece; nothing: halve it

  void found(double distance, const Vec3& at) {
    if (distance <= lower) return;
    lower = distance;
    place = at;
  }
};

// The distance from a convex set is a convex function: no point of the piece is farther from t than
// its farthest corner.
double farthest_corner(const TriangleTree::Corners& t, const TrianglePiece& piece) {
  double most = 0;
  for (const Vec3& p : piece)
    most = std::max(most, nearest_on_triangle(p, t.a, t.b, t.c).distance2);
  return std::sqrt(most);
}

double longest_side(const TrianglePiece& t) {
  return std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
}

// Planes separate the points nearest to the feature that was hit from those nearest to the other
// features of its triangle. Returns the first such plane that runs through the piece. Pieces much
// larger than the triangle get none: they are better halved.
std::optional<CutPlane> feature_cut(const TriangleTree& tree, const TrianglePiece& piece,
                                    const TriangleTree::Hit& hit) {
  const TriangleTree::Corners t = tree.corners(hit.triangle);
  const TrianglePiece v{t.a, t.b, t.c};
  if (longest_side(piece) > 2 * longest_side(v)) return {};
  const Vec3 normal = tree.normal(hit.triangle);
  std::optional<CutPlane> out;
  const auto try_plane = [&](bool wanted, const CutPlane& plane) {
    if (wanted && !out && splits(plane, piece)) out = plane;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const bool face = hit.feature == kTriangleFace, edge = hit.feature == 3 + i;
    const Vec3 along = normalized(v[j] - v[i]);
    try_plane(face || edge, {v[i], cross(normal, along)});
    try_plane(edge || hit.feature == i, {v[i], along});
    try_plane(edge || hit.feature == j, {v[j], along});
  }
  return out;
}

// Bounds on the distances of all points of the piece, cheapest first; stops once below `enough`.
Verdict judge(const NominalSurface& to, const FlatPatches& patches, const Piece& s, double enough) {
  const TriangleTree& tree = to.tree();
  const TrianglePiece& c = s.corners;
  const Vec3 centre = (1.0 / 3) * (c[0] + c[1] + c[2]);
  const TriangleTree::Hit hit = tree.nearest(centre, s.hint);
  Verdict out;
  out.hint = hit.triangle;
  out.nearest = s.nearest;
  out.found(std::sqrt(hit.distance2), centre);
  out.upper = s.upper;
  const auto lower_to = [&](double bound) {
    out.upper = std::min(out.upper, bound);
    return out.upper <= enough;
  };
  double radius = 0;
  for (const Vec3& p : c) radius = std::max(radius, distance(p, centre));
  if (lower_to(std::sqrt(hit.distance2) + radius)) return out;
  if (lower_to(farthest_corner(tree.corners(hit.triangle), c))) return out;
  const bool face = hit.feature == kTriangleFace, flat = face && patches.is_joined(hit.triangle);
  if (flat) {
    const FlatPatches::Overlay over = patches.overlay(c, hit.triangle, hit.point);
    if (over.inside && lower_to(over.height)) return out;
    out.cut = over.cut;
  }
  if (face && lower_to(patches.distance_over_ring(c, hit.triangle, hit.point))) return out;
  if (!flat) out.cut = feature_cut(tree, c, hit);
  for (std::size_t k = 0; k < 3; ++k) {
    if (out.nearest[k] != kUnknown) continue;  // counted when its parent was judged
    const TriangleTree::Hit at = tree.nearest(c[k], hit.triangle);
    out.nearest[k] = at.triangle;
    out.found(std::sqrt(at.distance2), c[k]);
  }
  for (const std::uint32_t t : out.nearest) lower_to(farthest_corner(tree.corners(t), c));
  return out;
}

// The parts of a piece that was judged; its bounds hold for them, too.
class Cutter {
 public:
  Cutter(const Piece& piece, const Verdict& verdict, std::vector<Piece>& out)
      : s_(piece), v_(verdict), out_(out) {}

  void run() {
    if (v_.cut)
      cut(*v_.cut);
    else
      halve();
  }

 private:
  struct Corner {
    Vec3 place;
    std::uint32_t nearest = kUnknown;
  };
  Corner corner(std::size_t k) const { return {s_.corners[k], v_.nearest[k]}; }

  void add(const Corner& a, const Corner& b, const Corner& c) {
    out_.push_back(
        {{a.place, b.place, c.place}, v_.upper, v_.hint, {a.nearest, b.nearest, c.nearest}});
  }

  // Across its longest side, so that slivers become compact before they become many.
  void halve() {
    const TrianglePiece& c = s_.corners;
    std::size_t i = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (distance(c[k], c[(k + 1) % 3]) > distance(c[i], c[(i + 1) % 3])) i = k;
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Corner middle{lerp(c[i], c[j], 0.5)};
    add(corner(i), middle, corner(k));
    add(middle, corner(j), corner(k));
  }

  // Corner i lies alone on one side of the plane. One of the others may lie on the plane.
  void cut(const CutPlane& plane) {
    std::array<double, 3> side;
    for (std::size_t k = 0; k < 3; ++k) side[k] = dot(plane.normal, s_.corners[k] - plane.point);
    std::size_t i = 0;
    while ((side[i] > 0) == (side[(i + 1) % 3] > 0) || (side[i] > 0) == (side[(i + 2) % 3] > 0))
      ++i;
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const auto between = [&](std::size_t other) {
      return Corner{lerp(s_.corners[i], s_.corners[other], side[i] / (side[i] - side[other]))};
    };
    const Corner p = between(j), q = between(k);
    add(corner(i), p, q);
    if (std::abs(side[j]) <= kSliver) return add(p, corner(k), q);
    if (std::abs(side[k]) <= kSliver) return add(p, corner(j), q);
    if (distance(p.place, s_.corners[k]) < distance(s_.corners[j], q.place)) {
      add(p, corner(j), corner(k));
      add(p, corner(k), q);
    } else {
      add(p, corner(j), q);
      add(corner(j), corner(k), q);
    }
  }

  const Piece& s_;
  const Verdict& v_;
  std::vector<Piece>& out_;
};

// In rounds: the pieces with the largest bounds are judged against the lower bound of the round
// before, so that the result does not depend on threads, and what the budget leaves undecided has
// the smallest bounds.
class Search {
 public:
  Search(const NominalSurface& to, const FlatPatches& patches, HausdorffBound known, double error,
         int threads)
      : to_(to), patches_(patches), bound_(known), error_(error), threads_(threads) {}

  // The budget is for what the triangles are split into: each of them is judged in any case.
  HausdorffBound run(std::vector<Piece> pieces, std::size_t budget) {
    std::vector<Piece> round;
    round.swap(pieces);
    for (;;) {
      judge_round(round, pieces);
      drop_decided(pieces);
      if (pieces.empty()) break;
      double most = 0;
      for (const Piece& s : pieces) most = std::max(most, s.upper);
      const auto count = static_cast<std::size_t>(std::count_if(
          pieces.begin(), pieces.end(), [&](const Piece& s) { return s.upper >= most / 2; }));
      if (count > budget || !has_memory(count, pieces.size())) break;
      budget -= count;
      take(pieces, most / 2, count, round);
    }
    bound_.upper = std::max(bound_.lower, decided_);
    for (const Piece& s : pieces) bound_.upper = std::max(bound_.upper, s.upper);
    return bound_;
  }

 private:
  // Moves the `count` pieces whose bound is at least `bound` to `round`.
  static void take(std::vector<Piece>& pieces, double bound, std::size_t count,
                   std::vector<Piece>& round) {
    round.clear();
    round.reserve(count);
    std::erase_if(pieces, [&](const Piece& s) {
      if (s.upper >= bound) round.push_back(s);
      return s.upper >= bound;
    });
    pieces.reserve(pieces.size() + kMostParts * count);
  }

  // Whether a round of `count` of `all` pieces, and what it splits them into, fits into the memory.
  static bool has_memory(std::size_t count, std::size_t all) {
    const double bytes = double(count) * (sizeof(Piece) + sizeof(Verdict)) +
                         double(all + kMostParts * count) * sizeof(Piece);
    return bytes <= memory_left();
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
        Cutter(round[i], verdicts[i], rest).run();
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

// From one mesh to the other, with a distance to start from: the largest at some of its corners and
// middles.
class DirectedWay {
 public:
  DirectedWay(const TriMesh& from, const TriMesh& to, int threads)
      : from_(from), surface_(to, threads), patches_(to, surface_, threads) {
    const std::size_t step = std::max<std::size_t>(1, from.triangles.size() / kStarts);
    const std::size_t n = (from.triangles.size() + step - 1) / step;
    std::vector<std::pair<double, Vec3>> found(n);
    parallel_for(n, threads, [&](std::size_t i) {
      const std::size_t f = i * step;
      const Vec3 p = corner(from, f, 0), q = corner(from, f, 1), r = corner(from, f, 2);
      for (const Vec3& at : {p, (1.0 / 3) * (p + q + r), 0.5 * (p + q)}) {
        const double d = std::sqrt(surface_.tree().nearest(at).distance2);
        if (d >= found[i].first) found[i] = {d, at};
      }
    });
    for (const auto& [d, at] : found)
      if (d >= known_) known_ = d, place_ = at;
  }
  double known() const { return known_; }
  HausdorffBound search(double error, int threads) const {
    return directed_hausdorff(from_, surface_, patches_, known_, place_, error, kHausdorffPieces,
                              threads);
  }

 private:
  static constexpr std::size_t kStarts = 20'000;
  const TriMesh& from_;
  NominalSurface surface_;
  FlatPatches patches_;
  double known_ = 0;
  Vec3 place_;
};

}  // namespace

HausdorffBound directed_hausdorff(const TriMesh& from, const NominalSurface& to,
                                  const FlatPatches& patches, double known, const Vec3& place,
                                  double error, std::size_t budget, int threads) {
  std::vector<Piece> pieces(from.triangles.size());
  for (std::size_t f = 0; f < pieces.size(); ++f)
    pieces[f].corners = {corner(from, f, 0), corner(from, f, 1), corner(from, f, 2)};
  return Search(to, patches, {known, known, place}, error, threads).run(std::move(pieces), budget);
}

HausdorffBound surface_distance(const TriMesh& a, const TriMesh& b, const DistanceError& error,
                                int threads) {
  const DirectedWay ways[2] = {{a, b, threads}, {b, a, threads}};
  const double known = std::max(ways[0].known(), ways[1].known());
  const double enough = error.of(known);
  HausdorffBound out;
  for (const DirectedWay& way : ways) {
    const HausdorffBound one = way.search(enough, threads);
    if (one.lower >= out.lower) out.lower = one.lower, out.place = one.place;
    out.upper = std::max(out.upper, one.upper);
  }
  return out;
}

}  // namespace mrsim
