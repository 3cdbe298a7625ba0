#include "mesh/points/vertex.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mrsim::detail {
namespace {

constexpr double kSmoothJoin = 3e-3;      ///< sine of the angle below which two faces join smoothly
constexpr double kLargestShallow = 0.05;  ///< sine
constexpr double kLeastDeterminant = 1e-4;  ///< of the normals of three faces that meet in a corner
constexpr double kClearDeterminant = 0.25;  ///< the same of a corner outside of its cell
constexpr double kSharpDeterminant = 0.05;  ///< the same, seen from a crease
constexpr double kAlike = 0.95;             ///< cosine between faces that may be exchanged
constexpr int kExchanges = 8;               ///< of faces on the way to a crease
constexpr double kRidgeReach = 2;  ///< of a room's diagonal: how far a ridge may lie beyond it

bool accept(const Probe& probe, const Vec3& p, const Box3& room, int flat) {
  return strictly_inside(p, room, flat) && probe.is_on_surface(p);
}

// The shortest step x with n_i . x = -g_i.
bool newton_step(const Vec3* n, const double* g, int rows, Vec3& step) {
  if (rows == 1) {
    step = -g[0] * n[0];
    return true;
  }
  if (rows == 2) {
    const double aa = dot(n[0], n[0]), ab = dot(n[0], n[1]), bb = dot(n[1], n[1]);
    const double det = aa * bb - ab * ab;
    if (!(det > 1e-9)) return false;
    step = (-g[0] * bb + g[1] * ab) / det * n[0] + (-g[1] * aa + g[0] * ab) / det * n[1];
    return true;
  }
  const Vec3 c12 = cross(n[1], n[2]), c20 = cross(n[2], n[0]), c01 = cross(n[0], n[1]);
  const double det = dot(n[0], c12);
  if (!(std::abs(det) > 1e-5)) return false;
  step = (-1 / det) * (g[0] * c12 + g[1] * c20 + g[2] * c01);
  return true;
}

// Up to `most` different faces, in the order of their first crossing.
std::size_t distinct_faces(std::span<const FieldSample> in, FieldSample* out, std::size_t most) {
  std::size_t n = 0;
  for (const FieldSample& s : in) {
    bool known = false;
    for (std::size_t k = 0; k < n; ++k) known = known || same_face(out[k], s);
    if (!known && n < most) out[n++] = s;
  }
  return n;
}

// Sine of the angle below which a crease may be cut off by a cell: a chord of length s across a
// crease of angle w leaves it by at most s w / 4.
double smooth_angle(const Probe& probe, double size) {
  return std::clamp(4 * probe.shallow / size, kSmoothJoin, kLargestShallow);
}

// Of faces with these unit normals.
bool join_smoothly(const Probe& probe, const Vec3& n, const Vec3& m, double size) {
  const Vec3 c = cross(n, m);
  const double limit = smooth_angle(probe, size);
  return dot(n, m) > 0 && dot(c, c) < limit * limit;
}

// `planes`: of the faces at the start.
SurfacePoint try_faces(const Probe& probe, const Box3& room, const Vec3& start,
                       std::span<const FieldSample> faces, const FacePlane* planes) {
  SurfacePoint result;
  Vec3 p = start;
  if (!solve_faces(probe.field, faces, -1, room, p, planes) || !accept(probe, p, room, -1))
    return result;
  result.position = p;
  result.count = static_cast<int>(faces.size());
  std::copy(faces.begin(), faces.end(), result.faces);
  return result;
}

// Where three faces or more meet the cell: the corner of the three with the largest determinant of
// their normals, above `least`.
SurfacePoint try_corners(const Probe& probe, const Box3& room, const Vec3& start,
                         std::span<const FieldSample> faces, double least = kLeastDeterminant) {
  struct Triple {
    double det;
    std::array<FieldSample, 3> faces;
    std::array<FacePlane, 3> planes;
  };
  std::array<FacePlane, 8> planes;
  for (std::size_t k = 0; k < faces.size(); ++k)
    planes[k] = probe.field.face_plane(start, faces[k]);
  std::vector<Triple> triples;
  for (std::size_t a = 0; a < faces.size(); ++a)
    for (std::size_t b = a + 1; b < faces.size(); ++b)
      for (std::size_t c = b + 1; c < faces.size(); ++c) {
        const double det =
            std::abs(dot(planes[a].normal, cross(planes[b].normal, planes[c].normal)));
        if (det > least)
          triples.push_back(
              {det, {faces[a], faces[b], faces[c]}, {planes[a], planes[b], planes[c]}});
      }
  std::stable_sort(triples.begin(), triples.end(),
                   [](const Triple& x, const Triple& y) { return x.det > y.det; });
  for (std::size_t k = 0; k < triples.size() && k < 6; ++k)
    if (SurfacePoint s = try_faces(probe, room, start, triples[k].faces, triples[k].planes.data());
        s.count > 0)
      return s;
  return {};
}

SurfacePoint try_creases(const Probe& probe, const Box3& room, std::span<const Vec3> starts,
                         std::span<const FieldSample> faces) {
  const double size = length(room.hi - room.lo);
  std::vector<FacePlane> planes;  // of all faces at each start
  for (const Vec3& start : starts)
    for (const FieldSample& face : faces) planes.push_back(probe.field.face_plane(start, face));
  for (std::size_t a = 0; a < faces.size(); ++a)
    for (std::size_t b = a + 1; b < faces.size(); ++b)
      for (std::size_t k = 0; k < starts.size(); ++k) {
        const FieldSample pair[2] = {faces[a], faces[b]};
        const FacePlane at[2] = {planes[k * faces.size() + a], planes[k * faces.size() + b]};
        if (join_smoothly(probe, at[0].normal, at[1].normal, size)) continue;
        if (SurfacePoint s = try_faces(probe, room, starts[k], pair, at); s.count > 0) return s;
      }
  return {};
}

// Moves p onto the surface, in the plane of the given axis (-1: freely); s: the sample there.
bool project(const Probe& probe, const Box3& room, int axis, Vec3& p, FieldSample& s) {
  for (int k = 0; k < 12; ++k) {
    s = probe.sample(p);
    if (std::abs(s.distance) < 1e-8) return true;
    auto [n, distance] = probe.field.face_plane(p, s);
    if (axis >= 0) component(n, axis) = 0;
    const double nn = dot(n, n);
    if (!(nn > 1e-4)) return false;
    p = p - distance / nn * n;
    if (!in_reach(p, room)) return false;
  }
  return false;
}

// Whether the crease between two faces was found from a point, or is known not to be met.
enum class CreaseSearch : std::uint8_t { found, not_found, none };

// The crease between two faces, from p on. The surface may pass a third face between them, which
// takes the place of the one that it is like: short moves in rows meet in a crease that few pairs
// of their faces draw. None where the third joins both smoothly.
CreaseSearch crease_by_exchange(const Probe& probe, const Box3& room, int axis, Vec3 p,
                                FieldSample a, FieldSample b, SurfacePoint& found) {
  const double size = length(room.hi - room.lo);
  for (int k = 0; k < kExchanges; ++k) {
    const FieldSample pair[2] = {a, b};
    if (!solve_faces(probe.field, pair, axis, room, p)) break;
    if (axis >= 0) component(p, axis) = component(room.lo, axis);
    if (!in_reach(p, room)) break;
    const FieldSample third = probe.sample(p);
    if (std::abs(third.distance) <= kOnSurface) {
      if (!strictly_inside(p, room, axis)) break;
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

// The crease between the two faces, found from p; none where they join smoothly or meet outside of
// the room.
CreaseSearch crease_from(const Probe& probe, const Box3& room, int axis, Vec3 p,
                         const FieldSample& a, const FieldSample& b, SurfacePoint& found) {
  const FieldSample pair[2] = {a, b};
  if (join_smoothly(probe, p, a, b, length(room.hi - room.lo))) return CreaseSearch::none;
  if (!solve_faces(probe.field, pair, axis, room, p)) return CreaseSearch::not_found;
  if (axis >= 0) component(p, axis) = component(room.lo, axis);
  if (!strictly_inside(p, room, axis)) return CreaseSearch::none;
  if (!accept(probe, p, room, axis)) return CreaseSearch::not_found;
  found.position = p;
  found.count = 2;
  std::copy(pair, pair + 2, found.faces);
  return CreaseSearch::found;
}

// False where the surface between two of its points joins their faces smoothly. Else halves the way
// over it until the crease between two faces is near, which need not be those two: tries each pair
// when it is met first, and again from nearer by. What is known from near by ends the search.
bool crease_between(const Probe& probe, const Box3& room, int axis, const Vec3& from, FieldSample a,
                    const Vec3& to, FieldSample b, SurfacePoint& found) {
  const CreaseSearch first = crease_by_exchange(probe, room, axis, 0.5 * (from + to), a, b, found);
  if (first != CreaseSearch::not_found) return first == CreaseSearch::found;
  Vec3 low = from, high = to;
  for (int k = 0; k < 20; ++k) {
    Vec3 m = 0.5 * (low + high);
    FieldSample s;
    if (!project(probe, room, axis, m, s)) break;
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

SurfacePoint crease_between_some(const Probe& probe, const Box3& room, const CellHints& hints) {
  SurfacePoint found;
  for (std::size_t k = 1; k < hints.crossings.size() && found.count == 0; ++k)
    if (!same_face(hints.faces[k - 1], hints.faces[k]))
      crease_between(probe, room, -1, hints.crossings[k - 1], hints.faces[k - 1],
                     hints.crossings[k], hints.faces[k], found);
  return found;
}

SurfacePoint try_smooth(const Probe& probe, const Box3& room, const Vec3& start) {
  SmoothSearch search(probe.field, room, start);
  run_together(probe, std::span(&search, 1));
  return search.result();
}

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum;
  for (const Vec3& p : points) sum += p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

}  // namespace

bool is_nearly_flat(const Probe& probe, const SurfaceElement& a, const SurfaceElement& b,
                    double size) {
  // Planes through the ends of a chord of length s, rising from it by h on the other end each, meet
  // less than 2h / 4 from it.
  const Vec3 chord = b.position - a.position;
  return dot(a.normal, b.normal) > 0 &&
         std::abs(dot(a.normal, chord)) + std::abs(dot(b.normal, chord)) <
             length(chord) * smooth_angle(probe, size);
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
    if (worst < 1e-9) return true;
    int all = rows;
    if (plane_axis >= 0) component(n[all++], plane_axis) = 1;
    if (!newton_step(n, g, all, step)) return worst < kOnSurface;
    const double size = length(step);
    if (size > reach) return false;
    p = p + step;
    if (distance(p, middle) > reach) return false;
    if (size < 1e-10) return worst < kOnSurface;
  }
  double worst = 0;
  for (const FieldSample& s : faces)
    worst = std::max(worst, std::abs(field.face_plane(p, s).distance));
  return worst < kOnSurface;
}

SurfacePoint point_in_face(const Probe& probe, const Box3& room, int axis, const Vec3& start,
                           const FieldSample& face) {
  SurfacePoint result;
  Vec3 p = start;
  if (!solve_faces(probe.field, std::span(&face, 1), axis, room, p)) return result;
  component(p, axis) = component(room.lo, axis);
  if (!accept(probe, p, room, axis)) return result;
  result.position = p;
  result.count = 1;
  result.faces[0] = face;
  return result;
}

std::optional<SurfacePoint> crease_in_face(const Probe& probe, const Box3& room, int axis,
                                           const Vec3& from, const FieldSample& a, const Vec3& to,
                                           const FieldSample& b) {
  SurfacePoint found;
  if (!crease_between(probe, room, axis, from, a, to, b, found)) return {};
  return found;
}

// A segment from the border of a convex room to its middle runs in its interior.
SurfacePoint point_towards_middle(const Probe& probe, const Box3& room,
                                  std::span<const Vec3> points) {
  const Vec3 middle = 0.5 * (room.lo + room.hi);
  const bool middle_inside = is_inside(probe.sample(middle).distance);
  for (const Vec3& p : points) {
    if (is_inside(probe.sample(p).distance) == middle_inside) continue;
    SurfacePoint result;
    result.position = middle_inside ? find_place(probe, middle, p) : find_place(probe, p, middle);
    result.faces[0] = probe.sample(result.position);
    result.count = 1;
    return result;
  }
  return {};
}

SurfacePoint crease_near(const Probe& probe, const Box3& room, int axis, const Vec3& start,
                         std::span<const FieldSample> faces) {
  FieldSample some[8];
  const std::size_t n = distinct_faces(faces, some, 8);
  const double size = length(room.hi - room.lo);
  const Box3 near = inflated(room, kRidgeReach * size);
  SurfacePoint result;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      Vec3 p = start;
      const FieldSample pair[2] = {some[a], some[b]};
      if (join_smoothly(probe, start, some[a], some[b], size) ||
          !solve_faces(probe.field, pair, axis, room, p) || !accept(probe, p, near, axis))
        continue;
      result.position = p;
      result.count = 2;
      std::copy(pair, pair + 2, result.faces);
      return result;
    }
  return result;
}

SurfacePoint corner_near(const Probe& probe, const Box3& room, const Vec3& start,
                         std::span<const FieldSample> faces) {
  FieldSample some[8];
  const std::size_t n = distinct_faces(faces, some, 8);
  if (n < 3) return {};
  const double size = length(room.hi - room.lo);
  if (SurfacePoint s =
          try_corners(probe, inflated(room, size), start, {some, n}, kClearDeterminant);
      s.count > 0)
    return s;
  const SurfacePoint crease = crease_near(probe, room, -1, start, faces);
  if (crease.count == 0) return {};
  return try_corners(probe, inflated(room, kRidgeReach * size), crease.position, {some, n},
                     kSharpDeterminant);
}

SurfacePoint point_in_cell(const Probe& probe, const Box3& room, const CellHints& hints) {
  FieldSample faces[8];
  const std::size_t n = distinct_faces(hints.faces, faces, 8);
  const Vec3 mean = mean_of(hints.crossings);
  const std::size_t ends = hints.creases.size();
  const Vec3 start = ends == 0 ? mean : mean_of(hints.creases);
  if (n >= 3)
    if (SurfacePoint s = try_corners(probe, room, start, {faces, n}); s.count > 0) return s;
  if (n >= 2) {
    // Without ends of creases both starts are the same; one end is the start.
    const Vec3 starts[2] = {start, mean};
    const std::span<const Vec3> means(starts, ends == 0 ? 1 : 2);
    if (SurfacePoint s = try_creases(probe, room, means, {faces, n}); s.count > 0) return s;
    // The crease may be hidden by other faces between its ends: start at each of them.
    if (ends > 1)
      if (SurfacePoint s = try_creases(probe, room, hints.creases, {faces, n}); s.count > 0)
        return s;
    if (SurfacePoint s = crease_between_some(probe, room, hints); s.count > 0) return s;
  }
  return try_smooth(probe, room, mean);
}

Vec3 snap_inside(const Vec3& p, const Box3& room, int axis) {
  Box3 between = inner(room);
  component(between.lo, axis) = component(between.hi, axis) = component(room.lo, axis);
  return snap_into(p, between);
}

}  // namespace mrsim::detail
