// Bottoms of sweeps in closed form against their distances, and the bounds of them.
#include "removal/sweep/sweep_heights.h"

#include "core/numbers/units.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/tool/underside.h"
#include "support/rounds.h"
#include "sweep_support.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

constexpr double kLow = -20, kHigh = 20;
constexpr double kWide = 6;  // mm: moves lie in a square of this half width

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

// Moves of one kind: distances of the slanted ones of tools that are not convex take milliseconds.
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
      const Motion m = move_of_kind(r, kind, kWide);
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

// Helices narrower and wider than the tool, up and down, of less than a turn and of many.
TEST_P(EveryRisingTool, BottomsOfHelicesAreWhereTheDistanceIsZero) {
  const Tool tool = rising_tools()[static_cast<std::size_t>(GetParam())];
  // Distances of others take milliseconds.
  const unsigned helices = rounds(make_cutter(tool).is_convex() ? 60 : 9);
  Random r(77);
  unsigned below = 0;
  for (unsigned round = 0; round < helices; ++round) {
    const double radii[] = {r(0.001, 0.1), r(0.1, 1), r(1, 6), r(6, 12)};
    const double sweeps[] = {kTwoPi, r(0.1, 3), r(3, 9), r(9, 40)};
    const double sweep = sweeps[r.pick(4)], turn = radii[r.pick(4)];
    const Motion m = arc({turn, 0, r(-5, 5)}, {0, 0, 0}, {0, 0, 1}, r.pick(2) ? sweep : -sweep,
                         r(-1, 1) * sweep);
    const SweepTable s({&m, 1}, {&tool, 1});
    const SweepUndersides tools(s);
    SweepHeights heights(s, tools, -60, 60);
    const std::uint32_t all[] = {0};
    heights.assign(all);
    for (int k = 0; k < 12; ++k) {
      const double angle = r(0, kTwoPi), from = std::max(0.0, turn + r(-5, 5));
      const double x = from * std::cos(angle), y = from * std::sin(angle);
      const double z = heights.bottom(0, x, y);
      SCOPED_TRACE(::testing::Message() << "helix of " << turn << " mm, " << m.sweep << " rad, "
                                        << m.rise << " mm at " << x << ", " << y);
      if (std::isinf(z)) {
        ASSERT_GT(s.distance(0, {x, y, 60}), -1e-6);
        continue;
      }
      ++below;
      ASSERT_NEAR(s.distance(0, {x, y, z}), 0, 1e-6);
      ASSERT_GT(s.distance(0, {x, y, z - 1e-3}), 0);
    }
  }
  EXPECT_GT(below, 2 * helices);
}

TEST_P(EveryRisingTool, BoundsHoldOverASquare) {
  const Tool tool = rising_tools()[static_cast<std::size_t>(GetParam())];
  int bounded = 0, asked = 0;
  for (int kind = 0; kind < 6; ++kind) {
    Random r(30 + kind);
    for (unsigned round = 0; round < moves_of(kind, tool); ++round) {
      const Motion m = move_of_kind(r, kind, kWide);
      const SweepTable s({&m, 1}, {&tool, 1});
      const SweepUndersides tools(s);
      SweepHeights heights(s, tools, kLow, kHigh);
      const std::uint32_t all[] = {0};
      heights.assign(all);
      const int places = make_cutter(tool).is_convex() ? 10 : 3;
      for (int k = 0; k < places; ++k, ++asked) {
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
  if (!tool.is_convex()) return;  // rising_heights_test.cpp bounds its slants
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
  const int kinds = 6;
  int sharp = 0, all_of_them = 0;
  Random r(50);
  for (int round = 0; round < 200; ++round) {
    const Motion m = move_of_kind(r, round % kinds, kWide);
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

// Kernels ask a ball's move at sixteen places: each as one place is asked, on every instruction
// set.
TEST(BallHeights, SixteenPlacesAreEachAsOne) {
  Random r(31);
  const double radii[] = {0.5, 2, 3.5};
  unsigned met = 0, missed = 0;
  for (unsigned round = 0; round < rounds(300); ++round) {
    const double radius = radii[r.pick(3)], turn = r(-4, 4);
    const Underside tool(make_cutter(mill(ToolType::ballmill, 2 * radius)));
    ASSERT_TRUE(tool.is_ball());
    const LineRecord move{{r(0, 5), r(0, 5), r(-3, 3), std::cos(turn), std::sin(turn),
                           r.pick(5) == 0 ? 0 : r(0, 6), r.pick(4) == 0 ? 0 : r(0, 3), radius}};
    const auto seen_from = [&](double x, double y) {
      const double dx = x - move.c[0], dy = y - move.c[1];
      return Underside::Slant{dx * move.c[3] + dy * move.c[4],
                              std::fabs(dx * move.c[4] - dy * move.c[3]), move.c[5], move.c[6]};
    };
    PlanPoints places;
    alignas(64) double least[PlanPoints::kCount], out[PlanPoints::kCount];
    for (std::size_t k = 0; k < PlanPoints::kCount; ++k) {
      places.x[k] = r(-3, 12), places.y[k] = r(-3, 12), least[k] = places.low[k] = r(-4, 12);
      if (k == 0) places.x[k] = move.c[0], places.y[k] = move.c[1];
    }
    const double wide = r.pick(3) == 0 ? 0.01 : r(0, 4);
    for (const InstructionSet isa :
         {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      const std::uint32_t below = set->ball_heights(move, places, out);
      PlanPoints bounded = places;
      alignas(64) double lower[PlanPoints::kCount];
      std::copy_n(least, PlanPoints::kCount, lower);
      const std::uint32_t kept = set->ball_bounds(move, wide, bounded, lower);
      for (std::size_t k = 0; k < PlanPoints::kCount; ++k) {
        const Underside::Slant at = seen_from(places.x[k], places.y[k]);
        const double one = move.c[2] + tool.bottom(at);
        ++(std::isinf(one) ? missed : met);
        ASSERT_EQ(std::isinf(out[k]), std::isinf(one));
        if (!std::isinf(one)) {
          ASSERT_NEAR(out[k], one, 1e-9) << set->name;
        }
        ASSERT_EQ((below >> k & 1) != 0, out[k] < places.low[k]);
        const Underside::Bounds bounds = tool.bounds(at, wide);
        const bool is_kept = (kept >> k & 1) != 0;
        if (std::fabs(move.c[2] + bounds.lower - places.low[k]) > 1e-9) {
          ASSERT_EQ(is_kept, move.c[2] + bounds.lower < places.low[k]);
        }
        if (!is_kept) continue;
        ASSERT_NEAR(lower[k], move.c[2] + bounds.lower, 1e-9);
        const double upper = std::min(places.low[k], move.c[2] + bounds.upper);
        ASSERT_NEAR(bounded.low[k], upper, 1e-9);
      }
    }
  }
  EXPECT_GT(met, rounds(1000));
  EXPECT_GT(missed, rounds(1000));
}

TEST(BallHeights, AreTheSameBitsOnEveryInstructionSet) {
  Random r(32);
  for (int round = 0; round < 500; ++round) {
    const double turn = r(-4, 4);
    const LineRecord move{{r(0, 5), r(0, 5), r(-3, 3), std::cos(turn), std::sin(turn), r(0, 6),
                           r.pick(4) == 0 ? 0 : r(0, 3), r(0.1, 4)}};
    PlanPoints places;
    for (std::size_t k = 0; k < PlanPoints::kCount; ++k)
      places.x[k] = r(-3, 12), places.y[k] = r(-3, 12), places.low[k] = r(-4, 12);
    const auto asked = [&](const SweepKernels& set) {
      struct Answers {
        alignas(64) double out[PlanPoints::kCount], least[PlanPoints::kCount];
        PlanPoints places;
        std::uint32_t below, kept;
      } a;
      a.places = places;
      std::copy_n(places.low, PlanPoints::kCount, a.least);
      a.below = set.ball_heights(move, places, a.out);
      a.kept = set.ball_bounds(move, 0.3, a.places, a.least);
      return a;
    };
    const auto one = asked(*sweep_kernels(InstructionSet::scalar));
    for (const InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
      const SweepKernels* set = sweep_kernels(isa);
      if (set == nullptr) continue;
      const auto other = asked(*set);
      ASSERT_EQ(one.below, other.below);
      ASSERT_EQ(one.kept, other.kept);
      ASSERT_EQ(std::memcmp(one.out, other.out, sizeof one.out), 0) << set->name;
      ASSERT_EQ(std::memcmp(one.least, other.least, sizeof one.least), 0) << set->name;
      ASSERT_EQ(std::memcmp(one.places.low, other.places.low, sizeof one.places.low), 0);
    }
  }
}

}  // namespace
}  // namespace mrsim
