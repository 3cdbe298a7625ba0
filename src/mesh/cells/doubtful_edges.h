// Edges of the voxel lattice between whose ends a thin wall or gap may pass (docs/mesh.md, Thin
// features).
#pragma once

#include "mesh/solid/vertex_lattice.h"
#include "removal/field/field.h"

#include <array>
#include <span>
#include <vector>

namespace mrsim::detail {

/// Distances at an edge of the voxel lattice and the points before and behind it, on one line: true
/// where they rise or fall evenly, as those of a surface do that passes beside the edge; a wall or
/// gap across it does not. False where one is not known (infinite).
bool run_evenly(const std::array<double, 4>& distances, double voxel);

/// An edge of the voxel lattice, a voxel long.
struct VoxelEdge {
  LatticePoint start;
  int axis = 0;
};

/// Edges of the voxel lattice in a cell larger than a voxel that may hide surface; the cell's high
/// sides are left out. An edge counts if its ends lie on one side of the surface, have different
/// owners, and are near enough to it for the surface to pass twice between them, unless d runs
/// evenly along it (run_evenly()). If all corners of the cell lie on one side (`alike`), edges that
/// the surface passes once count too. Cost: some eight samples for each voxel of the surface.
std::vector<VoxelEdge> doubtful_inside(const ExactField& field, const Lattice& lattice,
                                       std::span<const std::uint32_t> candidates,
                                       const LatticePoint& origin, std::int32_t voxels, bool alike);

}  // namespace mrsim::detail
