// G41/G42 and RND, CHF, CHR: where the tool's centre goes, worked out by hand.
#include "interp/support.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// "x,y" of the ends of all motions behind the first, with "a" before arcs.
std::string track(const Program& p, std::size_t from = 1) {
  std::string out;
  for (std::size_t i = from; i < p.motions.size(); ++i) {
    const Motion& m = p.motions[i];
    out += fmt::format("{}{}{},{}", out.empty() ? "" : " ", m.kind == MotionKind::arc ? "a" : "",
                       number_text(std::round(m.end.x * 1e4) / 1e4),
                       number_text(std::round(m.end.y * 1e4) / 1e4));
  }
  return out;
}

constexpr const char* kSquare =
    "G0 X-20 Y-20\nG41 G1 X0 Y0 D1 F100\nY40\nX40\nY0\nX0\nG40 X-20 Y-20\n";

TEST(Compensation, OutsideCornersAreArcsOrIntersections) {
  EXPECT_EQ(track(read_text(kSquare, at_origin(Dialect::sinumerik))),
            "-5,0 -5,40 a0,45 40,45 a45,40 45,0 a40,-5 0,-5 -20,-20");
  EXPECT_EQ(track(read_text(std::string("G451\n") + kSquare, at_origin(Dialect::sinumerik))),
            "-5,0 -5,45 45,45 45,-5 0,-5 -20,-20");
  EXPECT_EQ(track(read_text(kSquare, at_origin(Dialect::fanuc))),
            "-5,0 -5,45 45,45 45,-5 0,-5 -20,-20");
}

TEST(Compensation, SharpOutsideCornersDifferByControl) {
  const std::string text =
      "G0 X-20 Y0\nG42 G1 X0 Y0 D1 F100\nX40\nX10 Y30\nG40 X0 Y60\n";  // turn 135
  const double k = 5 / std::sqrt(2.0);
  const Program s = read_text("G451\n" + text, at_origin(Dialect::sinumerik));
  ASSERT_GE(s.motions.size(), 5U) << listing(s);
  EXPECT_EQ(s.motions[3].kind, MotionKind::arc);  // beyond 100 degrees: the arc
  expect_near(s.motions[3].end, {40 + k, k, 0});
  const Program f = read_text(text, at_origin(Dialect::fanuc));
  ASSERT_GE(f.motions.size(), 5U) << listing(f);
  expect_near(f.motions[2].end, {45, -5, 0});  // two points, each a radius beyond
  expect_near(f.motions[3].end, {40 + 2 * k, 0, 0});
}

TEST(Compensation, InsideCornersAreIntersections) {
  const std::string text =
      "G0 X20 Y20\nG42 G1 X0 Y20 D1 F100\nY40\nX40\nY0\nX0\nY20\nG40 X20 Y20\n";
  for (const Dialect d : {Dialect::sinumerik, Dialect::iso, Dialect::fanuc})
    EXPECT_EQ(track(read_text(text, at_origin(d))), "5,20 5,35 35,35 35,5 5,5 5,20 20,20");
}

TEST(Compensation, TheRadiusIsThatOfTheRegisterOrTheTool) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.table.offsets.push_back({"D1", 3, 0.5, 0});
  EXPECT_EQ(track(read_text(kSquare, options)),
            "-3.5,0 -3.5,43.5 43.5,43.5 43.5,-3.5 0,-3.5 -20,-20");
  const std::string german = "G1 X-20 Y-20 F100\nG41 D2 G1 X0 Y0\nY40\nX40\nG40 Y60\n";
  const Program c = read_text(german, at_origin(Dialect::codesys));
  EXPECT_EQ(track(c), "-2,0 -2,40 a0,42 40,42 40,60") << listing(c);
  const Program d0 = read_text("G0 X-20 Y-20\nG41 G1 X0 Y0 D0 F100\nY40\nX40\nG40 X60\n",
                               at_origin(Dialect::sinumerik));
  EXPECT_EQ(track(d0), "0,0 0,40 40,40 60,40");
}

TEST(Compensation, VoidElementsAreSkipped) {
  const std::string notch =
      "G0 X-20 Y0\nG42 G1 X0 Y0 D1 F100\nX20\nX21 Y1\nX22 Y0\nX40\nG40 Y-20\n";
  const Program p = read_text(notch, at_origin(Dialect::sinumerik));
  EXPECT_EQ(track(p), "0,-5 20,-5 40,-5 40,-20") << listing(p);
  EXPECT_EQ(codes(p), "comp-element-void comp-element-void");
  const std::string step = "G0 X-20 Y0\nG41 G1 X0 Y0 D1 F100\nX20\nY2\nX40\nG40 Y20\n";
  EXPECT_EQ(track(read_text(step, at_origin(Dialect::sinumerik))), "0,5 16,5 a20,7 40,7 40,20");
  EXPECT_EQ(track(read_text(step, at_origin(Dialect::fanuc))), "0,5 15,5 15,7 40,7 40,20");
}

// G41 to G42 without G40, at a corner of 90 degrees and on a straight line, radius 5. FANUC: the
// moved lines meet, or a vector square to the next block's start; SINUMERIK: square to both, a line
// between them.
TEST(Compensation, ChangesItsSide) {
  const auto run = [](Dialect dialect, const char* text) {
    return path_text(read_text(text, at_origin(dialect)));
  };
  const char* corner = "G41 G1 X10 Y0 F100\nY50\nG42 X50\nY0\nG40 X80\n";
  EXPECT_EQ(run(Dialect::fanuc, corner), "l5,0,0 l5,45,0 l45,45,0 l45,0,0 l80,0,0");
  EXPECT_EQ(run(Dialect::sinumerik, corner), "l5,0,0 l5,50,0 l10,45,0 l45,45,0 l45,0,0 l80,0,0");
  const char* straight = "G41 G1 X10 Y0 F100\nX30\nG42 X60\nG40 Y-20\n";
  EXPECT_EQ(run(Dialect::fanuc, straight), "l10,5,0 l30,5,0 l30,-5,0 l60,-5,0 l60,-20,0");
}

TEST(Compensation, AnArcTooSmallInsideIsAnError) {
  const Program p =
      read_text("G0 X-20 Y0\nG41 G1 X0 Y0 D1 F100\nG3 X0 Y4 I0 J2\nG1 X-20\nG40 Y20\n",
                at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(p, Severity::error), "comp-interference") << listing(p);
}

// A tangent arc whose last digits are rounded is no corner, inside or outside.
TEST(Compensation, RoundedTangentsAreNoCorners) {
  for (const char* y : {"9.9995", "10.0005", "10"})
    for (const char* side : {"G41", "G42"}) {
      SCOPED_TRACE(std::string(side) + " " + y);
      const Program p =
          read_text(fmt::format("G0 X-20 Y0\n{} G1 X0 Y0 F100\nX20\nG3 X30 Y{} I0 J10\n"
                                "G1 Y30\nX20\nG40 Y50\n",
                                side, y),
                    at_origin(Dialect::sinumerik));
      EXPECT_EQ(codes(p), "") << listing(p);
      EXPECT_LE(p.motions.size(), 9U) << listing(p);
    }
}

TEST(Compensation, CompensationBeginsAndEndsOnStraightLines) {
  const InterpOptions s = at_origin(Dialect::sinumerik), f = at_origin(Dialect::fanuc);
  EXPECT_EQ(codes(read_text("F100\nG41\nG1 X10\n", s)), "comp-void");
  EXPECT_EQ(codes(read_text("F100\nG41 D1 G2 X10 I5\nG1 X1\n", f)), "comp-start-arc");
  EXPECT_EQ(codes(read_text("F100\nG41 G1 X10 D1\nX20\nG18\nX30\n", s)), "comp-plane");
  EXPECT_EQ(codes(read_text("F100\nG41 G1 X10 D1\nX20\nG18\nX30\n", f)), "comp-plane");
  EXPECT_EQ(track(read_text("G41 D1\nG1 X10 F100\nX20\nG40 Y20\n", f), 0), "10,5 20,5 20,20");
}

TEST(Compensation, SuspendedCompensationKeepsTheShift) {
  const Program p =
      read_text("G0 X-20 Y0\nG41 G1 X0 Y0 F100\nX20\nCUTCONON\nX30 Y5\nCUTCONOF\nX40\nG40 Y30\n",
                at_origin(Dialect::sinumerik));
  EXPECT_EQ(track(p), "0,5 20,5 30,10 40,10 40,30") << listing(p);
}

TEST(Compensation, ARoundingBehindTheStartMayBeVoid) {
  const Program p = read_text("G0 X-20 Y0\nG42 G1 X0 Y0 RND=2 F100\nY-20\nG40 X20\n",
                              at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(p), "comp-element-void") << listing(p);
  EXPECT_EQ(track(p), "-5,-2 -5,-20 20,-20");
}

TEST(Compensation, CompensationIsResumedOverABridge) {
  const Program p =
      read_text("G0 X-20 Y0\nG41 G1 X0 Y0 F100\nY20\nCUTCONON\nX20\nCUTCONOF\nY0\nX0\nG40 Y-20\n",
                at_origin(Dialect::sinumerik));
  EXPECT_EQ(track(p), "-5,0 -5,20 15,20 25,20 25,0 a20,-5 0,-5 0,-20") << listing(p);
}

TEST(Compensation, InfeedsStayAtThePoint) {
  const Program p = read_text("G0 X-20 Y-20 Z5\nG41 G1 X0 Y0 F100\nZ-2\nY40\nZ-4\nX40\nG40 X60\n",
                              at_origin(Dialect::sinumerik));
  ASSERT_GE(p.motions.size(), 6U);
  expect_near(p.motions[2].end, {-5, 0, -2});
  expect_near(p.motions[4].end, {-5, 40, -4});
  EXPECT_EQ(p.motions[5].kind, MotionKind::arc);
}

TEST(Compensation, TheFanucPocketOfTheSeedFollowsItsCircles) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.table.offsets.push_back({"D3", 5, 0, 0});
  const Program p = read_program(std::string(MRSIM_DATA_DIR) + "/FANUC_POCKET.NC", options);
  EXPECT_EQ(codes(p), "comp-circle-open comp-circle-open comp-circle-open") << listing(p);
  int circles = 0;
  for (const Motion& m : p.motions) {
    if (m.kind != MotionKind::arc) continue;
    ++circles;
    if (m.radius != 20) continue;
    EXPECT_NEAR(m.start.x, std::sqrt(375.0), 1e-9);
    EXPECT_NEAR(m.start.y, -5, 1e-9);
    EXPECT_NEAR(degrees(m.sweep), -360 + degrees(std::asin(0.25)), 1e-9);
  }
  EXPECT_EQ(circles, 200);
  EXPECT_NEAR(p.motions[p.motions.size() - 2].start.z, -25, 1e-9);
}

TEST(Compensation, TheNoseOfATurningToolIsCompensated) {
  InterpOptions options = at_origin(Dialect::sinumerik, MachineKind::lathe);
  options.table.tools[0].nose_radius =
      0.8;  // orientation 3: the tip is at -X -Z of the nose centre
  const Program p =
      read_text("G0 X10 Z5\nG42 G1 X20 Z0 F.1\nZ-10\nX40 Z-20\nZ-30\nG40 X60\n", options);
  ASSERT_GE(p.motions.size(), 5U) << listing(p);
  // Along a cylinder the tip runs on the contour itself.
  expect_near(p.motions[1].end, {10, 0, -0.8}, 1);
  EXPECT_NEAR(p.motions[2].end.x, 10, 1e-9);
  // On a 45 degree cone the nose centre keeps its distance from the cone.
  const Motion& cone = p.motions[3];
  const double centre_x = cone.end.x + 0.8, centre_z = cone.end.z + 0.8;
  EXPECT_NEAR(((centre_x - 10) + (centre_z + 10)) / std::sqrt(2.0), 0.8, 1e-9);
}

TEST(Corners, TheExampleOfTheDocumentIsRoundedAsItSays) {
  const Program p =
      read_text("G1 X20 RND=2 F1\nG3 X30 Y10 I10 J0\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.motions.size(), 3U) << listing(p);
  expect_near(p.motions[1].center, {18.1678, -2, 0}, 1e-4);
  expect_near(p.motions[1].start, {18.1678, 0, 0}, 1e-4);
  expect_near(p.motions[1].end, {20.1399, -1.6667, 0}, 1e-4);
  EXPECT_LT(p.motions[1].sweep, 0);
}

TEST(Corners, CornersOfLinesAreRoundedAndCut) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  EXPECT_EQ(track(read_text("G1 X20 RND=3 F1\nY20\n", s), 0), "17,0 a20,3 20,20");
  EXPECT_EQ(track(read_text("G1 X20 CHR=3 F1\nY20\n", s), 0), "17,0 20,3 20,20");
  EXPECT_EQ(track(read_text("G1 X20 CHF=1.414213562373095 F1\nY20\n", s), 0), "19,0 20,1 20,20");
  EXPECT_EQ(track(read_text("G1 X20 RNDM=2 F1\nY20\nX0\nRNDM=0\nY0\nX5\n", s), 0),
            "18,0 a20,2 20,18 a18,20 2,20 a0,18 0,0 5,0");
  EXPECT_EQ(track(read_text("G1 X20 RND=3 CHF=1 F1\nY20\n", s), 0), "17,0 a20,3 20,20");
  EXPECT_EQ(track(read_text("G1 X20 RND=3 F1\nX30\n", s), 0), "20,0 30,0");
  const Program small = read_text("G1 X20 RND=30 F1\nY20\n", s);
  EXPECT_EQ(track(small, 0), "a20,20") << listing(small);
  EXPECT_EQ(codes(small), "corner-reduced");
}

TEST(Corners, ChrIsTheLegOfAChamfer) {
  // Turn 60 degrees: leg 2 gives a cut of 3.4641.
  const Program p =
      read_text("G1 X20 CHR=2 F1\nX30 Y17.320508075688775\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.motions.size(), 3U);
  const Vec3 a = p.motions[1].start, b = p.motions[1].end;
  EXPECT_NEAR(std::hypot(a.x - b.x, a.y - b.y), 2 * std::sqrt(3.0), 1e-9);
}

TEST(Corners, FrcIsTheFeedOfOneInsertedElement) {
  const Program p =
      read_text("G1 X20 RND=3 FRC=50 F100\nY20 RND=1\nX0\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.motions.size(), 5U) << listing(p);
  EXPECT_EQ(p.motions[1].feed, 50);
  EXPECT_EQ(p.motions[3].feed, 100);
}

TEST(Corners, WhatCannotBeInsertedIsReported) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  for (const char* text : {"G1 X30 RND=2\nX29\nY5\n", "G1 X10 Y20\nY20 CHF=50\nX50\n",
                           "G1 X20 RND=-2\nY20\n", "G1 X20 CHR=-2\nY20\n"})
    EXPECT_EQ(codes(read_text(std::string("F1\n") + text, s)), "corner-void") << text;
  EXPECT_EQ(codes(read_text("G1 AP=0 RP=2 F1\nRP=IC(-3)\n", s)), "polar-radius");
  EXPECT_EQ(codes(read_text("G112 X1 Y1 AP=3\nG1 X1 F1\n", s)), "polar-mixed");
}

TEST(Corners, ALoneAngleIsReportedOnce) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  const Program p = read_text("F1\nG1 ANG=30\nX5\nG1 ANG=30 X5\n", s);
  EXPECT_EQ(codes(p), "angle-incomplete");
  EXPECT_EQ(p.motions.size(), 1U) << listing(p);
  EXPECT_EQ(codes(read_text("G1 X1 F1\nG1 ANG=30\nM30\n", s)), "angle-incomplete");
}

TEST(Corners, TwoAnglesMeetInTheirCorner) {
  InterpOptions options = at_origin(Dialect::sinumerik, MachineKind::lathe);
  const Program p = read_text("DIAMOF\nG0 X10 Z100\nG1 ANG=140 F.1\nX80 Z70 ANG=95.824\n", options);
  ASSERT_EQ(p.motions.size(), 3U) << listing(p);
  expect_near(p.motions[1].end, {30.977, 0, 75}, 1e-3);
  expect_near(p.motions[2].end, {80, 0, 70});
  EXPECT_EQ(codes(read_text("F1\nG1 ANG=90 X5\nX1\n", at_origin(Dialect::sinumerik))),
            "angle-parallel");
  EXPECT_EQ(codes(read_text("F1\nG1 ANG=10 X-5\nX1\n", at_origin(Dialect::sinumerik))),
            "angle-behind");
}

// A frame between two blocks turns the axes, not the corner.
TEST(Corners, AFrameBetweenTheElementsTurnsNoCorner) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  for (const char* text : {"G1 X20 RND=3 F1\nROT RPL=90\nX20 Y-20\n",  // the point (20, 20)
                           "G1 X20 RND=3 F1\nMIRROR X0\nX-20 Y20\n"})
    EXPECT_EQ(track(read_text(text, s), 0), "17,0 a20,3 20,20") << text;
}

TEST(Compensation, AFrameBetweenTheElementsTurnsNoCorner) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  for (const char* frame : {"ROT RPL=90\nX40 Y-20", "TRANS X-20\nX40 Y40"})
    EXPECT_EQ(
        track(read_text(fmt::format("G0 X-20 Y0\nG41 G1 X0 Y0 F1\nX20\n{}\nG40 X-60\n", frame), s))
            .substr(0, 15),
        "0,5 15,5 15,40 ")
        << frame;
}

// The rounding takes the whole line of the G40 block: a line leads to where it begins.
TEST(Compensation, ARoundingMayTakeTheWholeLineOfG40) {
  const Program p = read_text("G0 X-20 Y0\nG41 G1 X0 Y0 F1\nX20\nG40 X23 RND=3\nY20\n",
                              at_origin(Dialect::sinumerik));
  EXPECT_EQ(track(p), "0,5 20,5 20,0 a23,3 23,20") << listing(p);
}

TEST(Corners, AnInfeedComesBehindTheRounding) {
  const Program p = read_text("G1 X50 RND=2 F1\nZ-5\nY60\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.motions.size(), 4U) << listing(p);
  expect_near(p.motions[1].end, {50, 2, 0});
  EXPECT_EQ(p.motions[1].rise, 0);
  expect_near(p.motions[2].start, {50, 2, 0});
  expect_near(p.motions[2].end, {50, 2, -5});
  expect_near(p.motions[3].start, {50, 2, -5});
  expect_near(p.motions[3].end, {50, 60, -5});
}

// Slanted neighbours: the rounding joins the heights at which it touches them; before an infeed it
// ends at that of the corner.
TEST(Corners, ARoundingJoinsTheHeightsOfSlantedLines) {
  const Program p = read_text("G1 X50 Z10 RND=5 F1\nZ4\nY60 Z16\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(p.motions.size(), 4U) << listing(p);
  expect_near(p.motions[0].end, {45, 0, 9});
  expect_near(p.motions[1].end, {50, 5, 10});
  expect_near(p.motions[2].end, {50, 5, 4});
  expect_near(p.motions[3].start, {50, 5, 4});
  expect_near(p.motions[3].end, {50, 60, 16});
}

// The largest rounding that fits takes the whole arc behind it.
TEST(Corners, NothingIsLeftOfAnArcThatARoundingTakes) {
  const Program p =
      read_text("G18 G21\nG1 X14.152 Z1 F1\nZ-7.167 R6.157\nG3 X9.205 Z-5.165 R8.017\n",
                at_origin(Dialect::fanuc, MachineKind::lathe));
  ASSERT_EQ(p.motions.size(), 3U) << listing(p);
  expect_near(p.motions[2].end, {4.6025, 0, -5.165});
}

// The rounding takes the whole element, so that the corner at its end has nothing to stand on.
TEST(Corners, ACornerWhoseElementARoundingTakesIsReported) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  for (const char* corner : {"CHR=0.5", "RND=2"}) {
    const Program p = read_text(fmt::format("G1 X16 RND=2 F1\nY2 {}\nX-30\n", corner), s);
    EXPECT_EQ(track(p, 0), "14,0 a16,2 -30,2");
    ASSERT_EQ(codes(p), "corner-reduced") << corner;
    EXPECT_EQ(p.diagnostics[0].place.line, 2);
    EXPECT_NE(p.diagnostics[0].text.find("reduced to 0 mm"), std::string::npos);
  }
  EXPECT_EQ(codes(read_text("G1 X16 ,R2. F1\nY2. ,C.5\nX-30.\n", at_origin(Dialect::fanuc))),
            "corner-reduced");
}

TEST(Corners, ACornerInTheLastBlockIsReported) {
  const InterpOptions f = at_origin(Dialect::fanuc);
  for (const char* end : {"M30\n", "G0 Z50.\nM30\n"}) {
    const Program p = read_text(fmt::format("G1 X16. F1\nY20. ,R5.\n{}", end), f);
    ASSERT_EQ(codes(p), "corner-void") << end;
    EXPECT_EQ(p.diagnostics[0].place.line, 2);
  }
  EXPECT_EQ(codes(read_text("RNDM=2\nG1 X16 F1\nY20\nM30\n", at_origin(Dialect::sinumerik))), "")
      << "RNDM holds for each corner";
}

TEST(Corners, ACornerReachesOverAtMostThreeBlocksWithoutTravel) {
  const InterpOptions s = at_origin(Dialect::sinumerik);
  const char* rows[] = {"M8\nM9\nM8\n", "Z1\nM9\n; note\n\nZ0\n"};
  for (const char* row : rows) {
    const Program p = read_text(fmt::format("G1 X50 RND=2 F1\n{}Y60\n", row), s);
    EXPECT_EQ(codes(p), "") << listing(p);
    EXPECT_EQ(p.motions.back().start.y, 2) << row;
  }
  for (const char* row : {"M8\nM9\nM8\nM9\nG4 F1\n", "Z1\nM9\nZ2\nZ0\n", "Z1\nM8\nM9\nM9\n"}) {
    const Program p = read_text(fmt::format("G1 X50 RND=2 F1\n{}Y60\n", row), s);
    EXPECT_EQ(codes(p), "corner-void") << row;
    EXPECT_EQ(p.motions.back().start.y, 0) << row;
  }
}

// An arc of radius 10 about the zero and back along one of radius 4 that touches it from within:
// the way back lies to the left. A tool of radius 1 there meets both at x^2 + y^2 = 81, (x - 6)^2 +
// y^2 = 25; on the right it goes round the cusp.
TEST(Compensation, AtACuspOfArcsTheirCurvatureSaysWhichSideIsTheInner) {
  const auto run = [](const char* comp) {
    return read_text(fmt::format("G21 G90 F100\nG0 X-20 Y-10\n{} D2\nG1 X0\nG3 X10 Y0 J10\n"
                                 "G2 X2 I-4\nG1 Y5\nG40 G1 Y20\nM2\n",
                                 comp),
                     at_origin(Dialect::ngc));
  };
  const Program left = run("G41.1");
  ASSERT_EQ(codes(left, Severity::error), "");
  expect_near(left.motions[2].end, {23.0 / 3, -std::sqrt(81 - 23.0 * 23 / 9), 0}, 1e-9);
  expect_near(left.motions[3].end, {1, 0, 0}, 1e-9);
  const Program right = run("G42.1");
  ASSERT_EQ(codes(right, Severity::error), "");
  expect_near(right.motions[2].end, {11, 0, 0}, 1e-9);
  expect_near(right.motions[3].end, {9, 0, 0}, 1e-9);
}

// Arcs of the tool's own radius on its inner side: the centre stands still at theirs.
TEST(Compensation, AnInsideArcOfTheToolsRadiusIsAPoint) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::sinumerik, Dialect::iso}) {
    const char* r = dialect == Dialect::sinumerik ? "CR=" : "R";
    const auto run = [&](const std::string& text) {
      return path_text(read_text("G90 G1 G41 D1 X20 Y0 F100\n" + text + "G40 X0 Y40\nM30\n",
                                 at_origin(dialect)));
    };
    EXPECT_EQ(run(fmt::format("G3 X25 Y5 {0}5\nG1 Y20\nG3 X20 Y25 {0}5\nG1\n", r)),
              "l20,5,0 l20,20,0 l0,40,0");
    EXPECT_EQ(run(fmt::format("X30\nG3 X35 Y5 {}5\nG1 Y20\n", r)),
              "l20,5,0 l30,5,0 l30,20,0 l0,40,0");
    EXPECT_NE(run(fmt::format("X30\nG3 X34.9 Y4.9 {}4.9\nG1 Y20\n", r)).find("comp-element-void"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace mrsim
