// Words of the ISO dialect that its family (Fagor 8055) reads otherwise than FANUC.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string iso(const std::string& text) {
  return path_text(read_text("G1 X0 Y0 F100\n" + text, at_origin(Dialect::iso)));
}

// The rounding and the chamfer of the programming manual's pictures.
TEST(IsoWords, CornersAreRoundedBetweenTwoMoves) {
  EXPECT_EQ(iso("G36 R5 X35 Y0\nX35 Y50\n"), iso("X30 Y0\nG3 X35 Y5 I0 J5\nG1 X35 Y50\n"));
  EXPECT_EQ(iso("G39 R15 X35 Y0\nX35 Y50\n"), iso("X20 Y0\nX35 Y15\nX35 Y50\n"));
  EXPECT_EQ(iso("G36 X35\n"), " | value-missing");
}

TEST(IsoWords, ArcsAreGivenByPointsAndTangents) {
  EXPECT_EQ(iso("G9 X20 Y0 I10 J10\nX30\n"), iso("G2 X20 Y0 I10 J0\nG1 X30\n"))
      << "behind G9 a line is in force again";
  EXPECT_EQ(iso("G91 X5\nG9 X20 Y0 I10 J10\n"), iso("G91 X5\nG2 X20 Y0 I10 J0\n"))
      << "in G91 the point counts from the start";
  EXPECT_EQ(iso("X10\nG8 X20 Y10\nY20\n"), iso("X10\nG3 X20 Y10 I0 J10\nG1 Y20\n"));
  EXPECT_EQ(iso("X10\nG6 G3 X20 Y10 I10 J10\nG1 Y20\n"), iso("X10\nG3 X20 Y10 I0 J10\nG1 Y20\n"));
  EXPECT_EQ(iso("X10\nG6 G3 X20 Y10 J10\n"), "l10,0,0 | arc-no-center");
}

// The manual's helix of ten turns: K is the pitch.
TEST(IsoWords, HelicesHaveTheirPitchInK) {
  const auto turns = [](const std::string& arc) {
    const Program p = read_text("G1 X0 Y0 F100\n" + arc + "\n", at_origin(Dialect::iso));
    return codes(p).empty() ? p.motions.back().sweep / kTwoPi : 0.0;
  };
  EXPECT_NEAR(turns("G3 X0 Y0 I15 J0 Z50 K5"), 10, 1e-9);
  EXPECT_NEAR(turns("G2 I15 J0 Z-15 K5"), -3, 1e-9);
  EXPECT_NEAR(turns("G2 X30 Y0 I15 J0 Z-12.5 K5"), -2.5, 1e-9);
  EXPECT_NEAR(turns("G2 X15 Y15 R15 Z-3.1 K2.48"), -1.25, 1e-9);
  EXPECT_NEAR(turns("G18 G3 Z0 X0 K15 I0 Y9 J3"), 3, 1e-9);
  EXPECT_EQ(iso("G3 X0 Y0 I15 J0 Z50 K7\n"), " | arc-turns");
  EXPECT_EQ(iso("G3 X0 Y0 I15 J0 K5\n"), " | arc-center-outside-plane");
}

TEST(IsoWords, WordsWithoutEffectOnThePartAreReadOver) {
  for (const char* words :
       {"G5", "G7", "G05 X10", "G50", "G10", "G31", "G9", "G73", "G51 E0.1", "G51 A50 E0.05"})
    EXPECT_EQ(codes(read_text("G1 X0 Y0 F100\n" + std::string(words) + "\nX20\n",
                              at_origin(Dialect::iso))),
              "")
        << words;
}

// 8055: G11 to G13 mirror about the zero, one beside the other; G72 S scales about it; G73 Q turns
// further each time, so that a part repeated by RPT stands round about; alone it ends that.
TEST(IsoWords, FagorMirrorsScalesAndTurns) {
  EXPECT_EQ(iso("G11 X5 Y2\nX10\nG12\nX11 Y3\nG10\nX12 Y4\n"),
            "l-5,2,0 l-10,2,0 l-11,-3,0 l12,4,0");
  EXPECT_EQ(iso("G13\nX1 Y1 Z-2\nG10 G1 X5 Z-3\n"), "l1,1,2 l5,1,-3");
  EXPECT_EQ(iso("G11 X5 Y0\nG3 X10 Y5 R5\n"), "l-5,0,0 a-10,5,0");
  EXPECT_EQ(iso("G72 S2\nX5 Y5 Z-1\nG72 S1\nX5 Y5\n"), "l10,10,-2 l5,5,-2");
  EXPECT_EQ(iso("G73 Q90\nX10 Y0\nG73 Q90\nX10 Y0\nG73\nX10 Y0\n"), "l0,10,0 l-10,0,0 l10,0,0");
  EXPECT_EQ(iso("G73 Q90 I10 J0\nX20 Y0\n"), "l10,10,0");
  EXPECT_EQ(iso("N10 G73 Q90\nN20 X10 Y0\n(RPT N10,N20) N3\n"),
            "l0,10,0 l-10,0,0 l0,-10,0 l10,0,0");
  EXPECT_EQ(iso("G73 Q90\nG73 Q90 I5\n"), " | not-supported");
  EXPECT_EQ(iso("G72 S0\n"), " | value-range");
}

// The picture of the manual's chapter on G93, and its circle of holes.
TEST(IsoWords, QAndRArePolarCoordinatesOfFagor) {
  EXPECT_EQ(iso("G93 I35 J30\nG90 G01 R25 Q0\nG03 Q90\nG01 X0 Y0\n"),
            iso("X60 Y30\nG3 X35 Y55 I-25 J0\nG1 X0 Y0\n"));
  EXPECT_EQ(iso("X20 Y0\nQ90\nX5\nG91 R15 Q-90\n"), "l20,0,0 l0,20,0 l5,20,0 l34.55,-8.638,0");
  EXPECT_EQ(iso("G93 I5\n"), " | value-missing");
  EXPECT_EQ(iso("G93 I10 J10\nG18\nG17\nR5 Q0\n"), "l5,0,0") << "a plane begins with its zero";
  const std::string holes = "G0 Z20\nG81 G99 G90 X100 Y0 Z2 I-8 F100\n";
  const auto hole = [](const char* at) { return fmt::format("r{0},2 l{0},-8 r{0},2", at); };
  const std::string first = "r0,0,20 r100,0,20 " + hole("100,0");
  const std::string round =
      first + " " + hole("0,100") + " " + hole("-100,0") + " " + hole("0,-100");
  EXPECT_EQ(iso(holes + "G91 Q90 N3\nG80\n"), round);
  // What stands in brackets before N is a comment or an expression, and no end of the block.
  EXPECT_EQ(iso(holes + "G91 Q90 (three of N4) N3 (all)\nG80\n"), round);
  EXPECT_EQ(iso(holes + "G91 Q(30*(1+2)) N3\nG80\n"), round);
  EXPECT_EQ(iso(holes + "G90 Q90\nQ180\nR100 Q270\nG80\n"), round);
  EXPECT_EQ(iso(holes + "G91 X10 N2\nG80\n"), first + " " + hole("110,0") + " " + hole("120,0"));
  EXPECT_EQ(iso("G0 Z20\nG81 G99 Q30 Z2 I-8 F100\n"), "r0,0,20 | not-supported");
}

// The manual's two arcs, in G90 and G91: Q is the angle at the centre that I and J give.
TEST(IsoWords, QEndsAnArcAtAnAngle) {
  const std::string arcs = iso("X60 Y40\nG3 X110 Y90 I0 J50\nX160 Y40 I50 J0\n");
  EXPECT_EQ(iso("X60 Y40\nG90 G17 G3 Q0 I0 J50\nQ-90 I50 J0\n"), arcs);
  EXPECT_EQ(iso("X60 Y40\nG91 G3 Q90 I0 J50\nQ90 I50 J0\n"), arcs);
  EXPECT_EQ(iso("X60 Y40\nG6 G3 Q0 I60 J90\nG6 Q-90 I160 J90\n"), arcs);
  EXPECT_EQ(iso("X10\nG2 Q90 I-10 J0 Z-3\n"), iso("X10\nG2 X0 Y10 I-10 J0 Z-3\n"));
  EXPECT_EQ(iso("G18\nX10 Z0\nG3 Q0 I-10 K0\n"), iso("G18\nX10 Z0\nG3 X0 Z10 I-10 K0\n"));
  const Program p = read_text("G1 X10 Y0 F9\nG3 Q180 I-10 J0 Z-5 K2\n", at_origin(Dialect::iso));
  EXPECT_NEAR(p.motions.back().sweep, 5 * kPi, 1e-9) << "two turns and a half";
  EXPECT_EQ(iso("G1 Q90 I5 J0\n"), " | not-supported");
}

TEST(IsoWords, TheToolMayNameItsOffset) {
  InterpOptions options = at_origin(Dialect::iso);
  OffsetRegister offset;
  offset.name = "D12";
  offset.radius = 2;
  options.table.offsets.push_back(offset);
  const Program p = read_text("T2.12 M6\nG1 G42 X10 Y0 F9\nX20\nM30\n", options);
  EXPECT_EQ(path_text(p), "l10,-2,0 l20,-2,0");
  EXPECT_NE(codes(p, Severity::note).find("tool-station"), std::string::npos);
  EXPECT_EQ(p.tools.at(0).id, "2");
}

// Each of them moved straight on with a warning at most.
TEST(IsoWords, WhatIsNotReadIsNamed) {
  for (const char* words : {"G72 S2 X1", "G32", "G37 R5 X20", "G38 R5 X20", "G61 X100 I10 Y50 J5",
                            "G63 X100 I10", "G1 R10", "G1 X10 Q45", "G1 X10 Y20 R3", "G3 Q90 R5"})
    EXPECT_EQ(iso(std::string(words) + "\n"), " | not-supported") << words;
}

}  // namespace
}  // namespace mrsim
