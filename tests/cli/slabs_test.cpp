// Runs whose memory is limited: done in slabs with the same files, or refused with what to do.
#include "run_program.h"

namespace mrsim {
namespace {

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

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Between what the run takes in slabs and in one piece, for that many threads.
std::string limit(int threads) { return std::to_string(60 + 30 * threads + 15) + "M"; }

TEST_F(Slabs, GiveTheSameBytes) {
  for (const char* format : {"stl", "ply", "obj", "off", "3mf"}) {
    const std::string whole = std::string("whole.") + format,
                      slabs = std::string("slabs.") + format;
    ASSERT_EQ(split("--color line -o " + whole).code, 0);
    for (const int threads : {1, 2}) {
      const Outcome outcome = split("--color line --threads " + std::to_string(threads) +
                                    " --max-memory " + limit(threads) + " -o " + slabs);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "note: done in ")) << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "the part is in 2 pieces")) << outcome.err;
      EXPECT_TRUE(read(slabs) == read(whole)) << format << ", threads " << threads;
    }
  }
}

TEST_F(Slabs, DropPieces) {
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
        {"--tolerance 0.001 -o part.stl", "with --voxel and no --tolerance"},
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

}  // namespace
}  // namespace mrsim
