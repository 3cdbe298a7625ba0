// Collisions against closed forms: depth and line of parts of tools in blocks, slots and bars, and
// the touches that are none.
#include "collision_support.h"
#include "core/numbers/units.h"
#include "removal/sweep/sweep_table.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::bar;
using testing::block;
using testing::check;
using testing::endmill;
using testing::expect_none;
using testing::expect_one;
using testing::Moves;

TEST(Collisions, RapidThroughABlockIsAsDeepAsItsTip) {
  const Moves m = Moves({-10, 30, 5}).rapid({-10, 30, -3}).rapid({110, 30, -3});
  const CollisionReport report = check(block(), m.motions, endmill(10));
  expect_one(report, 1, ToolPart::cutter, 3);
  EXPECT_NEAR(report.lines[0].place.z, -3, 0.01);
  EXPECT_LE(std::abs(report.lines[0].place.y - 30), 5.001);
  EXPECT_EQ(report.lines[0].motions, 1u);
  EXPECT_NEAR(report.lines[0].volume, 100 * 10 * 3, 30);
}

TEST(Collisions, PlungeWithABallIsAsDeepAsItsPole) {
  Tool ball = endmill(6);
  ball.type = ToolType::ballmill;
  const Moves m = Moves({40, 30, 5}).rapid({40, 30, -4});
  const CollisionReport report = check(block(), m.motions, ball);
  expect_one(report, 0, ToolPart::cutter, 4);
  EXPECT_NEAR(distance(report.lines[0].place, {40, 30, -4}), 0, 0.1);
  EXPECT_NEAR(report.lines[0].volume, kPi * (18 + 9), 0.8);  // half a ball, 1 mm of cylinder
}

// The place is one of that depth, also beside a sharp tip.
TEST(Collisions, TheDeepestPlaceOfADrillIsItsTip) {
  Tool tool = endmill(6);
  tool.type = ToolType::drill;
  tool.tip_angle = radians(90);
  std::mt19937 random(3);
  const auto r = [&random](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random() % 1000) / 999;
  };
  for (int k = 0; k < 40; ++k) {
    const Vec3 from{r(20, 80), r(10, 50), r(0.1, 4)}, end{r(20, 80), r(10, 50), r(-6, -2)};
    const CollisionReport report = check(block(), Moves(from).rapid(end).motions, tool);
    expect_one(report, 0, ToolPart::cutter, -end.z, 2e-3);
    EXPECT_LT(distance(report.lines[0].place, end), 5e-3);
  }
}

TEST(Collisions, GrazingFacesIsNone) {
  const Moves m = Moves({-10, 30, 0})
                      .rapid({110, 30, 0})   // on the top
                      .rapid({110, 65, -5})  // beside
                      .rapid({-10, 65, -5})  // along a side, a diameter away from it
                      .rapid({-10, 30, -0.009})
                      .rapid({110, 30, -0.009});  // less deep than a touch
  expect_none(check(block(), m.motions, endmill(10)));
  const Moves deeper = Moves({-10, 30, -0.05}).rapid({110, 30, -0.05});
  expect_one(check(block(), deeper.motions, endmill(10), 0.25), 0, ToolPart::cutter, 0.05);
}

TEST(Collisions, MaterialCountsAtTheMomentOfTheMove) {
  const Vec3 a{20, 30, -4}, b{80, 30, -4};
  const Moves after = Moves(a).cut(b).rapid(a).rapid(b + Vec3{0, 0, 1}).rapid(b + Vec3{0, 0, 20});
  expect_none(check(block(), after.motions, endmill(10)));
  const Moves before = Moves(a).rapid(b).cut(a);
  expect_one(check(block(), before.motions, endmill(10)), 0, ToolPart::cutter, 4);
}

// The usual ends of a cut: straight out, back along the slot, a helix out of a bore.
TEST(Collisions, RetractsTouchOnly) {
  for (const double flutes : {0.0, 8.0}) {
    const Moves m = Moves({30, 30, 5})
                        .cut({30, 30, -6})
                        .cut({60, 30, -6})
                        .arc({60, 50, -6}, {60, 40, -6}, kPi)
                        .rapid({60, 50, 10})
                        .rapid({30, 30, 10})
                        .rapid({30, 30, -6})
                        .rapid({60, 30, -6})
                        .rapid({45, 30, -6})
                        .rapid({45, 30, 10});
    expect_none(check(block(), m.motions, endmill(8, 0, flutes)));
  }
}

TEST(Collisions, RetractFromAPocketWithClosedFlutesAndAShankOfTheSameDiameter) {
  Tool tool = endmill(8, 0, 5);
  tool.shank = {{8, 8, 40}};
  Moves m({20, 20, 5});
  for (const double z : {-4.0, -8.0, -12.0}) {
    m.cut({20, 20, z}).cut({50, 20, z}).cut({50, 26, z}).cut({20, 26, z}).cut({20, 20, z});
    m.rapid({35, 23, z + 1}).rapid({20, 20, z});
  }
  m.rapid({20, 20, 30});
  expect_none(check(block(), m.motions, tool));
}

// The cuts of one level end where those of the next begin: no cut alone has cleared that plane, all
// of which a shank in the pocket passes.
TEST(Collisions, AShankClearsLevelsAsHighAsTheFlutes) {
  Tool tool = endmill(8, 0, 4);
  tool.shank = {{7, 7, 60}};
  Moves m({20, 20, 5});
  for (const double z : {-4.0, -8.0, -12.0, -16.0}) {
    m.rapid({20, 20, z + 4}).cut({20, 20, z});
    for (double y = 20; y < 40; y += 5)
      m.cut({70, y, z}).cut({70, y + 2.5, z}).cut({20, y + 2.5, z}).cut({20, y + 5, z});
    m.rapid({20, 40, 5}).rapid({20, 20, 5});
  }
  expect_none(check(block(), m.motions, tool));
  // A level of 4.1 mm leaves a roof of 0.1 mm, which every move below meets.
  const Moves roof =
      Moves({-20, 30, -4}).cut({120, 30, -4}).cut({120, 30, -8.1}).cut({-20, 30, -8.1});
  expect_one(check(block(), roof.motions, tool, 0.25), 2, ToolPart::shank, 0.05, 0.01);
}

TEST(Collisions, AHolderCollidesInASlotNarrowerThanItself) {
  Tool tool = endmill(10, 0, 6);
  tool.holder = {{30, 30, 40}};
  // The holder begins 6 mm above the tip: at Z-9 it reaches 3 mm into the block.
  const Moves m = Moves({-20, 30, -4}).cut({120, 30, -4}).cut({120, 30, -9}).cut({-20, 30, -9});
  expect_one(check(block(), m.motions, tool), 2, ToolPart::holder, 3);
}

TEST(Collisions, AShankWiderThanTheCutterCollidesInADeepPocket) {
  Tool tool = endmill(6, 0, 5);
  tool.shank = {{8, 8, 30}};
  const Moves m =
      Moves({30, 30, 2}).cut({30, 30, -4}).cut({70, 30, -4}).cut({70, 30, -9}).cut({30, 30, -9});
  const CollisionReport report = check(block(), m.motions, tool, 0.25);
  ASSERT_EQ(report.lines.size(), 2u);  // the plunge and the slot
  EXPECT_EQ(report.lines[0].motion, 2u);
  EXPECT_EQ(report.lines[1].motion, 3u);
  // A ring of 1 mm, 4 mm high, in the solid: the nearest air is the slot below and above.
  for (const Collision& c : report.lines) {
    EXPECT_EQ(c.part, ToolPart::shank);
    EXPECT_NEAR(c.depth, 1, 0.02);
  }
  // Of the plunge's ring the first slot has taken a part: 6 mm wide, on one side.
  const double taken = 3 * std::sqrt(7.0) + 16 * std::asin(0.75) - 4.5 * kPi;
  EXPECT_NEAR(report.lines[0].volume, 4 * (kPi * (16 - 9) - taken), 0.5);
  EXPECT_NEAR(report.lines[1].volume, 4 * (40 * (8 - 6) + kPi * (16 - 9)), 4);
}

// All boxes of the search are as thin as the layer: its lower face is deepest, not its middle.
TEST(Collisions, AShankThatDipsIntoTheFaceIsAsDeepAsItsEnd) {
  Tool tool = endmill(8);
  tool.type = ToolType::lollipop;
  tool.neck_diameter = 5.4, tool.shank = {{9.9, 9.9, 15.1}};
  const double low = -7.048, dip = -(low + 4 + std::sqrt(16 - 2.7 * 2.7));  // neck's upper end
  const Moves m = Moves({-13.79, -6, 10})
                      .cut({-13.79, -6, -6.748})
                      .rapid({-12.74, -6, -6.748})
                      .rapid({-12.74, -6, low})
                      .rapid({-13.04, -6, low})
                      .cut({-1.7, -0.48, low})
                      .rapid({-1.7, -0.48, 1.46});
  const StockShape stock = testing::box_stock({-20, -15, -12}, {20, 15, 0});
  const CollisionReport report = check(stock, m.motions, tool, 0.25);
  int shanks = 0;
  for (const Collision& c : report.lines) {
    if (c.part != ToolPart::shank) continue;
    ++shanks;
    EXPECT_NEAR(c.depth, dip, 0.003) << "motion " << c.motion;
  }
  EXPECT_EQ(shanks, 4);
}

TEST(Collisions, WhatLaterMotionsRemoveIsStillThere) {
  Tool tool = endmill(10, 0, 6);
  tool.holder = {{30, 30, 40}};
  const Moves m = Moves({-20, 30, -9}).cut({120, 30, -9}).cut({120, 40, -9}).cut({-20, 40, -9});
  const CollisionReport report = check(block(), m.motions, tool);
  ASSERT_FALSE(report.lines.empty());
  EXPECT_EQ(report.lines[0].motion, 0u);
}

TEST(Collisions, ATiltedHolderMeetsTheBlock) {
  Tool tool = endmill(10, 0, 10);
  tool.holder = {{40, 40, 40}};
  Moves m = Moves({-10, 30, -1}).cut({110, 30, -1});
  const Vec3 axis = normalized({0, 1, 1});
  m.motions[0].tool_axis = axis;
  // The lowest rim of the holder, at tip + 10 along the axis and 20 down the slope.
  const double low = -1 + 10 / std::sqrt(2.0) - 20 / std::sqrt(2.0);
  expect_one(check(block(), m.motions, tool), 0, ToolPart::holder, -low, 0.02);
}

TEST(Collisions, AnInsertThatRapidsThroughTheBarCollides) {
  Tool insert;
  insert.id = "1";
  insert.type = ToolType::turning;
  insert.nose_radius = 0.8;
  const Moves m = Moves({30, 0, 60})
                      .rapid({24, 0, 55})
                      .cut({24, 0, 20})
                      .cut({26, 0, 20.5})
                      .rapid({30, 0, 60})
                      .rapid({20, 0, 60})
                      .rapid({20, 0, 40});
  for (const double voxel : {0.5, 0.1}) {
    const CollisionReport report = check(bar(), m.motions, insert, voxel);
    ASSERT_EQ(report.lines.size(), 1u);
    EXPECT_EQ(report.lines[0].motion, 5u);
    // The tip runs 4 mm below the turned diameter, 10 mm from the end; its nose is round.
    EXPECT_NEAR(report.lines[0].depth, 4, 0.001);
    EXPECT_EQ(report.lines[0].place.y, 0);
    // A ring of 4 mm and what stands before the edge.
    EXPECT_NEAR(report.lines[0].volume, 10 * kPi * (24 * 24 - 20 * 20), 60);
  }
}

// On the axis a drill is searched for in one half plane; a little beside it, in space.
TEST(Collisions, ADrillOnTheAxisOfTheBarCollides) {
  for (const double x : {0.0, 1e-7}) {
    const Moves m = Moves({30, 0, 60})
                        .rapid({x, 0, 60})
                        .rapid({x, 0, 52})
                        .cut({x, 0, 30})
                        .rapid({x, 0, 55})
                        .rapid({x, 0, 26})
                        .cut({x, 0, 60});
    const CollisionReport report = check(bar(), m.motions, endmill(10));
    expect_one(report, 4, ToolPart::cutter, 4);
    EXPECT_NEAR(report.lines[0].place.z, 26, 0.01);
    EXPECT_NEAR(report.lines[0].volume, 4 * kPi * 25, 5);
  }
  // A rapid beside the axis into the bar is found, too.
  const Moves aside =
      Moves({0, 0, 60}).cut({0, 0, 40}).rapid({0, 0, 60}).rapid({15, 0, 60}).rapid({15, 0, 45});
  expect_one(check(bar(), aside.motions, endmill(10)), 3, ToolPart::cutter, 5);
}

TEST(Collisions, AssumedStartsAndToollessRapidsAreLeftOut) {
  Moves m = Moves({0, 0, 0}).rapid({50, 30, -5}).rapid({60, 30, -5}).cut({70, 30, -5});
  m.motions[0].assumed_start = true;
  m.motions[1].tool = -1;
  expect_none(check(block(), m.motions, endmill(10)));
}

TEST(Collisions, ManyLinesAreCounted) {
  Moves m({-10, 30, 5});
  for (int i = 0; i < 25; ++i) m.rapid({i * 3.0, 30, -1}).rapid({i * 3.0, 30, 5});
  const CollisionReport report = check(block(), m.motions, endmill(1));
  EXPECT_EQ(report.lines.size(), 20u);
  EXPECT_GT(report.more, 0u);
}

TEST(Collisions, TheDeepestLinesAreListed) {
  Moves m({-10, 30, 5});
  for (int i = 0; i < 25; ++i)
    m.rapid({i * 3.0, 30, 5}).rapid({i * 3.0, 30, -1 - 0.1 * i}).rapid({i * 3.0, 30, 5});
  const CollisionReport report = check(block(), m.motions, endmill(1));
  ASSERT_EQ(report.lines.size(), 20u);
  double deepest = 0;
  for (const Collision& c : report.lines) {
    EXPECT_GT(c.depth, 1.3);
    deepest = std::max(deepest, c.depth);
  }
  EXPECT_NEAR(deepest, 3.4, 1e-3);
}

TEST(Collisions, OneLineOfManyMotionsIsOnePlace) {
  Moves m({10, 10, 5});
  for (int i = 0; i < 5; ++i)
    m.rapid({10.0 + 10 * i, 10, 5})
        .rapid({10.0 + 10 * i, 10, -1.0 - i})
        .rapid({10.0 + 10 * i, 10, 5});
  for (Motion& motion : m.motions) motion.line = 7;
  const CollisionReport report = check(block(), m.motions, endmill(2));
  expect_one(report, 13, ToolPart::cutter, 5);
  EXPECT_EQ(report.lines[0].motions, 10u);  // down and up
}

// Random moves in a block: threads do not matter, and a larger threshold finds no more.
TEST(Collisions, ThreadsDoNotMatterAndALargerThresholdFindsNoMore) {
  std::mt19937 random(testing::salted(7));
  const auto pick = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random() % 1000) / 999;
  };
  Tool tool = endmill(6, 0, 4);
  tool.shank = {{6, 6, 5}, {9, 9, 5}};
  tool.holder = {{20, 30, 20}};
  Moves m({50, 30, 10});
  for (int i = 0; i < 60; ++i) {
    const Vec3 to{pick(0, 100), pick(0, 60), pick(-10, 3)};
    i % 4 == 0 ? m.rapid(to) : m.cut(to);
  }
  std::size_t lines = 1000;
  for (const double depth : {0.01, 0.1, 1.0, 4.0}) {
    const CollisionReport one = check(block(), m.motions, tool, 1, 1, depth);
    EXPECT_LE(one.lines.size() + one.more, lines);
    lines = one.lines.size() + one.more;
    for (const Collision& c : one.lines) EXPECT_GT(c.depth, depth);
    for (const int threads : {2, 7}) {
      const CollisionReport other = check(block(), m.motions, tool, 1, threads, depth);
      ASSERT_EQ(other.lines.size(), one.lines.size());
      EXPECT_EQ(other.more, one.more);
      for (std::size_t i = 0; i < one.lines.size(); ++i) {
        EXPECT_EQ(other.lines[i].motion, one.lines[i].motion);
        EXPECT_EQ(other.lines[i].depth, one.lines[i].depth);
        EXPECT_EQ(other.lines[i].place, one.lines[i].place);
        EXPECT_EQ(other.lines[i].motions, one.lines[i].motions);
      }
    }
  }
}

// Against dense sampling: what points of a grid prove is found, and depths reach theirs.
TEST(Collisions, AgreeWithDenseSampling) {
  std::mt19937 random(testing::salted(11));
  const auto pick = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random() % 1000) / 999;
  };
  const StockShape stock = testing::box_stock({0, 0, -5}, {20, 20, 0});
  for (unsigned scene = 0; scene < testing::rounds(4); ++scene) {
    Tool tool = endmill(scene % 2 == 0 ? 3 : 5, 0, 4);
    tool.type = scene % 3 == 0 ? ToolType::ballmill : ToolType::endmill;
    Moves m({10, 10, 1});
    for (int i = 0; i < 16; ++i) {
      const Vec3 to{pick(0, 20), pick(0, 20), pick(-3, 1)};
      i % 3 == 0 ? m.rapid(to) : m.cut(to);
    }
    const std::vector<Tool> tools{tool};
    std::vector<double> proved(m.motions.size(), 0);
    const SweepTable cuts(m.motions, tools);
    const SweepTable rapids(m.motions, tools, {SweepSelection::Part::cutter, false, true});
    for (double x = 0.1; x < 20; x += 0.2)
      for (double y = 0.1; y < 20; y += 0.2)
        for (double z = -4.95; z < 0; z += 0.1) {
          const Vec3 p{x, y, z};
          double least = std::min({x, 20 - x, y, 20 - y, -z, z + 5});
          std::size_t cut = 0;
          for (std::size_t r = 0; r < rapids.size(); ++r) {
            for (; cut < cuts.size() && cuts.motion(cut) < rapids.motion(r); ++cut)
              least = std::min(least, cuts.distance(cut, p));
            if (least <= 0.01) break;
            double& best = proved[static_cast<std::size_t>(rapids.motion(r))];
            if (least > best && rapids.distance(r, p) <= 0) best = least;
          }
        }
    const CollisionReport report = check(stock, m.motions, tool, 0.2);
    std::vector<double> found(m.motions.size(), 0);
    for (const Collision& c : report.lines) found[c.motion] = c.depth;
    for (std::size_t i = 0; i < proved.size(); ++i) {
      EXPECT_GE(found[i], proved[i] * (1 - 1.0 / 32) - 0.01) << scene << " " << i;
      EXPECT_LE(found[i], proved[i] + 0.2) << scene << " " << i;
    }
  }
}

}  // namespace
}  // namespace mrsim
