#include "mesh/tiles/bare_tile_set.h"

#include "mesh/cells/tile.h"

#include <algorithm>

namespace mrsim::detail {
namespace {

// The tile itself is one of them.
template <class Visit>
void for_neighbours(const LatticePoint& place, const Visit& visit) {
  for (int i = 0; i < 27; ++i) {
    const int x = i / 9 - 1, y = i / 3 % 3 - 1, z = i % 3 - 1;
    const LatticePoint at{place.x + x, place.y + y, place.z + z};
    if (at.x >= 0 && at.y >= 0 && at.z >= 0) visit(at, x, y, z);
  }
}

// The tiles that have the cell among their own or in their rings.
template <class Visit>
void for_tiles_with(const LatticePoint& cell, const Visit& visit) {
  const auto last = [&](int axis) { return component(cell, axis) / kTileOwned; };
  const auto first = [&](int axis) {
    return std::max(component(cell, axis) - kTileCells + kTileOwned, 0) / kTileOwned;
  };
  for (std::int32_t x = first(0); x <= last(0); ++x)
    for (std::int32_t y = first(1); y <= last(1); ++y)
      for (std::int32_t z = first(2); z <= last(2); ++z) visit(LatticePoint{x, y, z});
}

}  // namespace

void BareTileSet::find(const TileSet& set, const std::vector<LatticePoint>& split) {
  order_ = set.order;
  keys_.clear();
  for (const Tile& tile : set.tiles)
    if (tile.candidates.empty()) keys_.insert(order_.key(tile.place));
  for (const LatticePoint& cell : split)
    for_tiles_with(cell, [&](const LatticePoint& tile) {
      for_neighbours(tile,
                     [&](const LatticePoint& at, int, int, int) { keys_.erase(order_.key(at)); });
    });
}

BareTiles BareTileSet::about(const LatticePoint& place) const {
  BareTiles out;
  for_neighbours(place, [&](const LatticePoint& at, int x, int y, int z) {
    if (keys_.count(order_.key(at)) > 0) out.add(x, y, z);
  });
  return out;
}

}  // namespace mrsim::detail
