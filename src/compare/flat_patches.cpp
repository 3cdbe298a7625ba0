#include "compare/flat_patches.h"

#include "core/vec.h"
#include "mesh/half_edges.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace mrsim {
namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr std::size_t kMostBorders = 512;  // looked at for one piece

struct Range {
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  void add(double x) {
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
};

// Signed distances of the corners from the plane.
std::array<double, 3> sides(const CutPlane& plane, const TrianglePiece& piece) {
  std::array<double, 3> out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = dot(plane.normal, piece[k] - plane.point);
  return out;
}

bool splits(const std::array<double, 3>& side) {
  return std::max({side[0], side[1], side[2]}) > kSliver &&
         std::min({side[0], side[1], side[2]}) < -kSliver;
}

// How much of the border from `a` (its length along `along`) runs through the piece where the
// plane upright on it cuts the piece: negative when it misses by more than a sliver.
double overlap(const TrianglePiece& piece, const std::array<double, 3>& side, const Vec3& a,
               const Vec3& along, double border) {
  Range cut;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if ((side[i] > 0) == (side[j] > 0)) continue;
    const Vec3 p = lerp(piece[i], piece[j], side[i] / (side[i] - side[j]));
    cut.add(dot(along, p - a));
  }
  return std::min(cut.hi, border) - std::max(cut.lo, 0.0) + kSliver;
}

// Normals are those of the patch and of the piece's way of turning.
bool is_over(const TrianglePiece& piece, const Vec3& normal, const Vec3& p) {
  Range turn;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = piece[(i + 1) % 3] - piece[i];
    const Vec3 across = normalized(cross(normal, edge));
    turn.add(dot(across, p - piece[i]));
  }
  return turn.lo > -kSliver || turn.hi < kSliver;
}

}  // namespace

bool splits(const CutPlane& plane, const TrianglePiece& piece) {
  return splits(sides(plane, piece));
}

FlatPatches::FlatPatches(const TriMesh& mesh, const NominalSurface& surface, int threads)
    : tree_(surface.tree()) {
  const std::vector<std::uint32_t> opposite = find_opposites(mesh, threads);
  join(mesh, opposite);
  find_borders(mesh, opposite);
}

// From each triangle that is left to all about it within the steps of float off its plane. Slivers
// have normals of any direction: they only must not be upside down.
void FlatPatches::join(const TriMesh& mesh, const std::vector<std::uint32_t>& opposite) {
  double allowed = 0;
  for (const auto& v : mesh.vertices)
    for (const float x : v) allowed = std::max(allowed, 2e-7 * std::abs(double(x)));
  seed_.assign(mesh.triangles.size(), kNone);
  joined_.assign(seed_.size(), false);
  std::deque<std::uint32_t> front;
  for (std::uint32_t f = 0; f < seed_.size(); ++f) {
    if (seed_[f] != kNone) continue;
    seed_[f] = f;
    const Vec3 normal = tree_.normal(f), origin = corner(mesh, f, 0);
    const auto stray = [&](std::uint32_t g) {
      double most = 0;
      for (int k = 0; k < 3; ++k)
        most = std::max(most, std::abs(dot(normal, corner(mesh, g, k) - origin)));
      return most;
    };
    for (front.push_back(f); !front.empty(); front.pop_front())
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t across = opposite[3 * front.front() + k], g = across / 3;
        if (!is_half_edge(across) || seed_[g] != kNone || dot(normal, area_normal(mesh, g)) < 0 ||
            stray(g) > allowed)
          continue;
        flatness_ = std::max(flatness_, stray(g));
        seed_[g] = f;
        joined_[f] = joined_[g] = true;
        front.push_back(g);
      }
  }
}

// A border is a triangle without area in a tree of its own.
void FlatPatches::find_borders(const TriMesh& mesh, const std::vector<std::uint32_t>& opposite) {
  TriMesh borders;
  borders.vertices = mesh.vertices;
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    const std::uint32_t across = opposite[h], from = origin_of(mesh, h), to = target_of(mesh, h);
    const std::uint32_t here = seed_[h / 3];
    const std::uint32_t there = is_half_edge(across) ? seed_[across / 3] : here;
    if (is_half_edge(across) && (here == there || across < h)) continue;
    if (!joined_[here] && !joined_[there]) continue;
    borders.triangles.push_back({from, to, to});
    border_seeds_.push_back({here, there});
  }
  if (!borders.triangles.empty()) borders_.emplace(borders);
}

FlatPatches::Placement FlatPatches::place(const TrianglePiece& piece, std::uint32_t triangle,
                                          const Vec3& foot) const {
  const std::uint32_t seed = seed_[triangle];
  const Vec3 normal = tree_.normal(seed), origin = tree_.corners(seed).a;
  Placement out;
  if (dot(normal, normal) == 0 || !is_over(piece, normal, foot)) return out;
  Box3 shadow;
  for (const Vec3& p : piece) {
    const double height = dot(normal, p - origin);
    out.height = std::max(out.height, std::abs(height) + flatness_ + kSliver);
    extend(shadow, p - height * normal);
  }
  double most = 0;
  std::size_t seen = 0;
  const auto look = [&](std::uint32_t border) {
    const auto& [left, right] = border_seeds_[border];
    if (left != seed && right != seed) return true;
    const TriangleTree::Corners ends = borders_->corners(border);
    const Vec3 across = normalized(cross(normal, ends.b - ends.a)), along = cross(across, normal);
    const CutPlane plane{ends.a, across};
    const std::array<double, 3> side = sides(plane, piece);
    if (splits(side)) {
      const double length = overlap(piece, side, ends.a, along, dot(along, ends.b - ends.a));
      if (length > most) {
        most = length;
        out.cut = plane;
      }
    }
    return ++seen < kMostBorders;
  };
  if (borders_) borders_->visit(inflated(shadow, flatness_ + kSliver), look);
  out.inside = !out.cut && seen < kMostBorders;
  return out;
}

std::size_t FlatPatches::memory() const {
  return seed_.capacity() * sizeof(seed_[0]) +
         (borders_ ? borders_->memory() + border_seeds_.capacity() * sizeof(border_seeds_[0]) : 0);
}

}  // namespace mrsim
