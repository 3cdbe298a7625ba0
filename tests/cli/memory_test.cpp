// What a run takes against what was expected of it, and runs that may not take it.
#include "run_program.h"

#include <algorithm>
#include <array>

#include <sys/resource.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Memory : public CliTest {
 protected:
  // Rows of short moves of a ball mill, 1 mm apart, over waves: cells with many faces.
  void SetUp() override {
    CliTest::SetUp();
    std::string text = "G54 G17 G90\nT1 M6\nG0 X0 Y0 Z9\n";
    for (int row = 0; row <= 20; ++row)
      for (int i = 0; i <= 20; ++i) {
        const int x = row % 2 != 0 ? 20 - i : i;
        const int height = (x * x + 3 * x * row + row * row) % 11;
        text += "G1 X" + std::to_string(x) + " Y" + std::to_string(row) + " Z-" +
                std::to_string(2 + 0.05 * height) + " F500\n";
      }
    write("raster.MPF", text + "G0 Z9\nM30\n");
  }

  // rough.off, 23 x 23 x 8 mm.
  void write_rough_stock() {
    constexpr int kSide = 100;
    std::string corners, faces;
    const auto at = [](int i, int j) { return std::to_string(i * (kSide + 1) + j); };
    for (int i = 0; i <= kSide; ++i)
      for (int j = 0; j <= kSide; ++j) {
        const bool is_rim = i % kSide == 0 || j % kSide == 0;
        const int height = is_rim ? 0 : (7 * i * i + 5 * j * j + 3 * i * j) % 11;
        corners += std::to_string(0.23 * i) + " " + std::to_string(0.23 * j) + " " +
                   std::to_string(0.05 * height) + "\n";
        if (i == kSide || j == kSide) continue;
        faces += "3 " + at(i, j) + " " + at(i + 1, j) + " " + at(i + 1, j + 1) + "\n3 " + at(i, j) +
                 " " + at(i + 1, j + 1) + " " + at(i, j + 1) + "\n";
      }
    const int apex = (kSide + 1) * (kSide + 1);
    const auto side = [&](const std::string& from, const std::string& to) {
      faces += "3 " + to + " " + from + " " + std::to_string(apex) + "\n";
    };
    for (int k = 0; k < kSide; ++k) {
      side(at(k, 0), at(k + 1, 0)), side(at(kSide, k), at(kSide, k + 1));
      side(at(k + 1, kSide), at(k, kSide)), side(at(0, k + 1), at(0, k));
    }
    write("rough.off", "OFF\n" + std::to_string(apex + 1) + " " +
                           std::to_string(2 * kSide * kSide + 4 * kSide) + " 0\n" + corners +
                           "11.5 11.5 -8\n" + faces);
  }
};

TEST_F(Memory, IsExpectedOfThePartAloneWhereMoreIsMade) {
  const std::string cut = "PRIMER_2F.MPF --stock block.stl --voxel 1 -v -o part.stl";
  EXPECT_FALSE(contains(run(cut).out, "of the part alone"));
  EXPECT_TRUE(contains(run(cut + " --report r.html").out, "were expected of the part alone"));
}

TEST_F(Memory, IsWithinAFactorOfWhatWasExpected) {
  if (!kIsPlain) GTEST_SKIP();
  for (const char* arguments :
       {"PRIMER_2F.MPF --stock block.stl", "PRIMER_2F.MPF --stock block.stl --tolerance 0.001",
        "PRIMER_2F.MPF --stock block.stl --tolerance 0.05 -o part.vdb",
        "PRIMER_2S.MPF --stock bar.stl", "PRIMER_2S.MPF --stock bar.stl --tolerance 0.003",
        "raster.MPF --stock box:0,0,-8,20,20,0 --tool ballmill:d=6 --tolerance 0.02",
        "raster.MPF --stock box:0,0,-8,20,20,0 --tool ballmill:d=6 --tolerance 0.005"}) {
    const Outcome outcome = run(std::string(arguments) + " --threads 2 --verbose -o part.stl");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const double peak = number_after(outcome.out, "  memory "),
                 expected = number_after(outcome.out, "at most  (");
    EXPECT_LT(expected, 1.5 * peak) << arguments;  // both in MB
    EXPECT_GT(expected, peak / 1.5) << arguments;
  }
}

// Libraries need memory and threads of their own while they are loaded: where the system gives too
// little, the run ends with an error, whatever asked for it. Below some 62 MB the system's loader
// fails before the program begins.
TEST_F(Memory, LittleAddressSpaceIsAnError) {
  if (!kIsPlain) GTEST_SKIP();
  for (const char* output : {"part.stl", "part.vdb"})
    for (int kilobytes = 80000; kilobytes <= 900000;
         kilobytes += kilobytes < 320000 ? 20000 : 100000) {
      std::filesystem::remove(folder_ / output);
      const std::string limit = "ulimit -v " + std::to_string(kilobytes) + " &&";
      const Outcome outcome =
          run("PRIMER_2F.MPF --stock block.stl --voxel 1 -q --threads 7 -o " + std::string(output),
              limit);
      if (outcome.code == 0) continue;
      EXPECT_EQ(outcome.code, 1) << output << " " << kilobytes << "\n" << outcome.err;
      EXPECT_NE(outcome.err.find("error:"), std::string::npos) << output << " " << kilobytes;
      EXPECT_FALSE(exists(output)) << kilobytes;
    }
}

// OpenVDB's code is 29 MB, which a run that is refused for want of memory needs not open.
TEST_F(Memory, RefusesVoxelsBeforeItOpensTheirModule) {
  if (!kIsPlain) GTEST_SKIP();
  const Outcome outcome =
      run("raster.MPF --stock box:0,0,-8,20,20,0 --tool ballmill:d=6 --voxel 0.1 --threads 2 "
          "--max-memory 35M -o part.vdb --json run.json");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "[memory]")) << outcome.err;
  const double peak = number_after(read("run.json"), "\"peak\":");
  EXPECT_GT(peak, 1e6);
  EXPECT_LT(peak, 35e6);
}

// Nor one whose stock takes what the module would leave of the limit.
TEST_F(Memory, ReadsAStockBeforeItOpensTheModuleOfVoxels) {
  if (!kIsPlain) GTEST_SKIP();
  write_rough_stock();
  const Outcome outcome =
      run("raster.MPF --stock rough.off --tool ballmill:d=6 --voxel 0.02 --threads 2 "
          "--max-memory 45M -o part.vdb --json run.json");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "[memory]")) << outcome.err;
  const double peak = number_after(read("run.json"), "\"peak\":");
  EXPECT_GT(peak, 1e6);
  EXPECT_LT(peak, 47.2e6);  // 50.8 before
}

TEST_F(Memory, ALittleStackIsAnError) {
  if (!kIsPlain) GTEST_SKIP();
  for (const char* command : {"PRIMER_2F.MPF --stock block.stl --voxel 1 -o part.stl -o part.vdb",
                              "compare block.stl block.stl"}) {
    const Outcome outcome = run(command, "ulimit -s 64 &&");
    EXPECT_EQ(outcome.code, 1) << command;
    EXPECT_TRUE(contains(outcome.err, "ulimit -s")) << outcome.err;
  }
}

TEST_F(Memory, LittleAddressSpaceIsAnErrorInOtherCommands) {
  if (!kIsPlain) GTEST_SKIP();
  std::filesystem::copy(MRSIM_DATA_DIR "/../tests/fuzz/corpus/step/box", folder_ / "box.step");
  for (const char* command : {"render block.stl -o p.png", "compare block.stl box.step -q",
                              "rest block.stl box.step --voxel 2"})
    for (int kilobytes = 100000; kilobytes <= 500000; kilobytes += 200000) {
      const Outcome outcome = run(command, "ulimit -v " + std::to_string(kilobytes) + " &&");
      if (outcome.code == 0) continue;
      EXPECT_EQ(outcome.code, 1) << command << " " << kilobytes << "\n" << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "[memory]") || contains(outcome.err, "[threads]"))
          << command << " " << kilobytes << "\n"
          << outcome.err;
    }
}

// A mesh with a tolerance is refused once its cells are known, or too many.
TEST_F(Memory, MeshesWithAToleranceAreRefusedBeyondIt) {
  const std::string milled =
      "raster.MPF --stock box:0,0,-8,20,20,0 --tool ballmill:d=6 --threads 1 -o part.stl "
      "--tolerance ";
  EXPECT_EQ(run(milled + "0.05 --max-memory 300M").code, 0);
  std::filesystem::remove(folder_ / "part.stl");
  expect_failure(milled + "0.0002 --max-memory 300M", 1, "a larger --tolerance takes less");
  expect_failure(milled + "0.00001 --max-memory 300M", 1, "a larger --tolerance takes less");
  expect_failure(milled + "0.05 --max-memory 20M", 1, "with --voxel and no --tolerance");
}

// Cells about the tip of a drill that mills are split far beyond what the first ones tell: a grid
// takes the place of the mesh where they do not fit, and the limit holds.
TEST_F(Memory, AGridReplacesAMeshWhoseCellsDoNotFit) {
  if (!kIsPlain) GTEST_SKIP();
  write("helix.nc", "G17 G90 G71\nT1 M6\nS500 M3\nG0 X35 Y25 Z1\nG3 I-10 Z-4 F600\nG0 Z5\nM30\n");
  const Outcome outcome =
      run("helix.nc --dialect sinumerik --machine mill --stock box:0,0,-10,50,50,0 "
          "--tool 1=drill:d=6 --threads 2 -v --max-memory 100M -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_LT(number_after(outcome.out, "  memory "), 105) << outcome.out;  // MB; 227 before
}

// A wall of 0.05 mm askew to the grid, whose cells all have a surface once they are small.
TEST_F(Memory, MeshesOfThinWallsKeepToIt) {
  if (!kIsPlain) GTEST_SKIP();
  write("wall.nc",
        "G90 G21 G17 G94\nT1 M6\nS3000 M3\nG0 X34.0595 Y3.0767 Z5\nG1 Z-3.5573 F600\n"
        "G1 X3.0767 Y34.0595\nG0 Z5\nG0 X36.9233 Y5.9405\nG1 Z-3.5573\nG1 X5.9405 Y36.9233\nG0 "
        "Z5\nM30\n");
  const Outcome outcome =
      run("wall.nc --stock box:0,0,-12,40,40,0 --tool 1=bullmill:d=4,r=1 --threads 2 -v "
          "--max-memory 300M -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_LT(number_after(outcome.out, "  memory "), 315) << outcome.out;  // MB; 390 before
}

// A stock whose mesh has details finer than the voxel: nearly all of its cells are split.
TEST_F(Memory, StocksOfFineDetailKeepToItOrAreRefused) {
  if (!kIsPlain) GTEST_SKIP();
  write_rough_stock();
  write("slot.nc", "G90 G21 G17\nT1 M6\nG0 X5 Y5 Z5\nG1 Z-1 F500\nX18\nG0 Z5\nM30\n");
  const std::string cut =
      "slot.nc --stock rough.off --tool 1=endmill:d=4 --voxel 0.5 --threads 2 -v -o part.stl";
  const Outcome free = run(cut);
  ASSERT_EQ(free.code, 0) << free.err;
  const double peak = number_after(free.out, "  memory ");
  EXPECT_NEAR(number_after(free.out, "at most  ("), peak, 0.3 * peak);
  for (const double share : {0.9, 0.8, 0.7}) {
    const Outcome outcome = run(cut + " --max-memory " + std::to_string(int(share * peak)) + "M");
    if (outcome.code == 0)
      EXPECT_LT(number_after(outcome.out, "  memory "), 1.1 * share * peak) << outcome.out;
    else
      EXPECT_FALSE(contains(outcome.err, "tolerance")) << outcome.err;
  }
}

// Steps of a flat end mill whose mesh is given up: the grid in its place is planned, done in slabs
// or refused like any other, and what the mesh took is told too.
TEST_F(Memory, TheGridInThePlaceOfAMeshKeepsToItOrIsRefused) {
  if (!kIsPlain) GTEST_SKIP();
  std::string text = "G54 G17 G90\nT1 M6\nG0 X0 Y0 Z9\n";
  for (int row = 0; row <= 120; ++row)
    for (int i = 0; i <= 60; ++i) {
      const int x = row % 2 != 0 ? 60 - i : i;
      const int height = (x * x + 3 * x * row + row * row) % 11;
      text += "G1 X" + std::to_string(x) + " Y" + std::to_string(0.5 * row) + " Z-" +
              std::to_string(2 + 0.05 * height) + " F500\n";
    }
  write("steps.MPF", text + "G0 Z9\nM30\n");
  const std::string cut =
      "steps.MPF --stock box:0,0,-8,60,60,0 --tool endmill:d=1.25 --threads 2 -v -o part.stl";
  const Outcome free = run(cut);
  ASSERT_TRUE(contains(free.out, "was given up")) << free.out;
  const double peak = number_after(free.out, "  memory ");
  EXPECT_NEAR(number_after(free.out, "at most  ("), peak, 0.3 * peak);
  for (const int limit : {60, 90}) {
    const Outcome outcome = run(cut + " --max-memory " + std::to_string(limit) + "M");
    if (outcome.code == 0)
      EXPECT_LT(number_after(outcome.out, "  memory "), 1.05 * limit) << outcome.out;  // MB
    else
      EXPECT_TRUE(contains(outcome.err, "[memory]")) << outcome.err;
  }
}

// A list that grows hands back its earlier memory: 122 MB were taken here before it did.
TEST_F(Memory, LoopsWithoutAnEndAreRefusedWithinIt) {
  write("loop.nc",
        "%\nO1\nT1 M6\nG0 X0 Y0 Z5\n#1=0\nWHILE[#1NE0.5]DO1\nG1 Z-1 F100\nG0 "
        "Z5\n#1=#1+1\nEND1\nM30\n%\n");
  expect_failure(
      "loop.nc --stock box:0,0,-8,20,20,0 --tool ballmill:d=6 -o part.stl --json r.json "
      "--max-memory 100M",
      1, "a program of more than");
  if (kIsPlain) {
    EXPECT_LT(number_after(read("r.json"), "\"peak\":"), 105e6);
  }
}

// A history of many motions, whose rows are written one by one.
TEST_F(Memory, HistoriesKeepToItOrAreRefused) {
  if (!kIsPlain) GTEST_SKIP();
  std::string text = "G54 G17 G90\nT1 M6\nG0 X0 Y0 Z9\n";
  for (int i = 0; i < 100000; ++i)
    text += "G1 X" + std::to_string(i % 20) + " Y" + std::to_string(i / 20 % 20) + " Z-1 F500\n";
  write("many.MPF", text + "G0 Z9\nM30\n");
  const std::string cut =
      "many.MPF --stock box:0,0,-8,20,20,0 --tool ballmill:d=6 --threads 1 --voxel 1 -v -o "
      "part.stl --history h.json --max-memory ";
  const Outcome outcome = run(cut + "290M");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_LT(number_after(outcome.out, "  memory "), 304) << outcome.out;  // MB
  std::filesystem::remove(folder_ / "part.stl");
  expect_failure(cut + "200M", 1, "--history takes");
}

// A page for the browser, made from the whole mesh.
TEST_F(Memory, ReportsKeepToItOrAreRefused) {
  if (!kIsPlain) GTEST_SKIP();
  const std::string cut =
      "raster.MPF --stock box:0,0,-8,20,20,0 --tool ballmill:d=6 --threads 1 --voxel 0.03 -v -q "
      "-o part.stl --report r.html --json r.json";
  const auto peak = [&] { return number_after(read("r.json"), "\"peak\": "); };
  ASSERT_EQ(run(cut).code, 0);
  const double free = peak();
  for (const double share : {0.95, 0.85, 0.75}) {
    const int limit = int(share * free / 1048576);
    const Outcome outcome = run(cut + " --max-memory " + std::to_string(limit) + "M");
    if (outcome.code == 0)
      EXPECT_LT(peak(), 1.05 * limit * 1048576);
    else
      EXPECT_TRUE(contains(outcome.err, "[memory]")) << outcome.err;
  }
}

// The search for shanks and rapids that run into material asks for its memory, too.
TEST_F(Memory, TheSearchForCollisionsIsRefusedBeyondIt) {
  if (!kIsPlain) GTEST_SKIP();
  std::string tools, program = "G21 G90 G17\n";
  for (int i = 1; i <= 1500; ++i) {
    const std::string id = std::to_string(i);
    tools += "[[tool]]\nid = \"" + id + "\"\ntype = \"endmill\"\ndiameter = 6." +
             std::to_string(10'000 + i) + "\nflute_length = 2\nshank = [[5, 10], [6, 20]]\n" +
             "holder = [[20, 25, 30]]\n";
    program += "T" + id + " M6\nG0 X" + std::to_string(i % 200) + " Y" + std::to_string(i / 200) +
               " Z5\nG1 Z-4 F500\nG1 X" + std::to_string(i % 200 + 1) + "\nG0 Z5\n";
  }
  write("many.toml", tools);
  write("many.nc", program + "M30\n");
  const std::string cut =
      "many.nc --tools many.toml --stock box:0,0,-10,200,20,0 --voxel 1 --history off -o part.stl "
      "--json r.json -q";
  const auto peak = [&] { return number_after(read("r.json"), "\"peak\": "); };
  ASSERT_EQ(run(cut).code, 0);
  const double free = peak();
  const int limit = int(0.7 * free / 1048576);
  const Outcome outcome = run(cut + " --max-memory " + std::to_string(limit) + "M");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.err, "[memory]")) << outcome.err;
  EXPECT_LT(peak(), 1048576.0 * limit * 1.05);
}

// Each piece has a tree of its own while pieces are told apart.
TEST_F(Memory, OfWhatIsLeftGrowsLittleWithThePieces) {
  if (!kIsPlain) GTEST_SKIP();
  constexpr int kSide = 14;  // cubes of 2 mm in a layer, 6 mm apart, along an axis
  std::string corners, faces;
  int first = 0;
  const auto cube = [&](int i, int j, int k) {
    for (int c = 0; c < 8; ++c)
      corners += std::to_string(6 * i + (c & 1 ? 2 : 0)) + " " +
                 std::to_string(6 * j + (c & 2 ? 2 : 0)) + " " +
                 std::to_string(6 * k + (c & 4 ? 2 : 0)) + "\n";
    for (const auto& side : {std::array{0, 2, 3, 1},
                             {4, 5, 7, 6},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 4, 6, 2},
                             {1, 3, 7, 5}}) {
      faces += "4";
      for (const int c : side) faces += " " + std::to_string(first + c);
      faces += "\n";
    }
    first += 8;
  };
  const auto off = [&] {
    return "OFF\n" + std::to_string(first) + " " + std::to_string(first / 8 * 6) + " 0\n" +
           corners + faces;
  };
  cube(0, 0, 0);
  write("nominal.off", off());
  for (int n = 1; n < 3 * kSide * kSide; ++n)
    cube(n % kSide, n / kSide % kSide, n / (kSide * kSide));
  write("cubes.off", off());
  const auto peak = [] {  // of the largest child so far, kB
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    return usage.ru_maxrss;
  };
  const long before = peak();
  ASSERT_EQ(run("rest cubes.off nominal.off --voxel 0.5 --json r.json -q").code, 0);
  EXPECT_LE(peak(), std::max(before, 160'000L));
}

// Skins of an onion, each ray through all of them: their crossings took gigabytes.
TEST_F(Memory, ComparisonsOfManyLayersKeepToIt) {
  if (!kIsPlain) GTEST_SKIP();
  constexpr int kSkins = 60;
  std::string corners, faces;
  for (int i = 0; i < kSkins; ++i) {
    const std::string hi = std::to_string(10 + 0.1 * i), lo = "-" + hi;
    for (int c = 0; c < 8; ++c)
      corners += (c % 2 ? hi : lo) + " " + (c / 2 % 2 ? hi : lo) + " " + (c / 4 ? hi : lo) + "\n";
    const auto quad = [&](int a, int b, int c, int d) {
      const int first = 8 * i;
      const bool is_cavity = (kSkins - i) % 2 == 0;
      faces += "4 " + std::to_string(first + a) + " " +
               std::to_string(first + (is_cavity ? d : b)) + " " + std::to_string(first + c) + " " +
               std::to_string(first + (is_cavity ? b : d)) + "\n";
    };
    quad(0, 2, 3, 1), quad(4, 5, 7, 6), quad(0, 1, 5, 4);
    quad(2, 6, 7, 3), quad(0, 4, 6, 2), quad(1, 3, 7, 5);
  }
  write("onion.off", "OFF\n" + std::to_string(8 * kSkins) + " " + std::to_string(6 * kSkins) +
                         " 0\n" + corners + faces);
  const Outcome outcome = run("compare onion.off onion.off --json c.json --max-memory 150M");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_LT(number_after(read("c.json"), "\"memory\": "), 158e6);
}

// The mesh of a turned part is refused once its rings are counted.
TEST_F(Memory, TurnedMeshesAreRefusedBeyondIt) {
  const std::string turned = "PRIMER_2S.MPF --stock bar.stl --threads 1 -o part.stl --tolerance ";
  EXPECT_EQ(run(turned + "0.001 --max-memory 100M").code, 0);
  std::filesystem::remove(folder_ / "part.stl");
  expect_failure(turned + "0.0001 --max-memory 100M", 1, "a larger --tolerance takes less");
}

}  // namespace
}  // namespace mrsim
