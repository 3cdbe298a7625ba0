// Covers a region of a square grid with larger squares, as a quadtree does whose neighbours differ
// by one level (docs/mesh.md, Tiles).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

/// Cells (row, column), a bit for each column.
using CellRows = std::array<std::uint64_t, 64>;

/// The cells of rows and columns `row`, `column` and the next `size` - 1.
struct CellSquare {
  std::int32_t row = 0, column = 0, size = 0;
};

/// Squares of 2, 4, 8, .. cells within [first, end) on both axes, begun at `first`. All their cells
/// and all cells next to them are in the region; squares next to each other differ in size by a
/// factor of two at most, and squares of 2 alone are next to other cells. Costs some 500 operations
/// on words.
std::vector<CellSquare> flat_squares(const CellRows& region, std::int32_t first, std::int32_t end);

}  // namespace mrsim::detail
