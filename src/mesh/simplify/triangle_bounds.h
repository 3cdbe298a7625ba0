// Upper bounds of the distance of a triangle from the exact part (docs/mesh.md, Tolerance).
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/simplify/face_distances.h"

namespace mrsim::detail {

/// Upper bound in mm of |g| on a triangle, where g is the distance of one smooth face of the part.
struct TriangleBound {
  double distance = 0;
  bool is_proven = false;  ///< by ExactField::patch_range; else from samples of g
};
/// Proven where the field encloses g: as close as it takes to decide whether g stays below `limit`.
/// Else the largest value at 15 nodes (quarters of the sides), and what g can do between them by
/// its second differences there. Above `limit` it may be a value of g instead of a bound.
TriangleBound triangle_bound(FaceDistances& distances, const FieldSample& face, const Vec3& a,
                             const Vec3& b, const Vec3& c, double limit);

/// Largest |d| of the exact part at the nodes, where anything but `face` can decide it; stops early
/// once it is above `limit`. Finds triangles that leave the face they are measured by. `cell`: the
/// search for the nodes' cells begins there (any cell; a near one is faster) and leaves the last
/// one.
double largest_distance(FaceDistances& distances, const CellOctree& tree, const FieldSample& face,
                        const Vec3& a, const Vec3& b, const Vec3& c, double limit,
                        std::int32_t& cell);

/// Upper bound in mm of the distance of the segment's points from the curve in which two faces of
/// the part meet; from either face where they join smoothly.
double crease_bound(FaceDistances& distances, const FieldSample& f, const FieldSample& g,
                    const Vec3& a, const Vec3& b);

/// Upper bound of |d| itself, whatever faces decide it under the triangle: for one that lies over
/// several faces that join nearly smoothly. A side may run along a crease in which these end,
/// unless it is sharper than 60 degrees, and is measured from the crease. Infinite in all other
/// cases: a wall may taper off there. Requires: its corners lie on the surface.
double part_bound(FaceDistances& distances, const CellOctree& tree, const Vec3& a, const Vec3& b,
                  const Vec3& c, double limit);

/// Volume in mm^3 between the triangle and the part's surface, positive where the triangle lies in
/// the air: the integral of d over it, exact where d is a polynomial of degree 4 on the triangle
/// [Dunavant 1985]. d is that of `face` where it is below `limit`.
double excess_over(const ExactField& field, const CellOctree& tree, const FieldSample& face,
                   const Vec3& a, const Vec3& b, const Vec3& c, double limit);

}  // namespace mrsim::detail
