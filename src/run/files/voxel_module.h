// Voxels through the module that knows OpenVDB (removal/vdb), opened when the first are needed,
// or before that on a thread of its own.
#pragma once

#include "removal/part/level_set_surface.h"
#include "removal/part/rest_voxels.h"

#include <future>
#include <string>
#include <vector>

namespace mrsim {

/// What OpenVDB's code and tables take once the module is open, bytes: measured 29 MB.
inline constexpr double kVoxelModuleMemory = 35e6;

/// Starts to open the module. A fault is thrown by sample_voxels, not here; but where the address
/// space is limited, the module is opened at once, and Error "memory" or "vdb-module" thrown. The
/// future waits for the thread when it is destroyed.
std::future<void> open_voxel_module();

/// The level set of a .vdb file, or its only grid of floats, with the surface where it is zero. On
/// this thread alone; OpenVDB gives no guarantee on damaged files. Throws Error "vdb-unreadable",
/// without the file's name, where there is none; "vdb-module".
void read_level_set(const std::string& path, LevelSetSurface& found);

/// removal/vdb/rest.h. Throws Error "vdb-module", "memory".
std::vector<RestVoxels> find_rest_voxels(const RestTask& task);

}  // namespace mrsim
