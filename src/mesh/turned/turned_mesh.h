// The mesh of a part that is the same at every angle about the Z axis: its outline, turned.
#pragma once

#include "mesh/cells/mesh_report.h"
#include "mesh/solid/mesh_plan.h"
#include "removal/field/field.h"

#include <optional>

namespace mrsim::detail {

/// The mesh within options.tolerance of the part, with the guarantees of adaptive.h. Nothing where
/// it cannot be made so: the outline meets itself at this tolerance, or coordinates are too coarse
/// for it. Requires: field.is_turned(field.all()), a tolerance above 0. Throws Error "memory".
std::optional<TriMesh> turned_mesh(const ExactField& field, double voxel, const MeshPlan& options,
                                   MeshReport& report);

}  // namespace mrsim::detail
