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

#include "mesh/cells/mesh_report.h"
#include "mesh/solid/mesh_block.h"
#include "mesh/solid/mesh_plan.h"
#include "removal/field/field.h"
#include <mrsim/types.h>

namespace mrsim {

/// The surface of `field`, with the owner of each triangle. `voxel` (mm) is the size of features to
/// resolve, and the edge of all cells where options.tolerance is 0. Throws as refuse_empty() does,
/// "voxel-invalid", "tolerance-invalid", "memory" (options.max_memory); "mesh-unresolved" rather
/// than give a mesh that breaks a guarantee. Requires: options.most_nodes == 0.
TriMesh mesh_part(const ExactField& field, double voxel, const MeshPlan& options = {},
                  MeshReport* report = nullptr);

/// mesh_part(), handed on in blocks; without a tolerance as it is made, so that it is never in
/// memory as a whole. Does not throw where the part is empty, or its mesh was given up
/// (MeshReport::given_up): there are no triangles then.
void mesh_part(const ExactField& field, double voxel, const MeshPlan& options, MeshSink& sink,
               MeshReport* report = nullptr);

/// Ends a run whose mesh has no triangles: Error "part-empty", or "part-thin" where something is
/// left that is thicker than an eighth of the voxel (mm). Costs a few samples for each voxel that
/// the surface may pass.
[[noreturn]] void refuse_empty(const ExactField& field, double voxel);

}  // namespace mrsim
