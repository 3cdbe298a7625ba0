// Tiles of the uniform grid that no sweep reaches: their flat sides are one square each, which the
// tiles about them know (docs/mesh.md, Tiles).
#pragma once

#include <cstdint>

namespace mrsim::detail {

/// In which of a tile and the tiles about it the stock alone decides d.
class BareTiles {
 public:
  /// The tile that lies (x, y, z) tiles, -1 to 1 each, from this one.
  void add(int x, int y, int z) { bits_ |= bit(x, y, z); }
  bool has(int x, int y, int z) const { return (bits_ & bit(x, y, z)) != 0; }
  friend bool operator==(const BareTiles& a, const BareTiles& b) { return a.bits_ == b.bits_; }

 private:
  static std::uint32_t bit(int x, int y, int z) {
    return std::uint32_t(1) << (9 * (x + 1) + 3 * (y + 1) + z + 1);
  }
  std::uint32_t bits_ = 0;
};

}  // namespace mrsim::detail
