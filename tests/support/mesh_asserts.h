// What tests ask of meshes and of the bytes they are written as.
#pragma once

#include "core/text/text_io.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"
#include "removal/field/field.h"
#include "support/error_code.h"
#include <mrsim/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim::testing {

inline std::string bytes_of(const std::function<void(const ByteSink&)>& writer) {
  std::string bytes;
  writer([&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  });
  return bytes;
}

/// The triangles by the coordinates of their corners: what stays the same when vertices are
/// renumbered.
inline std::vector<std::array<std::array<float, 3>, 3>> corners_of(const TriMesh& mesh) {
  std::vector<std::array<std::array<float, 3>, 3>> out;
  for (const auto& t : mesh.triangles)
    out.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  return out;
}

/// mm: how far vertices are from the surface of the exact part, at most.
inline double largest_vertex_error(const ExactField& part, const TriMesh& mesh) {
  const Candidates all = part.all();
  double most = 0;
  for (const auto& v : mesh.vertices)
    most = std::max(most, std::abs(part.sample(to_vec(v), all).distance));
  return most;
}

inline void expect_closed_manifold(const TriMesh& mesh) {
  const MeshSummary s = check_mesh(mesh);
  EXPECT_TRUE(s.closed) << s.first_fault;
  EXPECT_TRUE(s.oriented) << s.first_fault;
  EXPECT_TRUE(s.manifold) << s.first_fault;
  EXPECT_EQ(s.first_fault, "");
}

}  // namespace mrsim::testing
