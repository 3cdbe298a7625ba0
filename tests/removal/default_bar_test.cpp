// The bar of a run that gives none, on lathes.
#include "support/stock_path.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// Faced at zero, turned in two passes, parted off from outside the bar.
TEST(DefaultBar, EndsWhereRapidsGo) {
  const StockShape bar = StockPath()
                             .rapid({27, 0, 5})
                             .rapid({27, 0, 0})
                             .cut({-0.8, 0, 0})
                             .rapid({-0.8, 0, 2})
                             .rapid({26, 0, 2})
                             .rapid({24, 0, 2})
                             .cut({24, 0, -50})
                             .cut({26, 0, -50})
                             .rapid({26, 0, 2})
                             .rapid({22, 0, 2})
                             .cut({22, 0, -30})
                             .cut({28, 0, -30})
                             .bar();
  EXPECT_EQ(bar.outer_radius, 26);
  EXPECT_EQ(bar.box.hi.z, 1);
  EXPECT_EQ(bar.box.lo.z, -53);
}

// Faced in levels from X 62.25 inwards: the rapids between them pass beside the bar.
TEST(DefaultBar, EndsBelowWhereLevelsBegin) {
  EXPECT_NEAR(StockPath()
                  .rapid({62.25, 0, -2})
                  .cut({35, 0, -2})
                  .rapid({62.25, 0, -2})
                  .rapid({62.25, 0, -4})
                  .cut({35, 0, -4})
                  .bar()
                  .outer_radius,
              62.2, 1e-9);
}

// As Fusion faces: a feed in front of the bar, to the slope that leads in; it passes zero where the
// bar ends.
TEST(DefaultBar, EndsWhereSlopesLeadIn) {
  StockPath face;
  face.rapid({30, 0, 1.4}).cut({26.4, 0, 1.4}).cut({25, 0, 0}).cut({-0.8, 0, 0});
  EXPECT_EQ(face.cut({0.6, 0, 1.4}).cut({28, 0, 1.4}).rapid({30, 0, 5}).bar().outer_radius, 25);
  StockPath levels;  // faced at two heights, with straight feeds in front
  levels.rapid({31, 0, 5}).cut({31, 0, 2.4}).cut({29.4, 0, 2.4}).cut({28, 0, 1}).cut({-0.8, 0, 1});
  levels.rapid({-0.8, 0, 3}).rapid({31, 0, 3}).rapid({31, 0, 1.4}).cut({29.4, 0, 1.4});
  levels.cut({28, 0, 0}).cut({-0.8, 0, 0}).rapid({-0.8, 0, 5});
  EXPECT_EQ(levels.bar().outer_radius, 28);
  EXPECT_GT(levels.bar().box.hi.z, 1);
  StockPath hollow;  // a cut across at zero is none
  hollow.rapid({30, 0, 0}).cut({20, 0, 0}).cut({15, 0, -2}).cut({-0.8, 0, -2});
  EXPECT_EQ(hollow.rapid({-0.8, 0, 1.4}).bar().outer_radius, 30);
}

// As Fusion turns: the slope in front of the bar faces nothing, the one behind the shoulder leads
// away over what has been turned.
TEST(DefaultBar, EndsBehindSlopesInAndBeforeSlopesAway) {
  const StockShape bar = StockPath()
                             .rapid({30, 0, 5})
                             .cut({22.4, 0, 1.4})
                             .cut({21, 0, 0})
                             .cut({21, 0, -30})
                             .cut({25, 0, -30})
                             .cut({26.4, 0, -28.6})
                             .cut({26.4, 0, 2})
                             .cut({19, 0, 2})
                             .cut({19, 0, -20})
                             .rapid({30, 0, 5})
                             .bar();
  EXPECT_EQ(bar.outer_radius, 25);
  EXPECT_EQ(bar.box.hi.z, 0);
  // A chamfer from behind is cut before anything in front of it.
  EXPECT_EQ(StockPath()
                .rapid({26, 0, -20})
                .cut({20, 0, -20})
                .cut({25, 0, -15})
                .rapid({30, 0, -15})
                .bar()
                .outer_radius,
            26);
}

// A feed across in front of the part, in the place of a rapid.
TEST(DefaultBar, IsNoWiderThanWhatFollowsAFeedInFront) {
  StockPath chamfer;
  chamfer.rapid({30, 0, 2}).cut({20, 0, 2}).cut({23, 0, -1}).cut({23, 0, -30}).cut({25, 0, -30});
  EXPECT_EQ(chamfer.rapid({30, 0, 5}).bar().outer_radius, 25);
  StockPath behind;  // of a turret behind the axis
  behind.rapid({-30, 0, 2}).cut({-20, 0, 2}).cut({-23, 0, -1}).cut({-23, 0, -30});
  EXPECT_EQ(behind.cut({-25, 0, -30}).rapid({-30, 0, 5}).bar().outer_radius, 25);
  StockPath rings;  // faced down to a bore, at two heights: what is fed across is cut
  rings.rapid({30, 0, 2}).cut({10, 0, 2}).rapid({10, 0, 3}).rapid({30, 0, 3}).rapid({30, 0, 1});
  EXPECT_EQ(rings.cut({10, 0, 1}).rapid({10, 0, 3}).bar().outer_radius, 30);
  StockPath steps;
  steps.rapid({32, 0, 3}).cut({30, 0, 3}).cut({28, 0, 1}).cut({28, 0, -40}).cut({30, 0, -40});
  EXPECT_EQ(steps.rapid({32, 0, 3}).bar().outer_radius, 30);
  EXPECT_EQ(steps.bar().box.hi.z, 0);
  StockPath past;  // past the axis
  past.rapid({30, 0, 1}).cut({-0.8, 0, 1}).cut({-0.8, 0, 0}).cut({20, 0, 0}).cut({20, 0, -9});
  EXPECT_EQ(past.rapid({31, 0, 1}).bar().outer_radius, 30);
}

// A pass at one radius cuts something, up to where the tool comes from.
TEST(DefaultBar, IsThickerThanItsOnlyPass) {
  StockPath pass;
  pass.rapid({30, 0, 2}).rapid({24, 0, 2}).cut({24, 0, -30});
  EXPECT_EQ(StockPath(pass).rapid({40, 0, 2}).bar().outer_radius, 27);
  EXPECT_EQ(StockPath(pass).rapid({26, 0, -30}).rapid({26, 0, 2}).bar().outer_radius, 26);
  StockPath cone;
  cone.rapid({15, 0, 0}).cut({25, 0, -30}).cut({25, 0, -50}).rapid({40, 0, -50});
  EXPECT_EQ(cone.bar().outer_radius, 25);
  StockPath two;  // "G1 U-2." from the bar's own radius
  two.rapid({25, 0, 2}).cut({24, 0, 2}).cut({24, 0, -30}).rapid({25, 0, -30}).rapid({25, 0, 2});
  two.rapid({24, 0, 2}).cut({23, 0, 2}).cut({23, 0, -20}).rapid({24, 0, -20});
  EXPECT_EQ(two.bar().outer_radius, 25);
  StockPath lifts;  // two passes, with the feed off each
  lifts.rapid({27, 0, 2}).rapid({23, 0, 2}).cut({23, 0, -30}).cut({24, 0, -29}).rapid({24, 0, 2});
  lifts.rapid({19, 0, 2}).cut({19, 0, -30}).cut({20, 0, -29});
  EXPECT_EQ(lifts.rapid({20, 0, 2}).bar().outer_radius, 24);
  StockPath faced;  // from the bar's radius, and off a shoulder of that radius
  faced.rapid({25, 0, 2}).cut({25, 0, 0}).cut({-0.8, 0, 0}).rapid({-0.8, 0, 2}).rapid({23, 0, 2});
  faced.cut({23, 0, -30}).cut({25, 0, -30}).cut({26, 0, -29}).rapid({26, 0, 2});
  EXPECT_EQ(faced.bar().outer_radius, 25);
}

// The rapid to where a slope leads in says nothing of the shoulder behind.
TEST(DefaultBar, IsAsWideAsAShoulderBehindASlopeIn) {
  StockPath shaft;
  shaft.rapid({30, 0, 5}).rapid({16.4, 0, 1.4}).cut({15, 0, 0}).cut({15, 0, -30});
  shaft.cut({25, 0, -30}).cut({26.4, 0, -28.6});
  EXPECT_EQ(shaft.rapid({30, 0, 5}).bar().outer_radius, 25);
  StockPath cone;
  cone.rapid({30, 0, 2}).rapid({25, 0, 2}).cut({20, 0, -30}).cut({27, 0, -30});
  EXPECT_EQ(cone.rapid({30, 0, 2}).bar().outer_radius, 27);
}

// A chamfer before the blade parts off begins outside the bar.
TEST(DefaultBar, IsAsWideAsAChamferBehindZero) {
  StockPath off;
  off.rapid({27, 0, 2}).rapid({27, 0, -38}).cut({23, 0, -42}).cut({0, 0, -42});
  EXPECT_EQ(off.rapid({27, 0, -42}).bar().outer_radius, 27);
}

// Shoulders in front of the zero are cut, on the way to a pass beyond it.
TEST(DefaultBar, EndsBeforeShouldersInFrontOfZero) {
  StockPath shaft;
  shaft.rapid({27, 0, 52}).rapid({10, 0, 52}).cut({10, 0, 40}).cut({15, 0, 40}).cut({15, 0, -3});
  const StockShape bar = shaft.cut({27, 0, -3}).rapid({27, 0, 60}).bar();
  EXPECT_EQ(bar.outer_radius, 27);
  EXPECT_EQ(bar.box.hi.z, 52);
  StockPath neck;  // and what is thinner behind, far in front of it
  neck.rapid({31, 0, 102}).rapid({25, 0, 102}).cut({25, 0, 60}).cut({20, 0, 50}).cut({20, 0, -2});
  EXPECT_EQ(neck.cut({31, 0, -2}).rapid({31, 0, 120}).bar().outer_radius, 31);
}

// From the axis outwards, with the rim in front of the zero; and a flank behind a pass.
TEST(DefaultBar, IsAsWideAsLongSlopesOutwards) {
  StockPath dish;
  dish.rapid({0, 0, 5}).cut({0, 0, 0}).cut({10, 0, 0}).cut({25, 0, 4}).rapid({25, 0, 10});
  EXPECT_EQ(dish.bar().outer_radius, 25);
  EXPECT_GE(dish.bar().box.hi.z, 4);
  StockPath flank;
  flank.rapid({27, 0, 2}).rapid({22, 0, 2}).cut({22, 0, -40}).cut({20, 0, -40});
  flank.cut({20, 0, -20}).cut({27, 0, -13});
  EXPECT_EQ(flank.rapid({30, 0, -13}).bar().outer_radius, 27);
}

// G71 R0.5: the rapid off a pass leads over what that has turned.
TEST(DefaultBar, IsAsWideAsWhereRoughingBegins) {
  StockPath rough;
  rough.rapid({26, 0, 2}).rapid({24.7, 0, 2}).cut({24.7, 0, -40}).rapid({25.2, 0, -39.5});
  rough.rapid({25.2, 0, 2}).rapid({23.2, 0, 2}).cut({23.2, 0, -40}).rapid({23.7, 0, -39.5});
  rough.rapid({23.7, 0, 2}).rapid({23, 0, 2}).cut({23, 0, -40}).cut({26, 0, -40});
  EXPECT_EQ(rough.rapid({26, 0, 2}).bar().outer_radius, 26);
}

// Zero in the chuck: what is turned lies above it, whatever is parted off below.
TEST(DefaultBar, EndsWhereCutsBeginWithZeroInTheChuck) {
  const StockShape bar = StockPath()
                             .rapid({31, 0, 51})
                             .cut({15, 0, 51})
                             .cut({20, 0, 45})
                             .cut({20, 0, 10})
                             .rapid({45, 0, -40})
                             .cut({-0.5, 0, -40})
                             .bar();
  EXPECT_EQ(bar.box.hi.z, 51);
}

TEST(DefaultBar, OfAContourEndsAtZero) {
  const StockShape bar = StockPath()
                             .rapid({8, 0, 2})
                             .cut({8, 0, 0})
                             .cut({10, 0, -2})
                             .cut({10, 0, -20})
                             .cut({15, 0, -30})
                             .cut({18, 0, -30})
                             .bar();
  EXPECT_EQ(bar.outer_radius, 18);
  EXPECT_EQ(bar.box.hi.z, 0);
}

// A parting cut begins in the air: where the grooves' rapids go is none of the bar.
TEST(DefaultBar, IsNoWiderThanWhereRapidsGoBeforeAnyCut) {
  const StockShape bar = StockPath()
                             .rapid({30, 0, 40})
                             .rapid({21, 0, -18})
                             .cut({15, 0, -18})
                             .rapid({21, 0, -18})
                             .rapid({40, 0, 80})
                             .rapid({22, 0, -60})
                             .cut({-0.5, 0, -60})
                             .rapid({22, 0, -60})
                             .bar();
  EXPECT_EQ(bar.outer_radius, 21);
}

// Faced from outside a bar of 40, and then in levels that begin at its radius: what the right-hand
// insert has cut lies before its tip.
TEST(DefaultBar, IsNoWiderThanWhereLevelsOfAFaceBegin) {
  EXPECT_EQ(StockPath()
                .rapid({22, 0, 0})
                .cut({-0.8, 0, 0})
                .rapid({20, 0, 1})
                .rapid({20, 0, -1})
                .cut({12, 0, -1})
                .rapid({12.5, 0, -0.5})
                .rapid({20, 0, -0.5})
                .rapid({20, 0, -2})
                .cut({12, 0, -2})
                .bar()
                .outer_radius,
            20);
}

// Levels of a face that end at a contour, as G72 cuts them, and the ways off them at 45 degrees;
// strokes of a groove: they begin and end where the levels before have cut.
TEST(DefaultBar, IsAsWideAsLevelsOfAFaceThatEndFartherOut) {
  EXPECT_EQ(StockPath()
                .rapid({27, 0, 4})
                .rapid({27, 0, 0})
                .cut({0, 0, 0})
                .rapid({0.5, 0, 0.5})
                .rapid({0.5, 0, 4})
                .rapid({27, 0, 4})
                .rapid({27, 0, -2})
                .cut({10, 0, -2})
                .rapid({10.5, 0, -1.5})
                .rapid({27, 0, -1.5})
                .rapid({27, 0, -4})
                .cut({15, 0, -4})
                .rapid({27, 0, -4})
                .bar()
                .outer_radius,
            27);
  EXPECT_EQ(StockPath()
                .rapid({26, 0, 4})
                .rapid({26, 0, -20})
                .cut({24, 0, -20})
                .rapid({24.5, 0, -20})
                .cut({22, 0, -20})
                .rapid({22.5, 0, -20})
                .cut({20, 0, -20})
                .rapid({26, 0, -20})
                .bar(ToolType::grooving)
                .outer_radius,
            26);
}

// Rapids back within the part, and a feed move to the first pass in the air, tell nothing.
TEST(DefaultBar, EndsAtZeroWhateverIsInside) {
  const StockShape bar = StockPath()
                             .rapid({32, 0, 2})
                             .cut({20, 0, 2})
                             .cut({20, 0, -30})
                             .cut({25, 0, -35})
                             .cut({30, 0, -35})
                             .rapid({29.5, 0, -34.5})
                             .rapid({32, 0, 2})
                             .bar();
  EXPECT_EQ(bar.box.hi.z, 0);
  const StockShape groove =
      StockPath().rapid({12, 0, 4}).rapid({16, 0, -25}).cut({12, 0, -25}).bar();
  EXPECT_EQ(groove.box.hi.z, 0);
  EXPECT_EQ(groove.outer_radius, 16);  // not 12: nothing would be cut
}

// What is cut far beside a link, or far before zero, is no link and no run-out in the air.
TEST(DefaultBar, IsAsWideAsCutsFarFromLinks) {
  StockPath finish;  // of one pass: the rapid is in front of its shoulder
  finish.rapid({18, 0, 2}).cut({15, 0, 2}).cut({15, 0, -30}).cut({30, 0, -30});
  EXPECT_EQ(finish.bar().outer_radius, 30);
  StockPath dish;
  dish.rapid({28, 0, 4}).cut({25, 0, 4}).cut({10, 0, -1}).cut({0, 0, -1});
  EXPECT_EQ(dish.bar().outer_radius, 28);
  StockPath ring;
  ring.rapid({28, 0, 3}).cut({15, 0, 3}).cut({15, 0, -2}).cut({0, 0, -2});
  EXPECT_EQ(ring.bar().outer_radius, 28);
  StockPath face;  // outwards, after a bore
  face.rapid({10, 0, 2}).cut({10, 0, -5}).cut({10, 0, 1}).cut({27, 0, 1});
  EXPECT_EQ(face.bar().outer_radius, 27);
  StockPath dome;
  dome.rapid({30, 0, 10}).cut({28, 0, 9}).cut({25, 0, 5}).cut({22, 0, -5});
  EXPECT_EQ(dome.bar().outer_radius, 30);
  EXPECT_EQ(dome.bar().box.hi.z, 10);
}

// Zero in the chuck.
TEST(DefaultBar, EndsBeforeTheFaceThatIsCut) {
  const StockShape bar = StockPath()
                             .rapid({30, 0, 85})
                             .rapid({27, 0, 80})
                             .cut({0, 0, 80})
                             .rapid({0, 0, 82})
                             .rapid({24, 0, 82})
                             .cut({24, 0, 30})
                             .bar();
  EXPECT_EQ(bar.box.hi.z, 81);
}

TEST(DefaultBar, HasAWallAroundWhatIsBored) {
  StockPath path;
  path.rapid({15, 0, 2}).cut({15, 0, -30}).cut({14, 0, -30}).rapid({14, 0, 2});
  EXPECT_EQ(path.bar(ToolType::boring).outer_radius, 17);
  EXPECT_EQ(path.bar(ToolType::boring).box.hi.z, 0);
  path.rapid({14, 0, -20}).cut({18, 0, -20}).cut({14, 0, -20});  // and a recess
  EXPECT_EQ(path.bar(ToolType::boring).outer_radius, 20);
  StockPath across;  // G72 in a bore
  across.rapid({8.8, 0, 1}).cut({15, 0, 1}).rapid({8.8, 0, 1.3}).rapid({8.8, 0, -1});
  across.cut({15, 0, -1}).rapid({8.8, 0, -1});
  EXPECT_EQ(across.bar(ToolType::boring).outer_radius, 17);
  StockPath blade;
  blade.rapid({14, 0, -20}).cut({18, 0, -20}).cut({14, 0, -20}).rapid({14, 0, 2});
  Tool inside;
  inside.type = ToolType::grooving;
  inside.tip = 2;
  EXPECT_EQ(default_stock(blade.motions, std::vector<Tool>{inside}, true).shape.outer_radius, 20);
  const StockShape drilled = StockPath().rapid({0, 0, 2}).cut({0, 0, -30}).bar(ToolType::drill);
  EXPECT_EQ(drilled.outer_radius, 8);
  EXPECT_EQ(drilled.box.hi.z, 0);
}

// A boring bar that goes in with a rapid where nothing was drilled: the raw part is hollow.
TEST(DefaultBar, IsHollowWhereABoringBarGoesIn) {
  StockPath pass;
  pass.rapid({19.04, 0, 2}).rapid({20.5, 0, 2}).cut({20.5, 0, -30}).cut({19.04, 0, -30});
  pass.rapid({19.04, 0, 2}).rapid({21, 0, 2}).cut({21, 0, -30}).rapid({20.8, 0, -29});
  const StockShape tube = pass.bar(ToolType::boring);
  EXPECT_EQ(tube.kind, StockShape::Kind::tube);
  EXPECT_EQ(tube.inner_radius, 19.1);
  EXPECT_EQ(tube.description, "around the program's cuts: tube:48,38.2,-33,0");
  EXPECT_EQ(pass.bar().kind, StockShape::Kind::cylinder);  // outside
  StockPath groove;
  groove.rapid({8, 0, 3}).rapid({8, 0, -8}).cut({12, 0, -8}).cut({8, 0, -8}).rapid({8, 0, 3});
  EXPECT_EQ(groove.bar(ToolType::boring).inner_radius, 8);
  // From the axis, and out with the feed: nothing tells of a hole.
  StockPath solid;
  solid.rapid({0, 0, 3}).cut({0, 0, -20}).cut({5, 0, -20}).cut({5, 0, 3});
  EXPECT_EQ(solid.bar(ToolType::boring).kind, StockShape::Kind::cylinder);
}

}  // namespace
}  // namespace mrsim
