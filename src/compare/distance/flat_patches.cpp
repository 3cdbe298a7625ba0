#include "compare/distance/flat_patches.h"

#include "core/numbers/vec.h"
#include "mesh/solid/half_edges.h"

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

struct Crossing {
  double length = 0;  // of the border that runs through the piece, 0 for none
  CutPlane plane;     // upright on it
};

// Where a border crosses the projection of the piece onto the plane with that normal.
Crossing crossing(const std::array<Vec3, 2>& border, const Vec3& normal,
                  const TrianglePiece& piece) {
  const Vec3 across = normalized(cross(normal, border[1] - border[0]));
  const Vec3 along = cross(across, normal);
  Crossing out{0, {border[0], across}};
  const std::array<double, 3> side = sides(out.plane, piece);
  if (!splits(side)) return out;
  Range cut;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if ((side[i] > 0) == (side[j] > 0)) continue;
    const Vec3 p = lerp(piece[i], piece[j], side[i] / (side[i] - side[j]));
    cut.add(dot(along, p - border[0]));
  }
  const double end = dot(along, border[1] - border[0]);
  out.length = std::max(0.0, std::min(cut.hi, end) - std::max(cut.lo, 0.0) + kSliver);
  return out;
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
    : mesh_(mesh), tree_(surface.tree()), opposite_(find_opposites(mesh, threads)) {
  join();
  find_borders();
}

// From each triangle that is left to all about it within the steps of float off its plane. Slivers
// have normals of any direction: they only must not be upside down.
void FlatPatches::join() {
  double allowed = 0;
  for (const auto& v : mesh_.vertices)
    for (const float x : v) allowed = std::max(allowed, 2e-7 * std::abs(double(x)));
  seed_.assign(mesh_.triangles.size(), kNone);
  joined_.assign(seed_.size(), false);
  std::deque<std::uint32_t> front;
  for (std::uint32_t f = 0; f < seed_.size(); ++f) {
    if (seed_[f] != kNone) continue;
    seed_[f] = f;
    const Vec3 normal = tree_.normal(f), origin = corner(mesh_, f, 0);
    const auto stray = [&](std::uint32_t g) {
      double most = 0;
      for (int k = 0; k < 3; ++k)
        most = std::max(most, std::abs(dot(normal, corner(mesh_, g, k) - origin)));
      return most;
    };
    for (front.push_back(f); !front.empty(); front.pop_front())
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t across = opposite_[3 * front.front() + k], g = across / 3;
        if (!is_half_edge(across) || seed_[g] != kNone || dot(normal, area_normal(mesh_, g)) < 0 ||
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
void FlatPatches::find_borders() {
  TriMesh borders;
  borders.vertices = mesh_.vertices;
  for (std::uint32_t h = 0; h < opposite_.size(); ++h) {
    const std::uint32_t across = opposite_[h], from = origin_of(mesh_, h), to = target_of(mesh_, h);
    const std::uint32_t here = seed_[h / 3];
    const std::uint32_t there = is_half_edge(across) ? seed_[across / 3] : here;
    if (is_half_edge(across) && (here == there || across < h)) continue;
    if (!joined_[here] && !joined_[there]) continue;
    borders.triangles.push_back({from, to, to});
    border_seeds_.push_back({here, there});
  }
  if (!borders.triangles.empty()) borders_.emplace(borders);
}

FlatPatches::Overlay FlatPatches::overlay(const TrianglePiece& piece, std::uint32_t triangle,
                                          const Vec3& foot) const {
  const std::uint32_t seed = seed_[triangle];
  const Vec3 normal = tree_.normal(seed), origin = tree_.corners(seed).a;
  Overlay out;
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
    const Crossing found = crossing({ends.a, ends.b}, normal, piece);
    if (found.length > most) {
      most = found.length;
      out.cut = found.plane;
    }
    return ++seen < kMostBorders;
  };
  if (borders_) borders_->visit(inflated(shadow, flatness_ + kSliver), look);
  out.inside = !out.cut && seen < kMostBorders;
  return out;
}

// The corners' fans: their edges that touch no corner of the triangle are the border.
double FlatPatches::distance_over_ring(const TrianglePiece& piece, std::uint32_t triangle,
                                       const Vec3& foot) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Vec3 normal = tree_.normal(triangle), origin = corner(mesh_, triangle, 0);
  if (dot(normal, normal) == 0 || !is_over(piece, normal, foot)) return kFar;
  const auto& own = mesh_.triangles[triangle];
  const auto is_own = [&](std::uint32_t v) { return v == own[0] || v == own[1] || v == own[2]; };
  Range surface, above;
  surface.add(0);
  for (const Vec3& p : piece) above.add(dot(normal, p - origin));
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t begin = 3 * triangle + k;
    std::uint32_t h = opposite_[previous_half_edge(begin)];
    for (std::size_t turned = 0; h != begin; h = opposite_[previous_half_edge(h)]) {
      if (!is_half_edge(h) || ++turned > kMostBorders) return kFar;
      if (dot(normal, area_normal(mesh_, h / 3)) <= 0) return kFar;
      const std::uint32_t far = next_half_edge(h);
      const Vec3 a = to_vec(mesh_.vertices[origin_of(mesh_, far)]);
      const Vec3 b = to_vec(mesh_.vertices[target_of(mesh_, far)]);
      surface.add(dot(normal, a - origin));
      surface.add(dot(normal, b - origin));
      if (is_own(origin_of(mesh_, far)) || is_own(target_of(mesh_, far))) continue;
      if (crossing({a, b}, normal, piece).length > 0) return kFar;
    }
  }
  return std::max(above.hi - surface.lo, surface.hi - above.lo) + kSliver;
}

}  // namespace mrsim
