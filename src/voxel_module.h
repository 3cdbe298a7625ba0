// Voxels through the module that samples them (removal/vdb), opened when the first are asked for,
// or before that on a thread of its own.
#pragma once

#include <future>

namespace mrsim {

/// Starts to open the module. A fault is thrown by sample_voxels, not here; but where the address
/// space is limited, the module is opened at once, and Error "memory" or "vdb-module" thrown. The
/// future waits for the thread when it is destroyed.
std::future<void> open_voxel_module();

}  // namespace mrsim
