// Mills without a shank of their own, below material that their flutes do not reach.
#include "removal/tool/assumed_shank.h"

#include "collision_support.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mrsim::testing {
namespace {

TEST(AssumedShank, MillBelowWhatItsFlutesDoNotReach) {
  // Flutes of 3 mm in a slot 5 mm deep leave a roof of 2 mm, whose middle is 1 mm from air.
  const Moves slot = Moves({-20, 30, -5}).cut({120, 30, -5});
  expect_one(check(block(), slot.motions, endmill(6, 0, 3), 0.25), 0, ToolPart::shank, 1, 0.01);
  const Moves levels =
      Moves({-20, 30, -3}).cut({120, 30, -3}).cut({120, 30, -5}).cut({-20, 30, -5});
  expect_none(check(block(), levels.motions, endmill(6, 0, 3), 0.25));
  expect_none(check(block(), slot.motions, endmill(6), 0.25));  // cuts up to the top
}

TEST(AssumedShank, TheNeckOfATSlotMillCollides) {
  Tool tool = mill(ToolType::tslot, 16);
  tool.width = 4;
  tool.neck_diameter = 8;
  // The neck runs through the 4 mm above the head.
  const Moves closed = Moves({-20, 30, -8}).cut({120, 30, -8});
  expect_one(check(block(), closed.motions, tool, 0.25), 0, ToolPart::shank, 2, 0.01);
  const std::vector<Tool> tools{endmill(10), tool};
  Moves m = Moves({-20, 30, -8}).cut({120, 30, -8}).cut({-20, 30, -8});
  m.motions[0].tool = 0;
  m.motions[1].tool = 1;
  CarvePlan carving;
  carving.voxel = 0.25;
  expect_none(find_collisions(carve(block(), m.motions, tools, carving), m.motions, tools, 0));
}

TEST(AssumedShank, StandsRightAboveAHeadThatIsLowerThanTheFluteLength) {
  Tool tool = mill(ToolType::tslot, 16, 0, 12);
  tool.width = 4;
  tool.shank = {{8, 8, 30}};
  const Moves closed = Moves({-20, 30, -8}).cut({120, 30, -8});
  expect_one(check(block(), closed.motions, tool, 0.25), 0, ToolPart::shank, 2, 0.01);
}

TEST(AssumedShank, IsAsWideAsTheUpperEndOrTheNeck) {
  EXPECT_DOUBLE_EQ(assumed_shank(endmill(6, 0, 3)), 5.7);
  EXPECT_EQ(assumed_shank(endmill(6)), 0);
  EXPECT_FALSE(has_unknown_neck(endmill(6)));
  Tool holder = endmill(6, 0, 3);
  holder.holder = {{20, 20, 30}};
  EXPECT_EQ(assumed_shank(holder), 0);
  Tool cone = mill(ToolType::chamfer, 10, 0, 3);  // 90 degrees, cut off at 3 mm
  EXPECT_NEAR(assumed_shank(cone), 0.95 * 6, 1e-12);
  Tool ball = mill(ToolType::lollipop, 8);
  EXPECT_EQ(assumed_shank(ball), 0);
  EXPECT_TRUE(has_unknown_neck(ball));
  ball.flute_length = 6.4;  // ends where the ball is 6.4 mm wide
  EXPECT_NEAR(assumed_shank(ball), 6.4, 1e-12);
  ball.flute_length = 0, ball.neck_diameter = 4;
  EXPECT_EQ(assumed_shank(ball), 4);
  EXPECT_FALSE(has_unknown_neck(ball));
  Tool head = mill(ToolType::form, 0);
  head.profile = {{0, 0, 0}, {8, 0, 0}, {8, 4, 0}, {0, 4, 0}};
  EXPECT_EQ(assumed_shank(head), 0);
  EXPECT_TRUE(has_unknown_neck(head));
  EXPECT_FALSE(has_unknown_neck(insert("VNMG", 0.4)));
}

}  // namespace
}  // namespace mrsim::testing
