// Where the stock alone is left, squares of cells become one each. The triangles about them cover
// what those of all their cells would (docs/mesh.md, Tiles).
#include "mesh/cells/tile.h"

#include <bit>

namespace mrsim::detail {
namespace {

// Cells in which the surface crosses the edges along an axis and no others, by layers on it.
class FlatLayers {
 public:
  // Rows are the first, columns the second of the other two axes.
  CellRows& of(int axis, std::int32_t layer) {
    std::int32_t& id = ids_[axis][layer];
    if (id == 0) {
      layers_.push_back({axis, layer, {}});
      id = static_cast<std::int32_t>(layers_.size());
    }
    return layers_[static_cast<std::size_t>(id - 1)].cells;
  }
  struct Layer {
    int axis;
    std::int32_t at;
    CellRows cells;
  };
  const std::vector<Layer>& all() const { return layers_; }

 private:
  std::int32_t ids_[3][kTileCells] = {};  ///< counted from 1
  std::vector<Layer> layers_;
};

// The edges between cells (row - 1 or row, column - 1 or column) that a square holds, or that lie
// on the side which two squares share.
CellRows edges_within(const std::vector<CellSquare>& squares) {
  // Cells that are in one square with the cell before them in the row, in the column.
  CellRows along{}, across{}, out{};
  for (const CellSquare& s : squares) {
    const std::uint64_t columns = ((std::uint64_t(1) << s.size) - 1) << s.column;
    for (std::int32_t i = s.row; i < s.row + s.size; ++i) {
      along[static_cast<std::size_t>(i)] |= columns & columns << 1;
      if (i > s.row) across[static_cast<std::size_t>(i)] |= columns;
    }
  }
  for (std::size_t i = 1; i < out.size(); ++i)
    out[i] = (along[i - 1] & along[i]) | (across[i] & across[i] << 1);
  return out;
}

}  // namespace

// A box is convex: where the surface crosses four parallel edges of a cell, it is one side of it.
void CellTile::merge_flat_cells() {
  FlatLayers flat;
  for (std::int32_t x = 1; x < kTileCells - 1; ++x)
    for (std::int32_t y = 1; y < kTileCells - 1; ++y) {
      const std::uint64_t uncut =
          column(x, y).sampled & ~column(x, y).cut & bit_range(1, kTileCells - 2);
      const std::uint64_t a = inside(x, y), b = inside(x, y + 1), c = inside(x + 1, y),
                          d = inside(x + 1, y + 1);
      const std::uint64_t differ = (a ^ b) | (a ^ c) | (a ^ d);
      if (((differ | (a ^ a >> 1)) & uncut) == 0) continue;
      const std::uint64_t even_in_z = ~((a ^ a >> 1) | (b ^ b >> 1) | (c ^ c >> 1) | (d ^ d >> 1));
      const auto row = static_cast<std::size_t>(x);
      if (const std::uint64_t bits = uncut & even_in_z & ~(a ^ b) & ~(c ^ d) & (a ^ c);
          bits != 0 && is_tested(x, false))
        flat.of(0, x)[static_cast<std::size_t>(y)] = bits;
      if (const std::uint64_t bits = uncut & even_in_z & ~(a ^ c) & ~(b ^ d) & (a ^ b);
          bits != 0 && is_tested(y, false))
        flat.of(1, y)[row] = bits;
      for (std::uint64_t left =
               uncut & (a ^ a >> 1) & ~(differ | differ >> 1) & bit_range(kFirstOwned, kTileOwned);
           left != 0; left &= left - 1)
        flat.of(2, std::countr_zero(left))[row] |= std::uint64_t(1) << y;
    }
  for (const FlatLayers::Layer& layer : flat.all()) {
    // Cells of which no other tile knows a triangle.
    const std::vector<CellSquare> squares = flat_squares(layer.cells, kFirstOwned, kEndOwned - 1);
    for (const CellSquare& s : squares) add_square({layer.axis, layer.at, s});
    remove_edges(layer.axis, layer.at, edges_within(squares));
  }
}

void CellTile::add_square(const TileSquare& square) {
  squares_.push_back(square);
  const CellSquare& s = square.cells;
  for (std::int32_t row = s.row; row < s.row + s.size; ++row)
    for (std::int32_t column = s.column; column < s.column + s.size; ++column) {
      const LatticePoint p = square.cell(row, column);
      merged_[static_cast<std::size_t>(p.x * kTileCells + p.y)] |= std::uint64_t(1) << p.z;
    }
}

void CellTile::remove_edges(int axis, std::int32_t layer, const CellRows& edges) {
  for (std::int32_t i = 0; i < kTileCells; ++i) {
    std::uint64_t bits = edges[static_cast<std::size_t>(i)];
    if (axis == 0) crossed_.remove(TileEdges::column(0, layer, i), bits);
    if (axis == 1) crossed_.remove(TileEdges::column(1, i, layer), bits);
    if (axis == 2)
      for (; bits != 0; bits &= bits - 1)
        crossed_.remove(TileEdges::column(2, i, std::countr_zero(bits)), std::uint64_t(1) << layer);
  }
}

}  // namespace mrsim::detail
