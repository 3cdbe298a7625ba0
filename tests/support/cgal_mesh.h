// Meshes as CGAL sees them: the independent judge of self-intersections and distances.
#pragma once

#include "mesh/solid/check.h"
#include "support/mesh_asserts.h"
#include <mrsim/types.h>

#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

namespace mrsim::testing {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

inline SurfaceMesh to_cgal(const TriMesh& mesh) {
  SurfaceMesh out;
  std::vector<SurfaceMesh::Vertex_index> ids;
  for (const auto& v : mesh.vertices) ids.push_back(out.add_vertex({v[0], v[1], v[2]}));
  for (const auto& t : mesh.triangles) out.add_face(ids[t[0]], ids[t[1]], ids[t[2]]);
  EXPECT_EQ(out.number_of_faces(), mesh.triangles.size());
  return out;
}

inline std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> meeting_faces(
    const TriMesh& mesh) {
  const SurfaceMesh m = to_cgal(mesh);
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(m, std::back_inserter(pairs));
  return pairs;
}

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
