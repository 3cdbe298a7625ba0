// Which cells with two pieces of surface hold triangles that meet others, found layer by layer.
#include "mesh/tiles/crowded_cells.h"

#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim::detail {
namespace {

// A triangle of side 0.5 from (x, y), level with z or upright through it, each in a cell of its
// own.
void add_triangle(CrowdedTriangles& out, float x, float y, float z, bool is_upright,
                  std::int32_t cell) {
  const auto first = static_cast<std::uint32_t>(out.vertices.size());
  const float low = is_upright ? z - 0.25f : z, high = is_upright ? z + 0.25f : z;
  out.vertices.push_back({x, y, low});
  out.vertices.push_back({x + 0.5f, y + (is_upright ? 0.25f : 0), low});
  out.vertices.push_back({x + (is_upright ? 0.25f : 0), y + (is_upright ? 0.125f : 0.5f), high});
  for (int k = 0; k < 3; ++k) out.cells.push_back({{cell, 0, 0}, 1});
  out.triangles.push_back({first, first + 1, first + 2});
}

std::set<std::int32_t> crossed(const std::vector<CrowdedTile>& tiles) {
  std::set<std::int32_t> found;
  for (const CellPlace& cell : crossed_cells(tiles, 2)) found.insert(cell.origin.x);
  return found;
}

// More triangles in the first layer than are looked at together.
TEST(CrowdedCells, AreFoundWithinLayersAndBetweenNeighbours) {
  CrowdedTriangles many, next, far, beyond;
  for (int k = 0; k < 110'000; ++k)
    add_triangle(many, static_cast<float>(k % 400), static_cast<float>(k / 400), 0, false, 0);
  add_triangle(many, 7, 500, 0, false, 1);
  add_triangle(many, 9, 500, 0, false, 2);
  add_triangle(many, 9, 500.125f, 0, true, 3);
  add_triangle(next, 7, 500.125f, 0, true, 4);
  add_triangle(next, 7, 600, 0, true, 5);
  add_triangle(far, 7, 700, 0, false, 6);
  add_triangle(far, 7, 700.125f, 0, true, 7);
  add_triangle(beyond, 7, 800, 0, true, 8);
  EXPECT_EQ(crossed({{0, &many}, {1, &next}, {9, &far}, {10, &beyond}}),
            (std::set<std::int32_t>{1, 2, 3, 4, 6, 7}));
  EXPECT_EQ(crossed({{0, &many}, {9, &far}}), (std::set<std::int32_t>{2, 3, 6, 7}));
  EXPECT_EQ(crossed({{3, &far}, {4, &many}}), (std::set<std::int32_t>{2, 3, 6, 7}));
  EXPECT_TRUE(crossed({}).empty());
}

TEST(CrowdedCells, TrianglesInsideOfABoxAreLeftOut) {
  CrowdedTriangles triangles;
  add_triangle(triangles, 5, 5, 5, false, 1);
  add_triangle(triangles, 9.75f, 5, 5, false, 2);
  add_triangle(triangles, 20, 5, 5, true, 3);
  keep_outside(triangles, {{0, 0, 0}, {10, 10, 10}});
  ASSERT_EQ(triangles.triangles.size(), 2u);
  ASSERT_EQ(triangles.vertices.size(), 6u);
  for (std::size_t t = 0; t < 2; ++t)
    for (const std::uint32_t v : triangles.triangles[t])
      EXPECT_EQ(triangles.cells[v].origin.x, static_cast<std::int32_t>(t) + 2);
  EXPECT_EQ(triangles.vertices[triangles.triangles[1][0]][0], 20);
}

}  // namespace
}  // namespace mrsim::detail
