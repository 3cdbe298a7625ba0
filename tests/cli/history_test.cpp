// --history: what motions, lines and tools remove, in the summary, in files and in the run's JSON.
#include "run_program.h"

#include <cstddef>
#include <sstream>
#include <string>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class HistoryOfRun : public CliTest {
 protected:
  // A slot in the stock, the same again, and a slot beside it with another tool.
  void write_slots() {
    write("slots.nc",
          "G54 G17 G90 G71\nT1 M6\nS5000 M3\nG0 X-10 Y10 Z-4\nG1 X40 F600\nG1 X-10\n"
          "G0 Z5\nT2 M6\nG0 X-10 Y30 Z-2\nG1 X60 F1200\nG0 Z5\nM30\n");
  }
  static constexpr const char* kRun =
      "slots.nc --dialect sinumerik --machine mill --stock box:0,0,-10,50,50,0 "
      "--tool 1=endmill:d=8 --tool 2=endmill:d=6 -o part.stl ";
  static constexpr double kFirst = 4 * (8 * 40 + 3.14159265 * 16 / 2), kSecond = 2 * 6 * 50;

  Json history() { return Json::parse(read("h.json"), nullptr, false); }
};

TEST_F(HistoryOfRun, FilesTellMotionsLinesToolsAndTheProgram) {
  write_slots();
  const Outcome outcome = run(std::string(kRun) + "--history h.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json j = history();
  double motions = 0, lines = 0;
  std::size_t air = 0;
  for (const Json& row : j["rows"]) {
    const double removed = row["removed"];
    if (row["kind"] == "motion") motions += removed, air += row["air"] == 1.0;
    if (row["kind"] == "line") lines += removed;
    if (row["kind"] == "line" && row["line"] == 5) {
      EXPECT_NEAR(removed, kFirst, 0.02 * kFirst);
    }
    if (row["kind"] == "tool" && row["tool"] == "2") {
      EXPECT_NEAR(removed, kSecond, 0.02 * kSecond);
      EXPECT_NEAR(row["rate"].get<double>() * row["seconds"].get<double>(), removed,
                  1e-6 * removed);
    }
  }
  EXPECT_EQ(air, 1u);  // the way back
  const Json& program = j["rows"].back();
  EXPECT_EQ(program["kind"], "program");
  EXPECT_NEAR(program["removed"], number_after(outcome.out, "removed"), 1e-3 * (kFirst + kSecond));
  EXPECT_NEAR(program["removed"], motions, 1e-6);
  EXPECT_NEAR(program["removed"], lines, 1e-6);
}

// The head of 3 mm on its helices is measured by voxels, 15 of the run's to the diameter.
TEST_F(HistoryOfRun, SumsOfASmallToolInVoxelsAreStockLessPart) {
  write("slots.nc",
        "G17 G90 G71\nT1 M6\nS3000 M3\nG0 X0 Y0 Z5\nG1 Z-3 F200\nG1 X3\nG3 X3 Y0 Z-4 I-3 J0\n"
        "G3 X3 Y0 Z-5 I-3 J0\nG1 X0\nG0 Z5\nM30\n");
  ASSERT_EQ(run("slots.nc --dialect sinumerik --machine mill --stock box:-9,-9,-10,40,9,0 "
                "--tool 1=tslot:d=3,w=1,n=2,l=30 -o part.stl --voxel 0.2 --json r.json "
                "--history h.json")
                .code,
            0);
  const Json j = Json::parse(read("r.json"), nullptr, false);
  const double removed = j["volume"]["removed"];
  EXPECT_NEAR(history()["rows"].back()["removed"], removed, 6e-4 * removed);
}

// A wall that twelve turns share is found to an eighth of a column.
TEST_F(HistoryOfRun, SumsOfBoresOnHelicesAreStockLessPart) {
  std::string text = "G17 G90 G71\nT1 M6\nS3000 M3\nG0 X4 Y0 Z3\nG1 Z0 F300\n";
  for (int k = 1; k <= 12; ++k) text += "G3 X4 Y0 Z-" + std::to_string(k) + " I-4 J0\n";
  write("slots.nc", text + "G3 X4 Y0 I-4 J0\nG0 Z5\nM30\n");
  ASSERT_EQ(run("slots.nc --dialect sinumerik --machine mill --stock box:-12,-12,-14,158,12,0 "
                "--tool 1=endmill:d=8,l=20 -o part.stl --json r.json --history h.json")
                .code,
            0);
  const Json j = Json::parse(read("r.json"), nullptr, false);
  const double removed = j["volume"]["removed"];
  EXPECT_NEAR(history()["rows"].back()["removed"], removed, 1e-3 * removed);
}

// The second tool is told from a program whose length offset is wrong.
TEST_F(HistoryOfRun, ToolsThatRemoveNothingAreWarnedOf) {
  write_slots();
  EXPECT_FALSE(contains(run(kRun).err, "tool-cuts-air"));
  std::string text = read("slots.nc");
  text.replace(text.find("Z-2"), 3, "Z2");
  write("slots.nc", text);
  const Outcome outcome = run(kRun);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.err, "slots.nc:10:1: warning: tool 2 removes nothing"))
      << outcome.err;
  EXPECT_FALSE(contains(run(std::string(kRun) + "--until 11").err, "tool-cuts-air"));
}

// A thread is not cut into the part (thread-not-cut), which makes its passes no air.
TEST_F(HistoryOfRun, PassesOfThreadsAreNoAir) {
  write("thread.MPF",
        "G18 G90 G95 DIAMON\nT1 D1\nG97 S500 M3\nG0 X22 Z5\nG0 X19\nG33 Z-20 K1.5\nG0 X22\nM30\n");
  ASSERT_EQ(run("thread.MPF --machine lathe --stock cylinder:20,-40,0 --tool 1=threading:a=60 "
                "--history h.json")
                .code,
            0);
  const Json row = history()["rows"][0];
  EXPECT_EQ(row["removed"], 0);
  EXPECT_EQ(row["air"], 0);
  EXPECT_TRUE(row["depth"].is_null()) << row;
}

// A face mill at the zero of a run without --stock: the stock that the user may mean is told.
TEST_F(HistoryOfRun, AFacingPassAtTheZeroIsToldTheRawFace) {
  write("face.nc",
        "O1\nG21 G90\nT1 M6 (FACE MILL D50)\nG0 X-30 Y0 Z5\nG1 Z0 F500\nX130\nG0 Z50\n"
        "T2 M6 (END MILL D10)\nG0 X0 Y0 Z5\nG1 Z-5 F500\nX100\nG0 Z50\nM30\n");
  const Outcome outcome = run("face.nc -o part.stl");
  EXPECT_TRUE(contains(outcome.err, "tool 1 removes nothing: it cuts at Z0 and above"))
      << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "say --stock box:-66,-36,-16,166,36,1 [tool-cuts-air]"))
      << outcome.err;
}

// A column below a falling arc of any but a flat mill takes a search: larger ones are summed, and
// the volume is that of the mesh all the same.
TEST_F(HistoryOfRun, HelicesTakeNoLongerThanOtherCuts) {
  write("helix.nc", "G17 G90 G71\nT1 M6\nS5000 M3\nG0 X35 Y25 Z1\nG3 I-10 Z-4 F600\nG0 Z5\nM30\n");
  for (const char* tool : {"ballmill:d=6", "drill:d=6", "chamfer:d=6"}) {
    const Outcome outcome =
        run("helix.nc --dialect sinumerik --machine mill --stock box:0,0,-10,50,50,0 "
            "--tool 1=" +
            std::string(tool) + " --voxel 1 -o part.stl -v");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const double removed = number_after(outcome.out, "removed");
    EXPECT_NEAR(number_after(outcome.out, "\n  cuts"), removed, 0.05 * removed) << tool;
    EXPECT_LT(number_after(outcome.out, "history "), 3) << tool;  // s; 5 to 32 s before
  }
}

TEST_F(HistoryOfRun, TableHoldsTheSame) {
  write_slots();
  ASSERT_EQ(run(std::string(kRun) + "--history h.csv").code, 0);
  std::istringstream table(read("h.csv"));
  std::string row, last;
  std::getline(table, row);
  EXPECT_EQ(
      row,
      "kind,file,line,motion,tool,seconds,removed_mm3,rate_cm3_min,air_share,depth_mm,width_mm,"
      "engagement_deg");
  std::size_t motions = 0;
  while (std::getline(table, row)) motions += row.starts_with("motion,"), last = row;
  EXPECT_EQ(motions, 3u);
  EXPECT_TRUE(last.starts_with("program,slots.nc,")) << last;
}

TEST_F(HistoryOfRun, CutThatLeavesTheMaterialIsInTheAirFromThere) {
  // 50 mm of stock, 150 mm of air beyond it.
  write("long.nc", "G54 G17 G90 G71\nT1 M6\nS5000 M3\nG0 X0 Y25 Z-4\nG1 X200 F600\nM30\n");
  const Outcome outcome =
      run("long.nc --dialect sinumerik --machine mill --stock box:0,0,-10,50,50,0 "
          "--tool 1=endmill:d=8 --history h.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json row = history()["rows"][0];
  EXPECT_NEAR(row["air"], 150.0 / 200, 4.0 / 200);  // a piece
  EXPECT_NEAR(row["removed"], 4 * 8 * 50, 0.02 * 4 * 8 * 50);
}

// 2 mm of 5 mm, of 4 mm from the bottom of the first hole on, in a mill of 10 mm and a drill of 1
// mm.
TEST_F(HistoryOfRun, PlungeIsInTheAirDownToTheMaterial) {
  write("plunge.nc", "G17 G90 G71\nT1 M6\nG0 X25 Y25 Z2\nG1 Z-3 F100\nG0 Z1\nG1 Z-4\nG0 Z5\nM30\n");
  for (const std::string tool : {"endmill:d=10", "drill:d=1"}) {
    const std::string words =
        "plunge.nc --dialect sinumerik --machine mill --stock box:0,0,-10,50,50,0 --json r.json "
        "--voxel 0.5 -o part.stl -q --tool 1=" +
        tool;
    ASSERT_EQ(run(words + " --history h.json").code, 0);
    const Json found = history();
    EXPECT_NEAR(found["rows"][0]["air"], 2.0 / 5, 1.25 / 5) << tool;
    EXPECT_NEAR(found["rows"][1]["air"], 4.0 / 5, 1.25 / 5) << tool;
    ASSERT_EQ(run(words).code, 0);
    EXPECT_NEAR(Json::parse(read("r.json"))["history"]["total"]["air"], 6.0 / 10, 0.15) << tool;
  }
}

// A groove of some 1 mm, deeper and shallower, across columns of 0.2 mm: as with those of a tenth.
TEST_F(HistoryOfRun, GroovesOfVToolsAddUpToTheirVolume) {
  std::string text = "G17 G90 G71\nT1 M6\nG0 X5 Y5 Z2\nG1 Z-0.4 F100\n";
  double x = 5, y = 5;
  for (int k = 0; k < 40; ++k)
    x += 0.83, y += 0.37 + 0.01 * k,
        text +=
        "X" + std::to_string(x) + " Y" + std::to_string(y) + (k % 2 ? " Z-0.4\n" : " Z-0.9\n");
  write("v.nc", text + "G0 Z5\nM30\n");
  const std::string words =
      "v.nc --dialect sinumerik --machine mill --stock box:0,0,-4,60,42,0 --tool "
      "1=chamfer:d=6,a=60 -o part.stl -q --voxel ";
  const auto sum = [&](const std::string& voxel) {
    EXPECT_EQ(run(words + voxel + " --history h.json").code, 0);
    return history()["rows"].back()["removed"].get<double>();
  };
  const double exact = sum("0.02");
  EXPECT_NEAR(sum("0.2"), exact, 1e-3 * exact);
}

// A half circle about (50, 0); the stock ends at x = 50.
TEST_F(HistoryOfRun, ArcThatLeavesTheMaterialIsInTheAirFromThere) {
  write("arc.MPF", "G17 G90 G71\nT1 M6\nG0 X10 Y0 Z5\nG1 Z-2 F200\nG2 X90 Y0 I40 J0\nG0 Z5\nM30\n");
  ASSERT_EQ(run("arc.MPF --machine mill --stock box:0,0,-10,50,60,0 --tool 1=endmill:d=4 -q "
                "--history h.json")
                .code,
            0);
  // The centre leaves x = 50 at the top of the circle, the cutter's edge 2 mm later: of 125.7 mm
  // some 61 mm are in the air, in pieces of 2 mm.
  double air = -1;
  const Json found = history();
  for (const Json& row : found["rows"])
    if (row["kind"] == "line" && row["line"] == 5) air = row["air"];
  EXPECT_NEAR(air, 61.0 / 125.7, 0.03);
}

// 5 000 moves of 0.02 mm in a stock whose columns are 0.8 mm wide: most moves have no column of
// their own. The second half of the way lies beside the stock.
TEST_F(HistoryOfRun, MovesShorterThanAColumnAreNoAir) {
  std::string program = "G54 G17 G90 G71\nT1 M6\nG0 X150 Y100 Z5\nG1 Z-2 F500\n";
  for (int i = 1; i <= 5000; ++i)
    program += "G1 X" + std::to_string(150 + 0.02 * i) + (i == 1 ? " F500\n" : "\n");
  write("short.nc", program + "M30\n");
  const Outcome outcome =
      run("short.nc --dialect sinumerik --machine mill --stock box:0,0,-10,200,200,0 "
          "--tool 1=endmill:d=2 --json r.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json h = Json::parse(read("r.json"), nullptr, false)["history"];
  EXPECT_GT(double(h["voxel"]), 0.5);
  EXPECT_NEAR(h["total"]["air"], 55.0 / 107, 0.02);  // of 100 mm of way and 7 mm of plunge
}

TEST_F(HistoryOfRun, SummaryAndJsonHaveTheSumsByTool) {
  write_slots();
  const Outcome outcome = run(std::string(kRun) + "--json r.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "of the time in air")) << outcome.out;
  const Json h = Json::parse(read("r.json"), nullptr, false)["history"];
  ASSERT_EQ(h["tools"].size(), 2u);
  EXPECT_NEAR(h["tools"][0]["removed"], kFirst, 0.02 * kFirst);
  EXPECT_GT(h["tools"][0]["air"], 0.4);
  EXPECT_NEAR(h["tools"][1]["air"], 17.0 / 70, 3.0 / 70);  // 7 mm before the stock, 10 after it
  EXPECT_NEAR(h["total"]["removed"], kFirst + kSecond, 0.02 * kFirst);
}

TEST_F(HistoryOfRun, OffLeavesItOut) {
  write_slots();
  const Outcome outcome = run(std::string(kRun) + "--history off --json r.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_FALSE(contains(outcome.out, "in air")) << outcome.out;
  const Json history = Json::parse(read("r.json"), nullptr, false)["history"];
  EXPECT_TRUE(history["voxel"].is_null());
  for (const char* figure : {"removed", "seconds", "rate", "air"})
    EXPECT_TRUE(history["total"][figure].is_null()) << figure;
}

TEST_F(HistoryOfRun, OtherFormatsAreWrongUsage) {
  expect_failure("PRIMER_2F.MPF --stock block.stl --history h.txt", 2, "--history");
}

TEST_F(HistoryOfRun, IsTheSameOnAnyNumberOfThreads) {
  ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl -q --history a.csv --threads 1").code, 0);
  ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl -q --history b.csv --threads 5").code, 0);
  EXPECT_EQ(read("a.csv"), read("b.csv"));
}

}  // namespace
}  // namespace mrsim
