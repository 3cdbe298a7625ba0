// The distance grid of a .vdb file that another program has made, or written again.
#pragma once

#include "removal/part/level_set_surface.h"
#include "removal/vdb/grids.h"

#include <algorithm>
#include <string>
#include <vector>

#include <openvdb/tools/VolumeToMesh.h>

namespace mrsim {

/// A hash of the active voxels, their places and values, and of the voxels' size: equal for equal
/// grids, in whatever way they were compressed.
std::string voxel_hash(const openvdb::FloatGrid& grid);

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

/// The level set of a file, or its only grid of floats, with the surface where it is zero. One
/// thread. Throws Error "vdb-unreadable", without the file's name, where there is none.
LevelSetSurface read_level_set(const std::string& path);

}  // namespace mrsim
