// What the module that samples voxels, <folder of the library>/mrsim/vdb.so, shows. It holds
// OpenVDB's side and a copy of the stage's code that this calls; objects made on one side are used
// by the other, so both are of one build.
#pragma once

#include "removal/voxel_grid.h"

namespace mrsim {

/// sample_voxels; the caller owns what it gives.
using SampleVoxels = VoxelGrid*(const PartField& field, const BlockIndex& index, double voxel,
                                const CarveOptions& options);

/// Name under which the module shows it; the number changes with the border.
constexpr const char* kSampleVoxels = "mrsim_sample_voxels_1";

}  // namespace mrsim
