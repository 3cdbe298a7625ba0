// The loops of a tile. In most cells the signs at the corners tell the loops; in the few others the
// segments are followed. Segments between crossings of one face of the part need no vertex and are
// left out.
#pragma once

#include "mesh/cells/tile.h"
#include "mesh/surface/loop_finder.h"

#include <vector>

namespace mrsim::detail {

class TileLoops : public LoopFinder {
 public:
  explicit TileLoops(SurfaceGraph& graph) : LoopFinder(graph) {}

  /// Fills faces, segments and loops. Requires: the crossings of the tile, in its order.
  void find(const CellTile& tile);

 private:
  void add_square(const CellTile& tile, const TileSquare& square);
  std::vector<std::uint64_t> add_plain_loops(const CellTile& tile);
  void add_loop(const CellTile& tile, std::int32_t x, std::int32_t y, std::int32_t z,
                std::uint32_t edges);
  template <int kAxis>
  void add_segments(const CellTile& tile, const std::vector<std::uint64_t>& crowded);
  void add_segment_if(CellFace& face, bool is_needed);
  void add_crowded_loops(const CellTile& tile, std::int32_t x, std::int32_t y, std::int32_t z);
};

}  // namespace mrsim::detail
