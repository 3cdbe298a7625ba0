// A mesh with fewer triangles (decimation.h): edges collapse into one of their ends, the
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

/// `mesh` with at most `most` triangles, or with more where fewer were not found: no edge is left
/// that may collapse, or what was tried crosses itself. Each triangle has the owner of the face of
/// `mesh` that is nearest to its middle. Requires: a closed, oriented, 2-manifold mesh without
/// crossings, coordinates as vertex_lattice.h says. Throws Error "cancelled", and "memory" where
/// there is less than reduction_memory(). Some 11 s for a million triangles, on one thread.
TriMesh reduce_mesh(const TriMesh& mesh, std::size_t most, const MeshOptions& options);

/// The bytes that reduce_mesh() needs beside a mesh of so many triangles.
double reduction_memory(std::size_t triangles);

}  // namespace mrsim
