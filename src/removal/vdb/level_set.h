// The distance grid of a .vdb file that another program has made, or written again.
#pragma once

#include "removal/part/level_set_surface.h"

#include <string>

#include <openvdb/openvdb.h>

namespace mrsim {

/// A hash of the active voxels, their places and values, and of the voxels' size: equal for equal
/// grids, in whatever way they were compressed.
std::string voxel_hash(const openvdb::FloatGrid& grid);

/// Where the grid is zero, mm; normals point to positive values.
TriMesh surface_of(const openvdb::FloatGrid& grid);

/// The level set of a file, or its only grid of floats, with the surface where it is zero. One
/// thread. Throws Error "vdb-unreadable", without the file's name, where there is none.
LevelSetSurface read_level_set(const std::string& path);

}  // namespace mrsim
