#include "run/files/voxel_module.h"

#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/process/module.h"
#include "removal/vdb/module.h"

#include <system_error>

namespace mrsim {
namespace {

// log4cplus, which OpenVDB is linked to, starts four threads while it is loaded, with stacks of 8
// MB and heaps of 64 to 128 MB of address space; where one cannot be started it waits for ever.
constexpr std::size_t kLoading = std::size_t(512) << 20;

Module::Description description() {
  if (!has_address_space(kLoading))
    throw Error("memory",
                "the module that samples voxels needs 0.5 GB of address space to be opened; raise "
                "its limit (ulimit -v); a run that only writes meshes does without");
  return {"vdb", "vdb-module", "samples voxels",
          "install mrsim with all its files and OpenVDB's library, build it again where that has "
          "changed, or ask for a mesh instead of a .vdb"};
}

struct VoxelModule {
  Module module{description()};
  SampleVoxels* sample = module.function<SampleVoxels>(kSampleVoxels);
  ReadLevelSet* read = module.function<ReadLevelSet>(kReadLevelSet);
  FindRest* rest = module.function<FindRest>(kFindRest);
};

// Opened once; where that failed, the next call tries again.
const VoxelModule& voxel_module() {
  static const VoxelModule module;
  return module;
}

}  // namespace

std::future<void> open_voxel_module() {
  if (is_address_space_limited()) {  // other threads would take what was found free
    voxel_module();
    return {};
  }
  try {
    return std::async(std::launch::async, [] { voxel_module(); });
  } catch (const std::system_error&) {  // no thread: opened when it is needed
    return {};
  }
}

std::unique_ptr<VoxelGrid> sample_voxels(const PartField& field, const BlockIndex& index,
                                         double voxel, const CarvePlan& options) {
  return std::unique_ptr<VoxelGrid>(voxel_module().sample(field, index, voxel, options));
}

void read_level_set(const std::string& path, LevelSetSurface& found) {
  voxel_module().read(path, found);
}

std::vector<RestVoxels> find_rest_voxels(const RestTask& task) {
  std::vector<RestVoxels> found;
  voxel_module().rest(task, found);
  return found;
}

}  // namespace mrsim
