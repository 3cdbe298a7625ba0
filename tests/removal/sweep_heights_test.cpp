// Bottoms of sweeps in closed form against their distances, and the bounds of them.
#include "removal/sweep/sweep_heights.h"

#include "core/units.h"
#include "removal/tool/underside.h"
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

// Moves of one kind: the distances that the slanted ones of tools that are not convex are asked by
// take milliseconds.
unsigned moves_of(int kind, const Tool& tool) {
  return rounds(kind < 2 || make_cutter(tool).is_convex() ? 12 : 3);
}

class EveryRisingTool : public ::testing::TestWithParam<int> {};

TEST_P(EveryRisingTool, BottomIsWhereTheDistanceIsZero) {
  const Tool tool = rising_tools()[static_cast<std::size_t>(GetParam())];
  int below = 0, asked = 0;
  for (int kind = 0; kind < 6; ++kind) {
    Random r(10 + kind);
    for (unsigned round = 0; round < moves_of(kind, tool); ++round) {
      const Motion m = any_move(r, kind);
      const SweepTable s({&m, 1}, {&tool, 1});
      ASSERT_TRUE(is_upward(s, 0));
      const SweepUndersides tools(s);
      SweepHeights heights(s, tools, kLow, kHigh);
      const std::uint32_t all[] = {0};
      heights.assign(all);
      for (int k = 0; k < 12; ++k, ++asked) {
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
  EXPECT_GT(below, asked / 15);
}

TEST_P(EveryRisingTool, BoundsHoldOverASquare) {
  const Tool tool = rising_tools()[static_cast<std::size_t>(GetParam())];
  int bounded = 0, asked = 0;
  for (int kind = 0; kind < 6; ++kind) {
    Random r(30 + kind);
    for (unsigned round = 0; round < moves_of(kind, tool); ++round) {
      const Motion m = any_move(r, kind);
      const SweepTable s({&m, 1}, {&tool, 1});
      const SweepUndersides tools(s);
      SweepHeights heights(s, tools, kLow, kHigh);
      const std::uint32_t all[] = {0};
      heights.assign(all);
      for (int k = 0; k < 10; ++k, ++asked) {
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
  EXPECT_GT(bounded, asked / 20);
}

// Slants of every steepness, among them that of the tool itself, seen from places at the ends of
// the move and at the edge of the tool; the least and the greatest bottom lie at the circle's edge.
TEST_P(EveryRisingTool, BoundsOfSlantsHoldOverACircle) {
  const Underside tool(make_cutter(rising_tools()[static_cast<std::size_t>(GetParam())]));
  if (!tool.is_convex()) return;  // its slants are searched
  const double radius = tool.radius();
  const double own = tool.height(radius) / radius;
  Random r(70);
  int finite = 0;
  for (int round = 0; round < 4000; ++round) {
    const double steep = own * (round % 3 == 0 ? 1 : 1 + r(-1e-6, 1e-6));
    const double slopes[] = {0, steep, r(0, 1), std::tan(radians(r(45, 89.9))), r(0, 1) * steep};
    Underside::Slant at{.length = r(0, 1) < 0.2 ? r(0, 0.1) : r(0, 12), .slope = slopes[r.pick(5)]};
    const double edge = radius + 1;
    const double xs[] = {0, at.length, r(-edge, at.length + edge)}, ys[] = {0, radius, r(0, edge)};
    const double x = xs[r.pick(3)], y = ys[r.pick(3)], wide = std::pow(10.0, r(-5, 0.5));
    at.u = x, at.v = y;
    const Underside::Bounds bounds = tool.bounds(at, wide);
    for (int k = 0; k < 8; ++k) {
      const double turn = r(0, kTwoPi), off = (k < 5 ? 1 : r(0, 1)) * (1 - 1e-12) * wide;
      at.u = x + off * std::cos(turn), at.v = std::fabs(y + off * std::sin(turn));
      const double z = tool.bottom(at), error = 1e-8 * (1 + at.slope);
      finite += std::isfinite(z);
      ASSERT_LE(bounds.lower, z + error) << "slope " << at.slope << " within " << wide;
      ASSERT_GE(bounds.upper, z - error) << "slope " << at.slope << " within " << wide;
    }
  }
  EXPECT_GT(finite, 8000);
}

// The bounds of a small square come near to the bottom, but at walls. Arcs are within 0.01 mm of
// their chords.
TEST_P(EveryRisingTool, BoundsOfASmallSquareAreSharp) {
  const Tool tool = rising_tools()[static_cast<std::size_t>(GetParam())];
  const int kinds = make_cutter(tool).is_convex() ? 6 : 2;  // slants of others are searched
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
    const double off = round % kinds < 3 ? 0.05 : 0.2;  // of a ball 0.01 mm from its rim
    ++all_of_them;
    sharp += bounds.lower > z - off && bounds.upper < z + off;
  }
  EXPECT_GT(all_of_them, 50);
  EXPECT_GT(sharp, 0.85 * all_of_them);
}

INSTANTIATE_TEST_SUITE_P(All, EveryRisingTool,
                         ::testing::Range(0, static_cast<int>(rising_tools().size())));

}  // namespace
}  // namespace mrsim
