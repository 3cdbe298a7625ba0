// Places vertices on the exact surface: on edges of the grid, in its faces, in its cells; on
// creases and corners where faces of the part meet (docs/mesh.md, Vertices).
#pragma once

#include "mesh/contour_lattice.h"
#include "removal/field.h"

#include <span>

namespace mrsim::detail {

inline bool same_face(const FieldSample& a, const FieldSample& b) {
  return a.owner == b.owner && a.patch == b.patch;
}

/// The field with the sweeps that matter here.
struct Probe {
  const ExactField& field;
  std::span<const std::uint32_t> candidates;
  double shallow = 0;  ///< mm: creases that need not be found if cutting them off moves less

  FieldSample sample(const Vec3& p) const { return field.sample(p, candidates); }
  double offset(const Vec3& p) const { return sample(p).distance + kInsideTolerance; }
};

/// A point of the surface and the faces of the part that meet in it.
struct SurfacePoint {
  Vec3 position;
  FieldSample faces[3];
  int count = 0;  ///< 1 smooth, 2 crease, 3 corner; 0 = none found
};

/// One end of a segment that the surface crosses, with d + kInsideTolerance there, which may be
/// rounded.
struct SegmentEnd {
  Vec3 position;
  double offset = 0;
};
struct FoundCrossing {
  Vec3 position;
  FieldSample at;
};
/// Where the surface crosses the segment from `inside` to `outside`, to 1e-10 mm. Requires d to
/// differ in side. Follows the face that decides d: two samples in most cases.
FoundCrossing find_crossing(const Probe& probe, const SegmentEnd& inside,
                            const SegmentEnd& outside);
Vec3 find_crossing(const Probe& probe, const Vec3& inside, const Vec3& outside);

/// True where the two faces join smoothly about p, or so nearly that a cell of `size` mm may cut
/// off their crease: none is looked for.
bool join_smoothly(const Probe& probe, const Vec3& p, const FieldSample& a, const FieldSample& b,
                   double size);

/// Newton's iteration from p to the common zero of up to three faces of the part, within the plane
/// where coordinate `plane_axis` is kept (-1: none). False where it does not settle near `room`.
bool solve_faces(const ExactField& field, std::span<const FieldSample> faces, int plane_axis,
                 const Box3& room, Vec3& p);

/// A point on the surface strictly inside the rectangle `room`, flat on `axis`: on the crease of a
/// and b, or smooth where b is null. count = 0 where there is none.
SurfacePoint point_in_face(const Probe& probe, const Box3& room, int axis, const Vec3& start,
                           const FieldSample& a, const FieldSample* b);

/// Where a crease passes the rectangle between two points of the surface on its border, which lie
/// on faces a and b of the part.
SurfacePoint crease_in_face(const Probe& probe, const Box3& room, int axis, const Vec3& from,
                            const FieldSample& a, const Vec3& to, const FieldSample& b);

/// A point of the surface between the middle of `room` and one of the points, of which the two
/// nearest in order lie on different sides. Requires: points on the border of the room.
SurfacePoint point_towards_middle(const Probe& probe, const Box3& room,
                                  std::span<const Vec3> points);

/// What a cell's vertex is placed by: crossings of the grid's edges, and points where creases enter
/// the cell through its faces.
struct CellHints {
  std::span<const Vec3> crossings;
  std::span<const FieldSample> faces;  ///< of the crossings
  std::span<const Vec3> creases;       ///< may be empty
  bool is_smooth = false;              ///< neighbouring crossings lie on faces that join smoothly
};

/// A point on the surface strictly inside `room`, as sharp as the part is there. count = 0: none.
SurfacePoint point_in_cell(const Probe& probe, const Box3& room, const CellHints& hints);

/// The crease of two of the faces nearest to `start`, in or near the room but not necessarily
/// inside: the tip of a ridge that passes between the edges of the grid. `axis` as in
/// point_in_face, -1: free.
SurfacePoint crease_near(const Probe& probe, const Box3& room, int axis, const Vec3& start,
                         std::span<const FieldSample> faces);

/// p moved into the interior of the box, off its sides by at least two steps of the coordinates
/// (not along `flat`).
Vec3 snap_inside(const Vec3& p, const Box3& room, int flat = -1);

}  // namespace mrsim::detail
