// The grid "cut": when each voxel of the stock was removed (docs/history.md).
#pragma once

#include "removal/part/block_index.h"
#include "removal/part/part_field.h"
#include "removal/vdb/grids.h"

namespace mrsim {

/// The voxels of the stock before the first cut are active. Each holds the index of the first
/// motion that removes it, or kStillThere. All other voxels hold kNeverThere. Uniform regions are
/// tiles. Same result for any number of threads. `index`: blocks of the voxels of `transform`.
openvdb::Int32Grid::Ptr make_cut_grid(const PartField& field, const BlockIndex& index,
                                      const openvdb::math::Transform::Ptr& transform, int threads);

}  // namespace mrsim
