// The functions that the module mrsim/vdb.so exports: it samples and reads voxels with OpenVDB. The
// module has its own copy of the code that it calls, and both sides use objects that the other side
// made. So both must come from the same build.
#pragma once

#include "removal/part/level_set_surface.h"
#include "removal/part/rest_voxels.h"
#include "removal/part/voxel_grid.h"

#include <string>
#include <vector>

namespace mrsim {

/// sample_voxels; the caller owns what it gives.
using SampleVoxels = VoxelGrid*(const PartField& field, const BlockIndex& index, double voxel,
                                const CarvePlan& options);

/// read_level_set into `found`.
using ReadLevelSet = void(const std::string& path, LevelSetSurface& found);

/// find_rest_voxels into `found`.
using FindRest = void(const RestTask& task, std::vector<RestVoxels>& found);

/// Names under which the module shows them. The number is raised when a function or a class that it
/// takes changes, so that a module of another version is refused.
constexpr const char* kSampleVoxels = "mrsim_sample_voxels_2";
constexpr const char* kReadLevelSet = "mrsim_read_level_set_1";
constexpr const char* kFindRest = "mrsim_find_rest_1";

}  // namespace mrsim
