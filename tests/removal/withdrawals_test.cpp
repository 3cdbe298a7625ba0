// Rapids of inserts right after a cut: what withdraws is told apart, what goes into material is
// not.
#include "collision_support.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::bar;
using testing::check;
using testing::expect_none;
using testing::expect_one;
using testing::Moves;

// External, right hand, 80 degrees; the bar's radius is 25 mm, its end at z = 50.
Tool rougher(double lead = 95) {
  Tool t;
  t.id.assign(1, '1');  // GCC 12 warns of overlap on = "1"
  t.type = ToolType::turning;
  t.insert = "C";
  t.lead_angle = radians(lead);
  return t;
}

Moves turned_to(double radius) { return Moves({radius, 0, 52}).cut({radius, 0, 20}); }

void expect_withdrawals(const CollisionReport& report, std::size_t lines, std::size_t motion,
                        double depth) {
  expect_none(report);
  EXPECT_EQ(report.withdrawals.lines, lines);
  EXPECT_EQ(report.withdrawals.motion, motion);
  EXPECT_NEAR(report.withdrawals.depth, depth, 1e-3);
}

// The edge leans back by 5 degrees. At height y over the tip the wedge is y sin 5 deep, the bar's
// surface 3 - y away: the deepest place has both alike.
TEST(Withdrawals, StraightOutOfAShoulderScrapesTheWedgeBehindTheEdge) {
  const double sine = sincos(radians(5)).sin;
  expect_withdrawals(check(bar(), turned_to(22).rapid({30, 0, 20}).motions, rougher()), 1, 1,
                     3 * sine / (1 + sine));
}

TEST(Withdrawals, TheWayBackAlongTheBarMeetsTheSameWedge) {
  for (const char* shape : {"C", "V"}) {
    Tool tool = rougher();
    tool.insert = shape;
    const Moves m = turned_to(22).rapid({23, 0, 20}).rapid({23, 0, 55}).rapid({30, 0, 55});
    const CollisionReport report = check(bar(), m.motions, tool);
    expect_none(report);
    EXPECT_EQ(report.withdrawals.lines, 2u) << shape;
  }
}

TEST(Withdrawals, AWayOutOfABoreIsAWithdrawal) {
  Tool tool = rougher();
  tool.type = ToolType::boring;
  const StockShape tube = testing::round_stock(25, 10, 0, 50);
  const Moves m = Moves({12, 0, 52}).cut({12, 0, 20}).rapid({8, 0, 20}).rapid({8, 0, 55});
  const CollisionReport report = check(tube, m.motions, tool);
  expect_none(report);
  EXPECT_EQ(report.withdrawals.lines, 1u);
}

TEST(Withdrawals, DeepWedgesStayCollisions) {
  const double sine = sincos(radians(5)).sin;
  expect_one(check(bar(), turned_to(17).rapid({30, 0, 20}).motions, rougher()), 1, ToolPart::cutter,
             8 * sine / (1 + sine), 2e-3);
}

TEST(Withdrawals, IntoMaterialAfterACutStaysACollision) {
  const Moves onwards = turned_to(22).rapid({22, 0, 19.8});
  expect_one(check(bar(), onwards.motions, rougher()), 1, ToolPart::cutter, 0.2, 2e-3);
  const Moves inwards = turned_to(22).rapid({21.8, 0, 20});
  expect_one(check(bar(), inwards.motions, rougher()), 1, ToolPart::cutter, 0.2, 2e-3);
  const Moves faced = Moves({30, 0, 45}).cut({0, 0, 45}).rapid({0, 0, 44.8});
  expect_one(check(bar(), faced.motions, rougher()), 1, ToolPart::cutter, 0.2, 2e-3);
}

TEST(Withdrawals, ABladeAgainstTheWallOfItsGrooveCollides) {
  Tool blade = rougher();
  blade.type = ToolType::grooving;
  blade.width = 3;
  const Moves out = Moves({30, 0, 20}).cut({20, 0, 20}).rapid({30, 0, 20});
  expect_withdrawals(check(bar(), out.motions, blade), 0, 0, 0);
  for (const double aside : {-0.2, 0.2}) {
    const Moves m = Moves({30, 0, 20}).cut({20, 0, 20}).rapid({20, 0, 20 + aside});
    expect_one(check(bar(), m.motions, blade), 1, ToolPart::cutter, 0.2, 2e-3);
  }
}

// Along a bar that is still 25 mm thick there.
TEST(Withdrawals, RapidsFromElsewhereCollideHoweverThin) {
  const Moves m = Moves({24.8, 0, 55}).cut({24.8, 0, 51}).rapid({24.8, 0, 40});
  expect_one(check(bar(), m.motions, rougher()), 1, ToolPart::cutter, 0.2, 2e-3);
}

}  // namespace
}  // namespace mrsim
