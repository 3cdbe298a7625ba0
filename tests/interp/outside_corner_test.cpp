// Outside corners under G41/G42: G451 beside arcs, DISC, KONT. Expected points are worked out by
// hand from the circles and lines a tool radius of 5 mm away.
#include "core/numbers/vec.h"
#include "interp/support.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

Program run(const std::string& text, Dialect dialect = Dialect::sinumerik) {
  return read_text(text, at_origin(dialect));
}

// Angle from the centre to a point, degrees.
double angle(double x, double y) { return degrees(std::atan2(y, x)); }

// Line y = 5 and the circle of radius 10 + 5 about (12, -6).
TEST(Intersection, ALineMeetsTheArcBehindItOutside) {
  const Program p =
      run("G451 G0 X-20 Y0\nG41 G1 X0 Y0 F100\nX20\nG2 X22 Y-6 I-8 J-6\nG1 Y-20\nG40 X60\n");
  ASSERT_EQ(p.motions.size(), 6U) << listing(p);
  const double x = std::sqrt(104.0);
  expect_near(p.motions[2].end, {12 + x, 5, 0});
  const Motion& arc = p.motions[3];
  EXPECT_EQ(arc.kind, MotionKind::arc);
  expect_near(arc.start, {12 + x, 5, 0});
  expect_near(arc.end, {27, -6, 0});
  expect_near(arc.center, {12, -6, 0});
  EXPECT_NEAR(arc.radius, 15, 1e-9);
  EXPECT_NEAR(degrees(arc.sweep), -angle(x, 11), 1e-9);
  expect_near(p.motions[4].end, {27, -20, 0});
}

// The tool runs within the arc: radius 10 - 5 about (28, 6).
TEST(Intersection, ALineMeetsTheArcBehindItFromWithin) {
  const Program p =
      run("G451 G0 X-20 Y0\nG41 G1 X0 Y0 F100\nX20\nG3 X28 Y-4 I8 J6\nG1 X50\nG40 Y60\n");
  ASSERT_EQ(p.motions.size(), 6U) << listing(p);
  const double x = std::sqrt(24.0);
  expect_near(p.motions[2].end, {28 - x, 5, 0});
  expect_near(p.motions[3].end, {28, 1, 0});
  EXPECT_NEAR(p.motions[3].radius, 5, 1e-9);
  EXPECT_NEAR(degrees(p.motions[3].sweep), 90 - angle(x, 1), 1e-9);
}

TEST(Intersection, AnArcMeetsTheLineBehindIt) {
  const Program p =
      run("G451 G0 X40 Y-20\nG42 G1 X22 Y-6 F100\nG3 X20 Y0 I-10 J0\nG1 X0\nG40 X-20\n");
  ASSERT_EQ(p.motions.size(), 5U) << listing(p);
  const double x = std::sqrt(104.0);
  expect_near(p.motions[1].end, {27, -6, 0});
  expect_near(p.motions[2].end, {12 + x, 5, 0});
  EXPECT_NEAR(degrees(p.motions[2].sweep), angle(x, 11), 1e-9);
  expect_near(p.motions[3].end, {0, 5, 0});
}

// The upper tip of a lens of two circles of radius 10 about (6, 0) and (-6, 0).
TEST(Intersection, TwoArcsMeetOutside) {
  const Program p = run(
      "G451 G0 X-4 Y-20\nG41 G1 X-4 Y0 F100\nG2 X0 Y8 I10 J0\nX4 Y0 I-6 J-8\nG1 Y-20\nG40 X40\n");
  ASSERT_EQ(p.motions.size(), 6U) << listing(p);
  const double y = std::sqrt(189.0);
  expect_near(p.motions[2].end, {0, y, 0});
  expect_near(p.motions[3].start, {0, y, 0});
  expect_near(p.motions[3].end, {9, 0, 0});
  EXPECT_NEAR(degrees(p.motions[2].sweep), -angle(6, y), 1e-9);
  EXPECT_NEAR(degrees(p.motions[3].sweep), -angle(6, y), 1e-9);
}

// A spike with hollow flanks, radius 20 about (-12, 24) and (12, 24).
TEST(Intersection, TwoArcsMeetFromWithin) {
  const Program p = run(
      "G451 G0 X-40 Y4\nG41 G1 X-12 Y4 F100\nG3 X0 Y8 I0 J20\nX12 Y4 I12 J16\nG1 X40\nG40 Y40\n");
  ASSERT_EQ(p.motions.size(), 6U) << listing(p);
  expect_near(p.motions[2].end, {0, 15, 0});
  EXPECT_NEAR(degrees(p.motions[2].sweep), 90 - angle(12, 9), 1e-9);
  expect_near(p.motions[3].end, {12, 9, 0});
}

// An outer circle into a hollow one: radius 15 about (0, -10), radius 5 about (16, -2).
TEST(Intersection, ArcsOfBothSensesMeet) {
  const Program p =
      run("G451 G0 X-30 Y0\nG41 G1 X0 Y0 F100\nG2 X6 Y-2 I0 J-10\nG3 X16 Y-12 I10 J0\nG1 X60\n"
          "G40 Y60\n");
  ASSERT_EQ(p.motions.size(), 6U) << listing(p);
  const double h = std::sqrt(13.75 / 5);
  expect_near(p.motions[2].end, {13 - h, -3.5 + 2 * h, 0});
  EXPECT_NEAR(degrees(p.motions[2].sweep), angle(13 - h, 6.5 + 2 * h) - 90, 1e-9);
  expect_near(p.motions[3].end, {16, -7, 0});
  EXPECT_NEAR(degrees(p.motions[3].sweep), 270 - angle(-3 - h, -1.5 + 2 * h), 1e-9);
}

// Circles that do not meet, and turns above 100 degrees: the arc round the corner.
TEST(Intersection, FallsBackToTheArc) {
  const Program apart =
      run("G451 G0 X-40 Y6\nG41 G1 X-6 Y6 F100\nG3 X0 Y8 I0 J10\nX6 Y6 I6 J8\nG1 X40\nG40 Y40\n");
  ASSERT_GE(apart.motions.size(), 5U) << listing(apart);
  expect_near(apart.motions[3].center, {0, 8, 0});
  EXPECT_NEAR(apart.motions[3].radius, 5, 1e-9);
  const Program sharp =
      run("G451 G0 X-40 Y4\nG41 G1 X-8 Y4 F100\nG3 X0 Y8 I0 J10\nX8 Y4 I8 J6\nG1 X40\nG40 Y40\n");
  ASSERT_GE(sharp.motions.size(), 5U) << listing(sharp);
  expect_near(sharp.motions[3].center, {0, 8, 0});
  EXPECT_NEAR(degrees(sharp.motions[3].sweep), -2 * angle(6, 8), 1e-9);
}

// An extended arc may go on to be cut short by the next inside corner, and the other way round.
TEST(Intersection, AnExtendedArcMayEndAtAnInsideCorner) {
  const Program p =
      run("G451 G0 X-20 Y0\nG41 G1 X0 Y0 F100\nX20\nG3 X28 Y-4 I8 J6\nG1 X60 Y20\nG40 Y60\n");
  ASSERT_EQ(p.motions.size(), 6U) << listing(p);
  expect_near(p.motions[2].end, {28 - std::sqrt(24.0), 5, 0});
  expect_near(p.motions[3].end, {26.6, 1.2, 0});  // 3 mm of the line from the centre (28, 6)
  EXPECT_NEAR(degrees(p.motions[3].sweep), 90 + angle(4.8, -1.4) - angle(std::sqrt(24.0), 1), 1e-9);
  expect_near(p.motions[4].end, {57, 24, 0});
}

// The turns of a helix between two inside corners leave nothing of the circle uncut.
TEST(Intersection, AHelixIsNoOpenCircle) {
  const Program p =
      run("G0 X-20 Y0\nG41 G1 X0 Y0 F100\nX20\nG2 X40 Y0 Z-5 I10 J0 TURN=2\nG1 X80\nG40 Y50\n");
  EXPECT_EQ(codes(p), "") << listing(p);
}

// Down a step lower than the tool's radius: the corner's arc, or its intersection, runs into the
// next line.
TEST(Intersection, AStepLowerThanTheRadiusLeavesOutItsLine) {
  const char* text = "G0 X-20 Y0\nG41 G1 X0 Y0 F100\nX20\nY-2\nX40\nG40 Y60\n";
  const Program arc = run(text), sharp = run(std::string("G451 ") + text);
  ASSERT_EQ(arc.motions.size(), 6U) << listing(arc);
  expect_near(arc.motions[3].center, {20, 0, 0});
  expect_near(arc.motions[3].end, {24, 3, 0});
  expect_near(arc.motions[4].end, {40, 3, 0});
  EXPECT_EQ(codes(arc), "comp-element-void");
  ASSERT_EQ(sharp.motions.size(), 6U) << listing(sharp);
  expect_near(sharp.motions[2].end, {25, 5, 0});
  expect_near(sharp.motions[3].end, {25, 3, 0});
  EXPECT_EQ(codes(sharp), "");
}

// The tangents, not the circles: this control extends straight.
TEST(Intersection, FanucRunsOnAlongTheTangents) {
  const Program p = run("G0 X-20 Y0\nG41 G1 X0 Y0 D1 F100\nX20\nG2 X22 Y-6 I-8 J-6\nG40 G1 X60\n",
                        Dialect::fanuc);
  ASSERT_GE(p.motions.size(), 5U) << listing(p);
  expect_near(p.motions[2].end, {22.5, 5, 0});
  expect_near(p.motions[3].end, {24, 3, 0});
  EXPECT_NEAR(p.motions[4].radius, 15, 1e-9);
}

constexpr const char* kSquare =
    "G0 X-20 Y-20\nG41 G1 X0 Y0 D1 F100\nY40\nX40\nY0\nX0\nG40 X-20 Y-20\n";

// The corner's vertex is raised by that share of the way from the circle to the intersection: an
// arc of radius (1 - DISC / 100) r between the tangents.
TEST(Disc, SharpensTheCorner) {
  const Program p = run(std::string("DISC=50\n") + kSquare);
  ASSERT_EQ(p.motions.size(), 16U) << listing(p);
  expect_near(p.motions[2].end, {-5, 40, 0});
  expect_near(p.motions[3].end, {-5, 42.5, 0});
  expect_near(p.motions[4].end, {-2.5, 45, 0});
  expect_near(p.motions[4].center, {-2.5, 42.5, 0});
  expect_near(p.motions[5].end, {0, 45, 0});
  EXPECT_EQ(p.motions[3].line, p.motions[6].line);  // part of the next block
  const double k = std::sqrt(0.5), vertex = -2.5 - 2.5 * k, circle = -5 * k;
  EXPECT_NEAR(vertex, 0.5 * (circle - 5), 1e-12);
  EXPECT_EQ(codes(p), "");
}

TEST(Disc, TheEndsOfTheRangeAreG450AndG451) {
  EXPECT_EQ(listing(run(std::string("DISC=0\n") + kSquare)),
            listing(run("\n" + std::string(kSquare))));
  EXPECT_EQ(listing(run(std::string("DISC=100\n") + kSquare)),
            listing(run("G451\n" + std::string(kSquare))));
  EXPECT_EQ(codes(run("DISC=101\nG1 X1 F1\n"), Severity::error), "value-range");
  EXPECT_EQ(codes(run("DISC=-1\nG1 X1 F1\n"), Severity::error), "value-range");
}

// Never nearer to the corner than the tool's radius, and never beyond the intersection.
TEST(Disc, StaysOutsideTheCircle) {
  for (const int disc : {10, 35, 80, 99})
    for (const double turn : {20.0, 75.0, 90.0, 115.0}) {
      const double c = std::cos(radians(turn)), s = std::sin(radians(turn));
      const Program p =
          run(fmt::format("DISC={} G0 X-20 Y0\nG42 G1 X0 Y0 F100\nX40\n"
                          "X{} Y{}\nG40 Y90\n",
                          disc, 40 + 30 * c, 30 * s));
      ASSERT_EQ(p.motions.size(), 8U) << listing(p);
      const Motion& arc = p.motions[4];
      const double rest = 1 - disc / 100.0, far = 5 * (1 - rest) / std::cos(radians(turn / 2));
      EXPECT_NEAR(arc.radius, 5 * rest, 1e-9);
      EXPECT_NEAR(std::hypot(arc.center.x - 40, arc.center.y), far, 1e-9);
      EXPECT_NEAR(degrees(arc.sweep), turn, 1e-9);
      EXPECT_GE(far + arc.radius, 5);
      const double reach = 5 * (1 - rest) * std::tan(radians(turn / 2));
      expect_near(p.motions[3].end, {40 + reach, -5, 0});
      expect_near(p.motions[5].end, {40 + 5 * s, -5 * c, 0});
    }
}

// The example of the manual: from (35, 0) behind the contour X10.
TEST(Kont, RoundsTheStartFromBehind) {
  const double l =
      std::sqrt(700.0);  // along the tangent from the start to the circle about (10, 10)
  const double tx = (-25 * l - 50) / 725, ty = (10 * l - 125) / 725;
  const Program p = run("G0 X35 Y0\nG41 KONT G450 G1 X10 Y10 F100\nY60\nG40 X-20\n");
  ASSERT_EQ(p.motions.size(), 5U) << listing(p);
  expect_near(p.motions[1].end, {10 - 5 * ty, 10 + 5 * tx, 0});
  EXPECT_NEAR(distance(p.motions[1].start, p.motions[1].end), l, 1e-9);
  EXPECT_EQ(p.motions[2].kind, MotionKind::arc);
  expect_near(p.motions[2].center, {10, 10, 0});
  expect_near(p.motions[2].end, {5, 10, 0});
  EXPECT_LT(p.motions[2].sweep, 0);
  EXPECT_EQ(p.motions[2].line, 3);  // part of the next block
  expect_near(p.motions[3].end, {5, 60, 0});
  EXPECT_EQ(codes(p), "");

  const Program sharp = run("G0 X35 Y0\nG41 KONT G451 G1 X10 Y10 F100\nY60\nG40 X-20\n");
  ASSERT_EQ(sharp.motions.size(), 4U) << listing(sharp);
  expect_near(sharp.motions[1].end, {5, -30 * ty / tx, 0});
  expect_near(sharp.motions[2].end, {5, 60, 0});
}

TEST(Kont, RoundsTheEndFromBehind) {
  const double l = std::sqrt(700.0);
  const double tx = (-25 * l - 50) / 725, ty = (10 * l - 125) / 725;
  const Program p = run("G0 X-20 Y60\nG42 KONT G450 G1 X10 Y60 F100\nY10\nG40 X35 Y0\n");
  ASSERT_EQ(p.motions.size(), 5U) << listing(p);
  expect_near(p.motions[2].end, {5, 10, 0});
  expect_near(p.motions[3].center, {10, 10, 0});
  expect_near(p.motions[3].end, {10 - 5 * ty, 10 + 5 * tx, 0});
  EXPECT_GT(p.motions[3].sweep, 0);
  expect_near(p.motions[4].end, {35, 0, 0});
  const Program sharp = run("G0 X-20 Y60\nG42 KONT G451 G1 X10 Y60 F100\nY10\nG40 X35 Y0\n");
  ASSERT_EQ(sharp.motions.size(), 4U) << listing(sharp);
  expect_near(sharp.motions[2].end, {5, -30 * ty / tx, 0});
  expect_near(sharp.motions[3].end, {35, 0, 0});
}

// In front of the contour, on its tangent, or with the point under the tool: straight, as NORM.
TEST(Kont, IsNormInFrontOfTheContour) {
  for (const char* start : {"X-20 Y-20", "X-20 Y50", "X10 Y-20", "X12 Y9"}) {
    const auto text = [&](const char* mode) {
      return fmt::format("G0 {}\nG41 {} G1 X10 Y10 F100\nY60\nG40 X-20 Y70\n", start, mode);
    };
    EXPECT_EQ(listing(run(text("KONT"))), listing(run(text("NORM")))) << start;
  }
  const auto behind = [&](const char* mode) {
    return fmt::format("G0 X35 Y0\nG41 {} G1 X10 Y10 F100\nY60\nG40 X-20\n", mode);
  };
  for (const char* mode : {"KONTC", "KONTT"}) {
    const Program p = run(behind(mode));
    ASSERT_EQ(p.motions.size(), 4U) << listing(p);
    expect_near(p.motions[1].end, {5, 10, 0});
  }
}

// The nose of a turning tool goes round the point too: orientation 9 keeps its centre.
TEST(Kont, TheNoseGoesRoundThePointOnALathe) {
  InterpOptions options = at_origin(Dialect::sinumerik, MachineKind::lathe);
  options.table.tools[0].nose_radius = 1;
  const auto text = [](const char* mode) {
    return fmt::format("DIAMOF\nG0 X5 Z10\nG42 {} G1 X20 Z0 F.1\nZ-20\nG40 X30\n", mode);
  };
  const Program kont = read_text(text("KONT"), options), norm = read_text(text("NORM"), options);
  ASSERT_EQ(kont.motions.size(), norm.motions.size() + 1) << listing(kont);
  const Motion& arc = kont.motions[2];
  EXPECT_NEAR(arc.radius, 1, 1e-12);
  expect_near(arc.center, {20 - 1, 0, 0 - 1});  // tip point of a nose centre over the corner
  expect_near(arc.end, norm.motions[1].end);
}

}  // namespace
}  // namespace mrsim
