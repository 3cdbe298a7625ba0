// The stock of a run that gives none, on mills.
#include "core/numbers/units.h"
#include "support/stock_path.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(DefaultStock, EndsAtTheProgramsZeroAboveItsCuts) {
  EXPECT_EQ(StockPath()
                .rapid({0, 0, 5})
                .cut({0, 0, -1})
                .cut({50, 0, -1})
                .cut({50, 0, -3})
                .cut({0, 0, -3})
                .top(),
            0);
  // A ramp from the approach down: its upper end is in the air.
  EXPECT_EQ(StockPath().rapid({0, 0, 5}).cut({9, 0, -1}).cut({50, 0, -1}).cut({50, 9, -4}).top(),
            0);
  // A ramp of several moves that begins in the air, by a later tool.
  EXPECT_EQ(StockPath()
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
  EXPECT_EQ(StockPath()
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
  EXPECT_EQ(StockPath()
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
  EXPECT_EQ(StockPath().rapid({0, 0, 2}).cut({0, 0, -4}).cut({50, 0, -4}).rapid({50, 0, 2}).top(),
            0);
  // A hole that is drilled from above the contour's only level.
  EXPECT_EQ(StockPath()
                .rapid({0, 0, 2})
                .cut({0, 0, -5})
                .cut({50, 0, -5})
                .rapid({20, 20, 2})
                .cut({20, 20, -12})
                .top(),
            0);
  // Faced at zero: the levels below say that there is more.
  EXPECT_EQ(StockPath().rapid({0, 0, 5}).cut({0, 0, 0}).cut({50, 0, 0}).cut({50, 0, -2}).top(), 0);
}

// A work offset that the program sets by G10 in the coordinates of the machine.
TEST(DefaultStock, TakesTheZeroOfTheWorkOffset) {
  const auto path = [](double zero) {
    return StockPath()
        .rapid({0, 0, zero + 5})
        .cut({0, 0, zero - 3})
        .cut({50, 0, zero - 3})
        .rapid({50, 0, zero + 5});
  };
  EXPECT_EQ(path(-420.5).top(-420.5), -420.5);
  EXPECT_EQ(path(100).top(100), 100);
  EXPECT_EQ(StockPath()
                .rapid({9, 0, 70})
                .cut({9, 0, 69})
                .cut({0, 0, 69})
                .bar(ToolType::turning, 70)
                .box.hi.z,
            70);
}

TEST(DefaultStock, EndsAtTheHighestCutBelowTheFirstPlungeWhereZeroIsElsewhere) {
  EXPECT_EQ(StockPath()
                .rapid({0, 0, 30})
                .cut({0, 0, 20})
                .cut({50, 0, 20})
                .cut({50, 0, 15})
                .cut({0, 0, 15})
                .top(),
            20);
  // One level: something is cut, and no rapid meets it.
  EXPECT_EQ(StockPath().rapid({0, 0, 30}).cut({0, 0, 20}).cut({50, 0, 20}).top(), 23);
  EXPECT_EQ(StockPath().rapid({0, 0, 22}).cut({0, 0, 20}).cut({50, 0, 20}).top(), 22);
  EXPECT_EQ(StockPath().rapid({0, 0, 5}).cut({0, 0, 0}).cut({50, 0, 0}).top(), 3);
}

// Strokes of a hole begin in the hole.
TEST(DefaultStock, StrokesOfAHoleAreNoClearance) {
  StockPath path;
  path.rapid({0, 0, 30}).cut({0, 0, 10}).cut({80, 0, 10}).rapid({80, 0, 30});
  path.rapid({20, 20, 22}).cut({20, 20, 17}).rapid({20, 20, 22}).rapid({20, 20, 17.25});
  path.cut({20, 20, 9}).rapid({20, 20, 10.25}).cut({20, 20, 2}).rapid({20, 20, 22});
  EXPECT_EQ(path.top(), 15);  // a margin above the contour
}

TEST(DefaultStock, HolesEndAtZeroOrWhereTheFeedBegins) {
  EXPECT_EQ(StockPath().rapid({0, 0, 2}).cut({0, 0, -12}).rapid({0, 0, 2}).top(), 0);
  EXPECT_EQ(StockPath().rapid({0, 0, 2}).cut({0, 0, -12}).cut({0, 0, 2}).top(), 0);  // tapped
  EXPECT_EQ(StockPath().rapid({0, 0, 22}).cut({0, 0, 8}).rapid({0, 0, 22}).top(), 22);
  EXPECT_EQ(StockPath().rapid({0, 0, -3}).cut({0, 0, -12}).rapid({0, 0, 2}).top(), -3);
}

// G83 R5. Q2. Z-7.: strokes from R end above the stock, whose top was at R for them.
TEST(DefaultStock, HolesInStrokesEndAtZeroToo) {
  StockPath top;
  top.rapid({0, 0, 5}).cut({0, 0, 3}).rapid({0, 0, 5}).rapid({0, 0, 3.25}).cut({0, 0, 1});
  top.rapid({0, 0, 5}).rapid({0, 0, 1.25}).cut({0, 0, -7}).rapid({0, 0, 5}).rapid({30, 0, 5});
  EXPECT_EQ(top.top(), 0);
  StockPath table;  // most strokes end above Z0
  table.rapid({0, 0, 22}).cut({0, 0, 14}).rapid({0, 0, 22}).rapid({0, 0, 15}).cut({0, 0, 6});
  EXPECT_EQ(table.rapid({0, 0, 22}).rapid({0, 0, 7}).cut({0, 0, -1}).rapid({0, 0, 22}).top(), 22);
}

// Posts that write G1 for rapids: their ways at the clearance were cuts, and the stock that high.
TEST(DefaultStock, FeedsAsideInTheAirAreNoCuts) {
  StockPath feeds;
  feeds.rapid({0, 0, 15}).cut({0, 0, 5}).cut({0, 0, 1}).cut({0, 0, -2}).cut({20, 0, -2});
  feeds.cut({20, 0, 5}).cut({20, 10, 5}).cut({20, 10, 1}).cut({20, 10, -2}).cut({0, 10, -2});
  EXPECT_EQ(StockPath(feeds).cut({0, 10, 15}).cut({0, 0, 15}).top(), 0);
  EXPECT_EQ(StockPath(feeds).cut({0, 10, 5}).cut({0, 20, 5}).cut({9, 20, -2}).top(), 0) << "ramp";
  StockPath holes;
  holes.rapid({0, 0, 15}).cut({0, 0, 5}).cut({0, 0, -10}).cut({0, 0, 5}).cut({20, 0, 5});
  EXPECT_EQ(holes.cut({20, 0, -10}).cut({20, 0, 5}).cut({20, 0, 15}).top(), 0);
  StockPath table;  // cuts from 8 down through the table
  table.rapid({0, 0, 30}).cut({0, 0, 8}).cut({20, 0, 8}).cut({20, 0, 12}).cut({0, 0, 12});
  EXPECT_EQ(table.cut({0, 0, 4}).cut({20, 0, 4}).cut({20, 0, -0.2}).cut({0, 0, -0.2}).top(), 8);
}

// A way that slants in the air, a way home behind the last cut, alone or with a last way up: they
// neither raise the top nor widen the box.
TEST(DefaultStock, SlantedFeedsInTheAirAndFeedsHomeAreNoCuts) {
  StockPath slot;
  slot.rapid({50, 50, 15}).cut({50, 50, -2}).cut({90, 50, -2}).cut({90, 50, 2});
  EXPECT_EQ(StockPath(slot).cut({90, 80, 5}).cut({90, 80, 1}).cut({90, 80, -2}).top(), 0);
  EXPECT_EQ(StockPath(slot).cut({90, 80, 1}).cut({90, 80, -2}).cut({80, 80, -2}).top(), 0);
  StockPath first;
  EXPECT_EQ(first.rapid({0, 0, 2}).cut({9, 9, 5}).cut({9, 9, -2}).cut({50, 9, -2}).top(), 0);
  const Box3 home = StockPath(slot).cut({0, 0, 2}).box();
  EXPECT_EQ(home.hi.z, 0);
  EXPECT_GT(home.lo.x, 40);
  EXPECT_EQ(StockPath(slot).cut({0, 50, 2}).cut({0, 0, 2}).top(), 0);
  EXPECT_EQ(StockPath(slot).cut({0, 0, 2}).cut({0, 0, 30}).top(), 0);
  EXPECT_EQ(StockPath(slot).rapid({90, 50, 20}).cut({0, 0, 20}).top(), 0);
  EXPECT_EQ(StockPath(slot).cut({70, 50, 2}).rapid({70, 50, 20}).top(), 2) << "a step";
  EXPECT_EQ(StockPath(slot).cut({90, 80, 5}).cut({90, 90, 5}).cut({90, 90, -2}).top(), 5);
  EXPECT_EQ(StockPath(slot).cut({50, 50, 2}).cut({50, 90, 2}).cut({50, 90, -2}).top(), 0) << "legs";
}

// Where the way up leads to more than one line, or nothing goes down behind it, it led to a cut.
TEST(DefaultStock, CutsThatAFeedLeadsUpToCount) {
  StockPath low;
  low.rapid({0, 0, 40}).cut({0, 0, 5}).cut({40, 0, 5}).cut({40, 0, 15});
  EXPECT_EQ(StockPath(low).cut({80, 0, 15}).rapid({80, 0, 40}).top(), 15);
  EXPECT_EQ(StockPath(low).cut({80, 0, 15}).cut({80, 40, 15}).cut({80, 40, 5}).top(), 15);
  StockPath middle;  // the zero lies between
  middle.rapid({0, 0, 40}).cut({0, 0, -5}).cut({40, 0, -5}).cut({40, 0, 3}).cut({40, 40, 3});
  EXPECT_EQ(middle.cut({0, 40, 3}).cut({0, 0, 3}).rapid({0, 0, 40}).top(), 3);
}

// G83 R2.5 Q0.5 Z-1.7 of a circuit board: most strokes end above the stock.
TEST(DefaultStock, ShallowHolesInStrokesEndAtZeroToo) {
  StockPath board;
  double from = 2.5;
  for (const double to : {2.0, 1.5, 1.0, 0.5, 0.0, -0.5, -1.0, -1.5, -1.7}) {
    board.rapid({0, 0, 2.5}).rapid({0, 0, from}).cut({0, 0, to});
    from = to + 0.1;
  }
  EXPECT_EQ(board.rapid({0, 0, 2.5}).rapid({20, 0, 2.5}).top(), 0);
}

// Rows of a slope that the zero passes, each with a rapid behind it.
TEST(DefaultStock, EndsOfSlopesAreCuts) {
  StockPath rows;
  rows.rapid({0, 0, 15}).cut({0, 0, -3}).cut({10, 0, 3}).rapid({10, 0, 15});
  EXPECT_EQ(rows.rapid({0, 2, 15}).cut({0, 2, -3}).cut({10, 2, 3}).rapid({10, 2, 15}).top(), 3);
}

// What an upright arc cuts lies between its ends, not at them.
TEST(DefaultStock, KnowsHowFarUprightArcsReach) {
  const Box3 trough = StockPath()
                          .rapid({-25, 0, 5})
                          .rapid({-25, 0, 0})
                          .cut({-20, 0, 0})
                          .arc({20, 0, 0}, {0, 0, 0}, -kPi, {0, 1, 0})
                          .box();
  EXPECT_EQ(trough.hi.z, 0);
  EXPECT_EQ(trough.lo.x, -30);
  EXPECT_EQ(trough.lo.z, -23);
  EXPECT_EQ(StockPath()
                .rapid({-25, 0, 5})
                .cut({-20, 0, 0})
                .arc({20, 0, 0}, {0, 0, 0}, kPi, {0, 1, 0})
                .box()
                .hi.z,
            20);
  // A way out on a quarter of a circle ends in the air, as a way in begins there.
  EXPECT_EQ(StockPath()
                .rapid({0, 0, 5})
                .cut({0, 0, -1})
                .cut({50, 0, -1})
                .arc({53, 0, 2}, {50, 0, 2}, -kPi / 2, {0, 1, 0})
                .rapid({53, 0, 5})
                .top(),
            0);
}

// A contour that a rapid goes down for beside the part: that place is not inside the stock.
TEST(DefaultStock, LeavesOutWhereARapidGoesDownBeside) {
  const Box3 box = StockPath()
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
  const Box3 box = StockPath()
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
  const Box3 box = StockPath()
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
  const Box3 box = StockPath()
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

// A face milled in passes: rapids lead from one to the next beside the part.
TEST(DefaultStock, EndsBesideLevelRapidsFromPassToPass) {
  const Box3 box = StockPath()
                       .rapid({-20, 0, 5})
                       .cut({-20, 0, -1})
                       .cut({120, 0, -1})
                       .rapid({120, 3, -1})
                       .cut({-20, 3, -1})
                       .rapid({-20, 6, -1})
                       .cut({120, 6, -1})
                       .rapid({120, 6, 5})
                       .box();
  EXPECT_EQ(box.hi.z, 0);
  EXPECT_NEAR(box.lo.x, -17.9, 1e-9);
  EXPECT_NEAR(box.hi.x, 117.9, 1e-9);
  EXPECT_EQ(box.lo.y, -10);
}

// From one pocket to the next without a way up: nothing says that the edge is none.
TEST(DefaultStock, KeepsWhatALevelRapidGoesThrough) {
  StockPath path;
  for (const double x : {0, 60}) {
    path.rapid({x, 0, x > 0 ? -5.0 : 5.0}).cut({x, 0, -5});
    for (double y = 0; y < 60; y += 2) path.cut({x + 30, y, -5}).cut({x, y + 2, -5});
    path.cut({x, 0, -5});
  }
  const Box3 box = path.box();
  EXPECT_EQ(box.lo.y, -7);
  EXPECT_EQ(box.lo.x, -7);
}

// Down beside the part, and on at that height to where the cut begins.
TEST(DefaultStock, EndsBesideRapidsThatGoOnBelowTheTop) {
  const Box3 box = StockPath()
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
  StockPath path;
  for (const double y : {0, 20, 40, 60, 80}) path.rapid({0, y, 2}).cut({0, y, -9}).rapid({0, y, 2});
  path.rapid({0, 100, 2}).rapid({0, 100, -3}).cut({0, 100, -9}).rapid({0, 100, 2});
  path.rapid({70, 0, 2}).cut({70, 0, -9}).rapid({70, 0, 2});
  const Box3 box = path.box();
  EXPECT_LT(box.lo.x, -2);
  EXPECT_EQ(box.hi.z, 0);
}

// A rapid back into a pocket changes nothing.
TEST(DefaultStock, KeepsThePlacesThatHaveBeenCut) {
  const Box3 box = StockPath()
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
  const Box3 box = StockPath()
                       .rapid({40, 40, -1})
                       .cut({0, 0, -1})
                       .cut({80, 0, -1})
                       .cut({80, 80, -1})
                       .cut({0, 80, -3})
                       .box();
  EXPECT_EQ(box.hi.z, -1);
  EXPECT_EQ(box.lo.x, -7);
}

}  // namespace
}  // namespace mrsim
