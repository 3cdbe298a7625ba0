// The two example parts at default settings, against their exact volumes.
#include "run_program.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using namespace mrsim::testing;

constexpr double kPi = std::numbers::pi;
const double kRemoved2F = 2 * (5 * 37.5 * kPi + 6.25 * kPi);
const double kPart2F = 60000 - kRemoved2F;
const double kPart2S =
    kPi * (625 * 25 + (2790 - 378 * kPi) + 225 * 14 + (500 + 125 * kPi + 250.0 / 3));

class Figures : public CliTest {
 protected:
  double part_volume(const std::string& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return number_after(outcome.out, "volume");
  }
};

TEST_F(Figures, AMilledPartHasItsVolume) {
  const Outcome outcome = run("PRIMER_2F.MPF --stock block.stl -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(number_after(outcome.out, "removed"), kRemoved2F, 0.005);
  EXPECT_NEAR(number_after(outcome.out, "volume"), kPart2F, 0.005);
  EXPECT_NEAR(number_after(outcome.out, "the mesh"), kPart2F, 0.0002 * kPart2F);
  EXPECT_TRUE(exists("part.stl"));
}

TEST_F(Figures, ATurnedPartHasItsVolume) {
  const Outcome outcome = run("PRIMER_2S.MPF --stock bar.stl -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(number_after(outcome.out, "volume"), kPart2S, 0.02);
  EXPECT_NEAR(number_after(outcome.out, "the mesh"), kPart2S, 0.0003 * kPart2S);
}

// A bar of 10 mm radius: what the thread would take is left, and nothing collides in its groove.
TEST_F(Figures, PartWithAThreadKeepsItsDiameter) {
  write("thread.nc",
        "%\nO1\nG21 G40 G99\nT0303 (THREADING TOOL 60 DEG)\nG97 S800 M3\nG0 X24. Z4.\n"
        "G92 X19.4 Z-18. F1.5\nX19.\nX18.6\nG0 X60. Z50.\n"
        "T0101 (OD ROUGH CNMG 120404)\nG0 X18. Z2.\nG1 Z-10. F0.2\nX24.\nG0 X60.\nZ50.\nM30\n%\n");
  const Outcome outcome = run("thread.nc --stock cylinder:20,-40,0 -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "thread-not-cut")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "3 passes of a thread of 1.5 mm")) << outcome.err;
  EXPECT_FALSE(contains(outcome.err, "rapid-collision")) << outcome.err;
  EXPECT_NEAR(number_after(outcome.out, "removed"), 596.9, 5) << outcome.out;
}

// For a counter spindle: the drill points to +Z, and an insert that cuts there has its hand to
// tell.
TEST_F(Figures, ToolsMayFeedTowardsACounterSpindle) {
  write(
      "drill.nc",
      "O1\nG21 G40 G99\nT0101 (DRILL 10MM)\nG97 S800 M3\nG0 X0 Z-2.\nG1 Z30. F.1\nG0 Z-10.\nM30\n");
  const Outcome drilled = run("drill.nc --machine lathe --stock cylinder:40,0,50 -o part.stl");
  ASSERT_EQ(drilled.code, 0) << drilled.err;
  const double point = 5 / std::tan(kPi * 59 / 180);
  EXPECT_NEAR(number_after(drilled.out, "removed"), 25 * kPi * (30 - point * 2 / 3), 0.01);
  const auto turn = [&](const std::string& comment) {
    write("turn.nc", "O1\nG21 G40 G99\nT0101 (CNMG 120404" + comment +
                         ")\nG96 S200 M3\nG0 X46. Z-2.\nG1 Z20. F.2\nX52.\nG0 Z-2.\nM30\n");
    return run("turn.nc --stock cylinder:50,0,50 -o part.stl").err;
  };
  EXPECT_TRUE(contains(turn(""), "[insert-hand]")) << turn("");
  EXPECT_FALSE(contains(turn(" LEFT HAND"), "[insert-hand]"));
  write("face.nc",
        "O1\nG21 G40 G99\nT0101 (CNMG 120404)\nG96 S200 M3\nG0 X54. Z0\nG1 X-1.6 F.2\n"
        "G0 X54.\nG1 Z5.\nG0 X100. Z100.\nM30\n");
  EXPECT_FALSE(contains(run("face.nc -o part.stl").err, "[insert-hand]"));  // a way back
}

// A cycle for grooves in a face, and a blade for the outside.
TEST_F(Figures, BladesThatPlungeAlongZAreTold) {
  const auto groove = [&](const std::string& spec) {
    write("face.nc",
          "O1\nG21 G40 G99\nT0303\nG97 S500 M3\nG0 X40. Z2.\nG74 R.5\n"
          "G74 X30. Z-5. P2000 Q2000 F.08\nG0 Z100.\nM30\n");
    return run("face.nc --stock cylinder:60,-30,0 -o part.stl --tool 3=grooving:w=3," + spec).err;
  };
  EXPECT_TRUE(contains(groove("tip=3"), "[blade-direction]")) << groove("tip=3");
  EXPECT_FALSE(contains(groove("tip=7"), "[blade-direction]"));
  write("turn.nc",
        "O1\nG21 G40 G99\nT0303\nG96 S150 M3\nG0 X46. Z2.\nG1 Z-10. F.1\nX52.\nG0 Z2.\n"
        "X42.\nG1 Z-10.\nZ2.\nG0 X60. Z50.\nM30\n");
  const Outcome turned =
      run("turn.nc --stock cylinder:50,-30,0 -o part.stl --tool 3=grooving:w=3,tip=3");
  EXPECT_FALSE(contains(turned.err, "[blade-direction]")) << turned.err;
}

// A coarse mesh still tells the volume of the exact part.
TEST_F(Figures, VolumeIsThatOfTheExactPart) {
  EXPECT_NEAR(part_volume("PRIMER_2F.MPF --stock block.stl --tolerance 0.1 -o part.stl"), kPart2F,
              0.02);
  EXPECT_NEAR(part_volume("PRIMER_2S.MPF --stock bar.stl --tolerance 0.1 -o part.stl"), kPart2S,
              0.5);
}

// A Ø50 x 25 cylinder, cut on centre lines; under G42 the control leaves a cusp.
// An arc that only touches the stock.
TEST_F(Figures, NothingRemovedIsNotLessThanNothing) {
  write("t.nc", "G21 G90 G17\nT1 M6\nS3000 M3\nG0 X30 Y5 Z5\nG1 Z0 F300\nG19 G2 Y35 Z0 R18\nM30\n");
  const Outcome outcome =
      run("t.nc --dialect fanuc --machine mill --tool 1=bullmill:d=12,r=2 "
          "--stock box:0,0,-20,60,40,0 --json out.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GE(number_after(read("out.json"), "\"removed\":"), 0);
  EXPECT_LE(number_after(read("out.json"), "\"part\":"), 48000);
}

TEST_F(Figures, FanucsPocketHasItsVolume) {
  const std::string folder = MRSIM_DATA_DIR "/";
  const std::string rest =
      " --stock box:-30,-30,-30,30,30,0 --tool 1=endmill:d=10 --tolerance 0.01 -o part.stl";
  EXPECT_NEAR(60 * 60 * 30 - part_volume(folder + "FANUC_POCKET_G40.NC" + rest), 25 * 625 * kPi,
              0.02);
  EXPECT_NEAR(60 * 60 * 30 - part_volume(folder + "FANUC_POCKET.NC" + rest), 49044.5, 0.1);
}

// G71 with a pocket between two cones, then G70: discs of radius 20, 12, 20 and 32, and two cones
// between 20 and 12 of 8 each.
TEST_F(Figures, APartOfATurningCycleHasItsVolume) {
  write("shaft.nc",
        "O1\nT0101\nG0 X64 Z2\nG71 U4 R1\nG71 P10 Q20 U.4 W0 F.3\nN10 G0 X40\nG1 Z-10 F.1\n"
        "X24 Z-18\nZ-30\nX40 Z-38\nZ-50\nN20 X64\nG70 P10 Q20\nM30\n");
  const double cone = 8 * (400 + 20 * 12 + 144) / 3.0;
  EXPECT_NEAR(part_volume("shaft.nc --stock cylinder:64,-60,0 -o part.stl"),
              kPi * (10 * 400 + 2 * cone + 12 * 144 + 12 * 400 + 10 * 1024), 0.01);
}

TEST_F(Figures, VolumeErrorFallsByThreeWhenTheVoxelIsHalved) {
  const std::string command = "PRIMER_2S.MPF --stock cylinder:50,0,51 --voxel ";
  const double coarse = std::fabs(part_volume(command + "0.5") - kPart2S);
  const double fine = std::fabs(part_volume(command + "0.25") - kPart2S);
  EXPECT_LT(3 * fine, coarse);
}

TEST_F(Figures, BytesAreTheSameForAnyNumberOfThreads) {
  for (const char* n : {"1", "2", "7"})
    ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl --voxel 0.5 --threads " + std::string(n) +
                  " -o t" + n + ".stl")
                  .code,
              0);
  EXPECT_EQ(read("t1.stl"), read("t2.stl"));
  EXPECT_EQ(read("t1.stl"), read("t7.stl"));
}

TEST_F(Figures, BytesAreTheSameForAnyInstructionSet) {
  for (const char* level : {"scalar", "avx2", "avx512"}) {
    ::setenv("MRSIM_SIMD", level, 1);
    for (const std::string part : {"2F.MPF --stock block.stl", "2S.MPF --stock bar.stl"})
      ASSERT_EQ(run("PRIMER_" + part + " --voxel 1 -o " + level + part.substr(0, 2) + ".stl").code,
                0);
  }
  ::unsetenv("MRSIM_SIMD");
  for (const std::string part : {"2F.stl", "2S.stl"}) {
    EXPECT_EQ(read("scalar" + part), read("avx2" + part));
    EXPECT_EQ(read("scalar" + part), read("avx512" + part));
  }
}

TEST_F(Figures, ExactPrimitiveIsTheStockOfTheFile) {
  const std::string voxel = " --voxel 0.5 -o ";
  ASSERT_EQ(run("PRIMER_2S.MPF --stock bar.stl" + voxel + "a.stl").code, 0);
  ASSERT_EQ(run("PRIMER_2S.MPF --stock cylinder:50,0,51" + voxel + "b.stl").code, 0);
  EXPECT_EQ(read("a.stl"), read("b.stl"));
}

// Five rows of a relief. The wall that was named beside them had the thickness of what stands below
// the stock's top, 8.6 mm, amid air.
TEST_F(Figures, ThinWallsAreThinnerThanAFewVoxels) {
  std::string text = "G90 G17 G21\nT1 M6\nS20000 M3\nF600\nG0 Z5\n";
  const auto row = [&](double x, double y, double way, const std::vector<double>& depths) {
    text += "G0 X" + std::to_string(x) + " Y" + std::to_string(y) + "\n";
    for (const double z : depths) {
      text += "G1 X" + std::to_string(x) + " Z" + std::to_string(z) + "\n";
      x += way;
    }
    text += "G0 Z5\n";
  };
  row(43.2, 58, 0.45, {-5.153, -5.18, -4.882, -4.456, -4.179});
  row(44.55, 58.5, -0.45, {-3.872, -4.317, -4.625, -4.605, -4.282});
  row(42.75, 59, 0.45, {-4.015, -4.355, -4.434, -4.175, -3.723});
  row(44.1, 59.5, -0.45, {-4.409, -4.562, -4.384, -4.03, -3.769});
  row(42.75, 60, 0.45, {-3.916, -4.251, -4.521, -4.506});
  write("relief.nc", text + "M30\n");
  ASSERT_EQ(run("relief.nc --stock box:-3,-3,-10,65,65,0 --tool 1=endmill:d=1 --voxel 0.16 "
                "-o part.stl --json part.json")
                .code,
            0);
  const nlohmann::json places = nlohmann::json::parse(read("part.json"))["thin"]["places"];
  EXPECT_FALSE(places.empty());
  for (const nlohmann::json& place : places) EXPECT_LT(place["thickness"], 0.32) << place;
}

}  // namespace
}  // namespace mrsim
