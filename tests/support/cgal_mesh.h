// Meshes as CGAL sees them: the independent judge of self-intersections and distances.
#pragma once

#include "mesh/solid/check.h"
#include "support/mesh_asserts.h"
#include <mrsim/types.h>

#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim::testing {

/// Triangles that meet elsewhere than in corners and edges that they share.
std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_faces(const TriMesh& mesh);

/// mm: the largest distance of points of one mesh from the other, to within `error`.
double directed_hausdorff_by_cgal(const TriMesh& from, const TriMesh& to, double error);

inline std::size_t self_intersections(const TriMesh& mesh) { return meeting_faces(mesh).size(); }

/// A closed 2-manifold that does not meet itself, its vertices on the exact part. `seed` tells it
/// from others.
inline void expect_sound(const ExactField& part, const TriMesh& mesh, std::uint64_t seed) {
  const MeshSummary s = check_mesh(mesh);
  EXPECT_TRUE(s.closed && s.oriented && s.manifold && s.degenerate == 0) << seed << s.first_fault;
  EXPECT_EQ(self_intersections(mesh), 0u) << seed;
  EXPECT_LE(largest_vertex_error(part, mesh), 1e-3) << seed;
}

}  // namespace mrsim::testing
