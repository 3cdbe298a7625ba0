// Words of LinuxCNC beside its motions, as its manual says them.
#include "interp/support.h"

namespace mrsim {
namespace {

Program run_words(const std::string& text) {
  return read_text(text, at_origin(Dialect::ngc), "part.ngc");
}

std::string path_of_words(const std::string& text) { return path_text(run_words(text)); }

TEST(LinuxCncWords, M70AndM72SaveAndRestoreModesButNoMotion) {
  // G21 G90 F100 come back; the motion in force stays the last one, G0.
  const Program p = run_words(
      "G21 G90 F100\nG1 X1\nM70\nG20 G91 F9\nG0 X1\nM72\nX5\nG1 X6\nM72\nG91\nM72\nX7\nM2\n");
  EXPECT_EQ(path_text(p), "l1,0,0 r26.4,0,0 r5,0,0 l6,0,0 l7,0,0");
  EXPECT_EQ(p.motions[3].feed, 100);
}

TEST(LinuxCncWords, M72RestoresPlaneWorkOffsetAndDiameters) {
  EXPECT_EQ(path_of_words("G10 L2 P2 X10\nG54 G8\nM70\nG55 G7 G18\nG1 X4 F1\nM72\nG1 X4 F1\nM2\n"),
            "l12,0,0 l4,0,0");
}

TEST(LinuxCncWords, M73RestoresWhenItsSubprogramReturns) {
  EXPECT_EQ(path_of_words("O<in> sub\nM73\nG20 G91\nG1 X1 F10\nO<in> endsub\n"
                          "G21 G90 F100\nO<in> call\nG1 X30\nM2\n"),
            "l25.4,0,0 l30,0,0");
  EXPECT_EQ(path_of_words("G21 G90 F100\nM98 P7\nG1 X30\nM2\nO7\nM73\nG91 G1 X1\nX1\nM99\n"),
            "l1,0,0 l2,0,0 l30,0,0");
}

TEST(LinuxCncWords, SavedModesBelongToTheirSubprogramAndMayBeForgotten) {
  EXPECT_EQ(path_of_words("G21 G90 F100\nM72\nM2\n"), " | saved-modes");
  EXPECT_EQ(path_of_words("M70\nM71\nM72\nG1 X1 F1\nM2\n"), "l1,0,0 | saved-modes");
  EXPECT_EQ(path_of_words("O1 sub\nM72\nO1 endsub\nG1 X1 F1\nM70\nO1 call\nM2\n"),
            "l1,0,0 | saved-modes");
  EXPECT_EQ(path_of_words("G1 X1 F1\nM70\nG41.1 D2\nG1 X5\nM72\nG40\nG1 X9\nM2\n")
                    .find("not-supported") != std::string::npos,
            true);
}

TEST(LinuxCncWords, AuxiliaryAxesThatMoveAreErrors) {
  EXPECT_EQ(path_of_words("G1 X1 U0 V0 W0 F1\nM2\n"), "l1,0,0");
  EXPECT_EQ(path_of_words("G1 X1 F1\nX2 U5\nM2\n"), "l1,0,0 | not-supported");
  EXPECT_EQ(path_of_words("G1 X1 F1\nG92 W3\nM2\n"), "l1,0,0 | not-supported");
}

// The tool touches somewhere on its way: where that is gets its coordinate, and the zero stays.
TEST(LinuxCncWords, TouchingOffByAProbeKeepsTheZero) {
  for (const char* off : {"G10 L20 P0 Z0", "G10 L20 P1 Z0", "G92 Z0"})
    EXPECT_EQ(path_of_words(std::string("G0 X0 Y0 Z10\nG38.2 Z-10 F50\n") + off +
                            "\nG0 Z5\nG1 Z-1 F9\nM2\n"),
              "r0,0,10 r0,0,5 l0,0,-1");
  EXPECT_EQ(path_of_words("G0 X3 Z10\nG38.2 Z-10 F50\nG10 L20 P1 X1 Z0\nG0 X1 Z5\nG1 X0 F9\nM2\n"),
            "r3,0,10 r3,0,5 l2,0,5");
}

TEST(LinuxCncWords, WhatAProbeOrAnInputSaidComesFromOutside) {
  InterpOptions options = at_origin(Dialect::ngc);
  const std::string text = "F50\nG38.2 Z-10\nM66 P0 L3 Q5\nG1 X#5399 Y#5063\nM2\n";
  const Program p = read_text(text, options);
  EXPECT_EQ(codes(p, Severity::error), "variable-number");
  EXPECT_NE(p.diagnostics[1].text.find("--set '#5399="), std::string::npos);
  options.variables = {{"#5399", "1"}, {"#5063", "-2"}};
  EXPECT_EQ(path_text(read_text(text, options)), "l1,-2,0");
}

TEST(LinuxCncWords, SignalsOverridesAndSpindlesHaveNoEffect) {
  const Program p = run_words(
      "M62 P0\nM63 P0\nM64 P1\nM65 P1\nM66 P0 L3 Q5\nM66 E0 L0\nM67 E0 Q1.5\nM68 E0 Q2\nM48\nM49\n"
      "M50 P0\nM51 P1\nM52 P1\nM53 P0\nM19 R90 Q2 $0\nS1000 $1 M3 $0\nG1 X1 F1\nM5 $1\nM2\n");
  EXPECT_EQ(listing(p).find("m-unknown"), std::string::npos);
  EXPECT_EQ(path_text(p), "l1,0,0 | address-twice");
}

TEST(LinuxCncWords, TwoWordsOfOneGroupAreRefused) {
  EXPECT_EQ(path_of_words("G1 X1 F1\nG20 G21 X2\nM2\n"), "l1,0,0 | group-twice");
  EXPECT_EQ(path_of_words("G1 X1 F1\nG54 G55 X2\nM2\n"), "l1,0,0 | group-twice");
  EXPECT_EQ(path_of_words("G0 G17 G21 G40 G49 G80 G90 G94 G54\nG1 X1 F1\nM2\n"), "l1,0,0");
}

TEST(LinuxCncWords, AxesBesideG80AreRefused) {
  EXPECT_EQ(path_of_words("G1 X1 F1\nG80 X2\nM2\n"), "l1,0,0 | motion-missing");
  EXPECT_EQ(path_of_words("G1 X1 F1\nG80 G0 X2\nG80 G92 X0\nG1 X1\nM2\n"), "l1,0,0 r2,0,0 l3,0,0");
}

}  // namespace
}  // namespace mrsim
