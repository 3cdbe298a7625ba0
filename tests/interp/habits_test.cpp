// What posts and hands write beside the words that move: numbers behind a colon, calls by
// name, taps by many names, offsets of the machine.
#include "interp/recognise/recognise.h"
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

const InterpOptions kFanuc = at_origin(Dialect::fanuc);

std::string milled_path(const std::string& text) { return path_text(read_text(text, kFanuc)); }

std::string notes(const std::string& text) {
  return codes(read_text(text, kFanuc), Severity::note);
}

// ":30 T1 M6" of NX is a block that can be started from; ":7" alone is a program.
TEST(Habits, AColonBeforeWordsNumbersABlock) {
  EXPECT_EQ(milled_path("%\nN10 G1 X1. F1\n:0020 T1 M6\nN30 X2.\n:40 T1 M6\nX3.\nM30\n"),
            "l1,0,0 l2,0,0 l3,0,0");
  EXPECT_EQ(milled_path(":1(PART)\nG1 X1. F1\nM98 P7\nM30\n:7 (SUB)\nX5.\nM99\n"), "l1,0,0 l5,0,0");
  EXPECT_EQ(milled_path(":1;\nG1 X1. F1;\nM98 P7;\nM30;\n:0007; X5.;\nM99;\n"), "l1,0,0 l5,0,0");
  EXPECT_EQ(
      milled_path("G1 X1. F1\n#1=0\nWHILE[#1LT2]DO1\n:50 T1 M6\nX[#1+2]\n#1=#1+1\nEND1\nM30\n"),
      "l1,0,0 l2,0,0 l3,0,0");
  EXPECT_EQ(
      recognise(TempFolder().write("a.nc", ":10 T1 M6 ; main block\nG1 X1 Y1 ; cut\n"), {}).dialect,
      Dialect::sinumerik);
}

TEST(Habits, ASignMayStandApart) {
  const auto told = [](const char* text) { return codes(read_text(text, kFanuc)); };
  EXPECT_EQ(told("G1 X+ 2. Y-  .5 F + 20.\n"), "");
  EXPECT_EQ(told("G1 X - 1 2. F20.\n"), "blank-in-number");
  EXPECT_EQ(told("G1 X1 F20.\nX12.3456789012345678 Y1 \n"), "") << "17 digits, and a blank behind";
  EXPECT_EQ(told("G1 95 X1. F20.\n"), "blank-in-number g-unknown");
}

// Lathes of Okuma have no G20: their units are a parameter of the control.
TEST(Habits, InchesThatOnlyACommentTellsAreAnError) {
  const auto told = [](const std::string& text) { return codes(read_text(text, kFanuc)); };
  EXPECT_EQ(told("(MATERIAL - STEEL INCH - 1030 - 200 BHN)\nG1 X1. F.01\n"), "units-unset");
  EXPECT_EQ(told("(MATERIAL - STEEL INCH - 1030)\nG20 G1 X1. F.01\n"), "");
  EXPECT_EQ(told("(UNITS: MM, NOT INCHES)\nG1 X1. F.01\n"), "");
  EXPECT_EQ(told("(FACE 1 INCH DEEP)\nG1 X1. F.01\n"), "");
  EXPECT_EQ(told("(UNITS: INCHES)\nG0 X1.\nG4 P1\n"), "program-without-cuts");
}

// A shop whose control wakes up in inches writes no G20; its tools and the sizes tell.
TEST(Habits, InchesThatOnlyTheToolsTellAreAnError) {
  InterpOptions options = kFanuc;
  options.table.tools.clear();
  const auto told = [&](const std::string& text) { return codes(read_text(text, options)); };
  const std::string cut = "T1 M6\nG0 X0 Y0 Z1.\nG1 Z-.25 F10.\nX2.\n";
  EXPECT_EQ(told("(T1 1/2 FLAT ENDMILL)\n" + cut), "units-unset");
  EXPECT_EQ(told("(T1 1/2 FLAT ENDMILL)\nG20\n" + cut), "");
  EXPECT_EQ(told("(T1 1/2 FLAT ENDMILL)\nG21\n" + cut), "");
  EXPECT_EQ(told("(T1 1/2 FLAT ENDMILL)\n" + cut + "X80.\n"), "");
  EXPECT_EQ(told("(T1 12 MM FLAT ENDMILL)\n" + cut), "");
  const auto turned = [&](const std::string& text) {
    options.machine = MachineKind::lathe;
    return codes(read_text(text + "T0101\nG99 G0 X2. Z.1\nG1 Z-1. F.01\n", options));
  };
  EXPECT_EQ(turned("(T1 CNMG-432)\n"), "units-unset");
  EXPECT_EQ(turned("(T1 CNMG 120408)\n"), "");
  EXPECT_EQ(turned("G96 S1000 M3\n"), "units-unset") << "by the spindle's speed";
  EXPECT_EQ(turned("G21 G96 S1000 M3\n"), "");
  EXPECT_EQ(turned("G96 S120 M3\n"), "") << "19 100 rev/min, as in a lathe for watches";
}

// The places of a drilling cycle may be reached from one side.
TEST(Habits, G60BesideADrillingCycleIsAPlace) {
  EXPECT_EQ(
      milled_path("G0 Z9.\nG60 X1. Y0\nG98 G83 Z-3. R2. L0 Q5. F9.\nG60 X5. Y1.\nG80\nG60 X2.\n"),
      milled_path("G0 Z9.\nX1. Y0\nG98 G83 Z-3. R2. L0 Q5. F9.\nX5. Y1.\nG80\nG0 X2.\n"));
}

// Only a zero in [machine] ties places of the machine to the stock.
TEST(Habits, OffsetsOfTheMachineAreToldOf) {
  const Program p = read_text("G10 L2 P1 X-350. Y-200. Z-400.\nG1 X5. F100.\n", kFanuc);
  EXPECT_EQ(path_text(p), "l-345,0,0");
  ASSERT_EQ(codes(p, Severity::note), "work-offset-set");
  EXPECT_NE(p.diagnostics[0].text.find("zero.G54 = [-350, -200, -400]"), std::string::npos);
  EXPECT_EQ(notes("G10 L2 P1 X0 Y0 Z0\nG91 G10 L2 P1 X5.\nG10 L2 P0 X5.\nG1 X5. F1\n"), "");
  InterpOptions options = kFanuc;
  options.places.zero = {{"G54", {-350, -200, -400}}};
  EXPECT_EQ(path_text(read_text("G10 L2 P1 X-350. Y-200. Z-400.\nG1 X5. F100.\n", options)),
            "l5,0,0");
}

// The 30i has program numbers of eight digits; M98 P910002 calls O0002 91 times where there is
// none.
TEST(Habits, ProgramNumbersMayHaveEightDigits) {
  const auto path = [](const std::string& text) { return path_text(read_text(text, kFanuc)); };
  EXPECT_EQ(path("M98 P910002 L2\nM98 P910002\nM30\nO910002\nG91 G1 X1. F100\nG90\nM99\n"),
            "l1,0,0 l2,0,0 l3,0,0");
  EXPECT_EQ(path("M98 P20002\nM30\nO2\nG91 G1 X1. F100\nG90\nM99\n"), "l1,0,0 l2,0,0");
}

TEST(Habits, ProbesAreCalledByM98Too) {
  EXPECT_EQ(notes("G1 X1. F1\nM98 P9832\nG0 X5.\n"), "probe");
  EXPECT_EQ(notes("G1 X1. F1\nM98 P9023\nM98 P9832\n"), "probe");
  EXPECT_EQ(notes("G1 X1. F1\nM98 P9832\nM30\nO9832\nG0 Z9.\nM99\n"), "") << "it is at hand";
  EXPECT_EQ(notes("G1 X1. F1\nM98 P9732\n"), "subprogram-missing");
  EXPECT_EQ(notes("G1 X1. F1\nG37 Z-100. H1\nG0 Z5.\n"), "probe") << "it measures the tool";
}

// The number of the program stands before its mark, too: what follows is not read as another tape.
TEST(Habits, TheProgramNumberMayStandBeforeTheMark) {
  const TempFolder scratch;
  const auto told = [&](const std::string& text) {
    const std::string path = scratch.write("o.nc", text);
    InterpOptions options = kFanuc;
    options.dialect = Dialect::automatic;
    return path_text(read_program(path, options));
  };
  EXPECT_EQ(told("O0090 (CONE)\n%\nG90 G17\nG1 X5. F100\nM30\n%\n"), "l5,0,0");
  EXPECT_EQ(told("O0090\nG1 X5. F100\n%\nG1 X9.\n%\n"), "l5,0,0");
}

// FANUC's 30i names programs, and Haas' M98 takes the path of a file.
TEST(Habits, ProgramsAreCalledByName) {
  const TempFolder scratch;
  scratch.write("SUB1.nc", "<SUB1>\nG91 G1 X1. F100\nG90\nM99\n");
  scratch.write("bore.NC", "%\nO77\nG1 Z-#7 F100\nM99\n%\n");
  const auto path = [&](const std::string& text) {
    return path_text(read_program(scratch.write("main.nc", text), kFanuc));
  };
  EXPECT_EQ(path("%\n<PART-1>(NAME)\nM98<SUB1>L2\nG65 <BORE> D5.\nG66 <BORE> D6.\nG0 X9.\nG67\n"
                 "M98 <HERE>\nM30\n<HERE>\nG1 Y3.\nM99\n%\n"),
            "l1,0,0 l2,0,0 l2,0,-5 r9,0,-5 l9,0,-6 l9,3,-6");
  EXPECT_EQ(path("O1\nM98 (USB0/PARTS/SUB1.NC) L2\nM98 (FIRST SUB.) P2\nM30\nO2\nG1 Y1.\nM99\n"),
            "l1,0,0 l2,0,0 l2,1,0");
  EXPECT_EQ(path("O1\nG1 X1. F1\nM98 (SUB 1)\nM30\n"), "l1,0,0 | call-without-program");
  EXPECT_EQ(path("O1\nG1 X1. F1\nM98 <NONE>\nM30\n"), "l1,0,0 | subprogram-missing");
  EXPECT_EQ(path("O1\nG1 X1. F1\nX2. <SUB1>\nM30\n"), "l1,0,0 | not-supported");
  EXPECT_EQ(recognise(scratch.write("named.txt", "<PART-1>\nG1 X1.\n"), {}).dialect_reason,
            "the name of a program in < > in line 1");
}

TEST(Habits, RigidTapsHaveManyNames) {
  const auto lead = [](const std::string& text) {
    const Program p = read_text("G0 Z9.\nS500 M3\n" + text, kFanuc);
    std::string out = codes(p);
    for (const Motion& m : p.motions)
      if (m.lead != 0) out += fmt::format(" {:g}@{:g}", m.lead, m.end.z);
    return out;
  };
  EXPECT_EQ(lead("G84 X5. Z-8. R2. F625.\n"), " 1.25@-8 1.25@2");
  EXPECT_EQ(lead("G84.2 X5. Z-8. R2. F625.\n"), " 1.25@-8 1.25@2");
  EXPECT_EQ(lead("G84.3 X5. Z-8. R2. F625.\n"), " -1.25@-8 -1.25@2");
  EXPECT_EQ(lead("G84 X5. Z-8. R2. F625. ,R1\n"), " 1.25@-8 1.25@2");
  EXPECT_EQ(lead("G84 X5. Z-8. R2. F625. J2\n"), " 1.25@-8 1.25@2");
  EXPECT_EQ(lead("G84 X5. Z-8. R2. F625. ,R1 ,S2000 ,I.05 ,J.1\n"), " 1.25@-8 1.25@2");
  EXPECT_EQ(lead("G84 X5. Z-8. R2. F1.25 ,R1\n"), " 1.25@-8 1.25@2") << "F is the lead";
  EXPECT_EQ(lead("G84 X5. Z-8. R2. F1.25\n"), "tap-lead 0.0025@-8 0.0025@2");
  EXPECT_EQ(lead("G95\nG84 X5. Z-8. R2. F1.25\n"), " 1.25@-8 1.25@2");
  // Brother: the lead, or threads per inch; L is the speed of the way back, not a count.
  EXPECT_EQ(lead("G77 X5. Z-8. R2. I0.8 S1000 L3000\nX9.\n"), " 0.8@-8 0.8@2 0.8@-8 0.8@2");
  EXPECT_EQ(lead("G78 X5. Z-8. R2. I1.\n"), " -1@-8 -1@2");
  EXPECT_EQ(lead("G20\nG77 X1. Z-.5 R.1 J20\n"), " 1.27@-12.7 1.27@2.54");
  EXPECT_EQ(lead("G77 X5. Z-8. R2. I.8\nG80\nG84 X9. Z-8. R2. F500.\n"), " 0.8@-8 0.8@2 1@-8 1@2");
  EXPECT_EQ(lead("G77 X5. Z-8. R2.\n"), "value-missing");
  EXPECT_EQ(lead("G77 X5. Z-8. R2. I0\n"), "thread-lead");
  EXPECT_EQ(lead("G77 X5. Z-8. R2. I.8 Q3.\n"), "not-supported");
}

// G10 L3 to G11: its T words change no tool.
TEST(Habits, ToolLifeIsNoGeometry) {
  const Program p = read_text(
      "T7 M6\nG10 L3\nP1 L30 Q1\nT1 H1 D1\nT2 H2 D2\nG11\nG0 X0 Y0 Z0\nG1 X9. F100.\n", kFanuc);
  EXPECT_EQ(codes(p, Severity::note), "reference-point tool-life tool-inferred");
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_EQ(p.tools[0].id, "7");
  EXPECT_EQ(p.motions.back().end.x, 9);
  EXPECT_EQ(codes(read_text("G1 X1. F100.\nG10 L3\nP1 L30\nG1 X9.\n", kFanuc)), "not-supported")
      << "without G11";
}

// Haas: an axis for each word, about the zero; arcs turn round.
TEST(Habits, HaasMirrorsAnAxisForEachWord) {
  const auto path = [](const std::string& text) {
    const Program p = read_text("G0 X0 Y0 Z0\n" + text, kFanuc);
    std::string out = codes(p);
    for (const Motion& m : p.motions)
      if (m.kind != MotionKind::rapid)
        out += fmt::format(" {:.6g},{:.6g}{}", m.end.x, m.end.y,
                           m.kind == MotionKind::arc ? m.sweep > 0 ? "+" : "-" : "");
    return out;
  };
  EXPECT_EQ(path("G101 X0\nG1 X10. Y5. F100.\nG2 X20. Y-5. I0 J-10.\nG100 X0\nG1 X1. Y1.\n"),
            path("G51.1 X0\nG1 X10. Y5. F100.\nG2 X20. Y-5. I0 J-10.\nG50.1 X0\nG1 X1. Y1.\n"));
  EXPECT_EQ(path("G101 X0 Y0.\nG1 X10. Y5. F100.\nG100 Y0\nG1 X20. Y5.\n"), " -10,-5 -20,5");
  EXPECT_EQ(path("G101 X10.\nG1 X10. F100.\n"), "not-supported 10,0");
  EXPECT_EQ(path("G101\nG1 X10. F100.\n"), "not-supported 10,0");
}

TEST(Habits, CyclesOfManualGuideAreOneError) {
  const Program p = read_text("G1 X1. F1\nG1040T1.L20.V100.E100.W1.\nG1 X2.\n", kFanuc);
  EXPECT_EQ(codes(p), "not-supported");
  EXPECT_NE(listing(p).find("MANUAL GUIDE"), std::string::npos);
}

// It stands before the cuts of many programs that are otherwise plain ISO.
TEST(Habits, BlanksOfManualGuideAreReadOver) {
  const Program p = read_text("N1 G1901D300.E72.L227.K2.\nG1 X1. F1\n", kFanuc);
  EXPECT_EQ(path_text(p), "l1,0,0");
  EXPECT_NE(listing(p).find("simulator-line"), std::string::npos) << listing(p);
}

// FANUC leaves out the rest of a block behind a slash that stands in it.
TEST(Habits, ASlashInABlockSkipsItsRest) {
  const auto run = [](unsigned skip, Dialect dialect) {
    InterpOptions options = at_origin(dialect);
    options.block_skip = skip;
    return path_text(read_text("G1 X1. F9 /Y2.\nX2. /2 Y3. (A)\nX3.\n", options));
  };
  EXPECT_EQ(run(0, Dialect::fanuc), "l1,2,0 l2,3,0 l3,3,0");
  EXPECT_EQ(run(1, Dialect::fanuc), "l1,0,0 l2,3,0 l3,3,0");
  EXPECT_EQ(run(4, Dialect::fanuc), "l1,2,0 l2,2,0 l3,2,0");
  EXPECT_EQ(path_text(read_text("G1 X1. F9 /Y2.\nX3.\n", at_origin(Dialect::iso))),
            "r3,0,0 | character");
  EXPECT_EQ(path_text(read_text("G1 X10/2 F9\n", at_origin(Dialect::fanuc))), "l10,0,0");
}

TEST(Habits, ACommentInACommentIsOneError) {
  EXPECT_EQ(milled_path("G1 X50. (to (the end) of the slot) F1.\n"), " | character");
  EXPECT_EQ(milled_path("(hole at (61.0, 67.7) )\nG1 X50. F1.\n"), "l50,0,0 | comment-nested");
  EXPECT_EQ(codes(read_text("(PART (A))\nG1 X1. F1\n", kFanuc)), "comment-nested");
}

TEST(Habits, MessagesSayWhatToDo) {
  const auto told = [](const std::string& text) {
    return read_text(text, kFanuc).diagnostics.at(0).text;
  };
  EXPECT_EQ(told("(PART (A) B)\nG1 X1. F1\n"),
            ") has no meaning here: a comment ends at its first ), one in another too");
  EXPECT_EQ(told("G1 X1.) F1\n"), ") has no meaning here");
  EXPECT_EQ(told("G1 Z-1,5 F1\n"), ", has no meaning here: a decimal point is written .");
}

TEST(Habits, ACommentThatIsNotUnderstoodIsQuoted) {
  const auto told = [](const std::string& text) {
    InterpOptions options;
    options.machine = MachineKind::mill;
    options.dialect = Dialect::fanuc;
    for (const Diagnostic& d : read_text(text + "G21\nG0 Z5.\nG1 Z-1. F9\n", options).diagnostics)
      if (d.code == "tool-unknown") return d.text;
    return std::string();
  };
  EXPECT_NE(
      told("(T4 6MM DRILL - CHAMFER EDGES)\nT4 M6\n").find("--tool 4=chamfer:d=6,tip_angle=90"),
      std::string::npos);
  EXPECT_NE(told("(T4 D12 BULL NOSE)\nT4 M6\n").find("--tool 4=bullmill:d=12,r=1 (r: its corner)"),
            std::string::npos);
  EXPECT_NE(told("(T04: GIZMO 10X90)\nT4 M6\n").find("in its comment \"T04: GIZMO 10X90\":"),
            std::string::npos);
  EXPECT_NE(told("T4 M6 (GIZMO)\n").find("in its comment \"GIZMO\":"), std::string::npos);
  EXPECT_NE(told("(GIZMO)\nT4 M6\n").find("there are no data for it"), std::string::npos);
  EXPECT_EQ(told("(T4: GIZMO)\nT4 M6 (8MM END MILL)\n"), "");
}

// 1/4 inch, typed for a program in inches.
TEST(Habits, TypedToolsBelowAMillimetreInInchProgramsAreDoubted) {
  const auto told = [](const std::string& text, double diameter) {
    InterpOptions options = at_origin(Dialect::fanuc);
    options.table.tools[0].diameter = diameter;
    options.table.tools[0].origin = "--tool";
    return codes(read_text(text, options), Severity::warning);
  };
  EXPECT_EQ(told("G20\nG1 X1. F10.\n", 0.25), "tool-unit");
  EXPECT_EQ(told("G20\nG1 X1. F10.\n", 6.35), "");
  EXPECT_EQ(told("G21\nG1 X1. F10.\n", 0.25), "");
}

// A part of 40 m is one of 40 mm in least increments.
TEST(Habits, PlacesTooFarForAnyMachineAreWarnings) {
  const auto told = [](const std::string& text) {
    return codes(read_text(text, kFanuc), Severity::warning);
  };
  EXPECT_EQ(told("G1 X2440 F1000\n"), "");
  EXPECT_EQ(told("G1 X2440 F1000\nX-40000\n"), "number-without-point");
  EXPECT_EQ(told("G1 X40000. F1000\n"), "");
  EXPECT_EQ(told("G20\nG1 X1500 F10\n"), "number-without-point");
  for (const Dialect dialect : {Dialect::iso, Dialect::ngc, Dialect::sinumerik}) {
    const auto other = [&](const std::string& text) {
      return codes(read_text(text, at_origin(dialect)), Severity::warning);
    };
    EXPECT_EQ(other("G1 X2440 F1000\n"), "");
    EXPECT_EQ(other("G1 X40000 F1000\n"), "number-without-point");
    EXPECT_EQ(other("G1 X40000. F1000\n"), "");
    EXPECT_EQ(other("G70\nG1 X1000 F10\n"), "number-without-point");
  }
  EXPECT_EQ(codes(read_text("R1=40000\nG1 X=R1 F1000\n", at_origin(Dialect::sinumerik))), "");
}

// The remedy that is named makes the radii agree.
TEST(Habits, RadiiThatDifferSayWhatWouldDo) {
  const auto told = [](const std::string& text) {
    const Program p = read_text(text, kFanuc);
    return p.diagnostics.empty() ? std::string() : p.diagnostics[0].text;
  };
  EXPECT_NE(
      told("G1 X24. Y-.25 F100.\nG3 X24.25 Y0 I24. J0\n")
          .find("about X24 Y0 both would be 0.25: do I and J say where the centre is (G90.1)?"),
      std::string::npos);
  EXPECT_NE(told("G1 X10. F100.\nG2 X0. Y10. I10. J0\n").find("I-10 would give 10 and 10"),
            std::string::npos);
  EXPECT_EQ(told("G1 X24. Y-.25 F100.\nG3 X24.25 Y0 I24. J3.\n").find("would"), std::string::npos);
}

// WinCNC goes to the machine's zero, Marlin homes one axis: neither leads through the part's zero.
TEST(Habits, AxesWithoutANumberBehindG53AndG28GoHome) {
  const auto told = [](Dialect dialect, const std::string& text) {
    return path_text(read_text("F100\nG0 X1 Y2 Z3\n" + text, at_origin(dialect)));
  };
  EXPECT_EQ(told(Dialect::ngc, "G53 Z\nG0 X5\nZ4\nG1 Z-1\n"), "r1,2,3 r5,2,3 r5,2,4 l5,2,-1");
  EXPECT_EQ(told(Dialect::iso, "G28 Z X\nG0 X5 Z4\nG1 Z-1\n"), "r1,2,3 r5,2,4 l5,2,-1");
  EXPECT_EQ(codes(read_text("G53 Z\n", at_origin(Dialect::ngc)), Severity::note),
            "axis-without-number reference-point program-without-cuts");
  const Program waits = read_text("M11 C8\nG4 X4.\nG1 X1 F1\nM12 C8\n", at_origin(Dialect::ngc));
  EXPECT_EQ(path_text(waits), "l1,0,0 | dwell-unit");
  EXPECT_EQ(codes(read_text("G4 X4. Y2\n", at_origin(Dialect::ngc))), "value-missing");
  EXPECT_EQ(codes(read_text("G1 X F1\n", at_origin(Dialect::ngc))), "address-without-number");
  EXPECT_EQ(codes(read_text("G28 X\n", kFanuc)), "address-without-number");
}

// Mitsubishi's lathes with several paths.
TEST(Habits, MarksWherePathsWaitAreReadOver) {
  EXPECT_EQ(notes("G1 X1. F9\n!L10\n!1!2 L11\nX2.\n"), "path-wait");
  EXPECT_EQ(path_text(read_text("G1 X1. F9\n!2L10 X2.\n", kFanuc)), "l1,0,0 l2,0,0");
  EXPECT_EQ(codes(read_text("G1 X1. F9\n!X2.\n", kFanuc)), "character");
}

// "//" begins a comment; a single one skips.
TEST(Habits, TwoSlashesBeginAComment) {
  EXPECT_EQ(milled_path("//T1 X9. Y9. (PART\nG1 X1. F9 // G1 X5.\n/X2.\n"), "l1,0,0 l2,0,0");
  EXPECT_EQ(notes("G1 X1. F9 //\n//\n"), "slash-comment");
  TempFolder folder;
  const std::string file = folder.write("a.nc", "// O1234 M98 G65 P2\nG1 X1 Y1\n");
  EXPECT_NE(recognise(file, {}).dialect, Dialect::fanuc);
}

}  // namespace
}  // namespace mrsim
