// Makes a closed surface a 2-manifold: where more than two triangles share an edge, or more than
// one fan a vertex, the sheets are taken apart.
#pragma once

#include <mrsim/types.h>

namespace mrsim::testing {

/// Splits edges and vertices at which sheets of the surface touch, so that pieces of material that
/// touch along them come apart (as a cut that leaves nothing between would), and moves the copies
/// from each other by 1/64 of the way to their neighbours, so that they stay apart in files that
/// know coordinates only. Triangles without area are opened in the same way. Topology of untouched
/// places and the order of triangles are kept. Requires: each edge has as many half edges one way
/// as the other; a mesh where it does not is returned with that fault.
void make_manifold(TriMesh& mesh);

}  // namespace mrsim::testing
