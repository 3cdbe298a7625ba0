// The surface where a grid of distances is zero.
#pragma once

#include "removal/vdb/grids.h"
#include <mrsim/types.h>

#include <algorithm>
#include <vector>

#include <openvdb/tools/VolumeToMesh.h>

namespace mrsim {

/// The triangles that VolumeToMesh makes of a grid whose voxels have edges of `voxel` mm at least.
TriMesh joined_surface(const std::vector<openvdb::Vec3s>& points,
                       const std::vector<openvdb::Vec3I>& triangles,
                       const std::vector<openvdb::Vec4I>& quads, double voxel);

/// Where the grid, whatever its tree, is zero, mm; normals point to positive values.
template <class Grid>
TriMesh surface_of(const Grid& grid) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(grid, points, triangles, quads);
  const openvdb::Vec3d size = grid.voxelSize();
  return joined_surface(points, triangles, quads, std::min({size.x(), size.y(), size.z()}));
}

}  // namespace mrsim
