// Cells that hold two pieces of surface: the only ones in which triangles can meet (docs/mesh.md,
// Surface).
#pragma once

#include "mesh/solid/vertex_lattice.h"
#include <mrsim/types.h>

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <tuple>
#include <vector>

namespace mrsim::detail {

/// A cell by its place, in fine units.
struct CellPlace {
  LatticePoint origin;
  std::int32_t size = 0;  ///< 0: no cell
  friend bool operator<(const CellPlace& a, const CellPlace& b) {
    return std::tie(a.origin.x, a.origin.y, a.origin.z, a.size) <
           std::tie(b.origin.x, b.origin.y, b.origin.z, b.size);
  }
};

/// The triangles of a tile that have a vertex in such a cell, by copies of their vertices.
struct CrowdedTriangles {
  std::vector<std::array<float, 3>> vertices;
  std::vector<CellPlace> cells;  ///< of the vertices
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The triangles of crowded cells among `triangles`. `cell_of`: by vertex; empty where there are
/// none.
CrowdedTriangles crowded_triangles(std::span<const std::array<float, 3>> vertices,
                                   std::span<const std::array<std::uint32_t, 3>> triangles,
                                   std::span<const CellPlace> cell_of);

/// Keeps only the triangles that are not inside of the box.
void keep_outside(CrowdedTriangles& triangles, const Box3& box);

struct CrowdedTile {
  std::int32_t layer = 0;  ///< tiles meet those of their own layer and of the next ones
  const CrowdedTriangles* triangles = nullptr;
};

/// The cells whose triangles meet others. Requires: layers ascend. Takes the memory of a few layers
/// at a time, or of 100 000 triangles where layers have fewer.
std::set<CellPlace> crossed_cells(std::span<const CrowdedTile> tiles, int threads);

}  // namespace mrsim::detail
