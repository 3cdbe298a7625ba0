// Bottoms of sweeps in closed form against their distances, and the bounds of them.
#include "removal/sweep/sweep_heights.h"

#include "core/units.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

constexpr double kLow = -20, kHigh = 20;

std::vector<Tool> rising_tools() {
  std::vector<Tool> t = {endmill(6), endmill(6, 1), ballmill(6)};
  t.push_back(mill(ToolType::chamfer, 8));
  t.back().tip_diameter = 1;
  t.push_back(mill(ToolType::drill, 5));
  t.push_back(mill(ToolType::taper, 9));
  t.back().taper_angle = radians(10), t.back().tip_diameter = 4, t.back().corner_radius = 2;
  t.push_back(mill(ToolType::chamfer, 8, 0.7));
  t.push_back(mill(ToolType::form, 0));  // corner rounding: not convex
  t.back().profile = {{0, 0, 0}, {2, 0, 0}, {2, 1, -std::tan(kPi / 8)}, {5, 4, 0}};
  return t;
}

Motion any_move(Random& r, int kind) {
  const Vec3 a = {r(-6, 6), r(-6, 6), r(-5, 5)}, b = {r(-6, 6), r(-6, 6), r(-5, 5)};
  switch (kind) {
    case 0:
      return line(a, {b.x, b.y, a.z});
    case 1:
      return line(a, {a.x, a.y, b.z});
    case 2:
      return line(a, b);
    case 3:
      return arc(a, {b.x, b.y, a.z}, {0, 0, 1}, r(-7, 7));
    case 4:  // helix
      return arc(a, {a.x + r(-6, 6), a.y + r(-6, 6), a.z}, {0, 0, 1}, r(-20, 20), r(-9, 9));
    default:  // G18
      return arc(a, {b.x, a.y, b.z}, {0, 1, 0}, r(-6, 6));
  }
}

class EveryRisingTool : public ::testing::TestWithParam<int> {};

TEST_P(EveryRisingTool, BottomIsWhereTheDistanceIsZero) {
  const Tool tool = rising_tools()[static_cast<std::size_t>(GetParam())];
  int below = 0;
  for (int kind = 0; kind < 6; ++kind) {
    Random r(10 + kind);
    for (int round = 0; round < rounds(12); ++round) {
      const Motion m = any_move(r, kind);
      const SweepTable s({&m, 1}, {&tool, 1});
      ASSERT_TRUE(is_upward(s, 0));
      const SweepUndersides tools(s);
      SweepHeights heights(s, tools, kLow, kHigh);
      const std::uint32_t all[] = {0};
      heights.assign(all);
      for (int k = 0; k < 12; ++k) {
        const Vec3 c = at(m, r(0, 1));
        const double x = c.x + r(-5, 5), y = c.y + r(-5, 5), z = heights.bottom(0, x, y);
        if (std::isinf(z)) {
          ASSERT_GT(s.distance(0, {x, y, kHigh}), -1e-6) << "move " << kind;
          continue;
        }
        ++below;
        ASSERT_NEAR(s.distance(0, {x, y, z}), 0, 1e-6) << "move " << kind;
        ASSERT_GT(s.distance(0, {x, y, z - 1e-3}), 0) << "move " << kind;
        ASSERT_LT(s.distance(0, {x, y, z + 10}), 1e-9) << "move " << kind;
      }
    }
  }
  EXPECT_GT(below, 60);
}

TEST_P(EveryRisingTool, BoundsHoldOverASquare) {
  const Tool tool = rising_tools()[static_cast<std::size_t>(GetParam())];
  int bounded = 0;
  for (int kind = 0; kind < 6; ++kind) {
    Random r(30 + kind);
    for (int round = 0; round < rounds(12); ++round) {
      const Motion m = any_move(r, kind);
      const SweepTable s({&m, 1}, {&tool, 1});
      const SweepUndersides tools(s);
      SweepHeights heights(s, tools, kLow, kHigh);
      const std::uint32_t all[] = {0};
      heights.assign(all);
      for (int k = 0; k < 10; ++k) {
        const Vec3 c = at(m, r(0, 1));
        const double x = c.x + r(-5, 5), y = c.y + r(-5, 5), half = r(0.01, 1);
        const Underside::Bounds bounds = heights.bounds(0, x, y, half * std::sqrt(2.0));
        bounded += std::isfinite(bounds.upper);
        for (int i = 0; i < 10; ++i) {
          const double z = heights.bottom(0, x + r(-half, half), y + r(-half, half));
          ASSERT_LE(bounds.lower, std::isinf(z) ? z : z + 1e-8) << "move " << kind;
          if (bounds.upper >= kHigh) continue;  // nothing is asked there
          ASSERT_GE(bounds.upper, z - 1e-8) << "move " << kind;
        }
      }
    }
  }
  EXPECT_GT(bounded, 40);
}

// The bounds of a small square come near to the bottom, but at walls.
TEST_P(EveryRisingTool, BoundsOfASmallSquareAreSharp) {
  const Tool tool = rising_tools()[static_cast<std::size_t>(GetParam())];
  const int kinds = make_cutter(tool).is_convex() ? 3 : 2;  // slants of others are searched
  int sharp = 0, all_of_them = 0;
  Random r(50);
  for (int round = 0; round < 200; ++round) {
    const Motion m = any_move(r, round % kinds);
    const SweepTable s({&m, 1}, {&tool, 1});
    const SweepUndersides tools(s);
    SweepHeights heights(s, tools, kLow, kHigh);
    const std::uint32_t all[] = {0};
    heights.assign(all);
    const Vec3 c = at(m, r(0, 1));
    const double x = c.x + r(-3, 3), y = c.y + r(-3, 3), z = heights.bottom(0, x, y);
    if (std::isinf(z)) continue;
    const Underside::Bounds bounds = heights.bounds(0, x, y, 1e-3);
    ++all_of_them;
    sharp += bounds.lower > z - 0.05 && bounds.upper < z + 0.05;
  }
  EXPECT_GT(all_of_them, 50);
  EXPECT_GT(sharp, 0.85 * all_of_them);
}

INSTANTIATE_TEST_SUITE_P(All, EveryRisingTool,
                         ::testing::Range(0, static_cast<int>(rising_tools().size())));

}  // namespace
}  // namespace mrsim
