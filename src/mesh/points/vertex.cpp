#include "mesh/points/vertex.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mrsim::detail {
namespace {

constexpr double kLeastDeterminant = 1e-4;  ///< of the normals of three faces that meet in a corner
constexpr double kClearDeterminant = 0.25;  ///< of a corner outside of its cell
constexpr double kSharpDeterminant = 0.05;  ///< of a corner seen from a crease
constexpr double kBesideRidge = 1e-3;  ///< mm: from a ridge to where the part about it is looked at
constexpr double kAlong = 16;          ///< of kBesideRidge: from the end of a ridge
constexpr double kClear = 0.25;        ///< of the distance to the two faces that is expected there
constexpr double kOnFace = 0.02;  ///< of kBesideRidge: how far from a face what lies on it may be
constexpr double kFlatRidge = 0.98;  ///< cosine between faces that need not be kept apart

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

// On the only crease that passes a cell: between the two faces of its ends, or where it goes over
// from one face to a third. Where both change, exchanges find the two in the middle.
SurfacePoint passing_crease(const Probe& probe, const Box3& room, const Vec3& start,
                            std::span<const SurfacePoint> ends) {
  SurfacePoint found;
  if (ends.size() != 2) return found;
  FieldSample faces[4];
  const FieldSample both[] = {ends[0].faces[0], ends[0].faces[1], ends[1].faces[0],
                              ends[1].faces[1]};
  const std::size_t n = distinct_faces(both, faces, 4);
  if (n < 4) found = try_faces(probe, room, start, {faces, n}, nullptr);
  if (n != 3 && found.count == 0)
    crease_by_exchange(probe, room, -1, start, ends[0].faces[0], ends[0].faces[1], found);
  return found;
}

// Whether the two faces with these normals run up to a ridge in p, and more of the surface does.
// On each face the surface goes on to one side of the ridge only: of an edge to where the other
// face has material, of a valley to where it has none. To its other side lies air (material).
bool is_doubled(const Probe& probe, const Vec3& p, const Vec3& n, const Vec3& m) {
  const double c = dot(n, m), sine = std::sqrt(std::max(0.0, 1 - c * c));
  if (c > kFlatRidge || sine < kSharpDeterminant) return false;
  const Vec3 first = (kBesideRidge / sine) * (m - c * n),
             second = (kBesideRidge / sine) * (n - c * m);
  const auto at = [&](const Vec3& v) { return probe.sample(p + v).distance; };
  const double under[] = {at(-first), at(-second)}, over[] = {at(first), at(second)};
  const double clear = kClear * sine * kBesideRidge;
  const auto on_surface = [](const double* d) {
    return std::abs(d[0]) < kOnFace * kBesideRidge && std::abs(d[1]) < kOnFace * kBesideRidge;
  };
  return (on_surface(under) && !(over[0] > clear && over[1] > clear)) ||
         (on_surface(over) && !(under[0] < -clear && under[1] < -clear));
}

}  // namespace

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
  std::vector<Vec3> ends;
  for (const SurfacePoint& end : hints.creases) ends.push_back(end.position);
  const Vec3 start = ends.empty() ? mean : mean_of(ends);
  if (SurfacePoint s = passing_crease(probe, room, start, hints.creases); s.count > 0) return s;
  if (n >= 3)
    if (SurfacePoint s = try_corners(probe, room, start, {faces, n}); s.count > 0) return s;
  if (n >= 2) {
    // Without ends of creases both starts are one point; one end is the start.
    const Vec3 starts[2] = {start, mean};
    const std::span<const Vec3> means(starts, ends.empty() ? 1 : 2);
    if (SurfacePoint s = try_creases(probe, room, means, {faces, n}); s.count > 0) return s;
    // The crease may be hidden by other faces between its ends: start at each of them.
    if (ends.size() > 1)
      if (SurfacePoint s = try_creases(probe, room, ends, {faces, n}); s.count > 0) return s;
    if (SurfacePoint s = crease_between_some(probe, room, hints); s.count > 0) return s;
  }
  return try_smooth(probe, room, mean);
}

void keep_apart(const Probe& probe, const Vec3& side, SurfacePoint& ridge) {
  if (ridge.count < 2) return;
  const Vec3 p = ridge.position;
  Vec3 normal[3];
  for (int k = 0; k < ridge.count; ++k)
    normal[k] = probe.field.face_plane(p, ridge.faces[k]).normal;
  for (int k = ridge.count == 2 ? 2 : 0; k < 3; ++k) {
    const Vec3 &n = normal[(k + 1) % 3], &m = normal[(k + 2) % 3];
    // The ridge may run either way from its end.
    const Vec3 along = ridge.count == 2 ? Vec3() : kAlong * kBesideRidge * normalized(cross(n, m));
    if (!is_doubled(probe, p + along, n, m) &&
        (ridge.count == 2 || !is_doubled(probe, p - along, n, m)))
      continue;
    const Vec3 out = normalized(n + m);
    ridge.position += std::clamp(dot(side - p, out), -probe.shallow, probe.shallow) * out;
  }
}

Vec3 snap_inside(const Vec3& p, const Box3& room, int axis) {
  Box3 between = inner(room);
  component(between.lo, axis) = component(between.hi, axis) = component(room.lo, axis);
  return snap_into(p, between);
}

}  // namespace mrsim::detail
