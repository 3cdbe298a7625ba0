// The largest tool that comes to places of a solid's surface without cutting the solid: a ball from
// any side, and an upright cylinder with a flat end that comes from above.
//
// With D(c) the distance of a tool's centre from the solid, a tool of radius D(c) leaves at most
// `leaves` at place s where |c - s| <= D(c) + leaves. The largest one is found by branch and bound
// over c: D changes by no more than c does. Distances are those of the triangles, so the error
// depends on no lattice.
#pragma once

#include "compare/distance/nominal.h"

#include <span>
#include <vector>

namespace mrsim {

struct ReachTask {
  double leaves = 0;  ///< mm above 0
  double most = 0;    ///< mm: larger radii are not tried
  double error = 0;   ///< mm: wanted error of a diameter, either way
};

struct Reach {
  double diameter = 0;    ///< mm
  double error = 0;       ///< mm, either way: more than was wanted where the search was cut short
  bool is_least = false;  ///< larger ones were not tried
  /// The tool leaves so much in an edge that one that leaves half of that is much smaller: no tool
  /// reaches the edge itself.
  bool is_most = false;
};

/// A place on a solid's surface.
struct SurfacePlace {
  Vec3 point;   ///< mm
  Vec3 normal;  ///< outward, of unit length; at an edge between those of its faces
};

/// The largest ball that comes to each of the places.
Reach largest_ball(const NominalSurface& solid, std::span<const SurfacePlace> places,
                   const ReachTask& task);
/// As largest_ball(), for an upright cylinder with a flat end below and no end above, which may end
/// `leaves` above the place.
Reach largest_flat(const NominalSurface& solid, std::span<const SurfacePlace> places,
                   const ReachTask& task);

/// Places of the solid's surface nearest to the points.
std::vector<SurfacePlace> surface_places(const NominalSurface& solid, std::span<const Vec3> points);

}  // namespace mrsim
