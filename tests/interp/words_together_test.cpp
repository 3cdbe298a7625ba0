// Words that stand in one block: each of them acts, or the block says why it does not.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// H is that of G43 then. G15 H of Okuma, a work offset, has no G43 beside it.
TEST(WordsTogether, PolarCoordinatesEndBesideALength) {
  const std::string polar = "G16\nG1 X10. Y90. F9\n";
  EXPECT_EQ(mill(polar + "G15 G43 H1\nX3. Y4.\n"), "l0,10,0 l3,4,0");
  EXPECT_EQ(mill(polar + "G49 H0 G15\nX3. Y4.\n"), "l0,10,0 l3,4,0");
  EXPECT_EQ(mill("G16 G43 H1\nG1 X10. Y90. F9\n"), "l0,10,0");
}

// G103 P and G187 P E of Haas set modes of the control; the rest of their block is a move.
TEST(WordsTogether, ModesOfHaasLeaveTheMoveItsAxes) {
  EXPECT_EQ(mill("G187 P3 G1 X5. F9\nG103 P1 Y5.\nG187 P1 E.01 X6.\n"), "l5,0,0 l5,5,0 l6,5,0");
  EXPECT_EQ(mill("F9\nG1 G131 J.05 E1. X5.\n"), "l5,0,0");
  EXPECT_EQ(mill("G22 X9. Y9. Z9. I0 J0 K0\nG1 X5. F9\n"), "l5,0,0");
}

TEST(WordsTogether, PBelongsToOneWord) {
  const Program p = read_text("G1 X10. F9\nG54.1 P2 G3 I-10. J0\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(p.motions.size(), 2U);
  EXPECT_NEAR(p.motions.back().sweep, kTwoPi, 1e-9) << "P2 is no number of turns";
  EXPECT_TRUE(dwells_of(read_text("G54.1 P2 G83 X3. Z-2. R1. Q9. F9\n", at_origin(Dialect::fanuc)))
                  .empty());
}

TEST(WordsTogether, OnlyOneOfThemIsAnError) {
  EXPECT_EQ(mill("G1 F9\nX5. G4 P1.\nX6.\n"), "l6,0,0 | call-not-alone");
  EXPECT_EQ(mill("G91 G28 Z0 G92 X0\nG90 G1 X6. F9\n"), "l6,0,0 | group-twice");
  EXPECT_EQ(mill("G91 G28 Z0 G28 X0\nG90 G1 X6. F9\n"), "l6,0,0");
}

// G5 and G7 of Fagor, round and square corners, stand beside moves of every form.
TEST(WordsTogether, CornersOfFagorStandBesideMoves) {
  EXPECT_EQ(mill("G5 G1 R5 Q90 F9\n", Dialect::iso), "l0,5,0");
  EXPECT_EQ(mill("G7 R5 Q90 F9 G1\n", Dialect::iso), "l0,5,0");
  EXPECT_EQ(mill("G5 G2 X10 Y0 I5 J0 F9\n", Dialect::iso), mill("G2 X10 Y0 I5 J0 F9\n"));
  EXPECT_EQ(mill("G5 P10000\nG1 X5 F9\n", Dialect::iso), "l5,0,0");
  EXPECT_EQ(mill("G5 X5 Y5 I1 J1 P1 Q1\n", Dialect::iso), " | not-supported");
}

// Words of CODESYS are split by blanks or tabs.
TEST(WordsTogether, TabsMaySplitWordsOfCodesys) {
  EXPECT_EQ(
      mill("N1 SUB{2}\nN2 G1 X9 F9\nSUBPROGRAM\tSUB{#A : LREAL}\nN1 G1 Y#A F9\nEND_SUBPROGRAM\n",
           Dialect::codesys),
      "l0,2,0 l9,2,0");
}

}  // namespace
}  // namespace mrsim
