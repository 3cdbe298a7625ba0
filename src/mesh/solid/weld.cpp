#include "mesh/solid/weld.h"

#include <bit>
#include <utility>

namespace mrsim {
namespace {

std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 32;
  x *= 0xd6e8feb86659fd93u;
  x ^= x >> 32;
  x *= 0xd6e8feb86659fd93u;
  return x ^ (x >> 32);
}

std::size_t hash(const std::array<float, 3>& p) {
  const std::uint64_t xy =
      std::uint64_t(std::bit_cast<std::uint32_t>(p[0])) << 32 | std::bit_cast<std::uint32_t>(p[1]);
  return mixed(mixed(xy) + std::bit_cast<std::uint32_t>(p[2]));
}

}  // namespace

std::uint32_t Welder::add(std::array<float, 3> point) {
  for (float& x : point) x += 0.0f;  // -0 becomes 0: they are one place
  if (2 * (points_.size() + 1) > slots_.size()) grow();
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = hash(point) & mask;
  while (slots_[at] != 0) {
    if (points_[slots_[at] - 1] == point) return slots_[at] - 1;
    at = (at + 1) & mask;
  }
  points_.push_back(point);
  slots_[at] = std::uint32_t(points_.size());
  return slots_[at] - 1;
}

void Welder::grow() {
  slots_.assign(slots_.empty() ? 1024 : 2 * slots_.size(), 0);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::size_t at = hash(points_[i]) & mask;
    while (slots_[at] != 0) at = (at + 1) & mask;
    slots_[at] = std::uint32_t(i + 1);
  }
}

TriMesh weld(const TriMesh& mesh) {
  TriMesh out;
  Welder welder;
  constexpr std::uint32_t kUnseen = ~0u;
  std::vector<std::uint32_t> to(mesh.vertices.size(), kUnseen);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    std::array<std::uint32_t, 3> t = mesh.triangles[f];
    for (std::uint32_t& v : t) {
      if (to[v] == kUnseen) {
        to[v] = welder.add(mesh.vertices[v]);
        if (!mesh.colors.empty() && welder.size() > out.colors.size())
          out.colors.push_back(mesh.colors[v]);
      }
      v = to[v];
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    out.triangles.push_back(t);
    if (!mesh.owners.empty()) out.owners.push_back(mesh.owners[f]);
  }
  out.vertices = welder.take();
  out.origin = mesh.origin;
  out.legend = mesh.legend;
  drop_unused_vertices(out);
  return out;
}

std::vector<std::uint32_t> number_used(std::vector<std::array<std::uint32_t, 3>>& triangles,
                                       std::size_t vertices) {
  std::vector<std::uint32_t> to(vertices, 0), kept;
  for (const auto& t : triangles)
    for (const std::uint32_t v : t) to[v] = 1;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (to[v] == 0) continue;
    to[v] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(v);
  }
  for (auto& t : triangles)
    for (std::uint32_t& v : t) v = to[v];
  return kept;
}

void drop_unused_vertices(TriMesh& mesh) {
  const std::vector<std::uint32_t> kept = number_used(mesh.triangles, mesh.vertices.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    mesh.vertices[k] = mesh.vertices[kept[k]];
    if (!mesh.colors.empty()) mesh.colors[k] = mesh.colors[kept[k]];
  }
  mesh.vertices.resize(kept.size());
  if (!mesh.colors.empty()) mesh.colors.resize(kept.size());
}

}  // namespace mrsim
