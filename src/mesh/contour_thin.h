// Walls and gaps that pass between neighbouring samples (docs/mesh.md, Thin features).
#pragma once

#include "mesh/contour.h"
#include "mesh/contour_cells.h"

#include <span>
#include <vector>

namespace mrsim::detail {

/// A thin feature and what tells it from others: its owners and its block of 8 voxels.
struct FoundThin {
  ThinFeature feature;
  std::uint64_t block = 0;
};

/// Thin walls and gaps on the doubtful edges, in their order.
std::vector<FoundThin> thin_features(const ExactField& field, const ContourCells& cells,
                                     std::span<const MinimalEdge> doubtful);

/// Those of them that a mesh of the part does not hold within `tolerance` mm, on the edge or on
/// lines beside it, in the order of the edges. Requires: the mesh is closed and oriented. Costs
/// some hundred samples and searches in the mesh for each thin feature.
std::vector<FoundThin> lost_features(const ExactField& field, const ContourCells& cells,
                                     std::span<const MinimalEdge> doubtful, const TriMesh& mesh,
                                     double tolerance, int threads);

/// One for each pair of owners in each block.
std::vector<ThinFeature> distinct(std::span<const FoundThin> found);

}  // namespace mrsim::detail
