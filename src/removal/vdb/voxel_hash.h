// What tells whether a grid of a .vdb file is as it was written.
#pragma once

#include "removal/vdb/grids.h"

#include <string>

namespace mrsim {

/// A hash of the active voxels, their places and values, and of the voxels' size: equal for equal
/// grids, in whatever way they were compressed.
std::string voxel_hash(const openvdb::FloatGrid& grid);

}  // namespace mrsim
