// The edges of a tile that the surface crosses, numbered so that a count of bits tells which edge
// has which number (docs/mesh.md, Tiles).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

class TileEdges {
 public:
  static constexpr std::int32_t kCells = 64;  ///< on a side: a bit each

  TileEdges() : columns_(3 * kCells * kCells) {}

  /// Of the edges along an axis that start at (x, y, z), z a bit. Sums of such numbers are the
  /// columns of sums of places.
  static constexpr std::int32_t column(int axis, std::int32_t x, std::int32_t y) {
    return (axis * kCells + x) * kCells + y;
  }

  void clear() { count_ = 0; }
  /// The next column in the order of numbers: all come once.
  void add(std::int32_t column, std::uint64_t bits) {
    columns_[static_cast<std::size_t>(column)] = {bits, count_};
    count_ += count(bits);
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
  // Without the instruction, which not all processors have, and without a call.
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

}  // namespace mrsim::detail
