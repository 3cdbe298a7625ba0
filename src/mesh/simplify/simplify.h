// Certified simplification: takes vertices out of the mesh while every triangle stays within the
// tolerance of the face of the part it lies on, and every crease within the tolerance of the exact
// one (docs/mesh.md, Simplification).
#pragma once

#include "mesh/cells/flat_map.h"
#include "mesh/cells/octree.h"
#include "mesh/points/vertex.h"
#include "mesh/simplify/labelled_mesh.h"

#include <array>
#include <vector>

namespace mrsim::detail {

struct SimplifyLimits {
  double tolerance = 0;  ///< mm
  double lateral = 0;    ///< mm: how far a border between owners may move on a smooth curved face
  double straight = 0;   ///< mm: how far it may move on a plane face, in which its vertices lie
};

/// Which measured triangles lie within the limits. Kept so that simplifying the same mesh again,
/// with more vertices locked, need not measure them again.
struct MeasuredTriangles {
  std::vector<FlatMap> of_block;  ///< the last one: what lies between the blocks
};

/// Vertices are only removed, never moved; `locked` ones stay. The result is manifold if `mesh` is;
/// it may intersect itself where walls are thinner than the tolerance (the caller checks). Blocks
/// of the mesh first, on `threads` threads, then what lies between them: the same for any number.
LabelledMesh simplify(const ExactField& field, const CellOctree& tree, const LabelledMesh& mesh,
                      const SimplifyLimits& limits, const std::vector<char>& locked,
                      MeasuredTriangles& measured, int threads);

}  // namespace mrsim::detail
