#include "mesh/simplify/cut_mesh.h"

#include <algorithm>
#include <cmath>

namespace mrsim::detail {
namespace {

constexpr double kNoSide = 1e-30;     ///< mm: in place of the longest side of a point
constexpr double kGoodHeight = 2e-4;  ///< mm: of a new triangle in place of a higher one

// Radians: an edge is flipped where the two angles that face it are together more than half a turn
// by more than this.
constexpr double kPastDelaunay = 1e-6;

// Whether the circle about a, b and c holds d beyond the edge a b.
bool circle_holds(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ca = a - c, cb = b - c, da = a - d, db = b - d;
  const double lengths = std::sqrt(dot(ca, ca) * dot(cb, cb) * dot(da, da) * dot(db, db));
  return length(cross(ca, cb)) * dot(da, db) + dot(ca, cb) * length(cross(da, db)) <
         -kPastDelaunay * lengths;
}

double height_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  return length(cross(b - a, c - a)) / std::max(longest, kNoSide);
}

}  // namespace

CutMesh::CutMesh(const LabelledMesh& from, int threads)
    : mesh(from),
      moved(from.triangles.size(), 0),
      marks(3 * from.triangles.size(), 0),
      opposites_(find_opposites(from.triangles, from.vertices.size(), threads)) {}

Vec3 CutMesh::normal(std::uint32_t t) const {
  const Corners& x = mesh.triangles[t];
  return cross(position(x[1]) - position(x[0]), position(x[2]) - position(x[0]));
}

Vec3 CutMesh::middle(std::uint32_t t) const {
  const Corners& x = mesh.triangles[t];
  return (1.0 / 3) * (position(x[0]) + position(x[1]) + position(x[2]));
}

double CutMesh::height(std::uint32_t t) const {
  const Corners& x = mesh.triangles[t];
  return height_of(position(x[0]), position(x[1]), position(x[2]));
}

bool CutMesh::cut_edge(std::uint32_t h, const Vec3& at) {
  const std::uint32_t o = opposites_[h];
  if (!is_half_edge(o)) return false;
  const std::uint32_t a = from(h), b = to(h), c = apex(h), d = apex(o), t = h / 3, u = o / 3;
  if (!may_replace(t, position(a), at, position(c)) ||
      !may_replace(t, at, position(b), position(c)) ||
      !may_replace(u, position(b), at, position(d)) ||
      !may_replace(u, at, position(a), position(d)))
    return false;
  const Side bc = side(next_half_edge(h)), ca = side(previous_half_edge(h)),
             ad = side(next_half_edge(o)), db = side(previous_half_edge(o));
  const bool moves = !is_horizontal({a, b, c, d}, at);
  const std::uint32_t v = add_vertex(at), t2 = add_copy(t, moves), u2 = add_copy(u, moves);
  mesh.triangles[t] = {a, v, c};
  mesh.triangles[t2] = {v, b, c};
  mesh.triangles[u] = {b, v, d};
  mesh.triangles[u2] = {v, a, d};
  join(3 * t, 3 * u2);
  join(3 * t + 1, 3 * t2 + 2);
  place(3 * t + 2, ca);
  join(3 * t2, 3 * u);
  place(3 * t2 + 1, bc);
  join(3 * u + 1, 3 * u2 + 2);
  place(3 * u + 2, db);
  place(3 * u2 + 1, ad);
  return true;
}

bool CutMesh::cut_triangle(std::uint32_t t, const Vec3& at) {
  const auto [a, b, c] = mesh.triangles[t];
  if (!may_replace(t, position(a), position(b), at) ||
      !may_replace(t, position(b), position(c), at) ||
      !may_replace(t, position(c), position(a), at))
    return false;
  const Side bc = side(3 * t + 1), ca = side(3 * t + 2);
  const bool moves = !is_horizontal({a, b, c}, at);
  const std::uint32_t v = add_vertex(at), t2 = add_copy(t, moves), t3 = add_copy(t, moves);
  mesh.triangles[t] = {a, b, v};
  mesh.triangles[t2] = {b, c, v};
  mesh.triangles[t3] = {c, a, v};
  place(3 * t2, bc);
  place(3 * t3, ca);
  join(3 * t + 1, 3 * t2 + 2);
  join(3 * t2 + 1, 3 * t3 + 2);
  join(3 * t3 + 1, 3 * t + 2);
  return true;
}

bool CutMesh::flip_edge(std::uint32_t h) {
  const std::uint32_t o = opposites_[h];
  if (!is_half_edge(o)) return false;
  const std::uint32_t a = from(h), b = to(h), c = apex(h), d = apex(o), t = h / 3, u = o / 3;
  if (!is_horizontal({a, b, c}, position(d)) ||
      !circle_holds(position(a), position(b), position(c), position(d)) ||
      !may_replace(t, position(a), position(d), position(c)) ||
      !may_replace(t, position(d), position(b), position(c)))
    return false;
  const Side bc = side(next_half_edge(h)), ca = side(previous_half_edge(h)),
             ad = side(next_half_edge(o)), db = side(previous_half_edge(o));
  mesh.triangles[t] = {a, d, c};
  mesh.triangles[u] = {d, b, c};
  moved[t] = moved[u] = static_cast<char>(moved[t] | moved[u]);
  place(3 * t, ad);
  join(3 * t + 1, 3 * u + 2);
  place(3 * t + 2, ca);
  place(3 * u, db);
  place(3 * u + 1, bc);
  return true;
}

bool CutMesh::may_replace(std::uint32_t t, const Vec3& a, const Vec3& b, const Vec3& c) const {
  const double least = std::max(kLeastHeight, std::min(kGoodHeight, 0.25 * height(t)));
  return height_of(a, b, c) > least && dot(cross(b - a, c - a), normal(t)) > 0;
}

bool CutMesh::is_horizontal(std::initializer_list<std::uint32_t> corners, const Vec3& at) const {
  for (int axis = 0; axis < 3; ++axis)
    if (std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
          return component(position(v), axis) == component(at, axis);
        }))
      return true;
  return false;
}

std::uint32_t CutMesh::add_vertex(const Vec3& p) {
  mesh.vertices.push_back(p);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

std::uint32_t CutMesh::add_copy(std::uint32_t t, bool moves) {
  if (moves) moved[t] = 1;
  moved.push_back(moved[t]);
  mesh.triangles.push_back(mesh.triangles[t]);
  mesh.labels.push_back(mesh.labels[t]);
  opposites_.insert(opposites_.end(), 3, kBoundaryEdge);
  marks.insert(marks.end(), 3, 0);
  return static_cast<std::uint32_t>(mesh.triangles.size() - 1);
}

void CutMesh::place(std::uint32_t h, const Side& side) {
  opposites_[h] = side.opposite;
  if (is_half_edge(side.opposite)) opposites_[side.opposite] = h;
  marks[h] = side.mark;
}

// Two new half edges.
void CutMesh::join(std::uint32_t h, std::uint32_t o) {
  opposites_[h] = o;
  opposites_[o] = h;
  marks[h] = marks[o] = 0;
}

}  // namespace mrsim::detail
