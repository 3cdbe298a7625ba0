#include "mesh/cells/tile_squares.h"

#include "removal/field/field.h"

#include <algorithm>
#include <array>
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

// The cells first .. end - 1 of a square's row or column that this tile has.
struct Inside {
  explicit Inside(std::int32_t begin, std::int32_t size)
      : first(std::max(begin, 0)), end(std::min(begin + size, kTileCells)) {}
  std::uint64_t bits() const { return ~std::uint64_t(0) >> (64 - (end - first)) << first; }
  std::int32_t first, end;
};

// The edges between cells (row - 1 or row, column - 1 or column) that a square holds, or that lie
// on the side which two squares share.
CellRows edges_within(const std::vector<CellSquare>& squares) {
  // Cells that are in one square with the cell before them in the row, in the column.
  CellRows along{}, across{}, out{};
  for (const CellSquare& s : squares) {
    const Inside rows(s.row, s.size);
    const std::uint64_t columns = Inside(s.column, s.size).bits();
    for (std::int32_t i = rows.first; i < rows.end; ++i) {
      along[static_cast<std::size_t>(i)] |= columns & columns << 1;
      if (i > s.row) across[static_cast<std::size_t>(i)] |= columns;
    }
  }
  for (std::size_t i = 1; i < out.size(); ++i)
    out[i] = (along[i - 1] & along[i]) | (across[i] & across[i] << 1);
  return out;
}

void remove_edges(TileEdges& crossed, int axis, std::int32_t layer, const CellRows& edges) {
  for (std::int32_t i = 0; i < kTileCells; ++i) {
    std::uint64_t bits = edges[static_cast<std::size_t>(i)];
    if (axis == 0) crossed.remove(TileEdges::column(0, layer, i), bits);
    if (axis == 1) crossed.remove(TileEdges::column(1, i, layer), bits);
    if (axis == 2)
      for (; bits != 0; bits &= bits - 1)
        crossed.remove(TileEdges::column(2, i, std::countr_zero(bits)), std::uint64_t(1) << layer);
  }
}

constexpr std::int32_t kFirstOwned = kTileFirstOwned, kEndOwned = kFirstOwned + kTileOwned;

bool is_owned(std::int32_t i) { return i >= kFirstOwned && i < kEndOwned; }

}  // namespace

void TileSquares::clear() {
  squares_.clear();
  std::fill(merged_.begin(), merged_.end(), 0);
}

// A box is convex: where the surface crosses four parallel edges of a cell, it is one side of it.
void TileSquares::merge(std::span<const TileColumn> columns, const TileStock& stock,
                        const BareTiles& bare, TileEdges& crossed) {
  const auto column = [&](std::int32_t x, std::int32_t y) -> const TileColumn& {
    return columns[static_cast<std::size_t>(x * kTileCells + y)];
  };
  FlatLayers flat;
  for (std::int32_t x = 1; x < kTileCells - 1; ++x)
    for (std::int32_t y = 1; y < kTileCells - 1; ++y) {
      const std::uint64_t uncut =
          column(x, y).sampled & ~column(x, y).cut & bit_range(1, kTileCells - 2);
      const std::uint64_t a = column(x, y).inside, b = column(x, y + 1).inside,
                          c = column(x + 1, y).inside, d = column(x + 1, y + 1).inside;
      const std::uint64_t differ = (a ^ b) | (a ^ c) | (a ^ d);
      if (((differ | (a ^ a >> 1)) & uncut) == 0) continue;
      const std::uint64_t even_in_z = ~((a ^ a >> 1) | (b ^ b >> 1) | (c ^ c >> 1) | (d ^ d >> 1));
      const auto row = static_cast<std::size_t>(x);
      if (const std::uint64_t bits = uncut & even_in_z & ~(a ^ b) & ~(c ^ d) & (a ^ c);
          bits != 0 && is_owned(x))
        flat.of(0, x)[static_cast<std::size_t>(y)] = bits;
      if (const std::uint64_t bits = uncut & even_in_z & ~(a ^ c) & ~(b ^ d) & (a ^ b);
          bits != 0 && is_owned(y))
        flat.of(1, y)[row] = bits;
      for (std::uint64_t left =
               uncut & (a ^ a >> 1) & ~(differ | differ >> 1) & bit_range(kFirstOwned, kTileOwned);
           left != 0; left &= left - 1)
        flat.of(2, std::countr_zero(left))[row] |= std::uint64_t(1) << y;
    }
  std::vector<CellSquare> whole[3];
  for (int axis = 0; axis < 3; ++axis) {
    whole[axis] = whole_squares(axis, stock, bare);
    if (whole[axis].empty()) continue;
    for (std::uint64_t left =
             (stock.within[axis] ^ stock.within[axis] >> 1) & bit_range(kFirstOwned, kTileOwned);
         left != 0; left &= left - 1)
      flat.of(axis, std::countr_zero(left));
  }
  for (const FlatLayers::Layer& layer : flat.all()) {
    std::vector<CellSquare> squares = whole[layer.axis];
    const bool is_whole = std::any_of(squares.begin(), squares.end(), [](const CellSquare& s) {
      return s.row == kFirstOwned && s.column == kFirstOwned;
    });
    if (!is_whole) {
      // Cells of which no other tile knows a triangle.
      const auto own = flat_squares(layer.cells, kFirstOwned, kEndOwned - 1);
      squares.insert(squares.end(), own.begin(), own.end());
    }
    for (const CellSquare& s : squares) add({layer.axis, layer.at, s});
    remove_edges(crossed, layer.axis, layer.at, edges_within(squares));
  }
}

// A tile where the stock alone decides d, and whose cells and their neighbours lie within a side of
// the box, has one square for all its cells. The tiles about it find the same square.
std::vector<CellSquare> TileSquares::whole_squares(int axis, const TileStock& stock,
                                                   const BareTiles& bare) const {
  std::vector<CellSquare> out;
  const int row_axis = axis == 0 ? 1 : 0, column_axis = axis == 2 ? 1 : 2;
  for (int row = -1; row <= 1; ++row)
    for (int column = -1; column <= 1; ++column) {
      int tile[3] = {};
      tile[row_axis] = row, tile[column_axis] = column;
      if (bare.has(tile[0], tile[1], tile[2]) && spans_side(row_axis, row, stock) &&
          spans_side(column_axis, column, stock))
        out.push_back(
            {kFirstOwned + row * kTileOwned, kFirstOwned + column * kTileOwned, kTileOwned});
    }
  return out;
}

// Whether the cells of the tile that lies so many tiles along the axis, and one more at each end,
// lie between two sides of the stock's box.
bool TileSquares::spans_side(int axis, int tile, const TileStock& stock) const {
  const Box3& box = stock.box;
  const std::int32_t first = component(stock.first, axis) + tile * kTileOwned;
  for (const std::int32_t plane : {first + kFirstOwned - 1, first + kEndOwned + 1}) {
    const double p = lattice_.coordinate(axis, plane * lattice_.per_voxel());
    if (!is_inside(
            std::max(mrsim::component(box.lo, axis) - p, p - mrsim::component(box.hi, axis))))
      return false;
  }
  return true;
}

void TileSquares::add(const TileSquare& square) {
  squares_.push_back(square);
  const Inside rows(square.cells.row, square.cells.size),
      columns(square.cells.column, square.cells.size);
  for (std::int32_t row = rows.first; row < rows.end; ++row)
    for (std::int32_t column = columns.first; column < columns.end; ++column) {
      const LatticePoint p = square.cell(row, column);
      merged_[static_cast<std::size_t>(p.x * kTileCells + p.y)] |= std::uint64_t(1) << p.z;
    }
}

}  // namespace mrsim::detail
