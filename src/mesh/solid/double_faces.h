// Triangles that lie on others with the same corners.
#pragma once

#include <mrsim/types.h>

#include <cstddef>

namespace mrsim {

/// Leaves the first of the triangles with the same corners in the same order. Returns how many were
/// dropped.
std::size_t drop_doubles(TriMesh& mesh);

/// Drops triangles that look at another one with the same corners: nothing is between them. There
/// two bodies touch, and their union has no face. Returns how many were dropped.
std::size_t drop_touching(TriMesh& mesh);

}  // namespace mrsim
