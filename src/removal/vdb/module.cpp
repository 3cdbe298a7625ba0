#include "removal/vdb/module.h"

extern "C" MRSIM_API mrsim::SampleVoxels mrsim_sample_voxels_1;

mrsim::VoxelGrid* mrsim_sample_voxels_1(const mrsim::PartField& field,
                                        const mrsim::BlockIndex& index, double voxel,
                                        const mrsim::CarveOptions& options) {
  return mrsim::sample_voxels(field, index, voxel, options).release();
}
