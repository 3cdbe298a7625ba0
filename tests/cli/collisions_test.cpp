// Collisions as a user sees them: line, place and depth; errors when asked; quiet for good
// programs.
#include "run_program.h"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class CollisionsSeen : public CliTest {
 protected:
  // A slot 3 mm deep, then a rapid 1 mm too low through what stands beside it.
  void SetUp() override {
    CliTest::SetUp();
    write("dive.MPF",
          "G54\nG17 G90 G71\nT1 M6\nG0 X-10 Y10 Z5\nG0 Z-3\nG1 X50 F100\nG0 Y20\n"
          "G0 Z-1\nG0 X-10\nG0 Z5\nM30\n");
  }
  Outcome dive(const std::string& more) {
    return run("dive.MPF --machine mill --stock box:0,0,-10,40,30,0 --voxel 0.5 " + more);
  }
};

TEST_F(CollisionsSeen, ARapidInMaterialIsAWarningWithItsLine) {
  const Outcome outcome = dive("--tool 1=endmill:d=6 -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err,
                       "dive.MPF:9:1: warning: the cutter of T1 runs 1.000 mm deep into material "
                       "in a rapid; deepest at ("))
      << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "[rapid-collision]\n    G0 X-10\n    ^")) << outcome.err;
  EXPECT_EQ(outcome.err.find("collision"), outcome.err.rfind("collision")) << outcome.err;
  EXPECT_TRUE(exists("part.stl"));
}

TEST_F(CollisionsSeen, AMillThatGivesNoShankHasOne) {
  // A slot 3 mm deep by flutes of 1 mm, then by the head of a T-slot mill.
  const Outcome flutes = dive("--tool 1=endmill:d=6,l=1 -o part.stl");
  EXPECT_TRUE(contains(flutes.err,
                       "dive.MPF:6:1: warning: the shank of T1, none given, taken as Ø5.7, runs "
                       "1.000 mm deep into material; deepest at ("))
      << flutes.err;
  const Outcome neck = dive("--tool 1=tslot:d=12,w=1,n=6 -o part.stl");
  EXPECT_TRUE(
      contains(neck.err, "dive.MPF:6:1: warning: the shank of T1, none given, taken as Ø6,"))
      << neck.err;
  EXPECT_FALSE(contains(neck.err, "neck-unchecked")) << neck.err;
  const Outcome unknown = dive("--tool 1=tslot:d=12,w=1 -o part.stl");
  EXPECT_TRUE(contains(unknown.err,
                       "note: tool 1: nothing tells how wide it is above its head, so whether it "
                       "runs into material there was not checked: give neck_diameter or shank "
                       "[neck-unchecked]"))
      << unknown.err;
}

TEST_F(CollisionsSeen, StrictRefusesThem) {
  const Outcome outcome = dive("--tool 1=endmill:d=6 --strict -o part.stl");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_TRUE(contains(outcome.err, "rapid-collision")) << outcome.err;
  EXPECT_FALSE(exists("part.stl"));
}

TEST_F(CollisionsSeen, ShankAndHolderAreNamed) {
  write("tools.toml",
        "[[tool]]\nid = \"1\"\ntype = \"endmill\"\ndiameter = 6\nflute_length = 2\n"
        "shank = [[8, 0.5]]\nholder = [[30, 30, 20]]\n");
  const Outcome outcome = dive("--tools tools.toml --json r.json --junit r.xml");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  // Tip at -3: the shank begins at -1, the holder at -0.5.
  EXPECT_TRUE(contains(outcome.err, "dive.MPF:6:1: warning: the shank of T1 runs 1.000 mm deep"))
      << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "dive.MPF:6:1: warning: the holder of T1 runs 0.500 mm deep"))
      << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "[shank-collision]")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "[holder-collision]")) << outcome.err;
  // For programs, too: red, and the deepest first, of equal ones the largest.
  const nlohmann::json lines = nlohmann::json::parse(read("r.json"))["collisions"]["lines"];
  ASSERT_GE(lines.size(), 2u);
  const auto order = [&](std::size_t k) {
    return std::pair(-std::lround(1000 * lines[k]["depth"].get<double>()),
                     -lines[k]["volume"].get<double>());
  };
  for (std::size_t k = 1; k < lines.size(); ++k) EXPECT_LE(order(k - 1), order(k)) << lines;
  for (const nlohmann::json& line : lines) {
    EXPECT_GT(line["volume"], 0) << line;
    EXPECT_EQ(line["seconds"] > 0, line["line"] > 5) << line;  // line 4 begins anywhere: no time
  }
  const std::string xml = read("r.xml");
  EXPECT_TRUE(contains(xml, "failures=\"1\"")) << xml;
  EXPECT_TRUE(contains(xml, "name=\"collisions\"><failure")) << xml;
  EXPECT_TRUE(contains(xml, "dive.MPF:6: the shank of T1 runs 1.000 mm deep into ")) << xml;
  EXPECT_TRUE(contains(xml, " mm³ of material, motion 3 at ")) << xml;
}

TEST_F(CollisionsSeen, ALoopIsOneWarningWithItsCalls) {
  write("loop.MPF", "G54\nG17 G90 G71\nT1 M6\nG0 X5 Y10 Z5\nG1 Z-1 F100\nG0 Z5\nDEEP P3\nM30\n");
  write("DEEP.SPF", "G91\nG0 X10\nG0 Z-7\nG0 Z7\nG90\nM17\n");
  const Outcome outcome =
      run("loop.MPF --machine mill --stock box:0,0,-10,60,30,0 --voxel 0.5 --tool 1=endmill:d=6");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "DEEP.SPF:3:1: warning: the cutter of T1 runs 2.000 mm"))
      << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "; 3 motions of this line do, this is the deepest"))
      << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "called from loop.MPF:7")) << outcome.err;
}

TEST_F(CollisionsSeen, WithdrawalsOfInsertsAreOneNote) {
  write("turn.nc",
        "%\nO1\nG21 G18 G99\nT101\nG0 X44. Z2.\nG1 Z-30. F.2\nG0 X52.\nG0 Z2.\n"
        "G0 X40.\nG1 Z-20.\nG0 X52.\nM30\n%\n");
  const Outcome outcome =
      run("turn.nc --machine lathe --dialect fanuc --stock cylinder:50,-50,0 "
          "--tool 1=turning:insert=CNMG,lead_angle=95,nose_radius=0.4 --strict -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "turn.nc:7:1: note: 2 lines withdraw an insert by rapids"))
      << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "[withdrawal-scrapes]")) << outcome.err;
}

TEST_F(CollisionsSeen, GoodProgramsHaveNone) {
  for (const char* job : {"PRIMER_2F.MPF --stock block.stl", "PRIMER_2S.MPF --stock bar.stl"}) {
    const Outcome outcome = run(std::string(job) + " --voxel 1");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(contains(outcome.err, "collision")) << outcome.err;
  }
}

}  // namespace
}  // namespace mrsim
