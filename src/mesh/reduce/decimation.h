// Edges of a mesh collapse into one of their ends, the one first that moves the surface least by
// quadrics (Garland and Heckbert 1997), on OpenMesh's half edges and with its quadrics.
//
// Why not OpenMesh's own loop: after each collapse it evaluates all edges about it again,
// which is most of its time: may they collapse, and at what cost? Here a vertex is evaluated when
// it is the next one, and of its edges the cheapest that may collapse. Its error can only have
// grown since, but for edges that have become legal; so the order is the same, or nearly.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace mrsim {

/// `mesh` with at most `most` triangles, or with more where no edge is left that may collapse.
/// Vertices with a mark in `stays` (one for each) stay. Faces keep their direction but for a turn,
/// and none becomes a needle; crossings are not looked for. `collapsed` is called for each collapse
/// and may throw. Requires: closed, oriented, 2-manifold.
TriMesh decimated(const TriMesh& mesh, std::size_t most, const std::vector<char>& stays,
                  const std::function<void()>& collapsed);

}  // namespace mrsim
