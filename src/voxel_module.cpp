#include "voxel_module.h"

#include "core/module.h"
#include "removal/vdb/module.h"

namespace mrsim {
namespace {

struct VoxelModule {
  Module module{{"vdb", "vdb-module", "samples voxels",
                 "install mrsim with all its files and OpenVDB's library, build it again where "
                 "that has changed, or ask for a mesh instead of a .vdb"}};
  SampleVoxels* sample = module.function<SampleVoxels>(kSampleVoxels);
};

// Opened once; where that failed, the next call tries again.
const VoxelModule& voxel_module() {
  static const VoxelModule module;
  return module;
}

}  // namespace

std::future<void> open_voxel_module() {
  return std::async(std::launch::async, [] { voxel_module(); });
}

std::unique_ptr<VoxelGrid> sample_voxels(const PartField& field, const BlockIndex& index,
                                         double voxel, const CarveOptions& options) {
  return std::unique_ptr<VoxelGrid>(voxel_module().sample(field, index, voxel, options));
}

}  // namespace mrsim
