// Inner edges of a solid that material left to cut covers: no tool reaches them, whatever its size.
#pragma once

#include "compare/reach/reach.h"

#include <span>
#include <vector>

namespace mrsim {

/// One place on each edge between two triangles that bend inwards, where it comes within `near` mm
/// of one of `points`, which lie on that material; evenly thinned out to some hundreds.
std::vector<SurfacePlace> inner_edge_places(const NominalSurface& solid,
                                            std::span<const Vec3> points, double near);

}  // namespace mrsim
