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

/// Calls sample_voxels(). The caller owns the grid that is returned.
using SampleVoxels = VoxelGrid*(const PartField& field, const BlockIndex& index, double voxel,
                                const CarvePlan& options);

/// Calls read_level_set() and stores the surface in `found`.
using ReadLevelSet = void(const std::string& path, LevelSetSurface& found);

/// Calls find_rest_voxels() and stores the pieces in `found`.
using FindRest = void(const RestTask& task, std::vector<RestVoxels>& found);

/// Names under which the module shows them. The number is raised when a function or a class that it
/// takes changes, so that a module of another version is refused.
constexpr const char* kSampleVoxels = "mrsim_sample_voxels_2";
constexpr const char* kReadLevelSet = "mrsim_read_level_set_1";
constexpr const char* kFindRest = "mrsim_find_rest_1";

}  // namespace mrsim
