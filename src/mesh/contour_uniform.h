// The mesher of the uniform grid: tile by tile, so that memory stays small and all cores work
// (docs/mesh.md, Tiles).
#pragma once

#include "mesh/contour.h"

namespace mrsim::detail {

/// The surface over cells of one voxel; cells in which two pieces of surface meet are split, at
/// most `fine_levels` times. Memory: the mesh, and about 20 MB a thread. Throws Error
/// "mesh-unresolved".
TriMesh contour_uniform(const ExactField& field, double voxel, int fine_levels,
                        const MeshOptions& options, ContourReport& report);

}  // namespace mrsim::detail
