// Which tiles of the uniform grid no sweep reaches (docs/mesh.md, Tiles).
#pragma once

#include "mesh/cells/bare_tiles.h"
#include "mesh/tiles/tile_search.h"

#include <cstdint>
#include <functional>
#include <unordered_set>

namespace mrsim::detail {

class BareTileSet {
 public:
  /// Tiles without candidates, but for those beside a tile, or itself, for which `has_split` holds:
  /// that one is drawn cell by cell.
  void find(const TileSet& set, const std::function<bool(const Tile&)>& has_split);
  BareTiles about(const LatticePoint& place) const;

 private:
  TileOrder order_;
  std::unordered_set<std::uint64_t> keys_;  ///< by order_
};

}  // namespace mrsim::detail
