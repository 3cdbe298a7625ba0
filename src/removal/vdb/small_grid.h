// Grids for what is left in many places. Each piece has a tree of its own for a while. OpenVDB's
// usual one takes 300 kB where it holds a single voxel, and there may be ten thousand pieces; in
// this one the nodes above the leaves are small.
#pragma once

#include "removal/vdb/grids.h"
#include <mrsim/types.h>

#include <vector>

namespace mrsim {

using SmallGrid = openvdb::Grid<openvdb::tree::Tree3<float, 3, 3>::Type>;

/// The pieces of a level set that do not touch each other.
std::vector<SmallGrid::Ptr> pieces_of(const openvdb::FloatGrid& grid);

/// Where the piece is zero, mm; normals point to positive values.
TriMesh surface_of(const SmallGrid& piece);

}  // namespace mrsim
