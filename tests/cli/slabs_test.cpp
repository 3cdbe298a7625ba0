// Runs whose memory is limited: done in slabs with the same files, or refused with what to do.
#include "run_program.h"
#include "support/random.h"

#include <algorithm>
#include <cmath>
#include <csignal>

#include <sys/resource.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Slabs : public CliTest {
 protected:
  // A slot of 2 mm through a block 60 x 20 x 4 at x = 40..42: two pieces.
  void SetUp() override {
    CliTest::SetUp();
    write("split.MPF",
          "G54\nTRANS X0 Y0\nG17 G90 G71\nT1 M6\nG0 X10 Y5 Z5\nG1 Z-2.3 F100\nG3 X10 Y5 I4 J0\nG0 "
          "Z5\nG0 X41 Y-3\nG1 Z-5\nG1 Y23\nG0 Z5\nM30\n");
  }
  Outcome split(const std::string& more) {
    return run(
        "split.MPF --machine mill --stock box:0,0,-4,60,20,0 --tool 1=endmill:d=2 --voxel 0.1 " +
        more);
  }
};

// Between what the run takes in slabs and in one piece, for that many threads.
std::string limit(int threads) { return std::to_string(15 + 14 * threads) + "M"; }

TEST_F(Slabs, GiveTheSameBytes) {
  for (const char* format : {"stl", "ply", "obj", "off", "3mf"}) {
    const std::string whole = std::string("whole.") + format,
                      slabs = std::string("slabs.") + format;
    ASSERT_EQ(split("--color line -o " + whole).code, 0);
    for (int threads = format == std::string("stl") ? 1 : 2; threads <= 2; ++threads) {
      const Outcome outcome = split("--color line --threads " + std::to_string(threads) +
                                    " --max-memory " + limit(threads) + " -o " + slabs);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "note: done in ")) << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "the part is in 2 pieces")) << outcome.err;
      EXPECT_TRUE(read(slabs) == read(whole)) << format << ", threads " << threads;
    }
  }
}

TEST_F(Slabs, LoosePiecesAreDroppedInSlabsToo) {
  ASSERT_EQ(split("--keep largest -o whole.ply -o whole.stl").code, 0);
  const Outcome outcome =
      split("--keep largest --threads 1 --max-memory " + limit(1) + " -o slabs.ply -o slabs.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "note: done in ")) << outcome.err;
  EXPECT_TRUE(read("slabs.ply") == read("whole.ply"));
  EXPECT_TRUE(read("slabs.stl") == read("whole.stl"));
}

TEST_F(Slabs, AreRefusedWithWhatToDo) {
  const std::string little = "--threads 1 --max-memory " + limit(1);
  for (const auto& [more, advice] :
       {std::pair<const char*, const char*>{"-o part.vdb", "without it the run is done in slabs"},
        {"-o part.glb", ".stl .ply .obj .off and .3mf are written in slabs"},
        {"--tolerance 0.0001 -o part.stl", "with --voxel and no --tolerance"},
        {"--report report.html -o part.stl", "report needs the whole mesh"}}) {
    const Outcome outcome = split(little + " " + more);
    EXPECT_EQ(outcome.code, 1) << more;
    EXPECT_TRUE(contains(outcome.err, advice)) << outcome.err;
  }
  const Outcome none = split("--threads 1 --max-memory 20M -o part.stl");
  EXPECT_EQ(none.code, 1);
  EXPECT_TRUE(contains(none.err, "in slabs")) << none.err;
  EXPECT_FALSE(exists("part.stl"));
}

// A comb whose teeth are much thinner than the blocks by which its surface is estimated.
TEST_F(Slabs, KeepToTheLimitWhereSurfaceIsDense) {
  std::string comb = "%\nG90 G21 G17 G94\nT1 M6\nS8000 M3\n";
  for (int k = 0; k < 150; ++k)
    comb += "G0 X" + std::to_string(10 + 0.6 * k) + " Y-3\nG1 Z-3 F500\nG1 Y8\nG0 Z5\n";
  write("comb.nc", comb + "M30\n%\n");
  const std::string command =
      "comb.nc --stock box:0,0,-4,110,5,0 --tool 1=endmill:d=0.4 --voxel 0.1 --threads 2 ";
  ASSERT_EQ(run(command + "-o whole.stl").code, 0);
  const Outcome none = run(command + "--max-memory 16M -o none.stl");
  const double needed = 1.02e6 * number_after(none.err, "needs up to ");  // MB, in slabs
  const std::string limit = std::to_string(static_cast<int>(needed / 1024)) + "K ";
  const Outcome slabs = run(command + "--max-memory " + limit + "-o slabs.stl --json slabs.json");
  ASSERT_EQ(slabs.code, 0) << slabs.err;
  EXPECT_TRUE(contains(slabs.err, "note: done in ")) << slabs.err;
  EXPECT_TRUE(read("slabs.stl") == read("whole.stl"));
  if (kIsPlain) {
    EXPECT_LE(number_after(read("slabs.json"), "\"peak\": "), needed);
  }
  const Outcome refused = run(command + "--max-memory " + limit + "-o part.glb");
  EXPECT_EQ(refused.code, 1) << refused.err;
  EXPECT_TRUE(contains(refused.err, "needs the whole mesh")) << refused.err;
  EXPECT_FALSE(exists("part.glb"));
}

// Loops of short lines, as adaptive clearing has them: hundreds of passes share each place of the
// floor, and the lists of what passes a tile are long.
TEST_F(Slabs, KeepToTheLimitWherePassesShareAFloor) {
  if (!kIsPlain) GTEST_SKIP();
  std::string loops = "%\nG90 G21 G17 G94\nT1 M6\nS8000 M3\nG0 X4 Y4 Z9\n";
  for (int place = 0; place < 4 * 12 * 340; ++place)
    for (int k = 0; k <= 12; ++k) {
      const double angle = 3.14159265358979 / 6 * k;
      loops += "G1 X" + std::to_string(4 + 0.15 * (place % 340) + 1.2 * std::cos(angle)) + " Y" +
               std::to_string(4 + 2.9 * (place / 340 % 12) + 1.2 * std::sin(angle)) + " Z-" +
               std::to_string(2 + place / 4080 * 2) + " F500\n";
    }
  write("loops.nc", loops + "G0 Z9\nM30\n%\n");
  for (const int limit : {150, 160, 340}) {
    const Outcome outcome =
        run("loops.nc --stock box:0,0,-12,60,40,0 --tool 1=endmill:d=3 --voxel 0.25 --threads 2 "
            "-o part.stl --json r.json --max-memory " +
            std::to_string(limit) + "M");
    EXPECT_TRUE(outcome.code == 0 || (limit < 340 && contains(outcome.err, "[memory]")))
        << outcome.err;
    const double peak = number_after(read("r.json"), "\"peak\": ");
    EXPECT_GT(peak, 20e6) << "the table of sweeps alone takes more";
    EXPECT_LE(peak, limit * 1048576.0);
  }
}

// A cutter nearly as large as the part: each of its passes is in the list of most tiles.
TEST_F(Slabs, KeepToTheLimitWhereEachPassMeetsMostTiles) {
  if (!kIsPlain) GTEST_SKIP();
  Random random(12345);
  std::string passes = "%\nG90 G21 G17 G94\nT1 M6\nS8000 M3\nG0 X60 Y60 Z9\n";
  for (int k = 0; k < 60000; ++k)
    passes += "G1 X" + std::to_string(random(40, 80)) + " Y" + std::to_string(random(40, 80)) +
              " Z-" + std::to_string(5 + k / 15000 * 5) + " F500\n";
  write("passes.nc", passes + "G0 Z9\nM30\n%\n");
  for (const int limit : {130, 340}) {
    const Outcome outcome =
        run("passes.nc --stock box:0,0,-30,120,120,0 --tool 1=endmill:d=80,l=30 --voxel 0.15 "
            "--history off --threads 2 -o part.stl --json r.json --max-memory " +
            std::to_string(limit) + "M");
    EXPECT_TRUE(outcome.code == 0 || (limit < 340 && contains(outcome.err, "[memory]")))
        << outcome.err;
    EXPECT_LE(number_after(read("r.json"), "\"peak\": "), limit * 1048576.0);
  }
}

// Milled, turned, and out of a mesh. (tests/mesh/slabs_test.cpp has slots that cross in every
// voxel.)
TEST_F(Slabs, GiveTheSameBytesWhateverThePart) {
  const std::pair<std::string, std::string> scenes[] = {
      {"milled", "PRIMER_2F.MPF --stock block.stl --voxel 0.4"},
      {"turned", "PRIMER_2S.MPF --stock cylinder:50,0,51 --voxel 0.4"},
      {"mesh", "PRIMER_2F.MPF --stock block.stl --stock-exact off --voxel 0.5"}};
  for (const auto& [name, arguments] : scenes)
    for (const std::string threads : {"1", "2"}) {
      const std::string command = arguments + " --threads " + threads;
      const Outcome whole = run(command + " -o whole.stl");
      ASSERT_EQ(whole.code, 0) << name << whole.err;
      // In slabs it takes less: what a run asks for that has too little.
      const Outcome refused = run(command + " --max-memory 16M -o none.stl");
      const double needed = 1.02e6 * number_after(refused.err, "needs up to ");  // MB
      const std::string limit = std::to_string(static_cast<int>(needed / 1024));
      const Outcome outcome = run(command + " --max-memory " + limit + "K -o slabs.stl");
      ASSERT_EQ(outcome.code, 0) << name << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "note: done in ")) << name << limit << outcome.err;
      EXPECT_TRUE(read("slabs.stl") == read("whole.stl")) << name << ", threads " << threads;
    }
}

TEST_F(Slabs, TheVoxelThatIsAdvisedFits) {
  const Outcome outcome = split("--threads 1 --max-memory 26M -o part.stl");
  ASSERT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, " in slabs")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "[memory]")) << outcome.err;
  const std::size_t end = outcome.err.find(" mm would fit");
  ASSERT_NE(end, std::string::npos) << outcome.err;
  const std::size_t begin = outcome.err.rfind(' ', end - 1) + 1;
  const std::string voxel = outcome.err.substr(begin, end - begin);
  EXPECT_GT(std::stod(voxel), 0.1);
  // The figure is rounded.
  const std::string larger = std::to_string(1.001 * std::stod(voxel));
  const Outcome fits =
      run("split.MPF --machine mill --stock box:0,0,-4,60,20,0 --tool 1=endmill:d=2 --threads 1 "
          "--max-memory 26M -o part.stl --voxel " +
          larger);
  EXPECT_EQ(fits.code, 0) << fits.err;
}

// No room for the scratch file, or for the output once the mesh is made: an error, the file that
// was there stays, nothing else does.
TEST_F(Slabs, FullDiskLeavesWhatWasThere) {
  write("part.stl", "old");
  struct sigaction ignore {
  }, before{};
  ignore.sa_handler = SIG_IGN;  // inherited: a write above the limit fails then
  ::sigaction(SIGXFSZ, &ignore, &before);
  rlimit old_limit{};
  ::getrlimit(RLIMIT_FSIZE, &old_limit);
  for (const std::size_t bytes : {std::size_t(100'000), std::size_t(1) << 40}) {
    const rlimit small{std::min<rlim_t>(bytes, old_limit.rlim_max), old_limit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const Outcome outcome = split("--threads 1 --max-memory " + limit(1) + " -o part.stl");
    ::setrlimit(RLIMIT_FSIZE, &old_limit);
    if (bytes < 1'000'000) {
      EXPECT_EQ(outcome.code, 1) << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "[output-")) << outcome.err;
      EXPECT_EQ(read("part.stl"), "old");
    } else {
      EXPECT_EQ(outcome.code, 0) << outcome.err;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      EXPECT_FALSE(entry.path().filename().string().starts_with(".mrsim-")) << entry.path();
  }
  ::sigaction(SIGXFSZ, &before, nullptr);
  EXPECT_EQ(split("--threads 1 --max-memory " + limit(1) + " -o none/part.stl").code, 1);
}

}  // namespace
}  // namespace mrsim
