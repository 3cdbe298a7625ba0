// Finer cells where a mesh has lost walls and gaps (docs/mesh.md, Thin features).
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/cells/thin_features.h"

#include <cstddef>
#include <span>

namespace mrsim::detail {

/// Splits the leaves about the features that are thicker than `tolerance` mm until their cells are
/// narrower than these, the thickest ones first, while about `room` more nodes are enough for that.
/// Returns how many leaves were split. Throws what CellOctree::split() throws.
std::size_t split_lost(CellOctree& tree, std::span<const FoundThin> lost, double tolerance,
                       double room);

/// Nodes that may be added about what is lost, by counts alone: equal runs give equal meshes.
/// `nodes`: of the octree; `most`: those that it may have, 0 = any number; `memory`: bytes left.
double room_for_lost(std::size_t nodes, double most, double memory);

}  // namespace mrsim::detail
