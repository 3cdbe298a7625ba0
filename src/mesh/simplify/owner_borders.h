// Borders between owners on one plane face, where the floors of two passes meet: triangles of the
// mesher are as large as its cells, and each belongs to one owner, so they are cut along the border
// (docs/mesh.md, Borders between owners).
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/simplify/simplify.h"

namespace mrsim::detail {

/// `mesh` with the triangles of plane faces cut along the borders between the owners of what they
/// lie on, and labelled anew: chords of a border are within `tolerance` mm of it. New vertices are
/// points of edges that lie on the exact surface, or of triangles that do; the surface stays as it
/// is. Triangles off the surface, and on curved faces, stay as they are. Five to seven samples a
/// plane triangle where more than one sweep can decide d, some thirty for each edge that a border
/// crosses. The result is the same for any number of threads.
LabelledMesh cut_owner_borders(const ExactField& field, const CellOctree& tree,
                               const LabelledMesh& mesh, double tolerance, int threads);

}  // namespace mrsim::detail
