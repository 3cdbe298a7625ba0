// Walls and gaps that pass between neighbouring samples (docs/mesh.md, Thin features).
#pragma once

#include "mesh/contour.h"
#include "mesh/contour_octree.h"

#include <vector>

namespace mrsim::detail {

/// Thin walls and gaps on the doubtful edges of the tree, one for each pair of owners in each block
/// of 8 voxels, in the order of the tree.
std::vector<ThinFeature> thin_features(const ExactField& field, const ContourOctree& tree);

}  // namespace mrsim::detail
