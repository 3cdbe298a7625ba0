#include "mesh/mesh_block.h"

namespace mrsim {

void MeshCollector::take(const MeshBlock& block) {
  const auto fresh = block.fresh();
  mesh_.vertices.insert(mesh_.vertices.end(), fresh.begin(), fresh.end());
  mesh_.colors.insert(mesh_.colors.end(), block.colors.begin(), block.colors.end());
  mesh_.owners.insert(mesh_.owners.end(), block.owners.begin(), block.owners.end());
  const std::size_t first = mesh_.triangles.size();
  mesh_.triangles.insert(mesh_.triangles.end(), block.triangles.begin(), block.triangles.end());
  for (std::size_t t = first; t < mesh_.triangles.size(); ++t)
    for (std::uint32_t& v : mesh_.triangles[t]) v = block.number(v);
}

}  // namespace mrsim
