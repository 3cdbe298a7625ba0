// Meshes of tiles that are kept until it is known that no tile must be made again (docs/mesh.md,
// Tiles).
#pragma once

#include "mesh/cells/bare_tiles.h"
#include "mesh/tiles/tile_mesh.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace mrsim::detail {

/// Any number of threads may use it at once.
class KeptTiles {
 public:
  /// `room`: bytes that all of them may take; what does not fit is not kept.
  KeptTiles(std::size_t tiles, std::size_t room) : room_(room), tiles_(tiles) {}

  /// Null where it is not kept, or was made when other tiles about it were bare.
  std::shared_ptr<const TileMesh> find(std::size_t tile, const BareTiles& about) const;
  /// In place of what was kept of this tile.
  void keep(std::size_t tile, const BareTiles& about, const std::shared_ptr<const TileMesh>& mesh);
  void forget(std::size_t tile);

 private:
  struct Kept {
    std::shared_ptr<const TileMesh> mesh;
    BareTiles about;
  };
  void drop(Kept& kept);

  std::size_t room_;  ///< bytes that are left
  std::vector<Kept> tiles_;
  mutable std::mutex mutex_;
};

}  // namespace mrsim::detail
