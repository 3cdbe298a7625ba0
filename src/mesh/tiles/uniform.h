// The mesher of the uniform grid: tile by tile, so that memory stays small and all cores work
// (docs/mesh.md, Tiles).
#pragma once

#include "mesh/cells/mesh_report.h"
#include "mesh/solid/mesh_block.h"
#include "mesh/solid/mesh_plan.h"
#include "mesh/tiles/crowded_cells.h"
#include "removal/field/field.h"

#include <set>

namespace mrsim::detail {

/// The surface over cells of one voxel, in blocks as it is made; where two pieces of surface meet
/// in a cell, it is flattened, then split, at most `halvings` times. `split`: cells that are split
/// from the start. Memory: some 13 MB a thread, and two tiles that are being made
/// (removal/part/memory_plan.h). Throws Error "mesh-unresolved", "mesh-too-large".
void mesh_uniform(const ExactField& field, double voxel, int halvings, const MeshPlan& options,
                  MeshSink& sink, MeshReport& report, const std::set<CellPlace>& split = {});

}  // namespace mrsim::detail
