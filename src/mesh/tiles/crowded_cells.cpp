#include "mesh/tiles/crowded_cells.h"

#include "core/vec.h"
#include "mesh/solid/self_intersection.h"
#include "mesh/solid/weld.h"

namespace mrsim::detail {

CrowdedTriangles crowded_triangles(std::span<const std::array<float, 3>> vertices,
                                   std::span<const std::array<std::uint32_t, 3>> triangles,
                                   std::span<const CellPlace> cell_of) {
  CrowdedTriangles out;
  if (cell_of.empty()) return out;
  std::vector<std::uint32_t> id(vertices.size(), ~0u);
  for (const auto& t : triangles) {
    if (cell_of[t[0]].size + cell_of[t[1]].size + cell_of[t[2]].size == 0) continue;
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& v = id[t[k]];
      if (v == ~0u) {
        v = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(vertices[t[k]]);
        out.cells.push_back(cell_of[t[k]]);
      }
      triangle[k] = v;
    }
    out.triangles.push_back(triangle);
  }
  return out;
}

std::set<CellPlace> crossed_cells(std::span<const CrowdedTriangles* const> tiles, int threads) {
  Welder welder;
  std::vector<Vec3> vertices;
  std::vector<CellPlace> cells;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const CrowdedTriangles* tile : tiles)
    for (const auto& t : tile->triangles) {
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& p = tile->vertices[t[k]];
        triangle[k] = welder.add(p);
        if (triangle[k] < vertices.size()) continue;
        vertices.push_back({p[0], p[1], p[2]});
        cells.push_back(tile->cells[t[k]]);
      }
      triangles.push_back(triangle);
    }
  std::set<CellPlace> bad;
  if (triangles.empty()) return bad;
  for (const auto& [i, j] : self_intersections(vertices, triangles, threads))
    for (const std::uint32_t k : {i, j})
      for (const std::uint32_t v : triangles[k])
        if (cells[v].size > 0) bad.insert(cells[v]);
  return bad;
}

}  // namespace mrsim::detail
