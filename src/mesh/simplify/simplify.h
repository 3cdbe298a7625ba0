// Certified simplification: takes vertices out of the mesh while every triangle stays within the
// tolerance of the face of the part it lies on, and every crease within the tolerance of the exact
// one (docs/mesh.md, Simplification).
#pragma once

#include "mesh/cells/flat_map.h"
#include "mesh/cells/octree.h"
#include "mesh/points/vertex.h"
#include "mesh/simplify/labelled_mesh.h"

#include <memory>
#include <vector>

namespace mrsim::detail {

struct SimplifyLimits {
  double tolerance = 0;  ///< mm
  double lateral = 0;    ///< mm: how far a border between owners may move on a smooth curved face
  double straight = 0;   ///< mm: how far it may move on a plane face, in which its vertices lie
};

struct CollapsedMesh;

/// Simplifies one mesh, and again with more vertices locked: what was measured is kept, and so are
/// the blocks of the mesh in which the same vertices are locked.
class MeshSimplifier {
 public:
  /// Keeps references to all of these.
  MeshSimplifier(const ExactField& field, const CellOctree& tree, const LabelledMesh& mesh,
                 const SimplifyLimits& limits, int threads);
  ~MeshSimplifier();

  /// Vertices are only removed, never moved; `locked` ones stay. The result is manifold if the mesh
  /// is; it may intersect itself where walls are thinner than the tolerance (the caller checks).
  /// Blocks of the mesh first, on all threads, then what lies between them: the same for any
  /// number.
  LabelledMesh simplified(const std::vector<char>& locked);

 private:
  using Vertices = std::vector<std::uint32_t>;

  void find_blocks();
  void simplify_blocks(const std::vector<char>& locked);

  const ExactField& field_;
  const CellOctree& tree_;
  const LabelledMesh& mesh_;
  const SimplifyLimits limits_;
  int threads_;
  double most_ = 0;                           ///< mm: no edge is longer
  std::vector<Vertices> blocks_;              ///< none: the mesh is too small for them
  std::unique_ptr<CollapsedMesh> by_blocks_;  ///< after the blocks
  std::vector<FlatMap> measured_;             ///< of each block, and of what lies between them
};

}  // namespace mrsim::detail
