// The size of a tile, and what it knows of its corners: a column along z is one word, a bit for
// each corner (docs/mesh.md, Tiles).
#pragma once

#include "mesh/cells/tile_edges.h"

#include <cstdint>

namespace mrsim::detail {

inline constexpr std::int32_t kTileCells = TileEdges::kCells;        ///< on a side, with the rings
inline constexpr std::int32_t kTileFirstOwned = 2, kTileOwned = 60;  ///< from the third on

/// What is known of the corners (x, y, 0..63), a bit for each.
struct TileColumn {
  std::uint64_t sampled = 0, inside = 0;
  std::uint64_t cut = 0;                  ///< d may be decided by a sweep
  std::uint64_t near = 0, very_near = 0;  ///< |offset| up to a voxel, half a voxel
};

/// Bits begin .. begin + count - 1.
constexpr std::uint64_t bit_range(std::int32_t begin, std::int32_t count) {
  return ~std::uint64_t(0) >> (64 - count) << begin;
}

}  // namespace mrsim::detail
