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
  /// Finds the tiles without candidates. A tile that has a cell of `split` (voxels) in it or in its
  /// rings is drawn cell by cell, so it and its neighbours are left out.
  void find(const TileSet& set, const std::vector<LatticePoint>& split);
  BareTiles about(const LatticePoint& place) const;

 private:
  TileOrder order_;
  std::unordered_set<std::uint64_t> keys_;  ///< by order_
};

}  // namespace mrsim::detail
