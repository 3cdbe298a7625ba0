// The mesh of a part within a tolerance: cells of an octree are split until every triangle is
// within it (docs/mesh.md). What it guarantees stands in mesh/mesh_part.h.
#pragma once

#include "mesh/cells/mesh_report.h"
#include "mesh/solid/mesh_plan.h"
#include "removal/field/field.h"
#include <mrsim/types.h>

#include <optional>

namespace mrsim {

/// The mesh within options.tolerance (mm) of the surface of `field`, on cells of `voxel` mm and
/// smaller ones. None where it takes more cells, splits or memory than are allowed and
/// options.most_nodes says that it may be given up: `report` then holds the reason and the memory
/// alone. Else throws "mesh-unresolved", "memory"; "cancelled" always.
std::optional<TriMesh> adaptive_mesh(const ExactField& field, double voxel, const MeshPlan& options,
                                     MeshReport& report);

}  // namespace mrsim
