// Finds the triangles of a surface that are farther from the part than the tolerance, and what each
// of them needs: a finer surface in the same cells, or smaller cells.
#pragma once

#include "mesh/cells/flat_map.h"
#include "mesh/cells/octree.h"
#include "mesh/surface/dual_surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

struct FailureRules {
  double tolerance = 0;  ///< mm
  bool may_draw = true;  ///< finer drawing may take the place of splitting
  bool is_late = false;  ///< few triangles fail: splitting more cells is cheaper than another round
  int threads = 0;       ///< 0 = all
};

/// By triangles of the surface, in their order.
struct FailedTriangles {
  std::vector<std::uint64_t> hashes;              ///< equal for equal triangles
  std::vector<Detail> wanted;                     ///< how finely to draw; flat: not more finely
  std::vector<std::vector<std::int32_t>> guilty;  ///< cells to split; none for one that is good
  std::size_t cells = 0;                          ///< to split, with duplicates
};

/// Measures all triangles but those whose hash is in `passed`. Costs a bound of each of them
/// (MeshCertifier::certified), on all threads. Requires: surface.make_triangles().
FailedTriangles failed_triangles(const ExactField& field, const CellOctree& tree,
                                 const DualSurface& surface, const FlatMap& passed,
                                 const FailureRules& rules);

}  // namespace mrsim::detail
