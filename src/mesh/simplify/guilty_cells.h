// Which cells are to blame for a triangle that is not within the tolerance (docs/mesh.md,
// Tolerance).
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/simplify/simplify.h"
#include "mesh/surface/surface.h"

#include <cstdint>
#include <vector>

namespace mrsim::detail {

/// The cells whose vertices have missed the face that triangle `t` of the surface is labelled with;
/// else the largest ones about its edge. `ahead`: those next to the former along the crease that
/// they have missed as well. With duplicates.
std::vector<std::int32_t> guilty_cells(const ExactField& field, const CellOctree& tree,
                                       const DualSurface& surface, const LabelledMesh& mesh,
                                       std::size_t t, bool ahead);

}  // namespace mrsim::detail
