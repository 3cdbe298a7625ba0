// What a part holds beyond a nominal: the difference of two level sets, in connected pieces.
#pragma once

#include "removal/part/rest_voxels.h"

#include <vector>

namespace mrsim {

/// The pieces, the largest first. Requires: closed, oriented meshes, voxel > 0, above <= 2 voxels.
/// Same result for any number of threads.
std::vector<RestVoxels> find_rest_voxels(const RestTask& task);

}  // namespace mrsim
