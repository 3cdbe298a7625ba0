// The stock of a run that gives none.
#include "removal/part/default_stock.h"

#include "core/units.h"
#include "core/vec.h"

#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

class Path {
 public:
  Path& rapid(Vec3 to) { return add(MotionKind::rapid, to); }
  Path& cut(Vec3 to) { return add(MotionKind::line, to); }
  // Half a turn about the Y axis, upwards or down, or a quarter up.
  Path& arc(Vec3 to, Vec3 center, double turns) {
    add(MotionKind::arc, to);
    Motion& m = motions_.back();
    m.center = center;
    m.axis = {0, 1, 0};
    m.radius = length(m.start - center);
    m.sweep = turns * kTwoPi;
    return *this;
  }
  Box3 box(double zero = 0) const {
    Tool tool;
    tool.diameter = 4;
    return default_stock(motions_, std::vector<Tool>{tool}, false, zero).box;
  }
  double top(double zero = 0) const { return box(zero).hi.z; }
  StockShape bar(ToolType type = ToolType::turning, double zero = 0) const {
    Tool tool;
    tool.type = type;
    tool.diameter = 12;
    if (type == ToolType::turning) tool.lead_angle = radians(95);
    return default_stock(motions_, std::vector<Tool>{tool}, true, zero);
  }

 private:
  Path& add(MotionKind kind, Vec3 to) {
    Motion m;
    m.kind = kind;
    m.start = at_;
    m.end = at_ = to;
    m.tool = 0;
    motions_.push_back(m);
    return *this;
  }
  Vec3 at_{0, 0, 20};
  std::vector<Motion> motions_;
};

TEST(DefaultStock, EndsAtTheProgramsZeroAboveItsCuts) {
  EXPECT_EQ(Path()
                .rapid({0, 0, 5})
                .cut({0, 0, -1})
                .cut({50, 0, -1})
                .cut({50, 0, -3})
                .cut({0, 0, -3})
                .top(),
            0);
  // A ramp from the approach down: its upper end is in the air.
  EXPECT_EQ(Path().rapid({0, 0, 5}).cut({9, 0, -1}).cut({50, 0, -1}).cut({50, 9, -4}).top(), 0);
  // A ramp of several moves that begins in the air, by a later tool.
  EXPECT_EQ(Path()
                .rapid({0, 0, 5})
                .cut({0, 0, -1})
                .cut({50, 0, -1})
                .rapid({0, 0, 2})
                .cut({0, 0, 1})
                .cut({9, 0, 0.5})
                .cut({0, 0, -0.5})
                .cut({9, 0, -4})
                .cut({50, 9, -4})
                .top(),
            0);
  // A feed aside at the clearance, then a plunge or a ramp through the zero.
  EXPECT_EQ(Path()
                .rapid({0, 0, 2})
                .cut({9, 9, 2})
                .cut({9, 9, -3})
                .cut({50, 9, -3})
                .rapid({50, 9, 1})
                .cut({50, 20, 1})
                .cut({60, 20, -1})
                .cut({60, 30, -2})
                .top(),
            0);
  // Levels above the zero that a feed goes down between are cuts.
  EXPECT_EQ(Path()
                .rapid({0, 0, 25})
                .rapid({0, 0, 20})
                .cut({50, 0, 20})
                .cut({50, 0, 18})
                .cut({0, 0, 18})
                .rapid({0, 0, 25})
                .cut({0, 0, -1})
                .cut({9, 0, -1})
                .top(),
            20);
  // One level, and a rapid close above.
  EXPECT_EQ(Path().rapid({0, 0, 2}).cut({0, 0, -4}).cut({50, 0, -4}).rapid({50, 0, 2}).top(), 0);
  // A hole that is drilled from above the contour's only level.
  EXPECT_EQ(Path()
                .rapid({0, 0, 2})
                .cut({0, 0, -5})
                .cut({50, 0, -5})
                .rapid({20, 20, 2})
                .cut({20, 20, -12})
                .top(),
            0);
  // Faced at zero: the levels below say that there is more.
  EXPECT_EQ(Path().rapid({0, 0, 5}).cut({0, 0, 0}).cut({50, 0, 0}).cut({50, 0, -2}).top(), 0);
}

// A work offset that the program sets by G10 in the coordinates of the machine.
TEST(DefaultStock, TakesTheZeroOfTheWorkOffset) {
  const auto path = [](double zero) {
    return Path()
        .rapid({0, 0, zero + 5})
        .cut({0, 0, zero - 3})
        .cut({50, 0, zero - 3})
        .rapid({50, 0, zero + 5});
  };
  EXPECT_EQ(path(-420.5).top(-420.5), -420.5);
  EXPECT_EQ(path(100).top(100), 100);
  EXPECT_EQ(
      Path().rapid({9, 0, 70}).cut({9, 0, 69}).cut({0, 0, 69}).bar(ToolType::turning, 70).box.hi.z,
      70);
}

TEST(DefaultStock, EndsAtTheHighestCutBelowTheFirstPlungeWhereZeroIsElsewhere) {
  EXPECT_EQ(Path()
                .rapid({0, 0, 30})
                .cut({0, 0, 20})
                .cut({50, 0, 20})
                .cut({50, 0, 15})
                .cut({0, 0, 15})
                .top(),
            20);
  // One level: something is cut, and no rapid meets it.
  EXPECT_EQ(Path().rapid({0, 0, 30}).cut({0, 0, 20}).cut({50, 0, 20}).top(), 23);
  EXPECT_EQ(Path().rapid({0, 0, 22}).cut({0, 0, 20}).cut({50, 0, 20}).top(), 22);
  EXPECT_EQ(Path().rapid({0, 0, 5}).cut({0, 0, 0}).cut({50, 0, 0}).top(), 3);
}

// Strokes of a hole begin in the hole.
TEST(DefaultStock, StrokesOfAHoleAreNoClearance) {
  Path path;
  path.rapid({0, 0, 30}).cut({0, 0, 10}).cut({80, 0, 10}).rapid({80, 0, 30});
  path.rapid({20, 20, 22}).cut({20, 20, 17}).rapid({20, 20, 22}).rapid({20, 20, 17.25});
  path.cut({20, 20, 9}).rapid({20, 20, 10.25}).cut({20, 20, 2}).rapid({20, 20, 22});
  EXPECT_EQ(path.top(), 15);  // a margin above the contour
}

TEST(DefaultStock, HolesEndAtZeroOrWhereTheFeedBegins) {
  EXPECT_EQ(Path().rapid({0, 0, 2}).cut({0, 0, -12}).rapid({0, 0, 2}).top(), 0);
  EXPECT_EQ(Path().rapid({0, 0, 2}).cut({0, 0, -12}).cut({0, 0, 2}).top(), 0);  // tapped
  EXPECT_EQ(Path().rapid({0, 0, 22}).cut({0, 0, 8}).rapid({0, 0, 22}).top(), 22);
  EXPECT_EQ(Path().rapid({0, 0, -3}).cut({0, 0, -12}).rapid({0, 0, 2}).top(), -3);
}

// What an upright arc cuts lies between its ends, not at them.
TEST(DefaultStock, KnowsHowFarUprightArcsReach) {
  const Box3 trough = Path()
                          .rapid({-25, 0, 5})
                          .rapid({-25, 0, 0})
                          .cut({-20, 0, 0})
                          .arc({20, 0, 0}, {0, 0, 0}, -0.5)
                          .box();
  EXPECT_EQ(trough.hi.z, 0);
  EXPECT_EQ(trough.lo.x, -30);
  EXPECT_EQ(trough.lo.z, -23);
  EXPECT_EQ(Path().rapid({-25, 0, 5}).cut({-20, 0, 0}).arc({20, 0, 0}, {0, 0, 0}, 0.5).box().hi.z,
            20);
  // A way out on a quarter of a circle ends in the air, as a way in begins there.
  EXPECT_EQ(Path()
                .rapid({0, 0, 5})
                .cut({0, 0, -1})
                .cut({50, 0, -1})
                .arc({53, 0, 2}, {50, 0, 2}, -0.25)
                .rapid({53, 0, 5})
                .top(),
            0);
}

// A contour that a rapid goes down for beside the part: that place is not inside the stock.
TEST(DefaultStock, LeavesOutWhereARapidGoesDownBeside) {
  const Box3 box = Path()
                       .rapid({-20, 30, 5})
                       .rapid({-20, 30, -6})
                       .cut({0, 0, -6})
                       .cut({80, 0, -6})
                       .cut({80, 60, -6})
                       .cut({0, 60, -6})
                       .cut({0, 0, -6})
                       .rapid({0, 0, 5})
                       .rapid({-20, 30, 5})
                       .rapid({-20, 30, -9})
                       .cut({80, 0, -9})
                       .box();
  EXPECT_EQ(box.hi.z, 0);
  EXPECT_NEAR(box.lo.x, -17.9, 1e-9);
  EXPECT_EQ(box.lo.y, -8);
  EXPECT_EQ(box.hi.x, 88);
}

// Near a corner the side counts along which the cut goes on, not the nearest: a face mill has been
// far beside the part before, then an edge is milled along X.
TEST(DefaultStock, KeepsTheEdgeThatIsMilled) {
  const Box3 box = Path()
                       .rapid({-60, 20, 5})
                       .rapid({-60, 20, 0})
                       .cut({160, 20, 0})
                       .rapid({160, 20, 5})
                       .rapid({-12, -1, 5})
                       .rapid({-12, -1, -6})
                       .cut({112, -1, -6})
                       .rapid({112, -1, 5})
                       .box();
  EXPECT_EQ(box.hi.z, 0);
  EXPECT_NEAR(box.lo.x, -9.9, 1e-9);
  EXPECT_EQ(box.lo.y, -15);
}

// A slot in two levels: behind its end a rapid goes deeper than the first has cut.
TEST(DefaultStock, EndsBesideARapidBelowTheLevelBefore) {
  const Box3 box = Path()
                       .rapid({-20, 0, 5})
                       .rapid({-20, 0, -10})
                       .cut({120, 0, -10})
                       .rapid({120, 0, -20})
                       .cut({-20, 0, -20})
                       .rapid({-20, 0, 5})
                       .box();
  EXPECT_NEAR(box.lo.x, -17.9, 1e-9);
  EXPECT_NEAR(box.hi.x, 117.9, 1e-9);
}

// From row to row of a raster a rapid goes down a little, over what the next row cuts.
TEST(DefaultStock, KeepsTheEndsOfRowsThatARapidJoins) {
  const Box3 box = Path()
                       .rapid({0, 0, 5})
                       .cut({0, 0, -2})
                       .cut({100, 0, -2})
                       .rapid({100, 1, -2.2})
                       .cut({0, 1, -2.4})
                       .rapid({0, 2, -2.6})
                       .cut({100, 2, -2})
                       .rapid({100, 2, 5})
                       .box();
  EXPECT_GE(box.hi.x, 100);
  EXPECT_LE(box.lo.x, 0);
}

// Down beside the part, and on at that height to where the cut begins.
TEST(DefaultStock, EndsBesideRapidsThatGoOnBelowTheTop) {
  const Box3 box = Path()
                       .rapid({-15, -15, 5})
                       .rapid({-15, -15, -8})
                       .rapid({-2, -10, -8})
                       .cut({-2, 42, -8})
                       .cut({62, 42, -8})
                       .cut({62, -2, -8})
                       .cut({-10, -2, -8})
                       .rapid({-10, -2, 5})
                       .box();
  EXPECT_LE(box.lo.x, -4) << "the edge along Y is milled";
  EXPECT_NEAR(box.lo.y, -7.9, 1e-9);
}

// A hole on a step is begun below the top: the holes beside it stay in the stock.
TEST(DefaultStock, KeepsHolesBesideOneThatIsBegunBelowTheTop) {
  Path path;
  for (const double y : {0, 20, 40, 60, 80}) path.rapid({0, y, 2}).cut({0, y, -9}).rapid({0, y, 2});
  path.rapid({0, 100, 2}).rapid({0, 100, -3}).cut({0, 100, -9}).rapid({0, 100, 2});
  path.rapid({70, 0, 2}).cut({70, 0, -9}).rapid({70, 0, 2});
  const Box3 box = path.box();
  EXPECT_LT(box.lo.x, -2);
  EXPECT_EQ(box.hi.z, 0);
}

// A rapid back into a pocket changes nothing.
TEST(DefaultStock, KeepsThePlacesThatHaveBeenCut) {
  const Box3 box = Path()
                       .rapid({0, 0, 5})
                       .cut({0, 0, -6})
                       .cut({80, 0, -6})
                       .rapid({80, 0, 5})
                       .rapid({0, 0, 5})
                       .rapid({0, 0, -5})
                       .cut({0, 0, -9})
                       .cut({80, 0, -9})
                       .box();
  EXPECT_EQ(box.hi.z, 0);
  EXPECT_EQ(box.lo.x, -7);
}

// In the middle there is no side to draw in: the top is where the first cut is.
TEST(DefaultStock, ARapidIntoTheMiddleSaysWhereTheTopIs) {
  const Box3 box = Path()
                       .rapid({40, 40, -1})
                       .cut({0, 0, -1})
                       .cut({80, 0, -1})
                       .cut({80, 80, -1})
                       .cut({0, 80, -3})
                       .box();
  EXPECT_EQ(box.hi.z, -1);
  EXPECT_EQ(box.lo.x, -7);
}

// Faced at zero, turned in two passes, parted off from outside the bar.
TEST(DefaultStock, ABarEndsWhereRapidsGo) {
  const StockShape bar = Path()
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
TEST(DefaultStock, ABarEndsBelowWhereLevelsBegin) {
  EXPECT_NEAR(Path()
                  .rapid({62.25, 0, -2})
                  .cut({35, 0, -2})
                  .rapid({62.25, 0, -2})
                  .rapid({62.25, 0, -4})
                  .cut({35, 0, -4})
                  .bar()
                  .outer_radius,
              62.2, 1e-9);
}

// Zero in the chuck: what is turned lies above it, whatever is parted off below.
TEST(DefaultStock, ABarEndsWhereCutsBeginWithZeroInTheChuck) {
  const StockShape bar = Path()
                             .rapid({31, 0, 51})
                             .cut({15, 0, 51})
                             .cut({20, 0, 45})
                             .cut({20, 0, 10})
                             .rapid({45, 0, -40})
                             .cut({-0.5, 0, -40})
                             .bar();
  EXPECT_EQ(bar.box.hi.z, 51);
}

TEST(DefaultStock, ABarOfAContourEndsAtZero) {
  const StockShape bar = Path()
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
TEST(DefaultStock, ABarIsNoWiderThanWhereRapidsGoBeforeAnyCut) {
  const StockShape bar = Path()
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
TEST(DefaultStock, ABarIsNoWiderThanWhereLevelsOfAFaceBegin) {
  EXPECT_EQ(Path()
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

// Rapids back within the part, and a feed move to the first pass in the air, tell nothing.
TEST(DefaultStock, ABarEndsAtZeroWhateverIsInside) {
  const StockShape bar = Path()
                             .rapid({32, 0, 2})
                             .cut({20, 0, 2})
                             .cut({20, 0, -30})
                             .cut({25, 0, -35})
                             .cut({30, 0, -35})
                             .rapid({29.5, 0, -34.5})
                             .rapid({32, 0, 2})
                             .bar();
  EXPECT_EQ(bar.box.hi.z, 0);
  const StockShape groove = Path().rapid({12, 0, 4}).rapid({16, 0, -25}).cut({12, 0, -25}).bar();
  EXPECT_EQ(groove.box.hi.z, 0);
  EXPECT_EQ(groove.outer_radius, 16);  // not 12: nothing would be cut
}

// Zero in the chuck.
TEST(DefaultStock, ABarEndsBeforeTheFaceThatIsCut) {
  const StockShape bar = Path()
                             .rapid({30, 0, 85})
                             .rapid({27, 0, 80})
                             .cut({0, 0, 80})
                             .rapid({0, 0, 82})
                             .rapid({24, 0, 82})
                             .cut({24, 0, 30})
                             .bar();
  EXPECT_EQ(bar.box.hi.z, 81);
}

TEST(DefaultStock, ABarHasAWallAroundWhatIsBored) {
  Path path;
  path.rapid({15, 0, 2}).cut({15, 0, -30}).cut({14, 0, -30}).rapid({14, 0, 2});
  EXPECT_EQ(path.bar(ToolType::boring).outer_radius, 17);
  EXPECT_EQ(path.bar(ToolType::boring).box.hi.z, 0);
  Path across;  // G72 in a bore
  across.rapid({8.8, 0, 1}).cut({15, 0, 1}).rapid({8.8, 0, 1.3}).rapid({8.8, 0, -1});
  across.cut({15, 0, -1}).rapid({8.8, 0, -1});
  EXPECT_EQ(across.bar(ToolType::boring).outer_radius, 17);
  const StockShape drilled = Path().rapid({0, 0, 2}).cut({0, 0, -30}).bar(ToolType::drill);
  EXPECT_EQ(drilled.outer_radius, 8);
  EXPECT_EQ(drilled.box.hi.z, 0);
}

}  // namespace
}  // namespace mrsim
