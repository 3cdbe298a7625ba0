// Words of the ISO dialect that its family (Fagor 8055) reads otherwise than FANUC.
#include "interp/support.h"

namespace mrsim {
namespace {

std::string iso(const std::string& text) {
  return path_text(read_text("G1 X0 Y0 F100\n" + text, at_origin(Dialect::iso)));
}

// The rounding and the chamfer of the programming manual's pictures.
TEST(IsoWords, CornersBetweenTwoMoves) {
  EXPECT_EQ(iso("G36 R5 X35 Y0\nX35 Y50\n"), iso("X30 Y0\nG3 X35 Y5 I0 J5\nG1 X35 Y50\n"));
  EXPECT_EQ(iso("G39 R15 X35 Y0\nX35 Y50\n"), iso("X20 Y0\nX35 Y15\nX35 Y50\n"));
  EXPECT_EQ(iso("G36 X35\n"), " | value-missing");
}

TEST(IsoWords, ArcsByPointsAndTangents) {
  EXPECT_EQ(iso("G9 X20 Y0 I10 J10\nX30\n"), iso("G2 X20 Y0 I10 J0\nG1 X30\n"))
      << "behind G9 a line is in force again";
  EXPECT_EQ(iso("G91 X5\nG9 X20 Y0 I10 J10\n"), iso("G91 X5\nG2 X20 Y0 I10 J0\n"))
      << "in G91 the point counts from the start";
  EXPECT_EQ(iso("X10\nG8 X20 Y10\nY20\n"), iso("X10\nG3 X20 Y10 I0 J10\nG1 Y20\n"));
  EXPECT_EQ(iso("X10\nG6 G3 X20 Y10 I10 J10\nG1 Y20\n"), iso("X10\nG3 X20 Y10 I0 J10\nG1 Y20\n"));
  EXPECT_EQ(iso("X10\nG6 G3 X20 Y10 J10\n"), "l10,0,0 | arc-no-center");
}

TEST(IsoWords, WordsWithoutEffectOnThePart) {
  for (const char* words : {"G5", "G7", "G05 X10", "G50", "G10", "G31", "G9", "G73"})
    EXPECT_EQ(codes(read_text("G1 X0 Y0 F100\n" + std::string(words) + "\nX20\n",
                              at_origin(Dialect::iso))),
              "")
        << words;
}

// Each of them moved straight on with a warning at most.
TEST(IsoWords, WhatIsNotReadIsNamed) {
  for (const char* words : {"G11", "G12", "G13", "G72 S2", "G73 Q45", "G32", "G37 R5 X20",
                            "G38 R5 X20", "G61 X100 I10 Y50 J5", "G63 X100 I10", "G93 I10 J10",
                            "G1 R10 Q45", "G1 X10 Q45", "G1 X10 Y20 R3"})
    EXPECT_EQ(iso(std::string(words) + "\n"), " | not-supported") << words;
}

}  // namespace
}  // namespace mrsim
