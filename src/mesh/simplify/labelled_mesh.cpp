#include "mesh/simplify/labelled_mesh.h"

#include "mesh/cells/flat_map.h"
#include "mesh/solid/weld.h"
#include "mesh/surface/dual_surface.h"

namespace mrsim::detail {

LabelledMesh labelled_mesh(const DualSurface& surface) {
  const BaseMesh& base = surface.mesh();
  LabelledMesh mesh;
  mesh.vertices = base.vertices;
  mesh.triangles = base.triangles;
  mesh.labels.reserve(base.crossings.size());
  FlatMap ids;
  auto moved = base.moved.begin();
  for (std::uint32_t t = 0; t < base.crossings.size(); ++t) {
    const bool is_moved = moved != base.moved.end() && moved->first == t;
    const FieldSample& face =
        is_moved ? (moved++)->second : at(surface.crossings(), base.crossings[t]).at;
    const auto [id, is_new] =
        ids.insert(face_key(face), static_cast<std::int32_t>(mesh.faces.size()));
    if (is_new) mesh.faces.push_back(face);
    mesh.labels.push_back(static_cast<std::uint32_t>(id));
  }
  return mesh;
}

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
