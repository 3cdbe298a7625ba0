// The mesher of the uniform grid: tile by tile, so that memory stays small and all cores work
// (docs/mesh.md, Tiles).
#pragma once

#include "mesh/contour.h"
#include "mesh/mesh_block.h"

namespace mrsim::detail {

/// The surface over cells of one voxel, in blocks as it is made; cells in which two pieces of
/// surface meet are split, at most `fine_levels` times. Memory: about 20 MB a thread. Throws Error
/// "mesh-unresolved", "mesh-too-large".
void contour_uniform(const ExactField& field, double voxel, int fine_levels,
                     const MeshOptions& options, MeshSink& sink, ContourReport& report);

}  // namespace mrsim::detail
