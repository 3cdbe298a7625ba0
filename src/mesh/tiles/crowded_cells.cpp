#include "mesh/tiles/crowded_cells.h"

#include "core/numbers/vec.h"
#include "mesh/solid/self_intersection.h"
#include "mesh/solid/weld.h"

#include <algorithm>
#include <utility>

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

void keep_outside(CrowdedTriangles& triangles, const Box3& box) {
  const auto is_inside = [&](std::uint32_t v) {
    const auto& [x, y, z] = triangles.vertices[v];
    return x > box.lo.x && y > box.lo.y && z > box.lo.z && x < box.hi.x && y < box.hi.y &&
           z < box.hi.z;
  };
  CrowdedTriangles out;
  std::vector<std::uint32_t> id(triangles.vertices.size(), ~0u);
  for (auto t : triangles.triangles) {
    if (std::ranges::all_of(t, is_inside)) continue;
    for (std::uint32_t& v : t) {
      if (id[v] == ~0u) {
        id[v] = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(triangles.vertices[v]);
        out.cells.push_back(triangles.cells[v]);
      }
      v = id[v];
    }
    out.triangles.push_back(t);
  }
  triangles = std::move(out);
}

namespace {

constexpr std::size_t kTogether = 100'000;  ///< triangles that are worth a search

// Tiles from `first` on whose triangles are looked at together: whole layers, at least two, until
// there are enough.
std::size_t end_of_group(std::span<const CrowdedTile> tiles, std::size_t first) {
  std::size_t end = first, triangles = 0;
  while (end < tiles.size() &&
         (triangles < kTogether || tiles[end].layer <= tiles[first].layer + 1 ||
          tiles[end].layer == tiles[end - 1].layer))
    triangles += tiles[end++].triangles->triangles.size();
  return end;
}

void add_crossed(std::span<const CrowdedTile> tiles, int threads, std::set<CellPlace>& bad) {
  Welder welder;
  std::vector<Vec3> vertices;
  std::vector<CellPlace> cells;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& [layer, tile] : tiles)
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
  for (const auto& [i, j] : self_intersections(vertices, triangles, threads))
    for (const std::uint32_t k : {i, j})
      for (const std::uint32_t v : triangles[k])
        if (cells[v].size > 0) bad.insert(cells[v]);
}

}  // namespace

// The last layer of a group is the first of the next one, since its triangles meet those of both.
std::set<CellPlace> crossed_cells(std::span<const CrowdedTile> tiles, int threads) {
  std::set<CellPlace> bad;
  for (std::size_t first = 0; first < tiles.size();) {
    const std::size_t end = end_of_group(tiles, first);
    add_crossed(tiles.subspan(first, end - first), threads, bad);
    const bool is_layer = tiles[first].layer == tiles[end - 1].layer;  // the next one is far off
    while (tiles[first].layer < tiles[end - 1].layer) ++first;
    if (is_layer || end == tiles.size()) first = end;
  }
  return bad;
}

}  // namespace mrsim::detail
