// Which tiles of the uniform grid no sweep reaches (docs/mesh.md, Tiles).
#pragma once

#include "mesh/cells/bare_tiles.h"
#include "mesh/tiles/tile_search.h"

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace mrsim::detail {

class BareTileSet {
 public:
  /// Tiles without candidates, but for those about a tile that has a cell of `split` (voxels) with
  /// its rings: that one is drawn cell by cell.
  void find(const TileSet& set, const std::vector<LatticePoint>& split);
  BareTiles about(const LatticePoint& place) const;

 private:
  TileOrder order_;
  std::unordered_set<std::uint64_t> keys_;  ///< by order_
};

}  // namespace mrsim::detail
