#include "mesh/points/crease.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim::detail {
namespace {

constexpr double kSmoothJoin = 3e-3;      ///< sine of the angle below which two faces join smoothly
constexpr double kLargestShallow = 0.05;  ///< sine
constexpr double kParallel = 1e-9;        ///< sine squared: two faces that meet in no line
constexpr double kParallelThree = 1e-5;   ///< determinant of normals: three that meet in no corner
constexpr double kParallelPlane = 1e-4;   ///< sine squared: a face that meets no plane of the cell
constexpr double kLastStep = 1e-10;       ///< mm: Newton's method has converged
constexpr double kCycle = 0.9;            ///< of the step before the last one: Newton goes round
constexpr double kAlike = 0.95;           ///< cosine between faces that may be exchanged
constexpr double kNearShare = 1.0 / 64;   ///< of a way over the surface: how near to it
constexpr int kExchanges = 8;             ///< of faces on the way to a crease

// The shortest step x with n_i . x = -g_i.
bool newton_step(const Vec3* n, const double* g, int rows, Vec3& step) {
  if (rows == 1) {
    step = -g[0] * n[0];
    return true;
  }
  if (rows == 2) {
    const double aa = dot(n[0], n[0]), ab = dot(n[0], n[1]), bb = dot(n[1], n[1]);
    const double det = aa * bb - ab * ab;
    if (!(det > kParallel)) return false;
    step = (-g[0] * bb + g[1] * ab) / det * n[0] + (-g[1] * aa + g[0] * ab) / det * n[1];
    return true;
  }
  const Vec3 c12 = cross(n[1], n[2]), c20 = cross(n[2], n[0]), c01 = cross(n[0], n[1]);
  const double det = dot(n[0], c12);
  if (!(std::abs(det) > kParallelThree)) return false;
  step = (-1 / det) * (g[0] * c12 + g[1] * c20 + g[2] * c01);
  return true;
}

// Sine of the angle below which a crease may be cut off by a cell: a chord of length s across a
// crease of angle w leaves it by at most s w / 4.
double smooth_angle(const Probe& probe, double size) {
  return std::clamp(4 * probe.shallow / size, kSmoothJoin, kLargestShallow);
}

// Moves p to within `near` mm of the surface, in the plane of the given axis (-1: freely); s: the
// sample there.
bool project(const Probe& probe, const Box3& room, int axis, double near, Vec3& p, FieldSample& s) {
  for (int k = 0; k < 12; ++k) {
    s = probe.sample(p);
    if (std::abs(s.distance) < near) return true;
    auto [n, distance] = probe.field.face_plane(p, s);
    if (axis >= 0) component(n, axis) = 0;
    const double nn = dot(n, n);
    if (!(nn > kParallelPlane)) return false;
    p = p - distance / nn * n;
    if (!in_reach(p, room)) return false;
  }
  return false;
}

// Whether the faces, which meet in p and were looked for from `start`, join smoothly for a cell of
// `size` mm. Where a corner of the tool moves on a slight slope it draws a floor whose sides turn
// up into the flanks within less than a micrometre: smooth in p, and a crease for the cell.
bool meet_smoothly(const Probe& probe, const Vec3& start, const Vec3& p, const FieldSample& a,
                   const FieldSample& b, double size) {
  constexpr double kNear = 1.0 / 256;  // of the size
  constexpr double kSharp = 0.1;       // sine: no tool that is as large as the cell turns as much
  if (!join_smoothly(probe, p, a, b, size)) return false;
  const Vec3 back = start - p;
  const double way = length(back), most = kNear * size;
  const Vec3 near = way > most ? p + most / way * back : start;
  const Vec3 n = probe.field.face_plane(near, a).normal, m = probe.field.face_plane(near, b).normal;
  const Vec3 c = cross(n, m);
  return dot(n, m) > 0 && dot(c, c) < kSharp * kSharp;
}

// The crease between the two faces, found from p; none where they join smoothly or meet outside of
// the room.
CreaseSearch crease_from(const Probe& probe, const Box3& room, int axis, Vec3 p,
                         const FieldSample& a, const FieldSample& b, SurfacePoint& found) {
  const FieldSample pair[2] = {a, b};
  const double size = length(room.hi - room.lo);
  const Vec3 start = p;
  if (join_smoothly(probe, p, a, b, size)) return CreaseSearch::none;
  if (!solve_faces(probe.field, pair, axis, room, p)) return CreaseSearch::not_found;
  if (axis >= 0) component(p, axis) = component(room.lo, axis);
  if (!strictly_inside(p, room, axis)) return CreaseSearch::none;
  if (!accept(probe, p, room, axis)) return CreaseSearch::not_found;
  if (meet_smoothly(probe, start, p, a, b, size)) return CreaseSearch::none;
  found.position = p;
  found.count = 2;
  std::copy(pair, pair + 2, found.faces);
  return CreaseSearch::found;
}

}  // namespace

bool accept(const Probe& probe, const Vec3& p, const Box3& room, int flat) {
  return strictly_inside(p, room, flat) && probe.is_on_surface(p);
}

bool is_nearly_flat(const Probe& probe, const SurfaceElement& a, const SurfaceElement& b,
                    double size) {
  // Planes through the ends of a chord of length s, rising from it by h on the other end each, meet
  // less than 2h / 4 from it.
  const Vec3 chord = b.position - a.position;
  return dot(a.normal, b.normal) > 0 &&
         std::abs(dot(a.normal, chord)) + std::abs(dot(b.normal, chord)) <
             length(chord) * smooth_angle(probe, size);
}

bool join_smoothly(const Probe& probe, const Vec3& n, const Vec3& m, double size) {
  const Vec3 c = cross(n, m);
  const double limit = smooth_angle(probe, size);
  return dot(n, m) > 0 && dot(c, c) < limit * limit;
}

bool join_smoothly(const Probe& probe, const Vec3& p, const FieldSample& a, const FieldSample& b,
                   double size) {
  if (same_face(a, b)) return true;
  return join_smoothly(probe, probe.field.face_plane(p, a).normal,
                       probe.field.face_plane(p, b).normal, size);
}

bool solve_faces(const ExactField& field, std::span<const FieldSample> faces, int plane_axis,
                 const Box3& room, Vec3& p, const FacePlane* planes) {
  const double reach = (kRidgeReach + 1) * length(room.hi - room.lo);
  const Vec3 middle = 0.5 * (room.lo + room.hi);
  const int rows = static_cast<int>(faces.size());
  double last = std::numeric_limits<double>::infinity(), before = last;  // steps
  for (int k = 0; k < kNewtonSteps; ++k) {
    Vec3 n[4], step;
    double g[4] = {}, worst = 0;
    for (int i = 0; i < rows; ++i) {
      const FacePlane plane = k == 0 && planes != nullptr
                                  ? planes[i]
                                  : field.face_plane(p, faces[static_cast<std::size_t>(i)]);
      n[i] = plane.normal, g[i] = plane.distance;
      worst = std::max(worst, std::abs(g[i]));
    }
    if (worst < kRounding) return true;
    int all = rows;
    if (plane_axis >= 0) component(n[all++], plane_axis) = 1;
    if (!newton_step(n, g, all, step)) return worst < kOnSurface;
    const double size = length(step);
    if (size > reach || (k >= 4 && size > kCycle * before)) return false;
    before = last, last = size;
    p = p + step;
    if (distance(p, middle) > reach) return false;
    if (size < kLastStep) return worst < kOnSurface;
  }
  double worst = 0;
  for (const FieldSample& s : faces)
    worst = std::max(worst, std::abs(field.face_plane(p, s).distance));
  return worst < kOnSurface;
}

CreaseSearch crease_by_exchange(const Probe& probe, const Box3& room, int axis, Vec3 p,
                                FieldSample a, FieldSample b, SurfacePoint& found) {
  const double size = length(room.hi - room.lo);
  const Vec3 start = p;
  for (int k = 0; k < kExchanges; ++k) {
    const FieldSample pair[2] = {a, b};
    if (!solve_faces(probe.field, pair, axis, room, p)) break;
    if (axis >= 0) component(p, axis) = component(room.lo, axis);
    if (!in_reach(p, room)) break;
    const FieldSample third = probe.sample(p);
    if (std::abs(third.distance) <= kOnSurface) {
      if (!strictly_inside(p, room, axis) || meet_smoothly(probe, start, p, a, b, size)) break;
      found.position = p;
      found.count = 2;
      std::copy(pair, pair + 2, found.faces);
      return CreaseSearch::found;
    }
    const Vec3 normal = probe.field.face_plane(p, third).normal;
    const Vec3 of_a = probe.field.face_plane(p, a).normal,
               of_b = probe.field.face_plane(p, b).normal;
    const bool joins_a = join_smoothly(probe, normal, of_a, size),
               joins_b = join_smoothly(probe, normal, of_b, size);
    if (joins_a && joins_b) return CreaseSearch::none;
    const bool is_like_a = dot(normal, of_a) > dot(normal, of_b);
    if (dot(normal, is_like_a ? of_a : of_b) < kAlike) break;
    const bool replaces_a = joins_a || (is_like_a && !joins_b);
    (replaces_a ? a : b) = third;
  }
  return CreaseSearch::not_found;
}

// Used where exchanges lead nowhere. Halves the way over the surface until the crease between two
// faces is near; these need not be a and b. Tries each pair of faces when it is met first, and
// again from nearer by. What is found from near by ends the search.
bool crease_between(const Probe& probe, const Box3& room, int axis, const Vec3& from, FieldSample a,
                    const Vec3& to, FieldSample b, SurfacePoint& found) {
  const CreaseSearch first = crease_by_exchange(probe, room, axis, 0.5 * (from + to), a, b, found);
  if (first != CreaseSearch::not_found) return first == CreaseSearch::found;
  Vec3 low = from, high = to;
  for (int k = 0; k < 20; ++k) {
    Vec3 m = 0.5 * (low + high);
    FieldSample s;
    if (!project(probe, room, axis, kNearShare * distance(low, high), m, s)) break;
    const bool is_near = k >= 4 && k % 4 == 0;
    bool is_new = false;
    if (same_face(s, a)) {
      low = m;
    } else {
      is_new = !same_face(s, b);
      high = m;
      b = s;
    }
    if (!is_near && !is_new) continue;
    const CreaseSearch end = crease_from(probe, room, axis, 0.5 * (low + high), a, b, found);
    if (end == CreaseSearch::found || (is_near && end == CreaseSearch::none)) break;
  }
  return true;
}

std::optional<SurfacePoint> crease_in_face(const Probe& probe, const Box3& room, int axis,
                                           const Vec3& from, const FieldSample& a, const Vec3& to,
                                           const FieldSample& b) {
  SurfacePoint found;
  if (!crease_between(probe, room, axis, from, a, to, b, found)) return {};
  return found;
}

}  // namespace mrsim::detail
