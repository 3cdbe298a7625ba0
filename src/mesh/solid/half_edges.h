// Neighbours in a triangle mesh, by half edges. Half edge h = 3 f + k runs from corner k of
// triangle f to the next corner.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

inline Vec3 to_vec(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }
inline Vec3 corner(const TriMesh& mesh, std::size_t face, int k) {
  return to_vec(mesh.vertices[mesh.triangles[face][k]]);
}
/// Outward normal; its length is twice the area.
inline Vec3 area_normal(const TriMesh& mesh, std::size_t face) {
  const Vec3 a = corner(mesh, face, 0);
  return cross(corner(mesh, face, 1) - a, corner(mesh, face, 2) - a);
}

inline std::uint32_t next_half_edge(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline std::uint32_t previous_half_edge(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
inline std::uint32_t origin_of(const TriMesh& mesh, std::uint32_t h) {
  return mesh.triangles[h / 3][h % 3];
}
inline std::uint32_t target_of(const TriMesh& mesh, std::uint32_t h) {
  return origin_of(mesh, next_half_edge(h));
}

/// Values that stand in place of a neighbour.
inline constexpr std::uint32_t kBoundaryEdge = ~0u;     ///< one triangle only
inline constexpr std::uint32_t kTwistedEdge = ~0u - 1;  ///< two that run through it the same way
inline constexpr std::uint32_t kCrowdedEdge = ~0u - 2;  ///< more than two
inline bool is_half_edge(std::uint32_t h) { return h < kCrowdedEdge; }

/// The other half of each half edge, or one of the three above: 3 #F numbers. Requires: indices in
/// range, fewer than 1.4e9 triangles. Linear in the mesh; the same for any number of threads.
std::vector<std::uint32_t> find_opposites(Triangles triangles, std::size_t vertices,
                                          int threads = 0);
inline std::vector<std::uint32_t> find_opposites(const TriMesh& mesh, int threads = 0) {
  return find_opposites(mesh.triangles, mesh.vertices.size(), threads);
}

/// Half edges grouped by the vertex they leave: those of v are items[begin[v]] .. items[begin[v +
/// 1]), ascending.
struct VertexFans {
  std::vector<std::uint32_t> begin;  ///< #V + 1
  std::vector<std::uint32_t> items;  ///< 3 #F
};
VertexFans half_edges_by_vertex(Triangles triangles, std::size_t vertices);
inline VertexFans half_edges_by_vertex(const TriMesh& mesh) {
  return half_edges_by_vertex(mesh.triangles, mesh.vertices.size());
}

/// The connected component of the surface that each triangle belongs to (triangles that share a
/// vertex are connected), numbered by their first triangle. Returns how many there are.
std::size_t find_components(Triangles triangles, std::size_t vertices,
                            std::vector<std::uint32_t>& component);

}  // namespace mrsim
