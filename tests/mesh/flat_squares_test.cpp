// Squares of cells cover a region as a quadtree does.
#include "mesh/cells/flat_squares.h"

#include "support/random.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace mrsim::detail {
namespace {

using Sizes = std::array<std::array<int, 64>, 64>;

bool has(const CellRows& rows, int row, int column) {
  return (rows[static_cast<std::size_t>(row)] >> column & 1) != 0;
}

// Of the square that holds each cell; 0 where none does.
Sizes sizes(const std::vector<CellSquare>& squares) {
  Sizes out{};
  for (const CellSquare& s : squares)
    for (int row = s.row; row < s.row + s.size; ++row)
      for (int column = s.column; column < s.column + s.size; ++column) {
        int& size = out.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column));
        EXPECT_EQ(size, 0);
        size = s.size;
      }
  return out;
}

int at(const Sizes& sizes, int row, int column) {
  return sizes[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
}

TEST(FlatSquares, CoverARegion) {
  std::mt19937_64 random(testing::salted(7));
  std::size_t large = 0;
  for (int round = 0; round < 400; ++round) {
    CellRows region{};
    region.fill(~std::uint64_t(0));
    for (int hole = 0; hole < round % 8; ++hole)
      region[random() % 64] &= ~(std::uint64_t(1) << random() % 64);
    const std::vector<CellSquare> squares = flat_squares(region, 2, 62);
    const Sizes size = sizes(squares);
    for (int row = 1; row < 63; ++row)
      for (int column = 1; column < 63; ++column) {
        const int own = at(size, row, column);
        if (own == 0) continue;
        EXPECT_TRUE(row >= 2 && row < 62 && column >= 2 && column < 62);
        large += own >= 8;
        for (int r = row - 1; r <= row + 1; ++r)
          for (int c = column - 1; c <= column + 1; ++c) {
            ASSERT_TRUE(has(region, r, c));
            const int next = std::max(1, at(size, r, c));
            EXPECT_TRUE(next <= 2 * own && own <= 2 * next) << own << " beside " << next;
          }
      }
  }
  EXPECT_GT(large, 100000u);
}

TEST(FlatSquares, LeaveNothingLargeOut) {
  CellRows region{};
  region.fill(~std::uint64_t(0));
  const std::vector<CellSquare> squares = flat_squares(region, 2, 62);
  const auto count = [&](int size) {
    return std::count_if(squares.begin(), squares.end(),
                         [&](const CellSquare& s) { return s.size == size; });
  };
  EXPECT_EQ(count(16), 1);
  EXPECT_EQ(count(8), 21);
  EXPECT_EQ(count(4), 69);
  EXPECT_EQ(count(2), 224);
  EXPECT_TRUE(flat_squares(CellRows{}, 2, 62).empty());
}

}  // namespace
}  // namespace mrsim::detail
