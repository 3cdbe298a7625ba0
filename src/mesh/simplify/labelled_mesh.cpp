#include "mesh/simplify/labelled_mesh.h"

#include "mesh/solid/weld.h"

namespace mrsim::detail {

void drop_unused_vertices(LabelledMesh& mesh) {
  const std::vector<std::uint32_t> used = number_used(mesh.triangles, mesh.vertices.size());
  for (std::size_t k = 0; k < used.size(); ++k) mesh.vertices[k] = mesh.vertices[used[k]];
  mesh.vertices.resize(used.size());
}

TriMesh to_tri_mesh(const LabelledMesh& mesh) {
  TriMesh out;
  out.vertices.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices)
    out.vertices.push_back(
        {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  out.triangles = mesh.triangles;
  out.owners.reserve(mesh.labels.size());
  for (const std::uint32_t l : mesh.labels) out.owners.push_back(mesh.faces[l].owner);
  return out;
}

}  // namespace mrsim::detail
