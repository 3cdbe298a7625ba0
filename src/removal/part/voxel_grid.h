// The border to OpenVDB, which src/removal/vdb alone knows: the samples of a part in a narrow band.
//
// What lies behind it is linked in, as the stages' tests do, or stands in a module that the library
// opens when the first samples are wanted (voxel_module.h): binding the 69 000 symbols of
// OpenVDB takes 35 ms, and most runs need no grid.
#pragma once

#include "removal/part/block_index.h"
#include "removal/part/carve_plan.h"
#include "removal/part/part_field.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

namespace mrsim {

/// Names of the metadata of a .vdb file (stock_file.h).
inline constexpr const char* kRecipeMetadata = "mrsim:recipe";
inline constexpr const char* kVoxelsMetadata = "mrsim:voxels";

class VoxelGrid {
 public:
  virtual ~VoxelGrid() = default;
  virtual std::size_t active_voxels() const = 0;
  virtual std::size_t memory() const = 0;  ///< bytes
  /// Writes a stream of OpenVDB with three grids: "distance" (mm, level set), "owner", and "cut",
  /// which is made here from the field and the blocks that the samples were taken from; `recipe`
  /// and a hash of the distances are metadata of the file. Faults of `out` are left in its state.
  virtual void write(const PartField& field, const BlockIndex& index, const std::string& recipe,
                     std::ostream& out) const = 0;
};

/// Samples the exact part block by block, voxels of `voxel` mm, kBandVoxels each way of the
/// surface. Cost: grows with the surface. Throws Error "cancelled"; "vdb-module" where the module
/// cannot be opened.
std::unique_ptr<VoxelGrid> sample_voxels(const PartField& field, const BlockIndex& index,
                                         double voxel, const CarvePlan& options);

}  // namespace mrsim
