// The edges of a tile that the surface crosses, numbered so that a count of bits tells which edge
// has which number (docs/mesh.md, Tiles).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

class TileEdges {
 public:
  static constexpr std::int32_t kCells = 64;  ///< on a side: a bit each

  TileEdges() {
    for (std::vector<Column>& columns : columns_) columns.resize(kCells * kCells);
  }

  void clear() { count_ = 0; }
  /// The next column: edges of this axis that start at (x, y, z), z a bit. Columns come by x, y and
  /// axis, all of them.
  void add(int axis, std::int32_t x, std::int32_t y, std::uint64_t bits) {
    column(axis, x, y) = {bits, count_};
    count_ += std::popcount(bits);
  }

  std::int32_t size() const { return count_; }
  std::uint64_t bits(int axis, std::int32_t x, std::int32_t y) const {
    return column(axis, x, y).bits;
  }
  /// Requires: its bit is set.
  std::int32_t number(int axis, std::int32_t x, std::int32_t y, std::int32_t z) const {
    const Column& c = column(axis, x, y);
    return c.first + std::popcount(c.bits & ((std::uint64_t(1) << z) - 1));
  }

 private:
  struct Column {
    std::uint64_t bits = 0;
    std::int32_t first = 0;
  };
  Column& column(int axis, std::int32_t x, std::int32_t y) {
    return columns_[axis][static_cast<std::size_t>(x * kCells + y)];
  }
  const Column& column(int axis, std::int32_t x, std::int32_t y) const {
    return columns_[axis][static_cast<std::size_t>(x * kCells + y)];
  }
  std::vector<Column> columns_[3];
  std::int32_t count_ = 0;
};

}  // namespace mrsim::detail
