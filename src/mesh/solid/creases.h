// Edges to draw and normals to shade with.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/types.h>

#include <cstdint>
#include <vector>

namespace mrsim {

/// Directions per corner for shading: the mean over the triangles that can be reached about the
/// vertex without passing an edge sharper than the crease angle, weighted by their angles there. So
/// a bore is shaded round and a floor flat up to its edge.
struct SurfaceShape {
  std::vector<Vec3> face_normals;             ///< #F, unit
  std::vector<std::array<float, 3>> normals;  ///< 3 #F, unit, by half edge
  std::vector<std::uint32_t> creases;         ///< half edges, one of each pair
  std::vector<std::uint32_t> smooth_edges;    ///< the others, one of each pair
  std::vector<std::uint32_t> opposite;        ///< 3 #F (half_edges.h)
};

/// `degrees`: faces that meet at more are an edge. Requires: indices in range.
SurfaceShape find_surface_shape(const TriMesh& mesh, double degrees, int threads = 0);

}  // namespace mrsim
