// What a run chooses where neither --voxel nor --tolerance is given.
#include "run_program.h"

#include <cmath>
#include <string>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Defaults : public CliTest {
 protected:
  /// The JSON of a run whose only cut is a groove of 0.2 mm by `tool`.
  Json groove(const std::string& tool, const std::string& rest = "") {
    write("groove.nc",
          "G21 G90\nT1 M6\nS9000 M3\nG0 X10 Y10 Z2\nG1 Z-.2 F100\nX30 Y17 F400\nG0 Z2\n");
    const Outcome o = run("groove.nc --stock box:0,0,-10,40,30,0 --tool 1=" + tool +
                          " -q -o part.stl --json r.json " + rest);
    EXPECT_EQ(o.code, 0) << o.err;
    return Json::parse(read("r.json"));
  }

  // The word for a corner of a part of 60 sides whose centre is (x, y).
  static std::string at_side(double x, double y, int side, double radius = 120) {
    const double turn = 6.28318530718 * side / 60, r = radius * (1 + 0.2 * std::sin(3 * turn));
    return "X" + std::to_string(x + r * std::cos(turn)) + " Y" +
           std::to_string(y + r * std::sin(turn));
  }

  /// The JSON of a run that cuts twelve parts out of a sheet, in five passes, then does `rest`
  /// (tool 2: a V-bit).
  Json sheet(const std::string& rest) {
    std::string text = "%\nO1\nG21 G90 G17\nT1 M6\nS18000 M3\nG0 Z20\n";
    for (int k = 0; k < 12; ++k) {
      const double x = 300 + 500 * (k % 4), y = 250 + 350 * (k / 4);
      text += "G0 " + at_side(x, y, 0) + "\n";
      for (int pass = 1; pass <= 5; ++pass) {
        text += "G1 Z" + std::to_string(-3.66 * pass) + " F1000\n";
        for (int side = 1; side <= 60; ++side) text += "G1 " + at_side(x, y, side) + " F6000\n";
      }
      text += "G0 Z20\n";
    }
    write("sheet.nc", text + rest + "M30\n%\n");
    const Outcome o =
        run("sheet.nc --stock box:0,0,-18,2440,1220,0 --tool 1=flat:d=6 --tool "
            "2=chamfer:d=12,a=90 -q -o part.stl --json r.json");
    EXPECT_EQ(o.code, 0) << o.err;
    return Json::parse(read("r.json"));
  }
};

TEST_F(Defaults, VoxelSuitsTheRadiusWithWhichAToolCuts) {
  EXPECT_EQ(groove("endmill:d=6")["voxel"]["value"], 0.1);
  EXPECT_EQ(groove("chamfer:d=6,a=90")["voxel"]["value"], 0.025);  // an eighth of 0.2 mm
  EXPECT_EQ(groove("ballmill:d=6")["voxel"]["value"], 0.1);
}

TEST_F(Defaults, GrooveOfAVBitHasItsVolume) {
  // A prism of 0.2 mm by 0.4, its ends halves of a cone.
  const Json j = groove("chamfer:d=6,a=90");
  const double length = 21.1896201, pi = 3.14159265;
  EXPECT_NEAR(j["volume"]["removed"], 0.04 * length + pi * 0.008 / 3, 5e-4);
}

// Text on a large plate, by default: a few letters within a tolerance, many of them on a grid on
// which their grooves, 0.17 mm wide, are still there.
TEST_F(Defaults, EngravedTextOnALargePlateIsNotLost) {
  const double pi = 3.14159265, radius = 0.15 * std::tan(pi / 6);
  for (const int rows : {1, 14}) {
    std::string text = "%\nO1\nG21 G90\nT1 M6\nS9000 M3\nG0 Z5\n";
    double length = 0;
    int strokes = 0;
    for (int row = 0; row < rows; ++row)
      for (int k = 0; k < 60; ++k, ++strokes) {
        const double x = 10 + 4.5 * k, y = 10 + 13 * row, to = 4 + 0.05 * k;
        const auto at = [](double px, double py) {
          return "X" + std::to_string(px) + " Y" + std::to_string(py);
        };
        text += "G0 " + at(x, y) + "\nZ1\nG1 Z-.15 F300\n" + at(x + 2, y + to) + " F900\nG0 Z5\n";
        length += std::hypot(2, to);
      }
    write("text.nc", text + "M30\n%\n");
    const Outcome o =
        run("text.nc --stock box:0,0,-10,300,200,0 --tool 1=chamfer:d=6,tip_angle=60 "
            "-q -o part.stl --json r.json");
    EXPECT_EQ(o.code, 0) << o.err;
    const Json j = Json::parse(read("r.json"));
    EXPECT_EQ(j["tolerance"]["value"].is_null(), rows > 1);
    const double removed = 0.15 * radius * length + strokes * pi * radius * radius * 0.15 / 3;
    EXPECT_NEAR(j["volume"]["removed"], removed, (rows > 1 ? 0.25 : 0.01) * removed);
    EXPECT_LT(j["voxel"]["value"], 2 * radius);  // narrower than a groove
  }
}

// 0.3 mm deep, on a plate whose usual tolerance would be 0.4 mm.
TEST_F(Defaults, ShallowGrooveOnALargePlateIsNotLost) {
  write("groove.nc",
        "G21 G90 G17\nT1 M6\nS1000 M3\nG0 Z5\nG0 X813 Y610\nG1 Z-0.3 F300\nG1 X1813\nG0 "
        "Z5\nM30\n");
  const Outcome o =
      run("groove.nc --stock box:0,0,-20,2440,1220,0 --tool endmill:d=6 -q -o part.stl "
          "--json r.json");
  EXPECT_EQ(o.code, 0) << o.err;
  const Json j = Json::parse(read("r.json"));
  const double exact = 0.3 * (6 * 1000 + 3.14159265 * 9);
  EXPECT_NEAR(j["volume"]["removed"], exact, 0.01 * exact);
}

// A comment tells its angle alone: the cone reaches up to the stock's top.
TEST_F(Defaults, AVBitWithoutDiameterHasTheSameGroove) {
  write("vee.nc",
        "%\nO1\nG21 G90\nT1 M6 (V-BIT 90 DEG)\nS9000 M3\nG0 X10 Y10 Z2\nG1 Z-.2 F100\nX30 Y17 "
        "F400\nG0 Z2\nM30\n%\n");
  for (const char* stock : {"--stock box:0,0,-10,40,30,0", ""}) {
    const Outcome o = run(std::string("vee.nc -o part.stl --json r.json ") + stock);
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_NE(o.err.find("cone-assumed"), std::string::npos) << o.err;
    const double length = 21.1896201, pi = 3.14159265;
    EXPECT_NEAR(Json::parse(read("r.json"))["volume"]["removed"], 0.04 * length + pi * 0.008 / 3,
                5e-4);
  }
  EXPECT_EQ(run("check vee.nc").code, 0);
}

// A thread behind a shoulder, and one in a bore: their inserts are as small as they must be.
TEST_F(Defaults, ThreadingInsertsWithoutDataFitTheirThreads) {
  write("out.nc",
        "%\nO1\n(T1 OD ROUGH CNMG 120408)\n(T3 OD THREAD)\nG18 G21 G40 G99\nT0101\nG97 S1000 M3\n"
        "G0 X44. Z2.\nG71 U1.5 R0.5\nG71 P10 Q20 U0 W0 F0.2\nN10 G0 X20.\nG1 Z-30.\nX40.\nN20 "
        "Z-50.\nG0 X100. Z100.\nT0303\nG97 S800 M3\nG0 X24. Z3.\nG76 P010060 Q100 R0.05\nG76 "
        "X18.16 Z-27. P920 Q300 F1.5\nG0 X100. Z100.\nM30\n%\n");
  write("in.nc",
        "%\nO1\n(T3 ID THREAD)\n(T4 ID GROOVE 2MM)\nG18 G21 G40 G99\nT0303\nG97 S800 M3\nG0 X9. "
        "Z3.\nG76 P010060 Q100 R0.05\nG76 X12. Z-15. P920 Q300 F1.5\nG0 Z100.\nT0404\nG97 S800 M3\n"
        "G0 X9. Z3.\nZ-15.\nG1 X14. F0.05\nG0 X9.\nZ3.\nM30\n%\n");
  const auto lines = [&](const std::string& arguments) {
    const Outcome o = run(arguments + " -q -o part.stl --json r.json");
    EXPECT_EQ(o.code, 0) << o.err;
    return Json::parse(read("r.json"))["collisions"]["lines"];
  };
  EXPECT_TRUE(lines("out.nc").empty()) << lines("out.nc");
  EXPECT_TRUE(lines("in.nc --stock tube:30,10,-30,0").empty());
}

// The stock that comments state is that of the run.
TEST_F(Defaults, TheStockThatCommentsStateIsThatOfTheRun) {
  const std::string cut =
      "G21 G90\nT1 M6 (6MM ENDMILL)\nS9000 M3\nG0 X10 Y10 Z2\nG1 Z-2 F100\nX30\nG0 Z2\nM30\n%\n";
  write("a.nc", "%\nO1\n(STOCK/BLOCK, 40, 30, 10, 0, 0, 10)\n" + cut);
  const Outcome o = run("a.nc -q -o part.stl --json r.json");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(Json::parse(read("r.json"))["stock"]["volume"], 12000);
  write("b.nc", "%\nO1\n(STOCK/BLOCK, 40, 30, 10, 0, 60, 10)\n" + cut);
  EXPECT_NE(run("b.nc -o part.stl").err.find("stock-elsewhere"), std::string::npos);
}

TEST_F(Defaults, ToleranceThatIsGivenIsKept) {
  const Json j = groove("chamfer:d=6,a=90", "--tolerance 0.004");
  EXPECT_EQ(j["tolerance"]["value"], 0.004);
}

// Twenty pecks leave one wall: they are no reason for a grid.
TEST_F(Defaults, PeckedHolesAreMeshedWithinATolerance) {
  write(
      "holes.nc",
      "%\nO1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X0 Y0\nG43 H1 Z20.\nG83 X0. Y0. Z-40. R2. Q2. F200\n"
      "X20.\nY20.\nX0.\nG80\nG0 Z20.\nM30\n%\n");
  const Outcome o = run(
      "holes.nc --stock box:-10,-10,-45,30,30,0 --tool 1=drill:d=6 -q -o part.stl --json r.json");
  EXPECT_EQ(o.code, 0) << o.err;
  const Json j = Json::parse(read("r.json"));
  EXPECT_GT(j["tolerance"]["value"], 0);
  EXPECT_LT(j["mesh"]["triangles"], 20000);
}

// Nor are the turns of a helix, by which a bore is milled.
TEST_F(Defaults, HelicalBoresAreMeshedWithinATolerance) {
  std::string program =
      "%\nO1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X10. Y0.\nG43 H1 Z2.\nG1 Z0. F200\n";
  for (int k = 1; k <= 20; ++k) program += "G3 Z" + std::to_string(-k) + ". I-10. J0.\n";
  write("bore.nc", program + "G3 I-10. J0.\nG0 Z20.\nM30\n%\n");
  const Outcome o = run(
      "bore.nc --stock box:-30,-30,-25,30,30,0 --tool 1=endmill:d=12 -q -o part.stl --json r.json");
  EXPECT_EQ(o.code, 0) << o.err;
  const Json j = Json::parse(read("r.json"));
  EXPECT_GT(j["tolerance"]["value"], 0);
  EXPECT_LT(j["mesh"]["triangles"], 20000);
}

// Too many cells for the tolerance that suits its size, but not for twice that one.
TEST_F(Defaults, PlatesOfManyPocketsAreMeshedWithinACoarserTolerance) {
  std::string program = "%\nO1\nG21 G90 G17 G54\nT1 M6\nS9000 M3\nG0 Z20. F800\n";
  const auto at = [](char axis, double mm) { return axis + std::to_string(mm); };
  for (int k = 0; k < 144; ++k) {
    const double x = 100.0 * (k % 12 + 0.5) / 12, y = 100.0 * (k / 12 + 0.5) / 12;
    program += "G0 " + at('X', x) + at('Y', y - 2) + "\nZ1.\nG1 Z-4.\n" + at('X', x + 1.2) +
               "\nG3 " + at('X', x + 2) + at('Y', y - 1.2) + " J.8\nG1 " + at('Y', y + 1.2) +
               "\nG3 " + at('X', x + 1.2) + at('Y', y + 2) + " I-.8\nG1 " + at('X', x - 1.2) +
               "\nG3 " + at('X', x - 2) + at('Y', y + 1.2) + " J-.8\nG1 " + at('Y', y - 1.2) +
               "\nG3 " + at('X', x - 1.2) + at('Y', y - 2) + " I.8\nG1 " + at('X', x) +
               "\nG0 Z2.\n";
  }
  write("plate.nc", program + "G0 Z20.\nM30\n%\n");
  const Outcome o = run(
      "plate.nc --stock box:0,0,-8,100,100,0 --tool 1=endmill:d=2 -q -o part.stl --json r.json");
  EXPECT_EQ(o.code, 0) << o.err;
  const Json j = Json::parse(read("r.json"));
  EXPECT_DOUBLE_EQ(j["tolerance"]["value"], 0.034);
  EXPECT_LT(j["mesh"]["triangles"], 60000);
}

// Crests between the turns of one motion are as many as between motions of one turn.
TEST_F(Defaults, CrestsOfAWindingHelixAreNoPlainBore) {
  write("wound.nc",
        "%\nG21 G90 G17\nT1 M6\nS3000 M3\nG0 X19. Y15.\nZ1.\nG1 Z0.5 F300\n"
        "G2 X19. Y15. Z-9. I-4. J0. P25 F600\nG1 X15.\nG0 Z9.\nM2\n%\n");
  const Outcome o =
      run("wound.nc --stock box:0,0,-15,30,30,0 --dialect ngc --tool 1=ballmill:d=4 -q -o part.stl "
          "--json r.json");
  EXPECT_EQ(o.code, 0) << o.err;
  const Json memory = Json::parse(read("r.json"))["memory"];
  EXPECT_GT(memory["expected"].get<double>(), 0.7 * memory["peak"].get<double>());
}

// Nor are the passes of deep slots.
TEST_F(Defaults, SlotsInPassesAreMeshedWithinATolerance) {
  std::string program = "%\nO1\nG21 G90 G54\nT1 M6\nS9000 M3\nG0 X3. Y-3. Z2.\n";
  for (int slot = 0; slot < 20; ++slot) {
    program += "G0 X" + std::to_string(3 + 2.2 * slot) + " Y-3.\n";
    for (int pass = 1; pass <= 12; ++pass)
      program += "G1 Z-" + std::to_string(pass) + (pass % 2 ? ". F200\nY63.\n" : ". F200\nY-3.\n");
    program += "G0 Z2.\n";
  }
  write("fins.nc", program + "M30\n%\n");
  const Outcome o =
      run("fins.nc --stock box:0,0,-15,56,60,0 --tool 1=endmill:d=1 -q -o part.stl --json r.json");
  EXPECT_EQ(o.code, 0) << o.err;
  const Json j = Json::parse(read("r.json"));
  EXPECT_GT(j["tolerance"]["value"], 0);
  EXPECT_LT(j["mesh"]["triangles"], 10000);
  EXPECT_NEAR(j["volume"]["removed"], 20 * 12. * 60, 1e-3);
}

// Parts cut out of a large sheet in passes: its blocks are large, and many passes meet in each.
TEST_F(Defaults, PartsOfALargeSheetAreMeshedWithinATolerance) {
  const Json j = sheet("");
  EXPECT_FALSE(j["tolerance"]["value"].is_null());
  EXPECT_LT(j["mesh"]["triangles"], 60'000);
}

// The chamfer is a narrow groove, but a short one.
TEST_F(Defaults, ChamferOfOnePartDoesNotKeepALargeSheetFromItsTolerance) {
  std::string text = "T2 M6\nS18000 M3\nG0 X417 Y250 Z20\nG1 Z-2.9 F1000\n";
  for (int side = 1; side <= 60; ++side) text += "G1 " + at_side(300, 250, side, 117) + "\n";
  const Json j = sheet(text + "G0 Z20\n");
  EXPECT_FALSE(j["tolerance"]["value"].is_null());
  EXPECT_LT(j["mesh"]["triangles"], 60'000);
}

// The facets of a stock that another run has left are scanned, too.
TEST_F(Defaults, VoxelIsRaisedForACurvedStock) {
  write("round.nc", "G21 G90\nT1 M6\nG0 X-50 Y0 Z2\nG1 Z-1 F100\nG2 X-50 Y0 I50 J0\nG0 Z2\n");
  ASSERT_EQ(run("round.nc --stock cylinder:120,-40,0 --tool 1=flat:d=10 -q -o round.stl").code, 0);
  groove("flat:d=10", "");
  ASSERT_EQ(run("groove.nc --stock round.stl --tool 1=flat:d=10 -q -o p.stl --json r.json").code,
            0);
  const Json j = Json::parse(read("r.json"));
  EXPECT_NE(j["voxel"]["reason"].get<std::string>().find("the stock's curved surface is large"),
            std::string::npos);
}

// A contour at one depth and holes, no stock: all of it is in the part, and no rapid meets it.
TEST_F(Defaults, StockEndsAtZeroAboveAContourAndHoles) {
  write("part.nc",
        "G21 G90\nT1 M6\nS3000 M3\nG0 X-60. Y0.\nG0 Z2.\nG1 Z-5. "
        "F200\nX-40.\nY30.\nX40.\nY-30.\nX-40.\n"
        "Y0.\nG0 Z2.\nX0. Y0.\nG1 Z-20.\nG0 Z25.\nM30\n");
  const Outcome o = run("part.nc --tool 1=endmill:d=10 -q -o part.stl --json r.json");
  EXPECT_EQ(o.code, 0) << o.err;
  const Json j = Json::parse(read("r.json"));
  EXPECT_GT(j["volume"]["removed"], 10000);
  EXPECT_TRUE(j["collisions"]["lines"].empty()) << j["collisions"];
}

}  // namespace
}  // namespace mrsim
