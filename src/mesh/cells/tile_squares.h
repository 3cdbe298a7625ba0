// The cells of a tile in which the stock alone is left, merged to squares: one vertex each instead
// of one a cell. The triangles about them cover what those of all their cells would (docs/mesh.md,
// Tiles).
#pragma once

#include "mesh/cells/bare_tiles.h"
#include "mesh/cells/flat_squares.h"
#include "mesh/cells/tile_columns.h"
#include "mesh/solid/vertex_lattice.h"

#include <span>
#include <vector>

namespace mrsim::detail {

/// Cells that are one: a square of a layer, which the surface crosses on the edges along `axis`.
struct TileSquare {
  int axis = 0;
  std::int32_t layer = 0;
  /// Rows and columns: the other two axes, in order. Of a square that a tile beside this one has,
  /// they go on beyond this tile.
  CellSquare cells;

  LatticePoint cell(std::int32_t row, std::int32_t column) const {
    if (axis == 0) return {layer, row, column};
    return axis == 1 ? LatticePoint{row, layer, column} : LatticePoint{row, column, layer};
  }
};

/// Where a tile lies in a stock that is a box.
struct TileStock {
  Box3 box;                 ///< mm
  LatticePoint first;       ///< the tile's first cell, in voxels
  std::uint64_t within[3];  ///< planes of the tile that lie within the box, a bit each
};

class TileSquares {
 public:
  explicit TileSquares(const Lattice& lattice)
      : lattice_(lattice), merged_(kTileCells * kTileCells) {}

  void clear();
  /// Merges cells where no sweep can decide. `columns`: what is known of the tile's corners, (x, y)
  /// at x * kTileCells + y. `bare`: tiles of which a flat side is one square. Edges inside a square
  /// no longer count as `crossed`.
  void merge(std::span<const TileColumn> columns, const TileStock& stock, const BareTiles& bare,
             TileEdges& crossed);

  std::span<const TileSquare> all() const { return squares_; }
  /// Bits of the cells (x, y, z), z a bit: in a square.
  std::uint64_t merged(std::int32_t x, std::int32_t y) const {
    return merged_[static_cast<std::size_t>(x * kTileCells + y)];
  }

 private:
  std::vector<CellSquare> whole_squares(int axis, const TileStock& stock,
                                        const BareTiles& bare) const;
  bool spans_side(int axis, int tile, const TileStock& stock) const;
  void add(const TileSquare& square);

  Lattice lattice_;
  std::vector<TileSquare> squares_;
  std::vector<std::uint64_t> merged_;  ///< bits of cells, by column
};

}  // namespace mrsim::detail
