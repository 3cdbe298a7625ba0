// Okuma's OSP: the cycles of LAP, corners of lathes.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string osp_turned(const std::string& text) {
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
  EXPECT_EQ(osp_turned(contour + calls), path);
  EXPECT_EQ(osp_turned(calls + "M2\n" + contour), path);
  EXPECT_EQ(osp_turned(calls + contour + "G0 X99\n"), path + " r49.5,0,9");
}

TEST(Okuma, OtherDepthsOnTheWayOfLapChangeNoShape) {
  const std::string contour = "NLAP1 G81\nG0 X20\nG1 Z-5 F.1\nX30\nG80\nG0 X30 Z2\n";
  const std::string call = "G85 NLAP1 D4 U.4 W.2 F.3";
  EXPECT_EQ(osp_turned(contour + call + " G84 XA=26 DA=2 FA=0.1 (LESS)\n$ G84 XB=22 DB=1\nG0 Z9\n"),
            osp_turned(contour + call + "\nG0 Z9\n"));
}

// U of a bore is left inside, whatever its sign; levels of G82 lie along Z, where D is a depth.
TEST(Okuma, LapLeavesItsAllowancesWhereThePassesComeFrom) {
  const std::string bore = "NB G81\nG0 X30\nG1 Z-5 F.1\nX20\nG80\nG0 X20 Z2\n";
  const std::string cut =
      "r10,0,2 r12,0,2 l12,0,-5 r11.5,0,-4.5 r11.5,0,2 r14,0,2 l14,0,-5 r13.5,0,-4.5 r13.5,0,2 "
      "r14.8,0,2 l14.8,0,-5 l9.8,0,-5 r10,0,2";
  EXPECT_EQ(osp_turned(bore + "G85 NB D4 U.4 F.3\n"), cut);
  EXPECT_EQ(osp_turned(bore + "G85 NB D4 U-.4 F.3\n"), cut);
  EXPECT_EQ(osp_turned("NF G82\nG0 Z-5\nG1 X10 F.1\nZ1\nG80\nG0 X30 Z1\nG85 NF D4 F.3\n"),
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
  EXPECT_EQ(osp_turned("G0 X16 Z0\nG1 F.2\nG75 X20 L2\nG76 Z-20 L3\nX30\n"),
            osp_turned("G0 X16 Z0\nG1 F.2\nX20 ,C2\nZ-20 ,R3\nX30\n"));
}

std::string osp_milled(const std::string& text,
                       const InterpOptions& options = at_origin(Dialect::fanuc)) {
  return path_text(read_text(text, options));
}

TEST(Okuma, VariablesHaveNames) {
  EXPECT_EQ(osp_milled("VC1=-2 VC2=VC1*3\nN10 DIA = 20\nG1 X=DIA/2 Y=VC2+1 Z=-VC1 F=100+50\nX=5\n"),
            "l10,-5,2 l5,-5,2");
  EXPECT_EQ(osp_milled("V1=3\nLP1=V1\nG1 X=LP1*SIN[30] F9\n"), "l1.5,0,0");
  EXPECT_EQ(osp_milled("G1 X=VC7 F9\n"), " | variable-unset");
  EXPECT_EQ(osp_milled("G1 X=ABC F9\n"), " | variable-unset");
  EXPECT_EQ(osp_milled("G1 X=VTOFH[1] F9\n"), " | variable-unset");
  InterpOptions options = at_origin(Dialect::fanuc);
  options.variables = {{"VC7", "4"}};
  EXPECT_EQ(osp_milled("G1 X=VC7 F9\n", options), "l4,0,0");
}

// As bar work begins and ends: the blank of the control's own picture, the name of a section before
// its tool, and the way back to the top, which is the next part.
TEST(Okuma, ABarProgramIsReadUpToTheNextPart) {
  const Program p = read_text(
      "$PART.MIN%\nVGRIN[1]=1 VGRA2[1]=3\nVCHKL=0 VWKR=-602\nM1\nNBAR\nCLEAR\nDEF WORK\nPS "
      "LC,[-400,0],[400,19]\nPS LC, [0,0],[46,9],0\nPT LF,LC,[0,0],[9,9]\n"
      "END\n"
      "DRAW\nN7 VLMON[1]=11\nMSG (LOAD BAR)\nNAT01  (OD AND FACE RGH. TURN .032R)\nG0 X20 "
      "Z20\nT010101\nG96 S200 "
      "M3\nG0 X10 Z1\n"
      "G1 Z-5 F.1\nG0 X20\nGOTO NBAR\nM2\n",
      InterpOptions{});
  EXPECT_EQ(path_text(p), "r10,0,20 r5,0,1 l5,0,-5 r10,0,-5") << listing(p);
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_NEAR(p.tools[0].nose_radius, 0.032 * 25.4, 1e-9);
  EXPECT_NE(codes(p, Severity::note).find("program-loops"), std::string::npos);
}

// A line that begins with $ goes on with the block before it, but for the name of the program.
TEST(Okuma, LinesGoOnBehindADollar) {
  const auto run = [](const std::string& text) {
    return path_text(
        read_text("$PART.MIN%\n" + text, at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  EXPECT_EQ(run("G1 X20\n$ Z-5\n  $F.2 (ON)\nX30\n"), "l10,0,-5 l15,0,-5");
  EXPECT_EQ(run("G1 X20 F.2\nCALL O5 XA=30\n$ ZA=-7\nM2\nO5\nX=XA Z=ZA\nRTS\n"),
            "l10,0,0 l15,0,-7");
  EXPECT_EQ(run("G1 F.2\nV1=0\nNLOOP X=V1*2\n$ Z=-V1\nV1=V1+1\nIF [V1 LT 3] GOTO NLOOP\nM2\n"),
            "l1,0,-1 l2,0,-2");
}

TEST(Okuma, JumpsGoToBlocksByNumberOrName) {
  EXPECT_EQ(osp_milled("G1 F9\nVC1=0\nNLP X=VC1\nVC1=VC1+1\nIF [VC1 LT 3] NLP\nGOTO NEND\nX99\n"
                       "NEND Y1\n"),
            "l1,0,0 l2,0,0 l2,1,0");
  EXPECT_EQ(osp_milled("G1 F9\nIF [1 EQ 2] N5\nX3\nGOTO N20\nN5 X99\nN20 Y1\n"), "l3,0,0 l3,1,0");
  EXPECT_EQ(osp_milled("GOTO NOUT\nG1 X1 F9\n"), " | jump-target");
}

// CALL gives local variables their values; RTS returns; Q counts.
TEST(Okuma, CallsRunProgramsByNumberOrName) {
  const std::string subs =
      "M2\nO100\nG91 G1 X=LN F9\nG90\nRTS\nOTAP (BY NAME)\nG1 Y7 F9\nIF [VC1 EQ 1] NX\nY8\nNX "
      "RTS\n";
  EXPECT_EQ(osp_milled("CALL O100 Q2 LN=3\nCALL O0100 LN=-1\n" + subs), "l3,0,0 l6,0,0 l5,0,0");
  EXPECT_EQ(
      osp_milled("CALL O101 Q2 PX=1 LEN=3\nCALL O101 PX=2 LE1 = 5 LEN=1\nM2\nO101\nG91 G1 X=PX F9 "
                 "Y=LEN\nG90\nRTS\n"),
      "l1,3,0 l2,6,0 l4,7,0")
      << "no LE of N";
  EXPECT_EQ(osp_milled("VC1=1\nCALL OTAP\n" + subs), "l0,7,0");
  EXPECT_EQ(osp_milled("VC1=2\nCALL OTAP\n" + subs), "l0,7,0 l0,8,0");
  EXPECT_EQ(osp_milled("LN=9\nCALL O100 LN=1\nG1 Y=LN\n" + subs), "l1,0,0 l1,9,0")
      << "variables of one program";
  EXPECT_EQ(osp_milled("CALL O100\n" + subs), " | variable-unset");
  EXPECT_EQ(osp_milled("CALL O7\n" + subs), " | subprogram-missing");
  EXPECT_EQ(osp_milled("RTS\n"), " | call-missing");
  EXPECT_EQ(osp_milled("CALL O100 Q-1 LN=1\n" + subs), " | value-range");
}

// MODIN: behind each block that moves, up to MODOUT.
TEST(Okuma, ModalCallsRunBehindEachMove) {
  EXPECT_EQ(
      osp_milled("MODIN O200 DP=-3\nG0 X5\nM8\nX9\nMODOUT\nX0\nM2\nO200\nG1 Z=DP F9\nG0 Z0\nRTS\n"),
      "r5,0,0 l5,0,-3 r5,0,0 r9,0,0 l9,0,-3 r9,0,0 r0,0,0");
  const std::string subs = "MODOUT\nM2\nO100\nG1 Z-1 F9\nZ0\nRTS\nO200\nG1 Y3 F9\nRTS\n";
  EXPECT_EQ(osp_milled("MODIN O100\nMODIN O200\n" + subs), " | not-supported");
  EXPECT_EQ(osp_milled("MODIN O100\nCALL O200\n" + subs), "l0,3,0 | not-supported");
  EXPECT_EQ(osp_milled("MODIN O100\nMODOUT\nMODIN O200\nG0 X1\n" + subs), "r1,0,0 l1,3,0");
}

TEST(Okuma, PathsByG131HaveWordsOfTheirOwn) {
  EXPECT_EQ(osp_milled("G131 F1000 J1 D0.01 E0.02\nG1 X5 F9\nG130\n"), "l5,0,0");
}

// K holes from the angle J on, below 0 clockwise; NCYL: no hole where the cycle is set up.
TEST(Okuma, BhcIsACircleOfHoles) {
  const std::string cycle = "G71 Z9\nG0 Z9\nNCYL G81 X0 Y0 R2 Z-5 F99 M53\n";
  EXPECT_EQ(osp_milled(cycle + "BHC X50 Y40 I10 J90 K2\n"),
            "r0,0,9 r50,50,9 r50,50,2 l50,50,-5 r50,50,9 r50,30,9 r50,30,2 l50,30,-5 r50,30,9");
  EXPECT_EQ(osp_milled("G0 Z9\nG85 R2 Z-5 F99 NCYL\nX4\n"),
            "r0,0,9 r4,0,9 r4,0,2 l4,0,-5 l4,0,2 r4,0,9");
  EXPECT_EQ(osp_milled(cycle + "BHC X0 Y0 I10 J0 K-4\n").substr(0, 40),
            "r0,0,9 r10,0,9 r10,0,2 l10,0,-5 r10,0,9 ");
  EXPECT_NE(osp_milled(cycle + "BHC X0 Y0 I10 J0 K-4\n").find(" r0,-10,9 "), std::string::npos);
  EXPECT_EQ(osp_milled("LAA X0 Y0 I10 K3 J0\n"), " | not-supported");
  EXPECT_EQ(osp_milled("PMIL X9 Y9 Z-1 I9 J9 K1\n"), " | not-supported");
}

/// A program of Okuma's lathes by the name of its file.
std::string osp_named(const std::string& text) {
  return path_text(read_text(text, at_origin(Dialect::fanuc, MachineKind::lathe), "program.MIN"));
}

// G33 and G31 are passes as FANUC's G92; J threads share the lead.
TEST(Okuma, G33OfLathesIsAPassOfAThread) {
  const std::string passes =
      "r12,0,5 r9.5,0,5 l9.5,0,-20 r12,0,-20 r12,0,5 r9.2,0,5 l9.2,0,-20 "
      "r12,0,-20 r12,0,5";
  EXPECT_EQ(osp_named("G0 X24 Z5\nG33 X19 Z-20 F2 L2\nX18.4\n"), passes);
  EXPECT_EQ(osp_named("G0 X24 Z5\nG31 X19 Z-20 F2\nX18.4\n"), passes);
  EXPECT_EQ(osp_turned("G0 X24 Z5\nG33 X19 Z-20 F2\n"), "r12,0,5 l9.5,0,-20") << "of FANUC";
  const Program p = read_text("G0 X24 Z5\nG33 X19 Z-20 F25 J10\n",
                              at_origin(Dialect::fanuc, MachineKind::lathe), "a.MIN");
  ASSERT_GT(p.motions.size(), 2U);
  EXPECT_EQ(p.motions[2].lead, 2.5);
  EXPECT_EQ(osp_named("G0 X24 Z5\nG33 X19 Z-20 F2 A3\n"), "r12,0,5 | not-supported");
  EXPECT_EQ(osp_named("G0 X24 Z5\nG32 X19 Z-20 F2\n"), "r12,0,5 | not-supported");
}

// Heights and depths of G71 are of the diameter: crest 10, root 9, passes at 0.5 and its roots.
TEST(Okuma, G71OfLathesIsAThread) {
  const std::string fanuc = osp_turned("G0 X24 Z5\nG76 X18 Z-20 K1. D.5 F1.5 A60\n");
  EXPECT_EQ(osp_named("G0 X24 Z5\nG71 X18 Z-20 B60 D1 U.1 H2 F1.5 M32 M73\n"), fanuc);
  EXPECT_EQ(osp_named("G0 X24 Z5\nG71 X18 Z-20 B60 D1 H2 F1.5 M33 M74\n"),
            osp_turned("G0 X24 Z5\nG76 X18 Z-20 K1. D.5 F1.5 A60 P2\n"));
  EXPECT_EQ(osp_named("G0 X24 Z5\nG71 X18 Z-20 D1 F1.5\n"), "r12,0,5 | value-missing");
  EXPECT_EQ(osp_named("G0 X24 Z5\nG72 X18 Z-20 D1 W.1 H2 F1.5\n"), "r12,0,5 | not-supported");
}

// G74 is a deep hole or grooves of a face, G73 grooves of a diameter.
// W is the axis of the sub-spindle or of the tailstock there, and no increment of Z.
TEST(Okuma, WOfLathesIsAnAxisOfItsOwn) {
  const auto told = [](const std::string& block) {
    InterpOptions options = at_origin(Dialect::automatic, MachineKind::lathe);
    return codes(read_text("$A.MIN%\nG0 X20 Z2\n" + block + "\nG1 Z-5 F.1\n", options));
  };
  EXPECT_EQ(told("G0 W-300"), "not-supported");
  EXPECT_EQ(told("G1 U2 F.2"), "not-supported");
  EXPECT_EQ(told("G91 G0 X2 Z1\nG90"), "");
  EXPECT_EQ(codes(read_text("O1\nG0 X20. Z2.\nG1 W-3. F.2\n",
                            at_origin(Dialect::fanuc, MachineKind::lathe))),
            "");
}

TEST(Okuma, G73AndG74OfLathesCutInStrokes) {
  EXPECT_EQ(osp_named("G0 X0 Z3\nG74 X0 Z-20 D8 L16 F.1 E1\n"),
            "r0,0,3 l0,0,-5 l0,0,-13 l0,0,-20 r0,0,3");
  EXPECT_EQ(osp_named("G0 X40 Z-5\nG73 X34 Z-9 K2.5 D4 F.1\n"),
            "r20,0,-5 l18,0,-5 l17,0,-5 r20,0,-5 r20,0,-7.5 l18,0,-7.5 l17,0,-7.5 r20,0,-7.5 "
            "r20,0,-9 l18,0,-9 l17,0,-9 r20,0,-9 r20,0,-5");
}

TEST(Okuma, WordsOfItsProgramsChangeNoPath) {
  EXPECT_EQ(osp_named("NAT0101 T010101\nG1 X20 E.1 F.2\n"), "l10,0,0");
  EXPECT_EQ(
      path_text(read_text("G0 Z5\nG83 X2 Z-4 R2 Q4 I1 F9\n", at_origin(Dialect::fanuc), "a.MIN")),
      path_text(read_text("G0 Z5\nG83 X2 Z-4 R2 Q4 F9\n", at_origin(Dialect::fanuc))));
}

TEST(Okuma, MacrosOfTheOwnerAreNoWorkOffsets) {
  EXPECT_EQ(osp_named("G96 S180 G110\nG1 X20 F.2\n"), "l10,0,0");
  EXPECT_EQ(path_text(read_text("G111 X30 Y20\n", at_origin(Dialect::fanuc), "a.MIN")),
            " | not-supported");
  EXPECT_EQ(path_text(read_text("G116 T3\nG1 X30 F9\n", at_origin(Dialect::fanuc), "a.MIN")),
            "l30,0,0");
}

// What was never set is EMPTY, and nothing else can be done with it.
TEST(Okuma, WhatIsNotSetIsEmpty) {
  EXPECT_EQ(osp_milled("IF[VC1 EQ EMPTY]N5\nG1 X7 F9\nN5 G1 X8 F9\n"), "l8,0,0");
  EXPECT_EQ(osp_milled("IF[DIA NE EMPTY]N5\nG1 X7 F9\nN5 G1 X8 F9\n"), "l7,0,0 l8,0,0");
  EXPECT_EQ(osp_milled("VC1=2\nIF[VC1 EQ EMPTY]N5\nG1 X7 F9\nN5 G1 X8 F9\n"), "l7,0,0 l8,0,0");
  EXPECT_EQ(osp_milled("IF[VC1 EQ 0]N5\nG1 X7 F9\nN5 G1 X8 F9\n"), " | variable-unset");
}

// G94 and G90 are modes; the zero is no variable to be set.
TEST(Okuma, G90AndG94OfLathesAreModes) {
  EXPECT_EQ(osp_named("G1 X30 Z5 F.2\nG94 X20 F100\nG90 X24 Z-6\n"), "l15,0,5 l10,0,5 l12,0,-6");
  EXPECT_EQ(osp_named("VZOFZ=5\nG1 X2 F1\n"), "l1,0,0 | variable-unset");
}

// NE of NEND was read as the comparison "not equal".
TEST(Okuma, AConditionEndsWithItsBracket) {
  const std::string end = "\nGOTO NA1\nNEND G1 Y1\nM02\n";
  for (const std::string jump :
       {"IF [VC1 GE 2] NEND", "IF[VC1 GE 2]GOTO NEND", "IF [VC1 EQ 2] NEND"})
    EXPECT_EQ(osp_milled("VC1=0\nNA1 VC1=VC1+1\nG1 X=VC1 F9\n" + jump + end),
              "l1,0,0 l2,0,0 l2,1,0")
        << jump;
}

}  // namespace
}  // namespace mrsim
