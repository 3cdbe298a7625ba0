// A mesh with fewer triangles, by OpenMesh's decimation: edges collapse into one of their ends, the
// ones first that move the surface least by quadrics (Garland and Heckbert 1997).
//
// Guarantees: vertices of the result are vertices of the mesh that was given; the result is closed,
// oriented and 2-manifold, has no triangle without area and does not cross itself; the same bytes
// for any number of threads. Not guaranteed: how far it is from the mesh that was given; that is
// measured afterwards (docs/mesh.md, Fewer triangles).
#pragma once

#include <mrsim/options.h>
#include <mrsim/types.h>

#include <cstddef>

namespace mrsim {

/// `mesh` with at most `most` triangles, or with more where no edge is left that may collapse. Each
/// triangle has the owner of the face of `mesh` that is nearest to its middle. Returns a mesh
/// without triangles where all that were tried cross themselves. Requires: a closed, oriented,
/// 2-manifold mesh without crossings, coordinates as vertex_lattice.h says. Throws Error
/// "cancelled". Some two minutes for a million triangles.
TriMesh reduce_mesh(const TriMesh& mesh, std::size_t most, const MeshOptions& options);

}  // namespace mrsim
