// The edges of a tile that the surface crosses, numbered so that a count of bits finds the number
// of an edge (docs/mesh.md, Tiles).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

class TileEdges {
 public:
  static constexpr std::int32_t kCells = 64;  ///< on a side: a bit each

  TileEdges() : columns_(3 * kCells * kCells) {}

  /// The column of the edges along an axis that start at (x, y, z), z a bit. Sums of such numbers
  /// are the columns of sums of places.
  static constexpr std::int32_t column(int axis, std::int32_t x, std::int32_t y) {
    return (axis * kCells + x) * kCells + y;
  }

  void set(std::int32_t column, std::uint64_t bits) {
    columns_[static_cast<std::size_t>(column)].bits = bits;
  }
  void remove(std::int32_t column, std::uint64_t bits) {
    columns_[static_cast<std::size_t>(column)].bits &= ~bits;
  }
  /// Numbers them by x, y, axis, z.
  void number() {
    count_ = 0;
    for (std::int32_t xy = 0; xy < kCells * kCells; ++xy)
      for (int axis = 0; axis < 3; ++axis) {
        Column& c = columns_[static_cast<std::size_t>(axis * kCells * kCells + xy)];
        c.first = count_;
        count_ += count(c.bits);
      }
  }

  std::int32_t size() const { return count_; }
  std::uint64_t bits(std::int32_t column) const {
    return columns_[static_cast<std::size_t>(column)].bits;
  }
  /// Requires: its bit is set.
  std::int32_t number(std::int32_t column, std::int32_t z) const {
    const Column& c = columns_[static_cast<std::size_t>(column)];
    return c.first + count(c.bits & ((std::uint64_t(1) << z) - 1));
  }

 private:
  struct Column {
    std::uint64_t bits = 0;
    std::int32_t first = 0;
  };
  // Counts set bits without the instruction, which not all processors have, and without a call.
  static std::int32_t count(std::uint64_t bits) {
    if ((bits & (bits - 1)) == 0) return bits != 0;
    bits -= bits >> 1 & 0x5555555555555555u;
    bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
    bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return static_cast<std::int32_t>(bits * 0x0101010101010101u >> 56);
  }
  std::vector<Column> columns_;
  std::int32_t count_ = 0;
};

/// An edge of a cell: the corner it starts at, by sides of the cell, the same as a column, and the
/// cell's quadrant about it.
struct CellEdge {
  int d[3], axis;
  std::int32_t column;
  int quadrant;
};

constexpr CellEdge cell_edge(int x, int y, int z, int axis) {
  CellEdge e{{x, y, z}, axis, TileEdges::column(axis, x, y), 0};
  // The cell lies on the high side of an edge on its own low side.
  const int beside = 1 - e.d[(axis + 1) % 3], above = 1 - e.d[(axis + 2) % 3];
  e.quadrant = above ? 3 - beside : beside;
  return e;
}

/// The edges of a cell in the order of all edges: by place, then axis.
inline constexpr CellEdge kCellEdges[12] = {
    cell_edge(0, 0, 0, 0), cell_edge(0, 0, 0, 1), cell_edge(0, 0, 0, 2), cell_edge(0, 0, 1, 0),
    cell_edge(0, 0, 1, 1), cell_edge(0, 1, 0, 0), cell_edge(0, 1, 0, 2), cell_edge(0, 1, 1, 0),
    cell_edge(1, 0, 0, 1), cell_edge(1, 0, 0, 2), cell_edge(1, 0, 1, 1), cell_edge(1, 1, 0, 2)};

}  // namespace mrsim::detail
