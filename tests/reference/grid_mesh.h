// Reference: the mesh of plain OpenVDB grids, for tests and benchmarks.
#pragma once

#include "removal/vdb/grids.h"
#include <mrsim/types.h>

namespace mrsim::testing {

/// The surface distance = -kInsideTolerance by OpenVDB's VolumeToMesh: quads split along their
/// shorter diagonal, taken apart where sheets touch (repair.h), each triangle with the owner of the
/// voxel nearest to the surface among the eight about it (`owners` may be null). Vertices lie on
/// the surface to about a tenth of a voxel; edges are rounded. The same for any number of threads.
/// Empty when nothing is inside. Requires: a closed narrow band level set in mm.
TriMesh mesh_grid(const openvdb::FloatGrid& distance, const openvdb::Int32Grid* owners,
                  int threads = 0);

}  // namespace mrsim::testing
