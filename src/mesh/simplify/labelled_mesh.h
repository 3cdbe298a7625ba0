// A mesh that knows, of each triangle, the face of the part that it stands for.
#pragma once

#include "removal/field/field.h"
#include <mrsim/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

class DualSurface;

inline constexpr double kLeastHeight = 2e-5;  ///< mm: no new triangle is lower

struct LabelledMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> labels;  ///< of each triangle: index into `faces`
  std::vector<FieldSample> faces;
};

inline Corners3 corners_of(const LabelledMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// The triangles of a surface, each with the face of the part at the crossing that it is about.
/// Requires: surface.make_triangles().
LabelledMesh labelled_mesh(const DualSurface& surface);

/// Drops the vertices that no triangle names; the order of the others is kept.
void drop_unused_vertices(LabelledMesh& mesh);

/// The mesh in single precision, each triangle with the owner of its face.
TriMesh to_tri_mesh(const LabelledMesh& mesh);

}  // namespace mrsim::detail
