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
/// options.fallback_voxel says that a grid may take its place: `report` then holds the reason
/// alone. Without a fallback throws "mesh-unresolved", "memory", and "cancelled" always.
std::optional<TriMesh> adaptive_mesh(const ExactField& field, double voxel, const MeshPlan& options,
                                     MeshReport& report);

}  // namespace mrsim
