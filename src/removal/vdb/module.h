// The functions that the module mrsim/vdb.so exports: it samples voxels with OpenVDB. The module
// has its own copy of the code that it calls, and both sides use objects that the other side made.
// So both must come from the same build.
#pragma once

#include "removal/part/voxel_grid.h"

namespace mrsim {

/// sample_voxels; the caller owns what it gives.
using SampleVoxels = VoxelGrid*(const PartField& field, const BlockIndex& index, double voxel,
                                const CarveOptions& options);

/// Name under which the module shows it; the number changes with the border.
constexpr const char* kSampleVoxels = "mrsim_sample_voxels_1";

}  // namespace mrsim
