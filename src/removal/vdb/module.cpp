#include "removal/vdb/module.h"

#include "removal/vdb/level_set.h"
#include "removal/vdb/rest.h"

extern "C" MRSIM_API mrsim::SampleVoxels mrsim_sample_voxels_2;
extern "C" MRSIM_API mrsim::ReadLevelSet mrsim_read_level_set_1;
extern "C" MRSIM_API mrsim::FindRest mrsim_find_rest_1;

mrsim::VoxelGrid* mrsim_sample_voxels_2(const mrsim::PartField& field,
                                        const mrsim::BlockIndex& index, double voxel,
                                        const mrsim::CarvePlan& options) {
  return mrsim::sample_voxels(field, index, voxel, options).release();
}

void mrsim_read_level_set_1(const std::string& path, mrsim::LevelSetSurface& found) {
  found = mrsim::read_level_set(path);
}

void mrsim_find_rest_1(const mrsim::RestTask& task, std::vector<mrsim::RestVoxels>& found) {
  found = mrsim::find_rest_voxels(task);
}
