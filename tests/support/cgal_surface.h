// Meshes as CGAL holds them, for the few sources that compute with it; all others ask cgal_mesh.h.
#pragma once

#include <mrsim/types.h>

#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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

}  // namespace mrsim::testing
