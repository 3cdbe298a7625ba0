// What a part holds beyond another solid, as the module removal/vdb finds it in voxels.
#pragma once

#include <mrsim/types.h>

#include <vector>

namespace mrsim {

/// A connected piece of the part that lies farther outside of the nominal than RestTask::above.
struct RestVoxels {
  TriMesh surface;   ///< mm, on the voxels: to be moved onto the exact surfaces
  double ball = 0;   ///< mm: diameter of the largest ball that reaches all of it
  double flat = 0;   ///< mm: of the largest upright cylinder that reaches it from above
  double error = 0;  ///< mm: of both diameters
  bool ball_is_least = false, flat_is_least = false;  ///< larger ones were not tried
};

struct RestTask {
  TriMesh part, nominal;
  double voxel = 0;          ///< mm
  double above = 0;          ///< mm, at most 2 voxels
  std::size_t searched = 0;  ///< pieces whose tools are looked for, the largest ones
  int threads = 0;
};

}  // namespace mrsim
