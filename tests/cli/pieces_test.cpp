// Pieces that a program cuts loose: counted, reported, and dropped when asked.
#include "run_program.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Pieces : public CliTest {
 protected:
  // A slot of 2 mm through a block 20 x 10 x 4 at x = 12..14: pieces of 480 and 240 mm3.
  void SetUp() override {
    CliTest::SetUp();
    write("split.MPF",
          "G54\nTRANS X0 Y0\nG17 G90 G71\nT1 M6\nG0 X13 Y-3 Z5\nG1 Z-5 F100\nG1 Y13\nG0 "
          "Z5\nM30\n");
  }
  Outcome split(const std::string& more) {
    return run(
        "split.MPF --machine mill --stock box:0,0,-4,20,10,0 --tool 1=endmill:d=2 "
        "--voxel 0.25 " +
        more);
  }
};

TEST_F(Pieces, AllAreKeptWithAWarning) {
  const Outcome outcome = split("-o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "warning: the part is in 2 pieces")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "detached piece of 240 mm3 at (17, 5, -2) mm")) << outcome.err;
  EXPECT_NEAR(number_after(outcome.out, "volume"), 720, 0.01) << outcome.out;
  EXPECT_EQ(split("--keep all -o all.stl").code, 0);
  EXPECT_EQ(read("all.stl"), read("part.stl"));
}

TEST_F(Pieces, LargestDropsTheOthersAndSaysSo) {
  const Outcome outcome = split("--keep largest -o part.stl --strict");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "dropped: detached piece of 240 mm3")) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "the largest kept")) << outcome.out;
  EXPECT_NEAR(number_after(outcome.out, "volume"), 480, 0.01) << outcome.out;
  EXPECT_NEAR(number_after(outcome.out, "removed"), 320, 0.01) << outcome.out;
}

// The STL was written while the mesh was made, all pieces of it: the piece is written anew.
TEST_F(Pieces, LargestLeavesNothingOfTheOthersInTheFile) {
  const Outcome outcome = split("--keep largest -o part.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto triangles = std::size_t(number_after(outcome.out, "triangles"));
  EXPECT_EQ(read("part.stl").size(), 84 + 50 * triangles);
}

// Found when the STL is complete but for its name.
TEST_F(Pieces, StrictRunsThatFailLeaveTheOldFile) {
  write("old.stl", "old");
  const Outcome outcome = split("--strict -o old.stl");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(read("old.stl"), "old");
  expect_failure(
      "split.MPF --machine mill --stock box:0,0,-4,20,10,0 --tool 1=endmill:d=40 "
      "--voxel 0.25 -o old.stl",
      1, "nothing is left");
  EXPECT_EQ(read("old.stl"), "old");
}

TEST_F(Pieces, OnePieceIsNotWorthAWord) {
  const Outcome outcome = run("PRIMER_2F.MPF --stock block.stl --voxel 1 --keep largest -o a.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_FALSE(contains(outcome.out + outcome.err, "piece")) << outcome.out << outcome.err;
}

TEST_F(Pieces, VdbHoldsThemAll) {
  const Outcome outcome = split("--keep largest -o part.vdb");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "the .vdb holds all pieces")) << outcome.err;
}

TEST_F(Pieces, StrictRefusesAPartInPieces) {
  const Outcome outcome = split("--strict -o part.stl");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_FALSE(exists("part.stl"));
}

TEST_F(Pieces, UnknownWordIsUsage) { expect_failure("PRIMER_2F.MPF --keep larges", 2, "largest"); }

}  // namespace
}  // namespace mrsim
