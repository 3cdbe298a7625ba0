// What a part holds beyond another solid, as the module removal/vdb finds it in voxels.
#pragma once

#include <mrsim/types.h>

#include <vector>

namespace mrsim {

/// A connected piece of the part that lies farther outside of the nominal than RestTask::above.
struct RestVoxels {
  TriMesh surface;           ///< mm, on the voxels: to be moved onto the exact surfaces
  std::vector<Vec3> places;  ///< in it and close above the nominal, evenly chosen, mm
};

struct RestTask {
  TriMesh part, nominal;
  double voxel = 0;  ///< mm
  double above = 0;  ///< mm, at most 2 voxels
  int threads = 0;
};

}  // namespace mrsim
