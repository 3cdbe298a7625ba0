// Okuma's OSP: the cycles of LAP, corners of lathes.
#include "interp/support.h"

namespace mrsim {
namespace {

std::string turned(const std::string& text) {
  return path_text(read_text(text, at_origin(Dialect::fanuc, MachineKind::lathe)));
}

// A contour is passed over where it stands, before or behind its calls.
TEST(Okuma, LapRoughsAndFinishesAContourByName) {
  const std::string contour = "NLAP1 G81\nG0 X20\nG1 Z-5 F.1\nX30\nG80\n";
  const std::string calls = "G0 X30 Z2\nG85 NLAP1 D4 U.4 W.2 F.3\nG87 NLAP1\nG0 Z9\n";
  const std::string path =
      "r15,0,2 r13,0,2 l13,0,-4.8 r13.5,0,-4.3 r13.5,0,2 r11,0,2 l11,0,-4.8 r11.5,0,-4.3 "
      "r11.5,0,2 r10.2,0,2.2 l10.2,0,-4.8 l15.2,0,-4.8 r15,0,2 r10,0,2 l10,0,-5 l15,0,-5 r15,0,2 "
      "r15,0,9";
  EXPECT_EQ(turned(contour + calls), path);
  EXPECT_EQ(turned(calls + "M2\n" + contour), path);
  EXPECT_EQ(turned(calls + contour + "G0 X99\n"), path + " r49.5,0,9");
}

// U of a bore is left inside, whatever its sign; levels of G82 lie along Z, where D is a depth.
TEST(Okuma, LapLeavesItsAllowancesWhereThePassesComeFrom) {
  const std::string bore = "NB G81\nG0 X30\nG1 Z-5 F.1\nX20\nG80\nG0 X20 Z2\n";
  const std::string cut =
      "r10,0,2 r12,0,2 l12,0,-5 r11.5,0,-4.5 r11.5,0,2 r14,0,2 l14,0,-5 r13.5,0,-4.5 r13.5,0,2 "
      "r14.8,0,2 l14.8,0,-5 l9.8,0,-5 r10,0,2";
  EXPECT_EQ(turned(bore + "G85 NB D4 U.4 F.3\n"), cut);
  EXPECT_EQ(turned(bore + "G85 NB D4 U-.4 F.3\n"), cut);
  EXPECT_EQ(turned("NF G82\nG0 Z-5\nG1 X10 F.1\nZ1\nG80\nG0 X30 Z1\nG85 NF D4 F.3\n"),
            "r15,0,1 r15,0,-3 l5,0,-3 r5.5,0,-2.5 r15,0,-2.5 r15,0,-5 l5,0,-5 l5,0,1 r15,0,1");
}

TEST(Okuma, WhatLapDoesNotReadIsNamed) {
  const std::string contour = "NLAP1 G81\nG0 X20\nG1 Z-5 F.1\nX30\nG80\nNBL G83\nG1 X9 F1\nG80\n";
  const auto code = [&](const std::string& call) {
    const Program p =
        read_text(contour + "G0 X30 Z2\n" + call, at_origin(Dialect::fanuc, MachineKind::lathe));
    return codes(p);
  };
  EXPECT_EQ(code("G85 NLAP2 D4 F.3\n"), "jump-target");
  EXPECT_EQ(code("G85 NLAP1 F.3\n"), "value-missing");
  EXPECT_EQ(code("G85 NBL D4 F.3\n"), "not-supported");
  EXPECT_EQ(code("G86 NLAP1 D4 F.3\n"), "not-supported");
  EXPECT_EQ(code("G88 NLAP1 D4 F.3\n"), "not-supported");
  EXPECT_EQ(code("G87 NLAP1 U.2\n"), "not-supported");
}

// G75 cuts the corner at the end of its line off, G76 rounds it; with P and Q they are FANUC's.
TEST(Okuma, CornersOfLathesStandBehindL) {
  EXPECT_EQ(turned("G0 X16 Z0\nG1 F.2\nG75 X20 L2\nG76 Z-20 L3\nX30\n"),
            turned("G0 X16 Z0\nG1 F.2\nX20 ,C2\nZ-20 ,R3\nX30\n"));
}

}  // namespace
}  // namespace mrsim
