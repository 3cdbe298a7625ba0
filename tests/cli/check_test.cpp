// `mrsim check` on programs, folders and pipes, `mrsim tools`, projects of CAMotics.
#include "run_program.h"

#include <filesystem>
#include <fstream>

namespace mrsim {
namespace {

using namespace mrsim::testing;

using CheckCli = CliTest;

const char* const kPart = "T1 M6 (6MM ENDMILL)\nG21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX20\nM30\n";

TEST_F(CheckCli, TellsWhatARunRefusesOrLeavesOut) {
  write("thread.nc", "G18 G21\nG96 S100\nT1 (CNMG 120408)\nG0 X50 Z2\nG33 Z-20 K1.5\n");
  const Outcome thread = run("check thread.nc");
  EXPECT_EQ(thread.code, 0);
  EXPECT_TRUE(contains(thread.err, "thread-not-cut")) << thread.err;
  write("bare.nc", "G1 X5 Y5 Z1 F100\nX6\n");
  EXPECT_EQ(run("check bare.nc").code, 1);
  EXPECT_EQ(run("check bare.nc --tool endmill:d=5").code, 0);
}

TEST_F(CheckCli, JsonKeepsTheExitCode) {
  write("unclear.nc", "%\nG90\nX1\nM30\n");
  EXPECT_EQ(run("check unclear.nc").code, 2);
  EXPECT_EQ(run("check unclear.nc --json").code, 2);
  EXPECT_EQ(run("check gone.nc --json").code, 1);
}

TEST_F(CheckCli, ManyProgramsAreOneProcess) {
  std::filesystem::create_directories(folder_ / "posts/inner");
  write("posts/a.nc", kPart);
  write("posts/inner/b.nc", "0 BEGIN PGM A MM\n");
  write("posts/readme.md", "no program");
  const Outcome text = run("check posts");
  EXPECT_EQ(text.code, 1);
  EXPECT_TRUE(contains(text.out, "2 programs, 1 failed")) << text.out;
  EXPECT_TRUE(contains(text.err, "Heidenhain")) << text.err;
  const Outcome json = run("check --json posts/a.nc posts");
  EXPECT_EQ(json.code, 1);
  EXPECT_TRUE(contains(json.out, "\"kind\":\"summary\",\"program\":\"posts/a.nc\"")) << json.out;
  EXPECT_TRUE(contains(json.out, "{\"kind\":\"total\",\"programs\":3,\"failed\":1")) << json.out;
}

// JSON is UTF-8, whatever bytes a name has.
TEST_F(CheckCli, JsonNamesAreUtf8) {
  write("b\xE6.nc", "G0 X0\n");
  for (const char* command :
       {"check --json 'b\xE6.nc'", "check --json 'b\xE6.nc' 'b\xE6.nc'", "check --json 'no\xE6.nc'",
        "trace --json 'no\xE6.nc'", "tools --json 'no\xE6.toml'"}) {
    const Outcome json = run(command);
    EXPECT_TRUE(contains(json.out, "\u0107.")) << json.out;  // as Latin-2
    EXPECT_FALSE(contains(json.out, "\xE6")) << command;
  }
}

TEST_F(CheckCli, TraceIsQuietAndNeedsNoTools) {
  write("bare.nc", "G1 X5 Y5 Z1 F100\nX6\n");
  const Outcome quiet = run("trace -q -o path.svg bare.nc");
  EXPECT_EQ(quiet.code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "path.svg"));
}

// The diameter of the table confirms what a remark says without a unit.
TEST_F(CheckCli, DiametersOfTablesConfirmTheirRemarks) {
  write("t.tbl",
        "T1 P1 D20 ;T-SLOT CUTTER 20MM X 4MM\nT2 P2 D6.35 ;1/4 V-BIT 60 DEG\n"
        "T3 P3 D5.105 ;#7 DRILL\nT4 P4 D3.175 ;1/8 X 3 DEG TAPER EM LOC 1.0\n"
        "T5 P5 D5.5 ;M6 CLEARANCE DRILL 6.6\nT6 P6 D3.3 ;DRILL\nT7 P7 D12 ;90DEG CHAMFER\n"
        "T8 P8 D12 ;T-SLOT\nT9 P9 D14 ;DOVETAIL 60\nT10 P10 D8 ;ALU 3 FLUTE\n");
  const Outcome tools = run("tools t.tbl");
  EXPECT_EQ(tools.code, 0) << tools.err;
  for (const char* tool : {"T1      T-slot mill Ø20", "T2      chamfer mill Ø6.35",
                           "T3      drill Ø5.105", "T4      tapered mill Ø3.175"})
    EXPECT_TRUE(contains(tools.out, tool)) << tool << "\n" << tools.out;
  // Without a size of its own a remark is about a tool of the table's; one that names a kind whose
  // shape it does not tell is no end mill.
  for (const char* tool : {"T6      drill Ø3.3", "T7      chamfer mill Ø12", "T10     end mill Ø8"})
    EXPECT_TRUE(contains(tools.out, tool)) << tool << "\n" << tools.out;
  for (const char* left_out : {"tool 8: the remark \"T-SLOT\" gives no width of the head; left out",
                               "tool 9: the remark \"DOVETAIL 60\" gives no"})
    EXPECT_TRUE(contains(tools.err, left_out)) << tools.err;
  EXPECT_FALSE(contains(tools.out, "T8")) << tools.out;
  EXPECT_TRUE(contains(tools.err, "gives the diameter 6.6 mm, and the table 5.5 mm; left out"))
      << tools.err;
  EXPECT_TRUE(contains(tools.out, "taken to be an end mill")) << tools.out;
}

// Both were end mills: a ball that was ground again, and a corner without a kind.
TEST_F(CheckCli, RemarksOfLinuxcncTablesKeepTheShape) {
  write("t.tbl",
        "T1 D5.85 ;6MM BALL NOSE\nT2 D4 ;CORNER RADIUS 0.5\nT3 D60 ;6MM BALL NOSE\n"
        "T4 D9.8 ;10MM END MILL\n");
  const Outcome tools = run("tools t.tbl");
  for (const char* tool : {"T1      ball mill Ø5.85",
                           "T2      bull-nose mill Ø4, corner radius 0.5", "T4      end mill Ø9.8"})
    EXPECT_TRUE(contains(tools.out, tool)) << tool << "\n" << tools.out;
  EXPECT_TRUE(contains(tools.err,
                       "tool 3: the remark \"6MM BALL NOSE\" gives the diameter 6 mm, "
                       "and the table 60 mm; left out"))
      << tools.err;
  write("mixed.tbl", "T1 D6 ;6MM END MILL\nT2 D4 ;4MM END MILL\nT3 D0.5 ;1/2\" END MILL\n");
  const Outcome mixed = run("tools mixed.tbl");
  EXPECT_TRUE(contains(mixed.out, "T1      end mill Ø6")) << mixed.out;
  EXPECT_TRUE(contains(mixed.err,
                       "tool 3: the remark \"1/2\" END MILL\" gives the diameter "
                       "12.7 mm, and the table 0.5 mm; left out"))
      << mixed.err;
}

// What a shop checks in a library: the angles too that nobody gave, and what stands above.
TEST_F(CheckCli, ToolsTellAnglesNecksShanksAndHolders) {
  write("t.toml",
        "[[tool]]\nid = \"1\"\ntype = \"chamfer\"\ndiameter = 6\nflute_length = 9\n"
        "shank = [[5, 10], [6, 20]]\nholder = [[20, 25, 30]]\n"
        "[[tool]]\nid = \"2\"\ntype = \"drill\"\ndiameter = 8\n"
        "[[tool]]\nid = \"3\"\ntype = \"lollipop\"\ndiameter = 8\nneck_diameter = 4\n"
        "[[tool]]\nid = \"4\"\ntype = \"turning\"\ninsert = \"RCMT\"\ndiameter = 10\n"
        "[[tool]]\nid = \"5\"\ntype = \"form\"\nprofile = [[0, 0], [3, 0, 0.4], [4, 3], [0, 3]]\n");
  const Outcome text = run("tools t.toml");
  for (const char* tool :
       {"T1      chamfer mill Ø6, point 90°, flutes 9 mm, shank Ø6, holder Ø25  (",
        "T2      drill Ø8, point 118°, cuts up to the stock's top  (",
        "T3      lollipop mill Ø8, neck Ø4  (", "T4      turning tool RCMT Ø10  (",
        "T5      form mill  ("})
    EXPECT_TRUE(contains(text.out, tool)) << tool << "\n" << text.out;
  const Outcome json = run("tools --json t.toml");
  for (const char* keys : {R"("shank":[[5,5,10],[6,6,20]],"holder":[[20,25,30]])",
                           R"("neck_diameter":4)", R"("profile":[[0,0],[3,0,0.4],[4,3],[0,3]])"})
    EXPECT_TRUE(contains(json.out, keys)) << keys << "\n" << json.out;
}

TEST_F(CheckCli, CamoticsProjectsRun) {
  write("a.nc", "T1 M6\nG21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX20\nM30\n");
  write(
      "p.camotics",
      R"({"units":"metric","tools":{"1":{"units":"metric","shape":"cylindrical","length":20,"diameter":4}},
        "workpiece":{"automatic":false,"bounds":{"min":[-5,-5,-5],"max":[30,5,0]}},"files":["a.nc"]})");
  const Outcome cut = run("p.camotics -o p.stl");
  EXPECT_EQ(cut.code, 0) << cut.err;
  EXPECT_TRUE(contains(cut.out, "box 35 x 10 x 5 mm")) << cut.out;
  EXPECT_TRUE(contains(cut.out, "end mill Ø4")) << cut.out;
  const Outcome tools = run("tools p.camotics -o t.svg -o t.png");
  EXPECT_EQ(tools.code, 0) << tools.err;
  EXPECT_TRUE(contains(tools.out, "end mill Ø4")) << tools.out;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "t.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "t.png"));
  EXPECT_EQ(run("tools a.nc").code, 1);
}

}  // namespace
}  // namespace mrsim
