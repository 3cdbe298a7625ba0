// How small the cells of the mesher may become.
#pragma once

#include "core/numbers/vec.h"

namespace mrsim::detail {

/// How often a voxel may be halved: down to half the tolerance (mm), in which any triangle is
/// within it, an eighth of a voxel without one; but not so small that coordinates as floats no
/// longer resolve the cells of a part within `bounds`, mm.
int voxel_halvings(const Box3& bounds, double voxel, double tolerance);

/// Throws Error "voxel-invalid" where float coordinates do not separate the planes of the voxels
/// apart.
void require_resolved(const Box3& bounds, double voxel);

/// Throws Error "tolerance-invalid" for a tolerance, mm, that vertices with coordinates as floats
/// can not keep.
void require_tolerance(const Box3& bounds, double tolerance);

}  // namespace mrsim::detail
