// --history: depth, width and engagement of cuts against closed forms.
#include "run_program.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// A motion on line `line` has these figures, to 2 % on voxels of kVoxel and 1 % on those of half of
// it, which take up to eight times as long and are asked for once a kind of move; 0: not defined,
// below 0: not asked.
constexpr double kVoxel = 0.1;
struct Shape {
  int line;
  double depth, width, engagement;
};

class ShapeOfCuts : public CliTest {
 protected:
  Json history() { return Json::parse(read("h.json"), nullptr, false); }

  void expect_shapes(const std::string& arguments, const std::vector<Shape>& shapes) {
    expect_coarse_shapes(arguments, shapes);
    expect_shapes(arguments, shapes, kVoxel / 2, 0.01);
  }
  void expect_coarse_shapes(const std::string& arguments, const std::vector<Shape>& shapes) {
    expect_shapes(arguments, shapes, kVoxel, 0.02);
  }

 private:
  void expect_shapes(const std::string& arguments, const std::vector<Shape>& shapes, double voxel,
                     double error) {
    const Outcome o = run(arguments + "--tolerance 0.1 --voxel " + std::to_string(voxel) +
                          " -q --history h.json");
    EXPECT_EQ(o.code, 0) << o.err;
    expect_valid("history", "h.json");
    expect_shapes(history(), shapes, error);
  }
  void expect_shapes(const Json& found, const std::vector<Shape>& shapes, double error) {
    for (const Shape& shape : shapes) {
      const auto row = std::find_if(found["rows"].begin(), found["rows"].end(), [&](const Json& r) {
        return r["kind"] == "line" && r["line"] == shape.line;
      });
      ASSERT_NE(row, found["rows"].end()) << shape.line;
      expect_figure((*row)["depth"], shape.depth, error);
      expect_figure((*row)["width"], shape.width, error);
      expect_figure((*row)["engagement"], shape.engagement, error);
    }
  }
  static void expect_figure(const Json& found, double exact, double error) {
    if (exact < 0) return;
    if (exact == 0)
      EXPECT_TRUE(found.is_null()) << found;
    else
      EXPECT_NEAR(found.get<double>(), exact, error * exact);
  }
};

// A slot, a side cut of half the diameter, a plunge, a ramp with a half circle after it, and a side
// cut of a quarter: cos a = 1 - 2 / 4.
const char* const kShapes =
    "G54 G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-10 Y30 Z-5\nG1 X50 F600\nG0 Z5\nG0 X-10 Y0\nG0 "
    "Z-4\nG1 X120 F600\nG0 Z5\nG0 X80 Y45\nG1 Z-8 F100\nG0 Z5\nG0 X60 Y20\nG1 Z-3\nG3 X75 Y20 "
    "I7.5 J0 F400\nG0 Z5\nG0 X-10 Y62.5\nG0 Z-2\nG1 X110\nG0 Z5\nM30\n";
const std::vector<Shape> kTheirs = {
    {5, 5, 10, 180}, {9, 4, 5, 90}, {12, 8, 10, 360}, {16, 3, 10, 180}, {20, 2, 2.5, 60}};

TEST_F(ShapeOfCuts, FlatMillAgreesWithClosedForms) {
  write("c.MPF", kShapes);
  expect_shapes("c.MPF --machine mill --stock box:0,0,-20,100,60,0 --tool 1=endmill:d=10 ",
                kTheirs);
}

// By voxels: a mill with flutes of some length leaves no heights. Its plunges have no engagement.
TEST_F(ShapeOfCuts, MillWithFlutesAgreesWithClosedForms) {
  write("c.MPF", kShapes);
  std::vector<Shape> shapes = kTheirs;
  shapes[2].engagement = 0;
  expect_shapes("c.MPF --machine mill --stock box:0,0,-20,100,60,0 --tool 1=endmill:d=10,l=25 ",
                shapes);
}

// A ball of 10 mm, 2 mm deep: the circle at the stock's top has the radius 4.
TEST_F(ShapeOfCuts, BallMillIsAsWideAsItIsDeep) {
  write("b.MPF", "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-10 Y30 Z-2\nG1 X110 F600\nM30\n");
  expect_shapes("b.MPF --machine mill --stock box:0,0,-20,100,60,0 --tool 1=ballmill:d=10 ",
                {{5, 2, 8, 180}});
}

// G18 and G19 arcs are as wide as the cutter across their plane: a slot, 2 mm of a side.
TEST_F(ShapeOfCuts, UprightArcsAreMeasuredAcrossTheirPlane) {
  write("u.MPF",
        "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X30 Y30 Z0\nG18 G2 X70 Z0 CR=29 F600\nG0 Z5\n"
        "G0 X85 Y10\nG0 Z0\nG19 G3 Y50 Z0 CR=29\nG0 Z5\nG0 X15 Y-3\nG0 Z0\n"
        "G18 G2 X60 Z0 CR=40\nM30\n");
  const double side = std::acos(1 - 2.0 / 5) * 180 / 3.14159265;
  expect_coarse_shapes("u.MPF --machine mill --stock box:0,0,-20,100,60,0 --tool 1=endmill:d=10 ",
                       {{5, -1, 10, 180}, {9, -1, 10, 180}, {13, -1, 2, side}});
}

// The second pass begins where the first one ended, between two columns; so does the wider circle.
TEST_F(ShapeOfCuts, PassesEndAtTheWallsOfThoseBefore) {
  write("p.MPF",
        "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-10 Y-3.9 Z-5\nG1 X110 F600\nG0 Z5\nG0 Y-2.8\n"
        "G0 Z-5\nG1 X-10\nG0 Z5\nG0 X59 Y30\nG1 Z-5\nG3 X59 Y30 I-9 J0\nG1 X60\n"
        "G3 X60 Y30 I-10 J0\nM30\n");
  const double degree = 180 / 3.14159265;
  const double round = 90 - std::asin((14 * 14 - 10 * 10 - 5 * 5) / (2.0 * 10 * 5)) * degree;
  expect_shapes("p.MPF --machine mill --stock box:0,0,-20,100,60,0 --tool 1=endmill:d=10 ",
                {{5, 5, 1.1, std::acos(1 - 1.1 / 5) * degree},
                 {9, 5, 1.1, std::acos(1 - 1.1 / 5) * degree},
                 {15, 5, -1, round}});
}

// The tip of a V tool passes the middle of no column.
// The side of a round stock ends a column as the cutter's edge does: round the outside of a bar,
// and of the bore of a tube.
TEST_F(ShapeOfCuts, RoundStocksEndBetweenColumns) {
  const std::string head = "G17 G90 G71\nT1 M6\nS5000 M3\n";
  write("bar.MPF", head + "G0 X40 Y0 Z-5\nG1 X34 F600\nG3 I-34\nM30\n");
  write("bore.MPF", head + "G0 X0 Y0 Z-5\nG1 X16 F600\nG3 I-16\nM30\n");
  const auto front = [](double path, double at) {  // of the cutter, from across the feed
    return std::asin((at * at - path * path - 25) / (10 * path)) * 180 / 3.14159265;
  };
  expect_coarse_shapes("bar.MPF --machine mill --stock cylinder:60,-20,0 --tool 1=endmill:d=10 ",
                       {{6, 5, 1, front(34, 30) + 90}});
  expect_coarse_shapes("bore.MPF --machine mill --stock tube:60,40,-20,0 --tool 1=endmill:d=10 ",
                       {{6, 5, 1, 90 - front(16, 20)}});
}

// Finishing passes thinner than a column: a wall is met to less than a 2000th of one.
TEST_F(ShapeOfCuts, ThinPassesHaveTheirVolume) {
  for (const double thick : {0.02, 0.1, 0.3}) {
    write("thin.MPF", "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-20 Y" + std::to_string(thick - 5) +
                          " Z-4\nG1 X120 F600\nM30\n");
    ASSERT_EQ(run("thin.MPF --machine mill --stock box:0,0,-20,100,60,0 --tool 1=endmill:d=10 "
                  "--voxel 0.25 -q --history h.json")
                  .code,
              0);
    EXPECT_NEAR(history()["rows"].back()["removed"], 400 * thick, 4e-3 * 100 * thick) << thick;
  }
  write("ring.MPF", "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X40 Y0 Z-5\nG1 X34.8 F600\nG3 I-34.8\nM30\n");
  ASSERT_EQ(run("ring.MPF --machine mill --stock cylinder:60,-20,0 --tool 1=endmill:d=10 "
                "--voxel 0.2 -q --history h.json")
                .code,
            0);
  const double ring = 3.14159265 * (900 - 29.8 * 29.8) * 5;
  EXPECT_NEAR(history()["rows"].back()["removed"], ring, 1e-3 * ring);
}

TEST_F(ShapeOfCuts, GroovesAreAsDeepAsTheirTip) {
  write("v.MPF", "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-10 Y30 Z-0.3\nG1 X110 F600\nM30\n");
  expect_shapes(
      "v.MPF --machine mill --stock box:0,0,-20,100,60,0 --tool 1=chamfer:d=12,tip_angle=90 ",
      {{5, 0.3, 0.6, 180}});
}

// The radius of a taper grows above its diameter, and a form has no diameter.
TEST_F(ShapeOfCuts, MillsAreAsWideAsTheirProfile) {
  write("w.MPF", "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-10 Y30.1 Z-5\nG1 X110 F600\nM30\n");
  write("form.toml", "[[tool]]\nid = 1\ntype = \"form\"\nprofile = [[0, 0], [4, 0], [4, 30]]\n");
  const std::string run = "w.MPF --machine mill --stock box:0,0,-20,100,60,0 ";
  const double flank = 5 * std::tan(5 * 3.14159265 / 180);
  expect_shapes(run + "--tool 1=taper:d=1.5,a=5,l=20 ", {{5, 5, 1.5 + 2 * flank, 180}});
  expect_shapes(run + "--tools form.toml ", {{5, 5, 8, 180}});
}

// A hundredth of a millimetre less than the radius is an angle of some degrees.
TEST_F(ShapeOfCuts, SlotsAreCutByHalfOfTheCutter) {
  write("s.MPF", "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-10 Y30.123 Z-1\nG1 X110 F600\nM30\n");
  write("l.MPF", "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-10 Y30.123 Z-10\nG1 X110 F600\nM30\n");
  const std::string run = " --machine mill --stock box:0,0,-20,100,60,0 ";
  expect_coarse_shapes("s.MPF" + run + "--tool 1=ballmill:d=8 ", {{5, 1, 2 * std::sqrt(7), 180}});
  expect_coarse_shapes("s.MPF" + run + "--tool 1=chamfer:d=12,a=60 ",
                       {{5, 1, 2 * std::tan(3.14159265 / 6), 180}});
  expect_coarse_shapes("l.MPF" + run + "--tool 1=lollipop:d=8,n=4 ",
                       {{5, 4 + 2 * std::sqrt(3), 8, 180}});
}

// A program with a T-slot mill is measured by voxels: so are the plunges of its other mills, here
// over the edge of the stock (a segment) and into the full material, and beside a hole.
TEST_F(ShapeOfCuts, PlungesByVoxelsHaveTheirShareOfTheCircle) {
  const std::string plunges =
      "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-1 Y10 Z5\nG1 Z-2 F100\nG0 Z5\nG0 X20 Y20\nG1 Z-4\n"
      "G0 Z5\nG0 X25\nG1 Z-4\nG0 Z20\n";
  write("p.MPF", plunges + "T2 M6\nS500 M3\nG0 X60 Y-10\nG1 Z-5\nG1 Y0\nG1 Y-10\nG0 Z20\nM30\n");
  write("ball.MPF", plunges + "T2 M6\nS500 M3\nG0 X60 Y-10\nG1 Z-5\nG0 Z20\nM30\n");
  const double angle = std::acos(0.2), pi = 3.14159265;  // 4 of 10 mm are over the material
  const double segment = (angle - 0.2 * std::sin(angle)) / pi * 360;
  const double lens = (2 * std::acos(0.5) - 0.5 * std::sqrt(3)) / pi;  // of two circles, r apart
  expect_shapes(
      "p.MPF --machine mill --stock box:0,0,-10,50,40,0 --tool 1=endmill:d=10 "
      "--tool 2=tslot:d=8,w=2,n=3 ",
      {{5, 2, 4, segment}, {8, 4, 10, 360}, {11, 4, -1, 360 * (1 - lens)}});
  expect_shapes(
      "ball.MPF --machine mill --stock box:0,0,-10,50,40,0 --tool 1=ballmill:d=8 "
      "--tool 2=lollipop:d=8,n=3 ",
      {{8, 4, 8, 360}});
}

// An arc of a radius below the cutter's: a helix into the full material is cut by half of the
// cutter, and so is a circle that widens a bore by a millimetre by a sixth.
TEST_F(ShapeOfCuts, NarrowArcsAreCutByTheFrontOfTheCutter) {
  const std::string head = "G17 G90 G71\nT1 M6\nS5000 M3\n";
  write("helix.MPF", head + "G0 X3 Y0 Z1\nG1 Z0 F300\nG3 X3 Y0 Z-2 I-3\nG3 Z-4 I-3\nM30\n");
  write("bore.MPF", head + "G0 X0 Y0 Z-5\nG1 X3 F600\nG3 I-3\nM30\n");
  const std::string block = "helix.MPF --machine mill --stock box:-9,-9,-6,9,9,0 ";
  for (const char* const flutes : {" ", ",l=30 "})
    expect_coarse_shapes(block + "--tool 1=endmill:d=10" + flutes,
                         {{6, -1, 10, 180}, {7, -1, 10, 180}});
  expect_coarse_shapes("bore.MPF --machine mill --stock tube:24,14,-8,0 --tool 1=endmill:d=10 ",
                       {{6, 5, 1, 60}});
}

// In the half plane of a turned part. The second drill widens the hole of the first; where that is
// 6 mm wide, the point of a drill of 118 degrees is 1.803 mm high.
TEST_F(ShapeOfCuts, DrillsOnTheAxisOfALatheCutAllRound) {
  write("d.MPF",
        "G18 G90 G71 DIAMON\nT1 D1\nG97 S1000 F0.1 M4\nG0 X0 Z5\nG1 Z-12\nG0 Z5\nT2 D1\n"
        "G0 X0 Z5\nG1 Z-12\nG0 Z5\nM30\n");
  expect_shapes(
      "d.MPF --machine lathe --stock cylinder:40,-30,0 --tool 1=endmill:d=6 "
      "--tool 2=endmill:d=10 ",
      {{5, 12, 6, 360}, {9, 12, 10, 360 * (1 - 0.36)}});
  expect_shapes(
      "d.MPF --machine lathe --stock cylinder:40,-30,0 --tool 1=endmill:d=6 "
      "--tool 2=drill:d=10,a=118 ",
      {{5, 12, 6, 360}, {9, 10.197, 10, 360 * (1 - 0.36)}});
}

TEST_F(ShapeOfCuts, TurningPassHasItsDepthAlone) {
  write("t.MPF",
        "G18 G90 G71 DIAMON\nT1 D1\nG96 S200 F0.2 M4 LIMS=2000\nG0 X54 Z5\nG1 Z-40\nG0 X70\n"
        "G0 Z5\nG0 X48\nG1 Z-35\nG0 X70\nM30\n");
  expect_shapes("t.MPF --machine lathe --stock cylinder:60,-60,0 --tool 1=turning:insert=R,d=4 ",
                {{5, 3, 0, 0}, {9, 3, 0, 0}});
}

}  // namespace
}  // namespace mrsim
