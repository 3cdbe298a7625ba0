// Words that controls read differently from one another: each is read as its control does, or it is
// an error that names it. Never a motion of another meaning.
#include "interp/support.h"

#include <cmath>
#include <utility>

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string lathe(const std::string& text) {
  return path_text(read_text(text, at_origin(Dialect::fanuc, MachineKind::lathe)));
}

// The bolt circle of the manual: angles in G91 count from the last one, repeats too.
TEST(ControlsDiffer, RepeatsUnderG16TurnAboutThePole) {
  EXPECT_EQ(mill("G0 Z9\nG16\nG99 G81 X10. Y0 Z-1. R2. F100\nG91 Y90. K3\nG90 G15 G80\n"),
            "r0,0,9 r10,0,9 r10,0,2 l10,0,-1 r10,0,2 r0,10,2 l0,10,-1 r0,10,2 r-10,0,2 l-10,0,-1 "
            "r-10,0,2 r0,-10,2 l0,-10,-1 r0,-10,2");
}

TEST(ControlsDiffer, G54WithPIsAnExtendedOffset) {
  const std::string set = "G10 L20 P2 X100. Y0 Z0\n";
  EXPECT_EQ(mill(set + "G54 P2\nG1 X1. F10\nG54 X2.\n"), "l101,0,0 l2,0,0");
  EXPECT_EQ(mill(set + "G90 G1 G54 P2 X1. F10\n"), "l101,0,0");
  EXPECT_EQ(mill(set + "G54 G82 X1. Z-1. R2. P2 F10\n"), "r1,0,0 r1,0,2 l1,0,-1 r1,0,2");
}

// Two P words, each right behind its own word: the offset's and the program's.
TEST(ControlsDiffer, AnExtendedOffsetMayStandBesideACall) {
  const std::string set = "O1\nG10 L20 P2 X100. Y0 Z0\n";
  const std::string sub = "\nM30\nO5\nG1 X1. F10\nX0\nM99\n";
  const std::string once = "l101,0,0 l100,0,0";
  EXPECT_EQ(mill(set + "G54.1 P2 M98 P5" + sub), once);
  EXPECT_EQ(mill(set + "M98 P5 L2 G154 P2" + sub), once + " " + once);
  EXPECT_EQ(mill(set + "G54 P2 M98 P5" + sub), once);
  EXPECT_EQ(mill(set + "G54.1 M98 P2 P5" + sub), " | address-twice");
  EXPECT_EQ(mill(set + "M98 P5 P2" + sub), " | address-twice");
}

TEST(ControlsDiffer, CallsOfBlocksAndExternalProgramsAreNeverOverlooked) {
  const std::string sub = "M30\nO5\nN1 G1 X5. F10\nN2 G1 X7.\nM99\n";
  EXPECT_EQ(mill("O1\nF10\nM98 P5 Q2\n" + sub), "l7,0,0");
  EXPECT_EQ(mill("O1\nF10\nM98 P5 H2\n" + sub), "l7,0,0");
  EXPECT_EQ(mill("O1\nF10\nM98 P5 H2 L2\n" + sub), " | not-supported");
  EXPECT_EQ(mill("O1\nM198 P5\n" + sub), "l5,0,0 l7,0,0");
  EXPECT_EQ(codes(read_text("O1\nG1 X1. F1\nM198 P99\nM30\n", at_origin(Dialect::fanuc))),
            "subprogram-missing");
}

// G50 U W of a lathe shifts the coordinates by an increment.
TEST(ControlsDiffer, G50MayBeIncremental) {
  EXPECT_EQ(lathe("G0 X40. Z2.\nG50 U10. W-2.\nG1 X50. Z-5. F.1\n"), "r20,0,2 l20,0,-3");
}

// P0 of G10 L2 is the external offset, which is part of all others.
TEST(ControlsDiffer, TheExternalOffsetIsPartOfAll) {
  EXPECT_EQ(mill("G10 L2 P0 X0 Y0 Z0\nG54\nG1 X1. F10\n"), "l1,0,0");
  EXPECT_EQ(mill("G10 L2 P0 X5.\nG10 L2 P2 X10.\nG1 X1. F10\nG55 X1.\n"), "l6,0,0 l16,0,0");
}

TEST(ControlsDiffer, NoRepeatsAtAnotherPointAreAWarning) {
  EXPECT_EQ(mill("G0 Z9\nG81 X10. Z-1. R2. K0 F10\nG80\nG1 X1.\n"),
            "r0,0,9 l1,0,9 | cycle-not-run");
  EXPECT_EQ(mill("G0 Z9\nG81 Z-1. R2. K0 F10\nX5.\n"), "r0,0,9 r5,0,9 r5,0,2 l5,0,-1 r5,0,9");
}

TEST(ControlsDiffer, LathesGoHomeInYAndFeedInG95) {
  EXPECT_EQ(lathe("G95\nG0 X40. Z2.\nG1 Z-1. F.1\nG28 U0. V0. W0.\n"), "r20,0,2 l20,0,-1");
}

TEST(ControlsDiffer, RotationsInSpaceAndUnknownScalesAreRefused) {
  EXPECT_EQ(mill("G68 X0 Y0 Z0 I1. J0 K0 R30.\nG1 X10. F10\n"), "l10,0,0 | not-supported");
  EXPECT_EQ(mill("G68 X0 Y0 Z0 I0 J0 K-1. R30.\nG1 X10. F10\n"), "l10,0,0 | not-supported");
  EXPECT_EQ(mill("G68 X0 Y0 Z0 I0 J0 K1. R90.\nG1 X10. F10\n"), "l0,10,0");
  EXPECT_EQ(mill("G51 X0 Y0\nG1 X10. F10\n"), "l10,0,0 | value-missing");
}

// Mach names the centre A and B, and adds the angle to that in force where I stands beside it.
TEST(ControlsDiffer, G68OfMachTurnsAboutAAndB) {
  EXPECT_EQ(mill("G1 X7. Y7. F10\nG68 A10 B0 R90\nG1 X15 Y0\n"), "l7,7,0 l10,5,0");
  EXPECT_EQ(mill("G68 A0 B0 R30\nG68 A0 B0 I1 R60\nG1 X10 Y0 F10\n"), "l0,10,0");
  EXPECT_EQ(mill("G68 A10 R90\nG1 X15 Y0 F10\n"), "l15,0,0 | value-missing");
  EXPECT_EQ(mill("G18 G68 A10 B0 R90\nG17 G1 X15 Y0 F10\n"), "l15,0,0 | not-supported");
}

// In G91 the angle of G68 adds to the rotation in force.
TEST(ControlsDiffer, G68InG91TurnsOn) {
  EXPECT_EQ(mill("G68 X0 Y0 R30.\nG91 G68 X0 Y0 R60.\nG90 G1 X10. F10\n"), "l0,10,0");
  EXPECT_EQ(mill("G91 G68 X0 Y0 R90.\nG90 G1 X10. F10\n"), "l0,10,0");
}

// A cutter that turns by itself and works beside the axis leaves no body of revolution.
TEST(ControlsDiffer, LiveToolsOfLathesAreRefused) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools.front().type = ToolType::drill;
  EXPECT_EQ(codes(read_text("G0 X0 Z5.\nG1 Z-5. F.1\nG0 Z5.\n", options)), "");
  const Program p = read_text("G0 X30. Z5.\nG1 Z-5. F.1\nX40.\nG0 Z5.\n", options);
  EXPECT_EQ(codes(p), "live-tool");
  EXPECT_EQ(p.diagnostics.back().place.line, 2);
}

// FANUC reads D0 there, and nothing is offset; programs that leave it out mean the tool's radius.
TEST(ControlsDiffer, CompensationWithoutDIsSaid) {
  const auto found = [](Dialect dialect, MachineKind machine, CompRadius comp) {
    InterpOptions options = at_origin(dialect, machine);
    options.comp = comp;
    const bool turns = machine == MachineKind::lathe;
    return codes(read_text(turns ? "G1 G42 X0 Z-10 F1\nZ-20\nX10 Z-30\nG40 X20\n"
                                 : "G1 G42 X0 Y10 F100\nY20\nX10 Y30\nG40 X20\n",
                           options));
  };
  const auto mill = MachineKind::mill;
  EXPECT_EQ(found(Dialect::fanuc, mill, CompRadius::automatic), "register-missing");
  EXPECT_EQ(found(Dialect::fanuc, mill, CompRadius::radius), "");
  EXPECT_EQ(found(Dialect::fanuc, mill, CompRadius::off), "");
  EXPECT_EQ(found(Dialect::ngc, mill, CompRadius::automatic), "") << "that of the tool";
  EXPECT_EQ(found(Dialect::sinumerik, mill, CompRadius::automatic), "") << "D1";
  EXPECT_EQ(found(Dialect::fanuc, MachineKind::lathe, CompRadius::automatic), "") << "T0101";
}

// Mastercam's list of tools says what is in the registers.
TEST(ControlsDiffer, TheListOfToolsSaysWhatDIs) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.comp = CompRadius::automatic;
  const auto x = [&](const char* comp, const char* expected) {
    const Program p = read_text(std::string("( T1 | 10. FLAT ENDMILL | H1 | D1 | ") + comp +
                                    " COMP | TOOL DIA. - 10. )\nT1 M6\nG0 X0 Y0\n"
                                    "G1 G41 D1 X0 Y10 F100\nY20\nY30\nG40 X-20\n",
                                options);
    EXPECT_EQ(codes(p), expected);
    return p.motions[1].end.x;
  };
  EXPECT_NEAR(x("WEAR", ""), 0, 1e-9);
  EXPECT_NEAR(x("CONTROL", ""), -5, 1e-9);
  EXPECT_NEAR(x("TOOL", "register-missing"), -5, 1e-9);
}

// A finishing pass after a roughing one: the register is set again under the same number.
TEST(ControlsDiffer, ARegisterMaySetItsRadiusAgain) {
  const auto x = [](Dialect dialect, const std::string& set, const std::string& again) {
    const std::string pass = "G41 D1 G1 X10. Y0 F100\nY10.\nG40 X0\nG0 Y0\n";
    const Program p = read_text(set + "\n" + pass + again + "\n" + pass, at_origin(dialect));
    EXPECT_EQ(codes(p), "");
    return p.motions.size() == 8 ? std::pair{p.motions[1].end.x, p.motions[5].end.x}
                                 : std::pair{0.0, 0.0};
  };
  EXPECT_EQ(x(Dialect::fanuc, "G10 L12 P1 R5.", "G10 L12 P1 R3."), (std::pair{5.0, 7.0}));
  // Controls with one offset a number (memory A) write no L.
  EXPECT_EQ(x(Dialect::fanuc, "G10 P1 R5.", "G91 G10 P1 R-2.\nG90"), (std::pair{5.0, 7.0}));
  EXPECT_EQ(x(Dialect::sinumerik, "T1 M6\n$TC_DP1[1,1]=120 $TC_DP6[1,1]=5", "$TC_DP6[1,1]=3"),
            (std::pair{5.0, 7.0}));
}

// The radius of D1 is that of the tool: the wear is added to it, and the warning stays.
TEST(ControlsDiffer, AWearAloneIsAddedToTheToolsRadius) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.comp = CompRadius::automatic;
  const auto x = [&](const std::string& set, const std::string& expected) {
    const Program p = read_text(
        "(T1 10MM END MILL)\nT1 M6\n" + set + "\nG41 D1 G1 X0 Y10. F100\nY20.\nG40 X-20.\n",
        options);
    EXPECT_EQ(codes(p), expected) << set;
    return p.motions.empty() ? 0 : p.motions[0].end.x;
  };
  EXPECT_NEAR(x("G10 L13 P1 R0.2", "register-missing"), -5.2, 1e-9);
  EXPECT_NEAR(x("#12001=0.2\n#12001=#12001+0.1", "register-missing"), -5.3, 1e-9);
  EXPECT_NEAR(x("G10 L13 P1 R0.2\nG10 L12 P1 R4.", ""), -4.2, 1e-9);
  EXPECT_NEAR(x("#13001=4.5", ""), -4.5, 1e-9);
  EXPECT_NEAR(x("#13001=4.5\n#12001=0.1", ""), -4.6, 1e-9);
  options.comp = CompRadius::wear;
  EXPECT_NEAR(x("G10 L13 P1 R0.2", ""), -0.2, 1e-9);
}

// A settable frame that turns about Z: whole, or its part RT.
TEST(ControlsDiffer, SettableFramesMayTurnAboutZ) {
  const auto s = Dialect::sinumerik;
  EXPECT_EQ(mill("TRANS X9\n$P_PFRAME=CTRANS()\nG1 X5 Y0 F10\n", s), "l5,0,0");
  EXPECT_EQ(mill("$P_UIFR[1]=CTRANS(X,10,Y,5):CROT(Z,90)\nG54\nG1 X5 Y0 F10\n", s), "l10,10,0");
  EXPECT_EQ(mill("$P_UIFR[1,Z,RT]=90\n$P_UIFR[1,X,TR]=1\nG54\nG1 X5 Y0 F10\n"
                 "X=$P_UIFR[1,Z,RT]\nG500\nX=$P_IFRAME[X,TR]\n",
                 s),
            "l1,5,0 l1,90,0 l0,90,0");
  EXPECT_EQ(mill("$P_UIFR[1]=CROT(X,90)\n", s), " | variable-unset");
}

TEST(ControlsDiffer, ComputedScalesCountAsWritten) {
  EXPECT_EQ(mill("G51 X0 Y0 P[1500+500]\nG1 X5. F10\n"), "l10,0,0");
  EXPECT_EQ(mill("#1=2\nG51 X0 Y0 I#1 J#1\nG1 X5. F10\n"), "l10,0,0");
}

// Within a word ROUND of FANUC rounds to least increments, everywhere else to whole numbers.
TEST(ControlsDiffer, RoundInAWordRoundsToIncrementsOnFanuc) {
  EXPECT_EQ(mill("#1=3.2\nG1 X[ROUND[#1*1.1]] F10\n"), "l3.52,0,0");
  EXPECT_EQ(mill("R1=3.2\nG1 X=ROUND(R1*1.1) F10\n", Dialect::sinumerik), "l4,0,0");
  EXPECT_EQ(mill("#1=3.2\nG1 X[ROUND[#1*1.1]] F10\n", Dialect::ngc), "l4,0,0");
  EXPECT_EQ(mill("(P1=3.2)\nG1 X(ROUND(P1*1.1)) F10\n", Dialect::iso), "l4,0,0");
}

// The programmable frame is in the units of the program. Settable ones and data of tools follow
// G700 alone; under G70 they stay mm.
TEST(ControlsDiffer, SettableFramesAndToolsFollowG700Alone) {
  const auto s = Dialect::sinumerik;
  EXPECT_EQ(mill("G70\n$P_PFRAME=CTRANS(X,1)\nG1 X0 Y0 F10\n", s), "l25.4,0,0");
  EXPECT_EQ(mill("G70\n$P_PFRAME=$P_PFRAME:CTRANS(X,1):CROT(Z,90)\nG1 X1 Y0 F10\n"
                 "$P_PFRAME=$P_PFRAME:CTRANS(X,1)\nX1 Y0\n",
                 s),
            "l25.4,25.4,0 l25.4,50.8,0");
  EXPECT_EQ(mill("G70\n$P_UIFR[1]=CTRANS(X,25.4)\nG54\nG1 X1 Y0 F10\n", s), "l50.8,0,0");
  EXPECT_EQ(mill("G700\n$P_UIFR[1]=CTRANS(X,1)\nG54\nG1 X1 Y0 F10\nX=3*$P_UIFR[1,X,TR]\n", s),
            "l50.8,0,0 l101.6,0,0");
  EXPECT_EQ(mill("G70\n$P_UIFR[1,X,TR]=25.4\nG54\nG1 X1 Y0 F10\n", s), "l50.8,0,0");
  EXPECT_EQ(mill("G700\nG71\n$P_UIFR[1]=CTRANS(X,1)\nG54\nG1 X1 Y0 F10\n", s), "l2,0,0");
  EXPECT_EQ(read_text("G700\nG71\nG1 X1 Y0 F10\n", at_origin(s)).motions.back().feed, 10);
  const std::string tool = "T1 D1 M6\n$TC_DP6[1,1]=", path = "\nG41 G1 X10 Y0 F100\nY1\n";
  EXPECT_EQ(mill("G70\n" + tool + "5.08" + path, s), "l248.9,0,0 l248.9,25.4,0");
  EXPECT_EQ(mill("G700\n" + tool + "0.2" + path, s), "l248.9,0,0 l248.9,25.4,0");
}

TEST(ControlsDiffer, OnePartOfASinumerikFrameCanBeSetAndRead) {
  EXPECT_EQ(mill("$P_PFRAME[X,TR]=5\nX1 F10\n$P_UIFR[2,Y,TR]=7\nTRANS\nG55 "
                 "Y=$P_UIFR[2,Y,TR]\n",
                 Dialect::sinumerik),
            "l6,0,0 l6,14,0");
}

// The tip of a boring bar lies towards +X: a cylinder is cut at the programmed diameter.
TEST(ControlsDiffer, CompensationOfABoringBarHasItsTipOutside) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools.front().type = ToolType::boring;
  options.table.tools.front().nose_radius = 0.4;
  const Program p = read_text(
      "G0 X30. Z5.\nG41 X40. Z2.\nG1 Z0 F.1\nX36. Z-2.\nZ-20.\nX24.\nG40 G0 X20.\n", options);
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 7U);
  const double chamfer = 0.4 * (std::sqrt(2.0) - 1);  // where the nose leaves an edge of 45 degrees
  expect_near(p.motions[2].end, {20, 0, -0.4 + chamfer});
  expect_near(p.motions[3].end, {18, 0, -2.4 + chamfer});
  expect_near(p.motions[4].end, {18, 0, -20});
}

// Okuma: G15 H chooses the work offset, for one block G16 H; behind it G56 H is the length along Z,
// which G53 ends. Without a G15 H the words are FANUC's.
TEST(ControlsDiffer, OkumaChoosesOffsetsByG15AndLengthsByG56) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.table.work.push_back({"G15 H2", {100, 0, 0}});
  options.table.offsets.push_back({});
  options.table.offsets.back().name = "H3";
  options.table.offsets.back().length = 7;
  EXPECT_EQ(path_text(read_text("G15 H2\nG1 X1. F10\nG56 H3 Z5.\nG53 Z5.\n", options)),
            "l101,0,0 l101,0,12 l101,0,5");
  EXPECT_EQ(mill("G15 H1\nG1 X1. F10\n"), "l1,0,0");
  EXPECT_EQ(mill("G15 H0\n"), " | value-range");
  EXPECT_EQ(mill("G16 H1\nG1 X1. F10\n"), "l1,0,0 | not-supported");
  EXPECT_EQ(mill("G56 H1 Z5.\nG1 X1. F10\n"), "l1,0,0 | not-supported");
  EXPECT_EQ(mill("G43 G54 H0 Z5.\nG1 X1. F10\n"), "r0,0,5 l1,0,5");
}

// Fagor: Z is the plane of reference, I the depth; G83 makes J strokes of I.
TEST(ControlsDiffer, FagorsCyclesHaveTheirDepthInI) {
  EXPECT_EQ(mill("G0 Z20\nG81 G98 X10 Y0 Z2 I-15 K50 F100\nX20\nG80\n", Dialect::iso),
            "r0,0,20 r10,0,20 r10,0,2 l10,0,-15 r10,0,20 r20,0,20 r20,0,2 l20,0,-15 r20,0,20");
  EXPECT_EQ(mill("G0 Z20\nG91 G81 G99 X10 Y0 Z-18 I-5 F100\nG80\n", Dialect::iso),
            "r0,0,20 r10,0,20 r10,0,2 l10,0,-3 r10,0,2");
  EXPECT_EQ(mill("G0 Z20\nG83 G99 X10 Y0 Z2 I-4 J3 F100\nG80\n", Dialect::iso),
            "r0,0,20 r10,0,20 r10,0,2 l10,0,-2 r10,0,2 r10,0,-1.746 l10,0,-6 r10,0,2 r10,0,-5.746 "
            "l10,0,-10 r10,0,2");
  EXPECT_EQ(mill("G1 X5 F100\nG9 X20 Y0 I10 J5\n", Dialect::iso), "l5,0,0 a20,0,0");
  EXPECT_EQ(mill("G0 Z5\nG81 Z2 I-1 F9\nG91 X10 N2\n", Dialect::iso),
            "r0,0,5 r0,0,2 l0,0,-1 r0,0,5 r10,0,5 r10,0,2 l10,0,-1 r10,0,5 r20,0,5 r20,0,2 "
            "l20,0,-1 r20,0,5");
  for (const char* call : {"G20 N1.2", "G25 N10", "G22 N1"})
    EXPECT_EQ(mill("G1 X5 F9\nN3 " + std::string(call) + "\nX6\n", Dialect::iso),
              "l5,0,0 l6,0,0 | not-supported")
        << call;
  EXPECT_EQ(mill("N1 G21 G1 X5 F9\nN2 G20\n", Dialect::iso), "l5,0,0");
}

// What stands in a mode that is not read has the meaning of that mode: no second error, no move.
TEST(ControlsDiffer, ARefusedModeIsToldOnce) {
  EXPECT_EQ(mill("G12.1\nG1 X20. C20. F9\nC30.\nG13.1\nG1 X5.\n"), "l5,0,0 | not-supported");
  EXPECT_EQ(lathe("G12.1\nG1 X20. C20. F9\nG13.1\nG1 X6.\n"), "l3,0,0 | not-supported");
  EXPECT_EQ(lathe("G107 C20.\nG1 Z-10. C30. F9\nG107 C0\nG1 X6.\n"), "l3,0,0 | not-supported");
  EXPECT_EQ(mill("G68.2 X0 Y0 Z0 I0 J30. K0\nG53.1\nG1 X9. B30. F9\nG69\nG1 X5.\n"),
            "l5,0,0 | not-supported");
  EXPECT_EQ(mill("G43.4 H1\nG1 X20. A3. F9\nX30.\nG49\nG1 X5.\n"), "l5,0,0 | not-supported");
  EXPECT_EQ(mill("G43.5 H1 Z5.\nG1 X20. I1. F9\nG49\nG1 X5.\n"), "l5,0,0 | not-supported");
  EXPECT_EQ(mill("G1 X20. C20. F9\n"), " | not-supported");
}

// Posts for five axes write such modes around every cut.
TEST(ControlsDiffer, AToolAlongZNeedsNoRotaryAxes) {
  const std::string cut = "G0 X1. Y2. Z9. A0 C0.\nG1 Z-1. F100\nX5.\n";
  for (const char* mode : {"G43.4", "G234", "G143"})
    EXPECT_EQ(mill(mode + (" H1\n" + cut) + "G49\n"), mill("G43 H1\n" + cut + "G49\n")) << mode;
  EXPECT_EQ(mill("G54 B0 C0\nG254\n" + cut + "G255\n"), mill(cut));
  EXPECT_EQ(mill("G254\n" + cut + "G255\nB90.\nG254\nX9.\nG255\n"),
            mill(cut) + " | not-supported not-supported");
  EXPECT_EQ(mill("G254\n" + cut + "B90.\nX9.\nG255\nG1 X6.\n"),
            mill(cut + "X6.\n") + " | not-supported");
  const auto notes = [](const std::string& text, MachineKind machine) {
    return codes(read_text(text, at_origin(Dialect::fanuc, machine)), Severity::note);
  };
  EXPECT_NE(notes("G254\n" + cut, MachineKind::mill).find("tool-upright"), std::string::npos);
  EXPECT_NE(notes("G43.4 H1\nG1 X1. F9\n", MachineKind::lathe).find("not-supported"),
            std::string::npos);
}

TEST(ControlsDiffer, AnAxisThatIsNotReadIsCalledWhatItIs) {
  const auto told = [](const char* text, MachineKind machine) {
    const Program p = read_text(text, at_origin(Dialect::fanuc, machine));
    return p.diagnostics.empty() ? "" : p.diagnostics.front().text;
  };
  EXPECT_NE(told("G0 B-300.\n", MachineKind::lathe).find("sub-spindle"), std::string::npos);
  EXPECT_NE(told("G0 C90.\n", MachineKind::lathe).find("turns the spindle"), std::string::npos);
  EXPECT_NE(told("G0 B90.\n", MachineKind::mill).find("B is a rotary axis"), std::string::npos);
}

// Cuts whose start is unknown are not simulated: that is told.
TEST(ControlsDiffer, CutsFromAnUnknownPlaceAreAWarning) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.start.reset();
  const auto run = [&](const char* text) { return codes(read_text(text, options)); };
  EXPECT_EQ(run("G0 X0 Y0\nG1 X1 F9\nX2\n"), "start-unknown");
  EXPECT_EQ(run("G1 X0 Y0 F9\nG1 Z5\nX5\nG28 Z9\nG1 X0 Y0\nZ5\nX3\n"), "");
  EXPECT_EQ(run("G0 X0 Y0 Z5\nG28 Z9\nG1 X5 F9\nX9\n"), "start-unknown");
}

}  // namespace
}  // namespace mrsim
