// Removes vertices of a mesh by collapsing edges, while every triangle and every crease stays
// within the limits (docs/mesh.md, Simplification).
#pragma once

#include "mesh/cells/flat_map.h"
#include "mesh/cells/octree.h"
#include "mesh/simplify/simplify.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim::detail {

/// A mesh of which vertices are removed. Blocks share it: a block removes a vertex only if the
/// vertex and all its neighbours are its own, so nothing changes that another block reads or
/// writes.
struct CollapsedMesh {
  using Triangle = std::array<std::uint32_t, 3>;

  /// Nothing is removed yet. `from` has to outlive it.
  explicit CollapsedMesh(const LabelledMesh& from);

  /// Begins anew where all corners lie in these blocks: as if no vertex of theirs had been removed.
  void restore(const std::vector<char>& blocks);

  /// What is left, without the vertices that no triangle names.
  LabelledMesh compact() const;

  const LabelledMesh& from;
  std::vector<Triangle> triangles;                 ///< as many as in `from`
  std::vector<char> alive;                         ///< by triangle
  std::vector<std::vector<std::uint32_t>> around;  ///< triangles by vertex; empty: it is removed
  std::vector<char> locked;                        ///< by vertex: stays
  std::vector<char> tried;          ///< by vertex: not removed, for another reason than length
  std::vector<double> wanted;       ///< mm: length of edges without which it can not be removed
  std::vector<std::uint8_t> block;  ///< by vertex; empty: all are one
};

/// Removes what it can of these vertices, short edges first, and makes edges of up to `most` mm.
/// `measured`: whether triangles lie within the limits, from this call and calls before.
void remove_vertices(const ExactField& field, const CellOctree& tree, const SimplifyLimits& limits,
                     std::span<const std::uint32_t> vertices, double most, CollapsedMesh& mesh,
                     FlatMap& measured);

}  // namespace mrsim::detail
