// The exact mesher: from the exact part to triangles that are sharp, manifold, small and certified
// (docs/mesh.md).
//
// Guarantees, all of them on the coordinates as written (float): closed, oriented, 2-manifold, no
// triangle without area, no self-intersection; every vertex within 1 um of the exact surface; same
// bytes for any number of threads. With a tolerance, the distance between mesh and part, both ways,
// stays below it on resolved features, and the bound that was reached is reported.
//
// Not guaranteed: features that no edge of the grid meets (a needle between the samples); walls and
// gaps thinner than a voxel are found where an edge of the grid shows them, and listed; with a
// tolerance, those that the mesh does not hold within it.
#pragma once

#include "mesh/mesh_block.h"
#include "removal/field.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace mrsim {

/// A wall or gap that passes between two neighbouring samples.
struct ThinFeature {
  Vec3 place;             ///< mm, on or in the feature
  bool wall = false;      ///< material between air; else a gap
  double thickness = 0;   ///< mm of the edge of the grid that lie in it
  std::int32_t owner[2];  ///< what bounds it: motion or kStockOwner
};

struct ContourReport {
  double bound = 0;         ///< mm: largest certified distance of the mesh from the part; 0 without
                            ///< tolerance
  std::size_t sampled = 0;  ///< triangles whose distance from their face is not proven, but sampled
  double volume_excess = 0;  ///< mm^3 that the mesh holds more than the exact part, by quadrature
                             ///< (docs/mesh.md, Volume); 0 without tolerance
  double memory = 0;         ///< bytes that the mesher was expected to take once its first cells
                             ///< were known; 0 without tolerance
  std::size_t cells = 0;     ///< cells that the surface passes
  std::size_t passes = 0;    ///< rounds of splitting
  std::size_t triangles_before = 0;  ///< triangles before simplification
  std::size_t unresolved = 0;     ///< places that stayed above the tolerance at the smallest cell
  std::vector<ThinFeature> thin;  ///< in the order of the grid's edges
  std::vector<std::pair<std::string, double>> seconds;  ///< by step
};

/// The surface of `field`, with the owner of each triangle. `voxel` (mm) is the size of features to
/// resolve, and the edge of all cells where options.tolerance is 0. Throws Error "part-empty",
/// "voxel-invalid", "tolerance-invalid", "memory" (options.max_memory); "mesh-unresolved" rather
/// than give a mesh that breaks a guarantee.
TriMesh contour(const ExactField& field, double voxel, const MeshOptions& options = {},
                ContourReport* report = nullptr);

/// The same mesh, handed on in blocks; without a tolerance as it is made, so that it is never in
/// memory as a whole. Does not throw "part-empty": there are no triangles then.
void contour(const ExactField& field, double voxel, const MeshOptions& options, MeshSink& sink,
             ContourReport* report = nullptr);

}  // namespace mrsim
