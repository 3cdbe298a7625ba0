// The surface of a level set that another program has made, as the module removal/vdb reads it.
#pragma once

#include <mrsim/types.h>

#include <string>

namespace mrsim {

struct LevelSetSurface {
  std::string grid;  ///< its name
  double voxel = 0;  ///< mm, the longest side of one
  std::string hash;  ///< of its voxels
  TriMesh surface;   ///< mm, normals point out of the material
};

}  // namespace mrsim
