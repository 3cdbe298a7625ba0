// How small the cells of the mesher may become.
#pragma once

#include "core/numbers/vec.h"

namespace mrsim::detail {

/// How often a voxel may be halved. With a tolerance (mm), until cells are half as large as it,
/// since any triangle in such a cell keeps it; without one, three times. Fewer where float
/// coordinates of a part within `bounds` (mm) could not tell the corners of so small cells apart.
int voxel_halvings(const Box3& bounds, double voxel, double tolerance);

/// Throws Error "voxel-invalid" where float coordinates do not separate the planes of the voxels
/// apart.
void require_resolved(const Box3& bounds, double voxel);

/// Throws Error "tolerance-invalid" for a tolerance, mm, that vertices with coordinates as floats
/// can not keep.
void require_tolerance(const Box3& bounds, double tolerance);

}  // namespace mrsim::detail
