#include "mesh/tiles/bare_tile_set.h"

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

}  // namespace

void BareTileSet::find(const TileSet& set, const std::function<bool(const Tile&)>& has_split) {
  order_ = set.order;
  keys_.clear();
  for (const Tile& tile : set.tiles)
    if (tile.candidates.empty()) keys_.insert(order_.key(tile.place));
  for (const Tile& tile : set.tiles)
    if (has_split(tile))
      for_neighbours(tile.place,
                     [&](const LatticePoint& at, int, int, int) { keys_.erase(order_.key(at)); });
}

BareTiles BareTileSet::about(const LatticePoint& place) const {
  BareTiles out;
  for_neighbours(place, [&](const LatticePoint& at, int x, int y, int z) {
    if (keys_.count(order_.key(at)) > 0) out.add(x, y, z);
  });
  return out;
}

}  // namespace mrsim::detail
