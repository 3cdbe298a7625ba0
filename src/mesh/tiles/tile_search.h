// Which tiles of the uniform grid the surface may pass (docs/mesh.md, Tiles).
#pragma once

#include "mesh/solid/vertex_lattice.h"
#include "mesh/tiles/tile_mesh.h"
#include "removal/field/field.h"

#include <vector>

namespace mrsim::detail {

struct Tile {
  LatticePoint place;     ///< in tiles
  LatticePoint first;     ///< of its cells, voxels
  Candidates candidates;  ///< what can matter in it
};

/// Tiles in their order.
struct TileSet {
  TileOrder order;
  std::vector<Tile> tiles;
};

/// The tiles that the surface may pass, sorted layer by layer along the part's longest axis, so
/// that few wait for neighbours. The result is the same for any number of threads.
TileSet find_tiles(const ExactField& field, const Lattice& lattice, int threads);

}  // namespace mrsim::detail
