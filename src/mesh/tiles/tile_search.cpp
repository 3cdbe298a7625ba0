#include "mesh/tiles/tile_search.h"

#include "core/process/parallel.h"
#include "mesh/cells/cells.h"
#include "mesh/cells/tile.h"

#include <algorithm>

namespace mrsim::detail {
namespace {

constexpr std::int64_t kLargeParts = 32;  ///< how many parts are searched at once

// Boxes of tiles, halved until they are single ones.
struct TileRange {
  LatticePoint low, high;  ///< tiles, half open
};
struct TilePart {
  TileRange range;
  Candidates candidates;
};

std::int32_t extent(const TileRange& range, int axis) {
  return component(range.high, axis) - component(range.low, axis);
}
std::int64_t count(const TileRange& range) {
  return std::int64_t(extent(range, 0)) * extent(range, 1) * extent(range, 2);
}

Box3 box(const Lattice& lattice, const TileRange& range) {
  const std::int32_t unit = lattice.per_voxel();
  const auto corner = [&](const LatticePoint& tile, std::int32_t more) {
    return lattice.position({(tile.x * kTileOwned + more) * unit,
                             (tile.y * kTileOwned + more) * unit,
                             (tile.z * kTileOwned + more) * unit});
  };
  return {corner(range.low, 0), corner(range.high, kTileCells - kTileOwned)};
}

TileRange whole(const ExactField& field, const Lattice& lattice) {
  TileRange range;
  const LatticePoint last = lattice.floor(field.bounds().hi);
  for (int a = 0; a < 3; ++a)
    component(range.high, a) = (component(last, a) / lattice.per_voxel() + 1) / kTileOwned + 1;
  return range;
}

// The parts of up to `most` tiles that the surface may pass.
void find_parts(const Lattice& lattice, ExactField::Descent& descent, const TileRange& range,
                std::size_t tier, std::int64_t most, std::vector<TilePart>& out) {
  const Box3 reach = reach_of(box(lattice, range), lattice.voxel());
  if (descent.enter(tier, reach, kSurfaceBand, false) != ExactField::Region::mixed) return;
  if (count(range) <= most) {
    out.push_back({range, {}});
    descent.candidates(tier, out.back().candidates);
    return;
  }
  int axis = 0;
  for (const int a : {1, 2})
    if (extent(range, a) > extent(range, axis)) axis = a;
  TileRange low = range, high = range;
  component(low.high, axis) = component(high.low, axis) =
      component(low.low, axis) + extent(range, axis) / 2;
  find_parts(lattice, descent, low, tier + 1, most, out);
  find_parts(lattice, descent, high, tier + 1, most, out);
}

}  // namespace

// Large parts one after another, then the tiles of each on their own.
TileSet find_tiles(const ExactField& field, const Lattice& lattice, int threads) {
  const Box3 bounds = field.bounds();
  const TileRange range = whole(field, lattice);
  std::vector<TilePart> large;
  const std::int64_t most = std::max<std::int64_t>(1, count(range) / kLargeParts);
  // Its lists, of all sweeps, are gone when the parts have theirs.
  find_parts(lattice, *field.descent(0.5 * (bounds.lo + bounds.hi), field.all()), range, 1, most,
             large);
  std::vector<std::vector<TilePart>> single(large.size());
  parallel_for(large.size(), threads, [&](std::size_t k) {
    const Box3 b = box(lattice, large[k].range);
    const auto own = field.descent(0.5 * (b.lo + b.hi), large[k].candidates);
    find_parts(lattice, *own, large[k].range, 1, 1, single[k]);
  });
  TileSet set;
  for (std::vector<TilePart>& parts : single)
    for (TilePart& part : parts) {
      const LatticePoint& at = part.range.low;
      set.tiles.push_back({at,
                           {at.x * kTileOwned, at.y * kTileOwned, at.z * kTileOwned},
                           std::move(part.candidates)});
    }
  std::stable_sort(set.order.axes.begin(), set.order.axes.end(),
                   [&](int a, int b) { return extent(range, a) > extent(range, b); });
  std::sort(set.tiles.begin(), set.tiles.end(), [&](const Tile& a, const Tile& b) {
    return set.order.key(a.place) < set.order.key(b.place);
  });
  return set;
}

}  // namespace mrsim::detail
