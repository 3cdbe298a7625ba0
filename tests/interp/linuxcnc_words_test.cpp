// Words of LinuxCNC beside its motions, as its manual says them.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

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

// Mach's G31 holds for its block, as FANUC's does.
TEST(LinuxCncWords, ProbingByG31OfMachIsNotRun) {
  const Program p =
      read_text("G0 X0 Y0 Z10\nG31 Z-10 F50\nG92 Z1.5\nG0 Z5\nG31 Z-1\nX3 Z5\nG1 Z-1 F9\nM2\n",
                at_origin(Dialect::ngc));
  EXPECT_EQ(path_text(p), "r0,0,10 r0,0,5 r3,0,5 l3,0,-1");
  EXPECT_EQ(codes(p, Severity::note), "word-of-mach probe");
  EXPECT_EQ(path_of_words("G31 F50\nM2\n"), " | motion-missing");
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

// G4 is of another group than G1: the block dwells, and moves.
TEST(LinuxCncWords, ADwellBesideAMoveMoves) {
  const Program p = run_words("G1 F50 X3 G4 P0.1\nG4 P1\nX4\nM2\n");
  EXPECT_EQ(path_text(p), "l3,0,0 l4,0,0");
  EXPECT_EQ(p.motions[0].feed, 50);
  EXPECT_EQ(path_of_words("G1 F50 X3\nG4 X2\nM2\n"), "l3,0,0 | dwell-unit");
  EXPECT_EQ(path_of_words("G1 F50 X3\nG4 S2\nM2\n"), "l3,0,0 | dwell-unit") << "Marlin";
  EXPECT_EQ(path_of_words("G1 F50 X3\nG4 S2 M3\nM2\n"), "l3,0,0 | value-missing");
}

// Twelve holes of the manual: four to the right, three up, three to the left, two down.
TEST(LinuxCncWords, TheHolesOfTheManualsSquareAreDrilled) {
  const Program p = run_words(
      "N1000 G90 G0 X0 Y0 Z0\nN1010 G1 F50 X0 G4 P0.1\nN1020 G91 G81 X1 Y0 Z-0.5 R1 L4\n"
      "N1030 X0 Y1 R0 L3\nN1040 X-1 Y0 L3\nN1050 X0 Y-1 L2\nN1060 G80\nN1070 G90 G0 X0\n"
      "N1080 Y0\nN1090 Z0\nN1100 M2\n");
  EXPECT_EQ(codes(p), "");
  std::string holes;
  for (const Motion& m : p.motions)
    if (m.kind == MotionKind::line) holes += fmt::format("{:g},{:g} ", m.end.x, m.end.y);
  EXPECT_EQ(holes, "1,0 2,0 3,0 4,0 4,1 4,2 4,3 3,3 2,3 1,3 1,2 1,1 ");
  expect_near(p.motions.back().end, {0, 0, 0});
}

TEST(LinuxCncWords, AnotherCycleNeedsItsOwnDepthAndStroke) {
  const std::string first = "F50 S100 M3\nG0 Z5\nG99 G83 X1 Z-2 R1 Q3\n";
  const std::string drilled = "r0,0,5 r1,0,5 r1,0,1 l1,0,-2 r1,0,1";
  EXPECT_EQ(path_of_words(first + "X2\nM2\n"), drilled + " r2,0,1 l2,0,-2 r2,0,1");
  EXPECT_EQ(path_of_words(first + "G81 X2\nM2\n"), drilled + " | value-missing");
  EXPECT_EQ(path_of_words(first + "G73 X2 Z-2\nM2\n"), drilled + " | value-missing");
  EXPECT_EQ(path_of_words(first + "G82 X2 Z-2\nM2\n"),
            drilled + " r2,0,1 l2,0,-2 r2,0,1 | dwell-missing");
  EXPECT_EQ(path_of_words(first + "G82 X2 Z-2 P1\nX3\nM2\n"),
            drilled + " r2,0,1 l2,0,-2 r2,0,1 r3,0,1 l3,0,-2 r3,0,1");
}

TEST(LinuxCncWords, LathesThatSayNeitherG7NorG8AreToldOf) {
  const auto notes = [](const std::string& text) {
    const Program p =
        read_text(text + "G1 X20 Z-5 F1\nX30\nM2\n", at_origin(Dialect::ngc, MachineKind::lathe));
    return path_text(p) + " " + codes(p, Severity::note);
  };
  EXPECT_EQ(notes("G18\n"), "l20,0,-5 l30,0,-5 radius-assumed");
  EXPECT_EQ(notes("G18 G8\n"), "l20,0,-5 l30,0,-5 ");
  EXPECT_EQ(notes("G18 G7\n"), "l10,0,-5 l15,0,-5 ");
  const Program iso =
      read_text("G18\nG1 X20 Z-5 F1\nM2\n", at_origin(Dialect::iso, MachineKind::lathe));
  EXPECT_EQ(path_text(iso) + " " + codes(iso, Severity::note), "l10,0,-5 diameter-assumed");
}

// "When G7 is in force the values for I, J and K are diameter measurements."
TEST(LinuxCncWords, G76TakesIJKAsDiametersInG7) {
  const auto thread = [](const char* words) {
    return path_text(read_text(std::string("G18 S400 M3\n") + words + "\nM2\n",
                               at_origin(Dialect::ngc, MachineKind::lathe)));
  };
  const std::string radii = thread("G8\nG0 X20 Z5\nG76 P2 Z-30 I-5 J1 K2 E3 L2");
  EXPECT_EQ(radii.substr(0, 54), "r20,0,5 r21,0,5 r14,0,5 l14,0,-27 l16,0,-30 r21,0,-30 ");
  EXPECT_EQ(thread("G7\nG0 X40 Z5\nG76 P2 Z-30 I-10 J2 K4 E3 L2"), radii);
}

// The tapered start of a thread begins with a feed to the crest.
TEST(LinuxCncWords, G76FeedsToATaperedStart) {
  const auto thread = [](const char* words) {
    return path_text(read_text(std::string("G18 G8 S400 M3\nG0 X20 Z0\n") + words + "\nM2\n",
                               at_origin(Dialect::ngc, MachineKind::lathe)));
  };
  EXPECT_EQ(thread("G76 P2 Z-11 I-3 J1 K1.3 E1 L1").substr(0, 68),
            "r20,0,0 r20.3,0,0 l17.3,0,0 l16,0,-1 l16,0,-11 r20.3,0,-11 r20,0,0 l");
  EXPECT_EQ(thread("G76 P2 Z-11 I-3 J1 K1.3").substr(0, 41),
            "r20,0,0 r20.3,0,0 r16,0,0 l16,0,-11 r20.3");
}

TEST(LinuxCncWords, G52OfALatheIsADiameterInG7) {
  const auto x = [](const char* words) {
    return path_text(read_text(std::string(words) + "\nG1 X30 F1\nM2\n",
                               at_origin(Dialect::ngc, MachineKind::lathe)));
  };
  EXPECT_EQ(x("G18 G7\nG52 X2"), "l16,0,0");
  EXPECT_EQ(x("G18 G8\nG52 X2"), "l32,0,0");
}

// A motion of its own beside G43.1 would share its axes with the lengths: its manual forbids it.
TEST(LinuxCncWords, AMotionBesideG431IsRefused) {
  EXPECT_EQ(path_of_words("F9\nG1 X1\nG43.1 Z5\nX2\nM2\n"), "l1,0,0 l2,0,0");
  EXPECT_EQ(path_of_words("F9\nG1 X1\nG43.1 G1 Z5\nX2\nM2\n"), "l1,0,0 l2,0,0 | word-unexpected");
  EXPECT_EQ(path_of_words("F9\nG1 X1\nG43.1 Z5\nX2 H3\nM2\n"), "l1,0,0 l2,0,0");
}

TEST(LinuxCncWords, AxesBesideG80AreRefused) {
  EXPECT_EQ(path_of_words("G1 X1 F1\nG80 X2\nM2\n"), "l1,0,0 | motion-missing");
  EXPECT_EQ(path_of_words("G1 X1 F1\nG80 G0 X2\nG80 G92 X0\nG1 X1\nM2\n"), "l1,0,0 r2,0,0 l3,0,0");
}

// Its interpreter keeps the numbers of R and Z, not the levels: in G91 they are increments.
TEST(LinuxCncWords, KeptWordsOfACycleAreReadAnewInG91) {
  EXPECT_EQ(path_of_words("F50\nG98 G0 Z10\nG81 X1 Z-5 R2\nG91 X1\nG90 X5\nM2\n"),
            "r0,0,10 r1,0,10 r1,0,2 l1,0,-5 r1,0,10 r1,0,12 r2,0,12 l2,0,7 r2,0,12 r5,0,12 r5,0,2 "
            "l5,0,-5 r5,0,10");
  EXPECT_EQ(path_of_words("F50\nG98 G0 Z10\nG91 G81 X1 Z-5 R-2\nG90 X5 Z-3 R1\nM2\n"),
            "r0,0,10 r1,0,10 r1,0,8 l1,0,3 r1,0,10 r5,0,10 r5,0,1 l5,0,-3 r5,0,10");
}

TEST(LinuxCncWords, NumbersHaveNoExponents) {
  const Program p = read_text("#1=[1e9]\nM2\n", at_origin(Dialect::ngc));
  ASSERT_FALSE(p.diagnostics.empty());
  EXPECT_EQ(p.diagnostics[0].code, "number-malformed");
  EXPECT_NE(p.diagnostics[0].text.find("exponent"), std::string::npos);
  for (const char* text : {"X-1.42e-14", "X1.5E+01", "X1.5E2", "G1 Y2e-7 F9"})
    EXPECT_EQ(path_of_words(std::string("F9\nG1 ") + text + "\nM2\n"), " | number-malformed")
        << text;
  EXPECT_EQ(path_of_words("M68 E0 Q1\nM68E2Q1\nG1 X1 F9\nM2\n"), "l1,0,0");
}

// A work offset of Fadal is E1, never E+01.
TEST(LinuxCncWords, FanucsNumbersHaveNoExponentsEither) {
  const auto fanuc = [](const std::string& text) {
    return path_text(read_text("F9\nG1 " + text + "\n", at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(fanuc("X-1.42e-14"), " | number-malformed");
  EXPECT_EQ(fanuc("X1.5E+01"), " | number-malformed");
  EXPECT_EQ(fanuc("Y3.\nG0X2.E1"), "l0,3,0 r2,3,0");
}

// G61, G64 and G92.1 to G92.3 have no axes of their own: those beside them belong to the motion.
TEST(LinuxCncWords, AxesBesideWordsThatHaveNoneMove) {
  EXPECT_EQ(path_of_words("F9\nG0 G64 Z5\nG64 P0.02 Q0.01 X3\nG61 Y4\nG1 G64 P0.01 X9\nM2\n"),
            "r0,0,5 r3,0,5 r3,4,5 l9,4,5");
  EXPECT_EQ(path_of_words("F9\nG61 G2 Y2 R1\nG64 G3 Y4 R1\nM2\n"), "a0,2,0 a0,4,0");
  EXPECT_EQ(path_of_words("F9\nG92 X5\nG1 X6\nG92.2 X7\nG92.3 X8\nG92.1 G0 X9\nM2\n"),
            "l1,0,0 l7,0,0 l3,0,0 r9,0,0");
  EXPECT_EQ(path_of_words("F9\nG81 G92.1 X1 Z-1 R1\nG0 X3\nM2\n"),
            "r0,0,1 r1,0,1 l1,0,-1 r1,0,1 r3,0,1");
}

// The machine cuts deeper, and here all passes are at one depth.
TEST(LinuxCncWords, ALengthMustNotChangeBetweenCuts) {
  const auto told = [](const std::string& first, const std::string& second) {
    const std::string cut = "G1 Z0 F9\nG0 Z9\n";
    return codes(read_text("T1 M6\n" + first + cut + second + cut, at_origin(Dialect::ngc)));
  };
  EXPECT_EQ(told("G43.1 Z100\n", "G43.1 Z98\n"), "not-supported");
  EXPECT_EQ(told("G43.1 Z100\n", "G43.1 Z100\n"), "");
  EXPECT_EQ(told("G43.1 Z100\n", "T2 M6\nG43.1 Z98\n"), "");
  EXPECT_EQ(told("G43 H1\n", "G10 L1 P1 Z98\nG43 H1\n"), "not-supported");
  EXPECT_EQ(told("G43\n", "G10 L1 P1 Z98\nG43\n"), "not-supported") << "of the tool in the spindle";
  EXPECT_EQ(told("G10 L1 P1 Z98\nG43 H1\n", "G43.1 Z97\n"), "not-supported");
  EXPECT_EQ(told("G43 H1\n", "G10 L1 P1 Z98\n"), "") << "no G43 behind it";
  EXPECT_EQ(told("G10 L1 P1 Z98\nG43 H1\n", "G10 L1 P1 Z98\nG43 H1\n"), "");
}

// D names a tool of the table; without it, or D0, the tool in the spindle counts. It is not kept.
TEST(LinuxCncWords, DIsTheNumberOfATool) {
  InterpOptions options = at_origin(Dialect::ngc);
  options.table.tools.clear();
  for (const int n : {2, 6}) {
    Tool tool;
    tool.id = std::to_string(n);
    tool.diameter = n;
    tool.origin = "test";
    options.table.tools.push_back(tool);
  }
  const auto run = [&](const std::string& text) {
    return path_text(read_text("F9\nT6 M6\n" + text + "M2\n", options));
  };
  EXPECT_EQ(run("G41 D2 G1 X10\nX30\n"), "l10,1,0 l30,1,0");
  EXPECT_EQ(run("G41 D2 G1 X10\nX30\nG40 X40\nG41 X50\nX60\n"),
            "l10,1,0 l30,1,0 l40,0,0 l50,3,0 l60,3,0");
  EXPECT_EQ(run("G41 D0 G1 X10\nX30\n"), "l10,3,0 l30,3,0");
  EXPECT_EQ(run("G10 L1 P2 R4\nG41 D2 G1 X10\nX30\n"), "l10,4,0 l30,4,0");
  EXPECT_EQ(run("G10 L1 P6 R4\nG41 G1 X10\nX30\n"), "l10,4,0 l30,4,0");
}

// Until G98 or G99 is said the tool returns to R.
TEST(LinuxCncWords, CyclesReturnToRFirst) {
  const Program p = run_words("F9\nG0 Z10\nG81 X1 Z-2 R3\nX2\nM2\n");
  EXPECT_EQ(path_text(p), "r0,0,10 r1,0,10 r1,0,3 l1,0,-2 r1,0,3 r2,0,3 l2,0,-2 r2,0,3");
  EXPECT_EQ(codes(p, Severity::note), "cycle-level");
  EXPECT_EQ(codes(run_words("F9\nG0 Z10\nG99 G81 X1 Z-2 R3\nM2\n"), Severity::note), "");
}

// From R or below it goes aside to R, slanted; in G98 to the level before the first hole. From
// above R it goes aside level. Under an R above that level it goes up or down to R first.
TEST(LinuxCncWords, AHoleIsApproachedAtItsLevel) {
  const std::string first = "F9\nG0 Z10\nG99 G81 X1 Z-2 R3\n";
  const std::string hole = "r0,0,10 r1,0,10 r1,0,3 l1,0,-2 r1,0,3 ";
  EXPECT_EQ(path_of_words(first + "X2 R5\nM2\n"), hole + "r2,0,5 l2,0,-2 r2,0,5");
  EXPECT_EQ(path_of_words(first + "G98 X2\nM2\n"), hole + "r2,0,10 r2,0,3 l2,0,-2 r2,0,10");
  EXPECT_EQ(path_of_words(first + "X2 R12\nM2\n"), hole + "r1,0,12 r2,0,12 l2,0,-2 r2,0,12");
  EXPECT_EQ(path_of_words(first + "G98 X2 R2\nM2\n"), hole + "r2,0,3 r2,0,2 l2,0,-2 r2,0,10");
  EXPECT_EQ(path_of_words("F9\nG0 Z1\nG99 G81 X1 Z-2 R3\nX2 R2\nM2\n"),
            "r0,0,1 r0,0,3 r1,0,3 l1,0,-2 r1,0,3 r1,0,2 r2,0,2 l2,0,-2 r2,0,2");
}

TEST(LinuxCncWords, G89FeedsOnToTheLevelOfG98) {
  EXPECT_EQ(path_of_words("F9\nG0 Z5\nG98 G89 Z-1 R4 P1\nM2\n"), "r0,0,5 r0,0,4 l0,0,-1 l0,0,5");
  EXPECT_EQ(path_of_words("F9\nG0 Z5\nG98 G85 Z-1 R4\nM2\n"),
            "r0,0,5 r0,0,4 l0,0,-1 l0,0,4 r0,0,5");
}

TEST(LinuxCncWords, PolarWordsGivePlacesOfHoles) {
  EXPECT_EQ(path_of_words("F9\nG81 X3 Y4 Z-2 R1\n^90\n@2\nM2\n"),
            "r0,0,1 r3,4,1 l3,4,-2 r3,4,1 r0,5,1 l0,5,-2 r0,5,1 r0,2,1 l0,2,-2 r0,2,1");
  EXPECT_EQ(path_of_words("G1 F9 @-5 ^0\nM2\n"), "l-5,0,0");
  for (const char* text : {"G1 F9 @5", "G91 G1 F9 @5 ^20", "G91 G1 F9 ^20"})
    EXPECT_EQ(path_of_words(std::string(text) + "\nM2\n"), " | value-missing") << text;
  EXPECT_EQ(path_of_words("G18 G1 F9 @5 ^0\nM2\n"), " | polar-mixed");
}

// Numbers of work offsets count from the next word on that chooses another one, or G10.
TEST(LinuxCncWords, NumbersOfWorkOffsetsWaitForTheirWord) {
  EXPECT_EQ(path_of_words("#5221=5\nG1 F9 X1\nG54 X2\nG55\nG54 X3\nM2\n"), "l1,0,0 l2,0,0 l8,0,0");
  EXPECT_EQ(path_of_words("#5221=5\nG10 L2 P2 X9\nG1 F9 X1\nG10 L2 P1 Y1\nG1 F9 X1\nM2\n"),
            "l1,0,0 l6,0,0");
  EXPECT_EQ(path_of_words("#5250=90\nG55\nG1 F9 X1\nX[#5250]\nM2\n"), "l0,1,0 l0,90,0");
}

// G52 and G92 are one shift.
TEST(LinuxCncWords, G52IsTheShiftOfG92) {
  EXPECT_EQ(path_of_words("G52 X3\nG1 F9 X1\nG92.2 X1\nG92.3 X2\nG92.1 X3\nM2\n"),
            "l4,0,0 l1,0,0 l5,0,0 l3,0,0");
  EXPECT_EQ(path_of_words("G92 X5\nG52 X3\nG1 F9 X1\nG92.3 X2\nM2\n"), "l4,0,0 l5,0,0");
}

TEST(LinuxCncWords, G281AndG301StoreAPlace) {
  EXPECT_EQ(path_of_words("G1 F9 X4 Y5\nG28.1\nX1 Y2 Z3\nG28 Z7\nG28\nM2\n"),
            "l4,5,0 l1,2,3 r1,2,7 r1,2,0 r4,5,0");
  EXPECT_EQ(path_of_words("G1 F9 X4\nG30.1 X5\nG30\nM2\n"), "l4,0,0 l5,0,0 r4,0,0");
}

TEST(LinuxCncWords, ACentreInG901NeedsBothCoordinates) {
  EXPECT_EQ(path_of_words("F9\nG90.1\nG3 X0 Y4 I0 J2\nM2\n"), "a0,4,0");
  EXPECT_EQ(path_of_words("F9\nG90.1\nG3 X0 Y4 J2\nM2\n"), " | arc-no-center");
}

TEST(LinuxCncWords, CallLevelCountsSubprograms) {
  EXPECT_EQ(path_of_words("o1 sub\nG1 F9 X#<_call_level>\no1 endsub\no2 sub\no1 call\no2 endsub\n"
                          "o2 call\no1 call\nG1 F9 X#<_call_level>\nM2\n"),
            "l2,0,0 l1,0,0 l0,0,0");
}

// D of G41.1 is a diameter each time, whatever register was in force before.
TEST(LinuxCncWords, G411TakesItsOwnDiameterBehindG41) {
  const std::string first = "G41 D1 G1 X-20 F100\nX-40\nG40 X-60\n";
  EXPECT_EQ(path_of_words(first + "G41.1 D4 X-80\nX-90\nM2\n"),
            "l-20,-5,0 l-40,-5,0 l-60,0,0 l-80,-2,0 l-90,-2,0");
  EXPECT_EQ(path_of_words("G41.1 D4 G1 X-20 F100\nX-40\nG40 X-60\nG41 D1 X-80\nX-90\nM2\n"),
            "l-20,-2,0 l-40,-2,0 l-60,0,0 l-80,-5,0 l-90,-5,0");
}

// Boards of printers switch their motors on by M17, which is no end of the program.
TEST(LinuxCncWords, M17EndsNothing) {
  EXPECT_EQ(path_text(read_text("M17\nG1 X1 F9\nM2\n", at_origin(Dialect::ngc))), "l1,0,0");
  EXPECT_EQ(path_text(read_text("M17\nG1 X1 F9\nM2\n", at_origin(Dialect::iso))), "l1,0,0");
  EXPECT_EQ(path_text(read_text("G1 X1 F9\nM17\nG1 X2\n", at_origin(Dialect::sinumerik))),
            "l1,0,0");
}

// G10 L10 and G43.2 make another length, too; G49 none.
TEST(LinuxCncWords, TouchingOffMustNotChangeALengthBetweenCuts) {
  const auto told = [](const std::string& first, const std::string& second) {
    const std::string cut = "G1 Z0 F9\nG0 Z9\n";
    return codes(read_text("T1 M6\nG0 Z9\n" + first + cut + second + cut, at_origin(Dialect::ngc)));
  };
  for (const char* const l : {"L10", "L11"}) {
    EXPECT_EQ(told("G43\n", fmt::format("G10 {} P1 Z5\nG43\n", l)), "not-supported");
    EXPECT_EQ(told(fmt::format("G10 {} P1 Z5\nG43\n", l), ""), "");
    EXPECT_EQ(told("G43\n", fmt::format("G10 {} P2 Z5\nG43\n", l)), "") << "another tool";
  }
  EXPECT_EQ(told("G43\n", "G43.2 H2\n"), "not-supported");
  EXPECT_EQ(told("G43\nG43.2 H2\n", "G43.2 H2\n"), "not-supported") << "added once more";
  EXPECT_EQ(told("G43\nG43.2 Z1\n", ""), "") << "Z is no place";
  EXPECT_EQ(told("G43 H1\n", "G49\n"), "not-supported");
  InterpOptions listed = at_origin(Dialect::ngc);
  listed.table.offsets.push_back({"H1", 0, 0, 20});
  EXPECT_EQ(codes(read_text("T1 M6\nG0 Z9\nG43\nG1 Z0 F9\nG0 Z9\nG49\nG1 Z0\n", listed)), "")
      << "the table tells the length of the tool";
}

// Its interpreter says "Unexpected character after O-word", whatever the condition says.
TEST(LinuxCncWords, WordsBehindAnOWordAreRefused) {
  const auto told = [](const std::string& text) {
    return path_of_words("F9\n#1=0\n" + text + "G1 Y9\nM2\n");
  };
  EXPECT_EQ(told("O1 if [1] G1 X5\nG1 Y1\nO1 endif\n"), " | statement");
  EXPECT_EQ(told("O1 if [0] THEN\nG1 Y1\nO1 endif\n"), " | statement");
  EXPECT_EQ(told("O1 if [0]\nG1 Y1\nO1 else #1=5\nO1 endif\n"), " | statement");
  EXPECT_EQ(told("O1 if [1]\nG1 Y1\nO1 endif #1=5\n"), "l0,1,0 | statement");
  EXPECT_EQ(told("O1 repeat [2] G1 X5\nG91 G1 Y1\nO1 endrepeat\n"), " | statement");
  EXPECT_EQ(told("O1 while [#1 LT 2]\nG1 Y1\nO1 endwhile #1=9\n"), "l0,1,0 | statement");
  EXPECT_EQ(told("O1 while [#1 LT 2] do\n#1=9\nO1 endwhile\n"), " | statement");
  EXPECT_EQ(told("O1 do\nG1 Y1\nO1 break #1=5\nO1 while [1]\n"), "l0,1,0 | statement");
  EXPECT_EQ(told("O1 if [1] (open\nG1 Y1\nO1 endif\n"), " | comment-unterminated");
  EXPECT_EQ(told("O1 if [1] (YES) ; so\nG1 Y1\nO1 endif (END)\n"), "l0,1,0 l0,9,0");
  EXPECT_EQ(told("O1 do ; so\nG1 Y1\nO1 while [0] (so)\n"), "l0,1,0 l0,9,0");
}

}  // namespace
}  // namespace mrsim
