// Places vertices on the exact surface: on edges of the grid, in its faces, in its cells; on
// creases and corners where faces of the part meet (docs/mesh.md, Vertices).
#pragma once

#include "mesh/points/crease.h"

#include <span>

namespace mrsim::detail {

/// A point on a face of the part and on the surface, strictly inside the rectangle `room`, flat on
/// `axis`. count = 0 where there is none.
SurfacePoint point_in_face(const Probe& probe, const Box3& room, int axis, const Vec3& start,
                           const FieldSample& face);

/// Where the surface crosses the straight way from the middle of `room` to the first of the points
/// that lies on its other side; count = 0: none does. Requires: points on the border of the room.
SurfacePoint point_towards_middle(const Probe& probe, const Box3& room,
                                  std::span<const Vec3> points);

/// What a cell's vertex is placed by: crossings of the grid's edges, and points where creases enter
/// the cell through its faces.
struct CellHints {
  std::span<const Vec3> crossings;
  std::span<const FieldSample> faces;     ///< of the crossings
  std::span<const SurfacePoint> creases;  ///< of two faces each; may be empty
};

/// A point on the surface strictly inside `room`, as sharp as the part is there. count = 0: none.
SurfacePoint point_in_cell(const Probe& probe, const Box3& room, const CellHints& hints);

/// The crease of two of the faces nearest to `start`, in or near the room but not necessarily
/// inside: the tip of a ridge that passes between the edges of the grid. `axis` as in
/// point_in_face, -1: free.
SurfacePoint crease_near(const Probe& probe, const Box3& room, int axis, const Vec3& start,
                         std::span<const FieldSample> faces);

/// Does what crease_near() does for the corner of three of the faces, wherever in space it lies.
SurfacePoint corner_near(const Probe& probe, const Box3& room, const Vec3& start,
                         std::span<const FieldSample> faces);

/// Where two ridges lie on each other (a cutter whose tip just reaches the stock's underside leaves
/// two edges on one line) no closed mesh can have both. A point of such a ridge, or of its end, is
/// moved off it by `probe.shallow`, towards `side`; others stay. Costs two samples a crease.
void keep_apart(const Probe& probe, const Vec3& side, SurfacePoint& ridge);

/// p rounded, in the interior of the rectangle, which is flat on `axis`.
Vec3 snap_inside(const Vec3& p, const Box3& room, int axis);

}  // namespace mrsim::detail
