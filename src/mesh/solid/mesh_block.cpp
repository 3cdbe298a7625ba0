#include "mesh/solid/mesh_block.h"

#include "core/process/heap.h"

#include <algorithm>
#include <utility>

namespace mrsim {
namespace {

// Grows to what is expected, or by doubling, into huge pages: small ones take longer to come than
// to be filled.
template <class T>
void append(std::vector<T>& all, std::span<const T> more, std::size_t expected) {
  if (all.size() + more.size() > all.capacity()) {
    std::vector<T> larger;
    reserve_large(larger, std::max({all.size() + more.size(), 2 * all.size(), expected}));
    larger.insert(larger.end(), all.begin(), all.end());
    std::swap(all, larger);
  }
  all.insert(all.end(), more.begin(), more.end());
}

// Bytes that append() needs. If the array has to grow, the old one exists beside the new one.
template <class T>
std::size_t bytes_to_append(const std::vector<T>& all, std::span<const T> more) {
  const std::size_t in_all = all.size() + more.size();
  return sizeof(T) * (in_all > all.capacity() ? all.size() + in_all : in_all);
}

}  // namespace

std::size_t MeshCollector::bytes_with(const MeshBlock& block) const {
  return bytes_to_append(mesh_.vertices, block.fresh()) +
         bytes_to_append(mesh_.colors, block.colors) + bytes_to_append(mesh_.owners, block.owners) +
         bytes_to_append(mesh_.triangles, block.triangles);
}

void MeshCollector::expect(std::size_t vertices, std::size_t triangles) {
  expected_vertices_ = vertices;
  expected_triangles_ = triangles;
}

void MeshCollector::take(const MeshBlock& block) {
  append(mesh_.vertices, block.fresh(), expected_vertices_);
  append(mesh_.colors, block.colors, expected_vertices_);
  append(mesh_.owners, block.owners, expected_triangles_);
  const std::size_t first = mesh_.triangles.size();
  append(mesh_.triangles, block.triangles, expected_triangles_);
  for (std::size_t t = first; t < mesh_.triangles.size(); ++t)
    for (std::uint32_t& v : mesh_.triangles[t]) v = block.number(v);
}

}  // namespace mrsim
