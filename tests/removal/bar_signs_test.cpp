// Bars of lathes whose program does not count from the front: zero at a shoulder or in the chuck,
// a counter spindle, a raw part with a hole.
#include "removal/part/bar_signs.h"

#include "core/numbers/units.h"
#include "support/stock_path.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// A spigot in front of Z0, turned in levels that end at its shoulder, without a face at its end.
TEST(BarSigns, BeginsWhereANeckInFrontOfZeroIsCut) {
  StockPath neck;
  neck.rapid({30, 0, 12}).cut({30, 0, -10}).cut({32, 0, -10}).rapid({32, 0, 12});
  neck.rapid({25, 0, 12}).cut({25, 0, 0.1}).cut({30, 0, 0.1}).rapid({30, 0, 12});
  neck.rapid({20, 0, 12}).cut({20, 0, 0}).cut({31, 0, 0}).rapid({31, 0, 50});
  EXPECT_EQ(neck.bar().box.hi.z, 12);
  EXPECT_NE(neck.guesses(), "");
  StockPath off;  // and parted off behind
  off.rapid({30, 0, 12}).rapid({20, 0, 12}).cut({20, 0, 0}).cut({30, 0, 0}).cut({30, 0, -5});
  off.cut({32, 0, -5}).rapid({32, 0, -8}).cut({-0.5, 0, -8}).rapid({32, 0, -8});
  EXPECT_EQ(off.bar().box.hi.z, 12);
  StockPath low;  // 5 mm high
  low.rapid({25, 0, 7}).cut({25, 0, 0.1}).cut({30, 0, 0.1}).rapid({30, 0, 7});
  low.rapid({20, 0, 7}).cut({20, 0, 0}).cut({31, 0, 0}).cut({31, 0, -20}).rapid({32, 0, 7});
  EXPECT_EQ(low.bar().box.hi.z, 7);
  EXPECT_NE(low.guesses(), "");
}

TEST(BarSigns, BeginsWhereCutsDoWithZeroInTheChuck) {
  StockPath shaft;  // turned behind Z0, and parted off there
  shaft.rapid({23, 0, 62}).cut({23, 0, -2}).cut({26, 0, -2}).rapid({26, 0, 62});
  shaft.rapid({20, 0, 62}).cut({20, 0, -2}).cut({26, 0, -2}).rapid({27, 0, -3});
  shaft.cut({-0.5, 0, -3}).rapid({27, 0, -3});
  EXPECT_EQ(shaft.bar().box.hi.z, 62);
  EXPECT_EQ(shaft.guesses(),
            "tools begin to cut 62 mm in front of the zero, and the bar is taken to begin there");
  StockPath groove;  // or with a groove in front of Z0
  groove.rapid({23, 0, 62}).cut({23, 0, 10}).cut({26, 0, 10}).rapid({26, 0, 62});
  groove.rapid({20, 0, 62}).cut({20, 0, 20}).cut({26, 0, 20}).rapid({27, 0, 30});
  EXPECT_EQ(groove.cut({15, 0, 30}).rapid({27, 0, 30}).bar().box.hi.z, 62);
  StockPath plunge;  // where a pass begins, too
  plunge.rapid({23, 0, 52}).cut({23, 0, -2}).cut({27, 0, -2}).rapid({27, 0, 52});
  plunge.rapid({25, 0, 25}).cut({18, 0, 25}).cut({18, 0, -2}).cut({25, 0, -2});
  EXPECT_EQ(plunge.rapid({25, 0, 60}).bar().box.hi.z, 52);
  StockPath cone;  // that the last cut leaves behind
  cone.rapid({15, 0, 62}).cut({25, 0, -1}).cut({27, 0, -1}).rapid({28, 0, -4});
  EXPECT_EQ(cone.cut({-0.5, 0, -4}).rapid({28, 0, -4}).bar().box.hi.z, 62);
  StockPath inward;  // narrower towards the chuck
  inward.rapid({27, 0, 52}).cut({20, 0, 52}).cut({15, 0, 40}).cut({15, 0, -2}).cut({27, 0, -2});
  EXPECT_EQ(inward.rapid({27, 0, 60}).bar().box.hi.z, 52);
}

// A groove or a cut-off alone does not show how far the bar reaches beyond it.
TEST(BarSigns, TellsThatNothingShowsTheFront) {
  StockPath off;
  off.rapid({27, 0, 40}).cut({-0.5, 0, 40}).rapid({27, 0, 40});
  EXPECT_EQ(off.bar(ToolType::grooving).box.hi.z, 40);
  EXPECT_EQ(off.guesses(ToolType::grooving),
            "nothing faces the bar, which is taken to begin 40 mm in front of the zero");
  EXPECT_EQ(off.guesses(), "");  // a face
}

// The same program at another zero is cut from the same bar.
TEST(BarSigns, TellsTheSameBarWhereverTheFacedFrontIs) {
  const auto bar_at = [](double z) {
    StockPath path;
    path.rapid({30, 0, z + 1.4}).cut({26.4, 0, z + 1.4}).cut({25, 0, z}).cut({-0.8, 0, z});
    path.rapid({-0.8, 0, z + 2}).rapid({22, 0, z + 15}).cut({22, 0, z - 30});
    path.cut({25, 0, z - 30}).rapid({30, 0, z + 5});
    EXPECT_EQ(path.guesses(), "");
    return path.bar();
  };
  EXPECT_EQ(bar_at(0).outer_radius, 25);
  EXPECT_EQ(bar_at(80).outer_radius, bar_at(0).outer_radius);
  EXPECT_EQ(bar_at(80).box.hi.z, bar_at(0).box.hi.z + 80);
}

// Long ways through the air in front of passes behind Z0; and one among others.
TEST(BarSigns, BeginsAtZeroWherePassesReachFarBehind) {
  StockPath shaft;
  shaft.rapid({20, 0, 22}).cut({20, 0, -30}).cut({22, 0, -30}).rapid({22, 0, 22});
  shaft.rapid({15, 0, 22}).cut({15, 0, -10}).cut({20, 0, -10}).rapid({20, 0, 22});
  EXPECT_EQ(shaft.bar().box.hi.z, 0);
  EXPECT_EQ(
      shaft.guesses(),
      "tools begin to cut 22 mm in front of the zero, and the bar is taken to begin behind that");
  shaft.rapid({14, 0, 2}).cut({14, 0, -8}).cut({15, 0, -8}).rapid({15, 0, 2});
  shaft.rapid({13, 0, 2}).cut({13, 0, -8}).cut({15, 0, -8}).rapid({15, 0, 2});
  shaft.rapid({12, 0, 2}).cut({12, 0, -8}).cut({15, 0, -8}).rapid({15, 0, 2});
  EXPECT_EQ(shaft.bar().box.hi.z, 0);
  EXPECT_EQ(shaft.guesses(), "");
  StockPath slope;  // in the place of a rapid
  slope.rapid({50, 0, 50}).cut({26, 0, 2}).cut({23, 0, 2}).cut({23, 0, -20}).cut({26, 0, -20});
  EXPECT_EQ(slope.rapid({50, 0, 50}).guesses(), "");
  StockPath faced;
  faced.rapid({25, 0, 0}).cut({-0.8, 0, 0}).rapid({-0.8, 0, 30}).rapid({20, 0, 30});
  EXPECT_EQ(faced.cut({20, 0, -5}).rapid({30, 0, 30}).guesses(), "");
}

// A face that is roughed in levels of G71 down to the axis, then finished.
TEST(BarSigns, IsNoGuessWhereAFaceFollows) {
  StockPath rough;
  rough.rapid({20, 0, 2}).rapid({15, 0, 2}).cut({15, 0, 0.1}).rapid({16, 0, 1}).rapid({16, 0, 2});
  rough.rapid({10, 0, 2}).cut({10, 0, 0.1}).rapid({11, 0, 1}).rapid({11, 0, 2});
  rough.rapid({0, 0, 2}).cut({0, 0, 0}).cut({18, 0, 0}).cut({18, 0, -20}).cut({21, 0, -20});
  EXPECT_EQ(rough.bar().box.hi.z, 0);
  EXPECT_EQ(rough.guesses(), "");
}

TEST(BarSigns, TurnsRoundWhatACounterSpindleHolds) {
  StockPath shaft;
  shaft.rapid({26, 0, -2}).rapid({23, 0, -2}).cut({23, 0, 30}).cut({26, 0, 30});
  shaft.rapid({26, 0, -2}).rapid({20, 0, -2}).cut({20, 0, 20}).cut({23, 0, 20});
  shaft.rapid({26, 0, -2}).rapid({26, 0, 0}).cut({-0.8, 0, 0}).rapid({-0.8, 0, -50});
  const StockShape bar = shaft.bar();
  EXPECT_EQ(bar.outer_radius, 26);
  EXPECT_EQ(bar.box.lo.z, -1);
  EXPECT_EQ(bar.box.hi.z, 33);
  EXPECT_EQ(bar.description, "around the program's cuts: cylinder:52,-1,33");
  EXPECT_NE(shaft.guesses(), "");
  const StockShape drilled = StockPath().rapid({0, 0, -2}).cut({0, 0, 30}).bar(ToolType::drill);
  EXPECT_EQ(drilled.box.lo.z, 0);
  EXPECT_EQ(drilled.box.hi.z, 32);
  StockPath groove;  // from a plunge behind Z0 towards it, at an ordinary bar
  groove.rapid({22, 0, -30}).cut({20, 0, -30}).cut({20, 0, -10}).cut({22, 0, -10});
  EXPECT_EQ(groove.rapid({22, 0, 5}).bar().box.hi.z, 0);
}

// Passes from the chuck outwards, and levels of a face with the feed back, at an ordinary bar.
TEST(BarSigns, IsHeldAtMinusWhereToolsComeFromPlus) {
  StockPath prime;
  prime.rapid({30, 0, 2}).rapid({30, 0, -40}).cut({23, 0, -40}).cut({23, 0, 2}).rapid({30, 0, 2});
  prime.rapid({30, 0, -40}).rapid({21, 0, -40}).cut({21, 0, 2}).rapid({30, 0, 2});
  EXPECT_EQ(prime.bar().box.hi.z, 0);
  EXPECT_EQ(prime.guesses(),
            "all tools cut towards +Z, and the bar is taken to be held at its end towards -Z");
  StockPath faces;
  faces.rapid({26, 0, 2}).rapid({26, 0, -1}).cut({10, 0, -1}).cut({10, 0, 2});
  faces.rapid({26, 0, 2}).rapid({26, 0, -2}).cut({10, 0, -2}).cut({10, 0, 2});
  EXPECT_LT(faces.bar().box.lo.z, -2);
  EXPECT_EQ(faces.guesses(), "");
  StockPath out;  // with the feed in front, too
  out.rapid({27, 0, 0}).cut({-0.5, 0, 0}).cut({-0.5, 0, 2}).cut({27, 0, 2}).rapid({30, 0, 2});
  EXPECT_EQ(out.guesses(), "");
}

// A centre drill from 15 mm, or a stop, before the face; and a hole that the face leads to.
TEST(BarSigns, BeginsAtTheFaceThatAnInsertCuts) {
  StockPath centred;
  centred.rapid({0, 0, 15}).cut({0, 0, -4}).rapid({0, 0, 100});
  centred.rapid({27, 0, 0}).cut({-0.8, 0, 0}).rapid({27, 0, 5}).rapid({23, 0, 5});
  EXPECT_EQ(centred.cut({23, 0, -30}).cut({26, 0, -30}).bar().box.hi.z, 1);
  EXPECT_EQ(centred.guesses(), "");
  StockPath drilled;
  drilled.rapid({0, 0, 20}).cut({0, 0, -30}).rapid({0, 0, 100});
  drilled.by(1).rapid({27, 0, 0}).cut({7, 0, 0}).rapid({27, 0, 5}).rapid({23, 0, 5});
  drilled.cut({23, 0, -30}).cut({26, 0, -30});
  std::vector<Tool> tools(2);
  tools[0].type = ToolType::drill;
  tools[0].diameter = 16;
  tools[1].type = ToolType::turning;
  const AssumedStock bar = default_stock(drilled.motions, tools, true);
  EXPECT_EQ(bar.shape.box.hi.z, 1);
  EXPECT_EQ(bar.guesses, "");
  StockPath off;  // the blade parts off at the zero, which is in the chuck
  off.rapid({23, 0, 62}).cut({23, 0, -2}).cut({26, 0, -2}).rapid({26, 0, 62});
  off.by(1).rapid({26, 0, 0}).cut({-0.5, 0, 0}).rapid({26, 0, 0});
  tools = {tools[1], tools[1]};
  tools[1].type = ToolType::grooving;
  EXPECT_EQ(default_stock(off.motions, tools, true).shape.box.hi.z, 62);
}

// G71 leaves an allowance of W in front of where it begins, 10 mm before the bar.
TEST(BarSigns, BeginsAtZeroWhereRoughingAddsItsAllowance) {
  StockPath rough;
  rough.rapid({25, 0, 10.2}).cut({25, 0, -2.8}).cut({26, 0, -1.8}).rapid({26, 0, 10.2});
  rough.rapid({23, 0, 10.2}).cut({23, 0, -2.8}).cut({24, 0, -1.8}).rapid({26, 0, 10.2});
  EXPECT_EQ(rough.bar().box.hi.z, 0);
  EXPECT_EQ(rough.guesses(), "");
}

// The way back beside the bar, with the feed after a rapid.
TEST(BarSigns, IsNotTurnedRoundByAWayOutBesideIt) {
  StockPath face;
  face.rapid({27, 0, 0}).cut({-0.8, 0, 0}).rapid({27, 0, 0}).cut({27, 0, 5}).rapid({50, 0, 5});
  const StockShape bar = face.bar();
  EXPECT_LT(bar.box.lo.z, 0);
  EXPECT_GE(bar.box.hi.z, 0);
  EXPECT_EQ(face.guesses(), "");
  StockPath neck;  // whose groove begins beside the neck alone, at a counter spindle
  neck.rapid({23, 0, -2}).cut({23, 0, 30}).cut({26, 0, 30}).rapid({26, 0, -2}).rapid({17, 0, -2});
  neck.cut({17, 0, 10}).cut({23, 0, 10}).rapid({23, 0, 5}).rapid({18, 0, 5}).cut({15, 0, 5});
  EXPECT_EQ(neck.rapid({26, 0, 5}).bar().box.hi.z, 33);
}

// In with the feed, to and fro: a bar leaves no core, so there was a hole.
TEST(BarSigns, HasAHoleWhereABoringBarFeedsIn) {
  StockPath bore;
  bore.rapid({15, 0, 2}).cut({15, 0, -30}).cut({16, 0, -30}).cut({16, 0, 2}).cut({17, 0, 2});
  bore.cut({17, 0, -30}).rapid({17, 0, 2}).rapid({17, 0, 50});
  const StockShape tube = bore.bar(ToolType::boring);
  EXPECT_EQ(tube.kind, StockShape::Kind::tube);
  EXPECT_EQ(tube.inner_radius, 14);
  EXPECT_EQ(bore.guesses(ToolType::boring),
            "a boring bar goes in where nothing drills before, and a hole of 28 mm is taken to be "
            "there");
  StockPath blind;  // its floor, up to the axis
  blind.rapid({5, 0, 2}).cut({5, 0, -10}).cut({0, 0, -10}).rapid({0, 0, 2});
  EXPECT_EQ(blind.bar(ToolType::boring).kind, StockShape::Kind::cylinder);
}

TEST(BarSigns, MirrorsArcsAndTips) {
  StockPath path;
  path.rapid({10, 0, 0}).arc({12, 0, -2}, {12, 0, 0}, radians(90), {0, 1, 0});
  const std::vector<Motion> mirrored = mirrored_in_z(path.motions);
  EXPECT_EQ(mirrored[1].end.z, 2);
  EXPECT_EQ(mirrored[1].sweep, -radians(90));
  Tool tool;
  tool.tip = 3;
  EXPECT_EQ(mirrored_in_z(std::vector<Tool>{tool})[0].tip, 4);
  EXPECT_TRUE(mirrored_in_z(std::vector<Tool>{tool})[0].left_hand);
}

}  // namespace
}  // namespace mrsim
