// Words that posts write around their paths: safe starts, machine coordinates, offsets, calls.
#include "core/numbers/vec.h"
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(PostWords, ASafeStartNeverWarns) {
  const std::pair<Dialect, const char*> starts[] = {
      {Dialect::fanuc, "G90 G94 G17 G21 G40 G49 G80 G69 G50"},
      {Dialect::fanuc, "G00 G17 G21 G40 G49 G80 G90 G98"},
      {Dialect::fanuc, "G91 G28 Z0.\nG90 G28 X0. Y0.\nG90"},
      {Dialect::fanuc, "G28 G91 Z0.\nG30 G91 Z0.\nG90"},
      {Dialect::fanuc, "G5.1 Q1\nG5.1 Q0\nG5 P10000\nG5 P0\nG8 P1\nG64\nG61"},
      {Dialect::fanuc,
       "G10 L2 P1 X0. Y0. Z0.\nG54\nG92.1 X0 Y0 Z0\nG187 P2\nG22 X1. Y1. Z1. I0 J0 K0"},
      {Dialect::iso, "G90 G94 G17 G21 G40 G49 G80 G90.1 G91.1 G61.1 G64"},
      {Dialect::iso, "G90.1\nG91.1\nG54.1 P1\nG59.1"},
      {Dialect::ngc, "G17 G21 G40 G49 G54 G80 G90 G94\nG64 P0.01 Q0.01\nG90.1\nG91.1\nG61\nG61.1"},
      {Dialect::ngc,
       "G92.1\nG92.2\nG92.3\nG28.1\nG30.1\nG10 L2 P1 X0 Y0 Z0\nG10 L20 P0 X0\nG59.3\nG8"},
      {Dialect::sinumerik,
       "G40 G17 G90 G94 G71 G64 G500\nTRAFOOF\nCYCLE800()\nCYCLE832()\nMSG(\"A\")"},
      {Dialect::sinumerik, "G0 SUPA Z0 D0\nG0 G153 X0 Y0\nG74 Z1=0\nG75 X1=0 FP=1"},
  };
  for (const auto& [dialect, text] : starts) {
    SCOPED_TRACE(text);
    InterpOptions options = at_origin(dialect);
    options.start.reset();
    const Program p = read_text(std::string(text) + "\nG0 X1 Y1 Z1\nG1 X2 F100\n", options);
    EXPECT_EQ(codes(p), "") << listing(p);
    EXPECT_EQ(p.motions.size(), 2U) << listing(p);
  }
}

TEST(PostWords, WhatMovesTheMachineIsNamed) {
  const std::pair<const char*, const char*> rows[] = {{"G68.2 X0 Y0 Z0 I0 J30 K0", "tilted"},
                                                      {"G54.4 P1", "setting error"},
                                                      {"G5 X1 Y1 I1 J1", "spline"},
                                                      {"G7.1 C20.", "cylindrical"}};
  for (const auto& [text, name] : rows) {
    SCOPED_TRACE(text);
    const Program p =
        read_text(std::string("G1 X1 F100\n") + text + "\n", at_origin(Dialect::fanuc));
    ASSERT_FALSE(p.diagnostics.empty());
    EXPECT_EQ(p.diagnostics[0].code, "not-supported");
    EXPECT_NE(p.diagnostics[0].text.find(name), std::string::npos) << p.diagnostics[0].text;
    EXPECT_EQ(p.diagnostics[0].place.line, 2);
  }
}

TEST(PostWords, SemicolonsPointsAndTurnsAreRead) {
  for (const Dialect d : {Dialect::fanuc, Dialect::iso, Dialect::ngc}) {
    const Program p = read_text("G1 Z-1 F100 ;Z-3\nG1 X1\n", at_origin(d));
    ASSERT_EQ(p.motions.size(), 2U);
    EXPECT_EQ(p.motions[0].end.z, -1);
    const Program turns = read_text("G1 X10 F100\nG3 I-10 Z-3 P3\n", at_origin(d));
    ASSERT_EQ(turns.motions.size(), 2U);
    EXPECT_NEAR(turns.motions[1].sweep, 6 * kPi, 1e-12);
  }
  EXPECT_EQ(codes(read_text("G1 X1000 F1\n", at_origin(Dialect::fanuc)), Severity::note),
            "number-without-point");
  EXPECT_EQ(codes(read_text("G55\nG1 X1 F1\n", at_origin(Dialect::iso)), Severity::note),
            "work-offset-unset");
  const Program half = read_text("G1 X0 F1\nG2 X10 R4.999\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(half, Severity::error), "");
  EXPECT_NEAR(half.motions.back().sweep, -kPi, 1e-9);
}

// A ";" may end a block of FANUC or begin a comment: words behind it are told of.
TEST(PostWords, WordsBehindASemicolonAreToldOf) {
  const auto said = [](const std::string& line) {
    return codes(read_text("G1 X0 F100\n" + line + "\n", at_origin(Dialect::fanuc)));
  };
  for (const char* doubt : {"G1 X5.;Y6.", "G0 Z5. ;G1 Z-1. F100", "X5. ; Z-3", "#1=5; G1 X3",
                            "IF[1EQ1]THEN #1=5 ; G1 X3"})
    EXPECT_EQ(said(doubt), "block-end-sign") << doubt;
  for (const char* clear : {"G1 X5.;Y6.;", "G1 X5. ; FIRST CUT", ";G1 X5. Y6.", "X5. ; D10 R3",
                            "X5.;", "X5. ; 10 MM", "X5. ;", "N7 (CUT) ; G1 X3", "#1=5; G1 X3;"})
    EXPECT_EQ(said(clear), "") << clear;
}

// The letter O for the digit, and the minus of a word processor.
TEST(PostWords, ALetterOForADigitIsNamed) {
  const auto said = [](const std::string& line) {
    const Program p = read_text(line + "\n", at_origin(Dialect::fanuc));
    return p.diagnostics.empty() ? std::string() : p.diagnostics[0].text;
  };
  for (const char* line : {"GO X5.", "GOX5.", "G1 MO3 X5."})
    EXPECT_NE(said(line).find("a letter O stands where the digit 0 is meant"), std::string::npos)
        << line;
  EXPECT_NE(said("00001").find("the digit 0 stands where the letter O is meant"),
            std::string::npos);
  EXPECT_NE(said("G1 X1O Y5").find("is the digit 0 meant?"), std::string::npos);
  EXPECT_NE(said("G1 X5. Y\xE2\x88\x92"
                 "3.")
                .find("no number after Y"),
            std::string::npos);
  EXPECT_EQ(said("G1 X1 F100\nIF [1 EQ 1] GOTO 10\nN10"), "");
}

// Two vises, or two sides of a part, lie one on the other where nothing tells them apart.
TEST(PostWords, OriginsWithoutAnEntryCoincide) {
  InterpOptions options = at_origin(Dialect::fanuc);
  const std::string two = "G54 G1 X1. F1.\nG55 X2.\nG56 X3.\n";
  EXPECT_EQ(codes(read_text(two, options)), "origins-coincide");
  EXPECT_EQ(codes(read_text("G54 G0 X1.\nG55 G1 X2. F1.\nX3.\n", options)), "");
  EXPECT_EQ(codes(read_text("G10 L2 P2 X50. Y0 Z0\nG54 G1 X1. F1.\nG55 X2.\n", options)), "");
  options.table.work = {{"G55", {100, 0, 0}}};
  EXPECT_EQ(codes(read_text("G54 G1 X1. F1.\nG55 X2.\n", options)), "");
}

// G54's zero at X-200 Y-100 Z-300 of the machine: machine X0 lies at X200 of the stock.
TEST(PostWords, MachineCoordinatesMoveWhereTheZeroIsKnown) {
  const auto moved = [](Dialect dialect, const std::string& text, bool table = false) {
    InterpOptions options = at_origin(dialect);
    options.places.zero = {{"G54", {-200, -100, -300}}, {"G55", {-150, -100, -300}}};
    options.places.reference = {0, 0, -10};
    options.places.second = Vec3{-300, 0, 0};
    if (table) options.table.work.push_back({"G54", {0, 0, 40}});
    const Program p = read_text(text, options);
    std::string out = codes(p, Severity::note);
    for (const Motion& m : p.motions)
      out += " " + std::to_string(static_cast<int>(m.end.x)) + "," +
             std::to_string(static_cast<int>(m.end.y)) + "," +
             std::to_string(static_cast<int>(m.end.z)) + (m.assumed_start ? "?" : "");
    return out;
  };
  const auto f = Dialect::fanuc, s = Dialect::sinumerik;
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG53 G0 Z0.\nG53 X-50.\nG0 X0.\n"),
            " 5,0,0 5,0,300 150,0,300 0,0,300");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG91 G28 Z3.\nG28 X0. Y0.\nG90 G30 X10.\n"),
            " 5,0,0 5,0,3 5,0,290 200,100,290 10,100,290 -100,100,290");
  // G29 goes back over the intermediate point, and its increments count from there.
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG28 X9. Z3.\nG29 X1. Z2.\n"),
            " 5,0,0 9,0,3 200,0,290 9,0,3 1,0,2");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG91 G28 X4. Z0\nG29 X-2.\n"),
            " 5,0,0 9,0,0 200,0,290 9,0,290 7,0,290");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG28 X9.\nG29 X1. Y2.\n"), "value-missing 5,0,0 9,0,0 200,0,0");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG28 X9.\nG29\n"), "motion-missing 5,0,0 9,0,0 200,0,0");
  for (const Dialect dialect : {f, Dialect::ngc})  // without axes all of them
    EXPECT_EQ(moved(dialect, "G1 X5. F100.\nG28\nG30\n"), " 5,0,0 200,100,290 -100,100,300");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG28 A0.\n"), "rotary-axis 5,0,0");
  EXPECT_EQ(moved(f, "G1 X5. F100.\nG55\nX0. Y0.\n"), " 5,0,0 50,0,0");
  EXPECT_EQ(moved(f, "G10 L2 P1 X-190. Y-100. Z-300.\nG1 X5. F100.\n"), " 15,0,0");
  EXPECT_EQ(moved(f, "G1 X5. Z0. F100.\nG53 G0 Z0.\n", true), " 5,0,40 5,0,340");
  EXPECT_EQ(moved(s, "G1 X5 F100\nG0 SUPA Z0 D0\nG74 X1=0\nG75 X1=0 Z1=0\n"),
            " 5,0,0 5,0,300 200,0,300 -100,0,300");
}

TEST(PostWords, WithoutARegisterTheRadiusIsTheTools) {
  InterpOptions options = at_origin(Dialect::fanuc);
  const char* text = "G0 X0 Y0\nG1 G41 D1 X0 Y10 F100\nY20\nY30\nG40 X-20\n";
  const auto x = [&](CompRadius comp, const char* expected) {
    options.comp = comp;
    const Program p = read_text(text, options);
    EXPECT_EQ(codes(p), expected);
    return p.motions[1].end.x;
  };
  EXPECT_NEAR(x(CompRadius::automatic, "register-missing"), -5, 1e-9);
  EXPECT_NEAR(x(CompRadius::radius, ""), -5, 1e-9);
  EXPECT_NEAR(x(CompRadius::wear, ""), 0, 1e-9);
  EXPECT_NEAR(x(CompRadius::off, ""), 0, 1e-9);
}

TEST(PostWords, G10SetsOffsetsAndRadii) {
  const Program p = read_text(
      "G10 L2 P2 X100 Y50\nG55\nG1 X1 Y1 F1\nG54\nG10 L12 P3 R2\nG41 D3 X1 Y10\nY20\nG40 X-9\n",
      at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p), "");
  expect_near(p.motions[0].end, {101, 51, 0});
  EXPECT_NEAR(p.motions[2].end.x, -1, 1e-9);
  EXPECT_EQ(p.zero_height, 0);
  const auto height = [](const char* text) {
    return read_text(text, at_origin(Dialect::fanuc)).zero_height;
  };
  EXPECT_EQ(height("G10 L2 P1 Z-420.5\nG54\nG0 Z5\nG1 Z-3 F1\nX9\n"), -420.5);
  EXPECT_EQ(height("G10 L2 P1 Z-40\nG10 L2 P2 Z-30\nG54\nG1 X9 F1\nG55\nG52 Z50\nX8\n"), -30);
  // On a lathe TRANS leads from the chuck to the face.
  const InterpOptions turned = at_origin(Dialect::sinumerik, MachineKind::lathe);
  EXPECT_EQ(read_text("G54\nTRANS Z60\nG1 X40 Z-5 F0.1\nATRANS Z-20\nX42\n", turned).zero_height,
            60);
  EXPECT_EQ(read_text("TRANS Z60\nG1 X4 F1\n", at_origin(Dialect::sinumerik)).zero_height, 0);
  const Program here = read_text("G1 X10 F1\nG10 L20 P1 X0\nG1 X5\n", at_origin(Dialect::ngc));
  EXPECT_EQ(here.motions.back().end.x, 15);
}

// LinuxCNC: the entry ends beside its own end, not beside the next element's start; round an
// outside corner an arc follows, an inside one ends the entry where the moved elements meet.
TEST(PostWords, LinuxCncEntersCompensationBesideTheEntry) {
  const InterpOptions options = at_origin(Dialect::ngc);
  const Program outside = read_text("G42.1 D2 G1 X10 F100\nY10\nG40 X20\nM2\n", options);
  EXPECT_EQ(codes(outside), "");
  ASSERT_EQ(outside.motions.size(), 4U) << listing(outside);
  expect_near(outside.motions[0].end, {10, -1, 0});
  EXPECT_EQ(outside.motions[1].kind, MotionKind::arc);
  expect_near(outside.motions[1].center, {10, 0, 0});
  expect_near(outside.motions[1].end, {11, 0, 0});
  const Program inside = read_text("G41.1 D2 G1 X10 F100\nY10\nG40 X20\nM2\n", options);
  expect_near(inside.motions[0].end, {9, 1, 0});
  EXPECT_EQ(codes(read_text("G41.1 D4 G1 X2 F100\nY10\nG40 X20\nM2\n", options)), "comp-entry");
}

// LinuxCNC: R of G10 L2 turns the offset about its zero, L20 keeps the position.
TEST(PostWords, G10TurnsAWorkOffset) {
  const InterpOptions options = at_origin(Dialect::ngc);
  const Program p = read_text("G10 L2 P1 X10 Y0 R90\nG1 X5 Y1 F1\nG10 L20 P1 X1 Y0\nX2\n", options);
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 2U);
  expect_near(p.motions[0].end, {9, 5, 0});
  expect_near(p.motions[1].end, {9, 6, 0});
}

// Compensation ends with a straight move; a full circle is none.
TEST(PostWords, AFullCircleDoesNotEndCompensation) {
  for (const Dialect d : {Dialect::fanuc, Dialect::ngc})
    EXPECT_EQ(codes(read_text("G41 D1 G1 X10 F100\nX30\nG40\nG2 I5\nG1 X50\nM2\n", at_origin(d))),
              "comp-end-arc");
}

TEST(PostWords, LinuxCncChecksArcsAndReadsDAsADiameter) {
  const InterpOptions options = at_origin(Dialect::ngc);
  EXPECT_EQ(codes(read_text("F1\nG2 X6000 I3100\n", options)), "arc-radii-differ");
  EXPECT_EQ(codes(read_text("F1\nG2 X1.01 I0.5\n", options), Severity::error), "");
  EXPECT_EQ(codes(read_text("F1\nG2 X10.1 I5\n", options)), "arc-radii-differ");
  const Program p = read_text("G1 G41.1 D6.5 X0 Y10 F100\nY20\nY30\nG40 X-20\n", options);
  EXPECT_EQ(codes(p), "");
  EXPECT_NEAR(p.motions[1].end.x, -3.25, 1e-9);
}

// A macro of a probe that is not at hand cuts nothing; where it ends is unknown.
TEST(PostWords, ProbingMacrosAreNotRun) {
  const Program p = read_text(
      "G0 X1. Y1. Z1.\nG65 P9810 Z-5. F2000.\nG65 P9811 Z0. S1.\nG0 X5. Y5.\nZ5.\nG1 X9. F1.\n",
      at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p, Severity::note), "probe") << listing(p);
  ASSERT_EQ(p.motions.size(), 4U);
  EXPECT_TRUE(p.motions[2].assumed_start);
  EXPECT_FALSE(p.motions[3].assumed_start);
  EXPECT_EQ(codes(read_text("G65 P9100 Z-5.\n", at_origin(Dialect::fanuc)), Severity::error),
            "subprogram-missing");
}

TEST(PostWords, LAloneIsACallThatIsNotMade) {
  for (const Dialect d : {Dialect::fanuc, Dialect::iso})
    EXPECT_EQ(codes(read_text("G1 X1. F1.\nL101\n", at_origin(d))), "call-without-program");
}

TEST(PostWords, ProgramNamesOfOkumaAreHeaders) {
  const Program p = read_text("$PART1.MIN%\nO1\nG1 X1. F1.\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p), "");
  EXPECT_EQ(p.motions.size(), 1U);
}

TEST(PostWords, TwoToolsBesideM6AreOneNowAndOneNext) {
  InterpOptions options = at_origin(Dialect::fanuc);
  for (const char* id : {"1", "2"}) {
    Tool tool;
    tool.id = id;
    tool.diameter = 4;
    options.table.tools.push_back(tool);
  }
  const Program p = read_text("T01 T02 M06\nG1 X1 F1\nM6\nX2\n", options);
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 2U);
  EXPECT_EQ(p.tools[static_cast<std::size_t>(p.motions[0].tool)].id, "1");
  EXPECT_EQ(p.tools[static_cast<std::size_t>(p.motions[1].tool)].id, "2");
}

// WinCNC: [ ] about a line is a comment, which may name the tool.
TEST(PostWords, RemarksOfWinCncStandInSquareBrackets) {
  const std::string text = "[Pocket 1]\n[X= 300, Y= 200]\n[T1 6mm endmill]\nT1\nG1 X5 F100\n";
  for (const Dialect dialect : {Dialect::iso, Dialect::ngc, Dialect::fanuc}) {
    InterpOptions options = at_origin(dialect);
    options.table.tools.clear();
    const Program p = read_text(text, options);
    EXPECT_EQ(path_text(p), "l5,0,0");
    ASSERT_EQ(p.tools.size(), 1U);
    EXPECT_EQ(p.tools[0].diameter, 6);
  }
  EXPECT_EQ(codes(read_text("G1 X5 [A] F100\n", at_origin(Dialect::iso))), "not-supported");
  for (const Dialect dialect : {Dialect::ngc, Dialect::fanuc})
    for (const char* lost : {"[#2+1]", "[2 MOD #2]", "[SIN[#2] + 1]", "[#<_x>]", "[[#2]]"})
      EXPECT_EQ(codes(read_text(fmt::format("#2=3\nG1 X5 F100\n{}\n", lost), at_origin(dialect))),
                "not-supported")
          << "no remark, but an expression that has lost its address: " << lost;
  for (const char* remark : {"[SETUP #1]", "[#2 SIDE]", "[TOOL #3 AND #4]", "[####]", "[No. #1]"})
    EXPECT_EQ(codes(read_text(fmt::format("G1 X5 F100\n{}\n", remark), at_origin(Dialect::ngc))),
              "")
        << remark;
}

TEST(PostWords, SmoothingOfCentroidAndMazakIsReadOver) {
  EXPECT_EQ(path_text(read_text("G64 ON\nG1 X5 F100\nG64 OFF\nG61.1 ,K50\nX9\n",
                                at_origin(Dialect::fanuc))),
            "l5,0,0 l9,0,0");
  EXPECT_EQ(codes(read_text("G1 ON X5 F100\n", at_origin(Dialect::fanuc))),
            "address-without-number");
}

// Marlin's display; T1 of such a text is no tool.
TEST(PostWords, MessagesOfMarlinNameNoTool) {
  const Program p =
      read_text("M117 T1 flat end mill\nM0 Put tool 2\nM1 ; stop\nM118 X9\nG1 X5 F100\n",
                at_origin(Dialect::iso));
  EXPECT_EQ(path_text(p), "l5,0,0");
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_EQ(p.tools[0].id, "");
  EXPECT_EQ(path_text(read_text("M0 G1 X5 F100\n", at_origin(Dialect::iso))), "l5,0,0");
  for (const Dialect dialect : {Dialect::iso, Dialect::ngc})
    EXPECT_EQ(path_text(read_text("M117 2D Pocket1\nM118 3\nG1 X5 F9\nM2\n", at_origin(dialect))),
              "l5,0,0");
}

// G10 L50 to G11 sets parameters of the control, N and R in each of its lines.
TEST(PostWords, ParametersOfTheControlAreNotRead) {
  const auto fanuc = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(fanuc("G10 L50\nN1851 P1 R50\nG11\nG1 X5 F100\n"), "l5,0,0 | parameter-set");
  EXPECT_EQ(fanuc("G10 L52\nN3401 R1\nG11\nG1 X5 F100\n"), "l5,0,0 | parameter-set");
}

TEST(PostWords, WordsOfSpindlesAndNamesAreReadOver) {
  const auto fanuc = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(fanuc("M19 R90.\nM3 S1=1000\nS2=50\nG5.4 Q1\nSETVN 500[DEPTH]\nG1 X5 F100\nG5.4 Q0\n"),
            "l5,0,0");
  const Program p = read_text("M3 S1=1000\nS2=50\nG1 X5 F100\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(p.motions.size(), 1U);
  EXPECT_EQ(p.motions[0].speed, 1000);
}

// G284 and G274 of Okuma, G184 of Haas: rigid taps.
TEST(PostWords, RigidTapsOfOkumaAndHaasHaveTheirLead) {
  const auto lead = [](const std::string& cycle, MachineKind machine = MachineKind::mill) {
    const Program p = read_text("G0 Z5\nS500 M3\n" + cycle, at_origin(Dialect::fanuc, machine));
    return p.motions.size() > 2 ? p.motions[p.motions.size() - 2].lead : 0;
  };
  EXPECT_EQ(lead("G284 X0 Z-5 R2 F500\n"), 1);
  EXPECT_EQ(lead("G274 X0 Z-5 R2 F500\n"), -1);
  EXPECT_EQ(lead("G184 X0 Z-5. R2. F500\n"), -1);
}

TEST(PostWords, OffsetsOfPathPilotAndHomesOfTinyGAreRead) {
  InterpOptions options = at_origin(Dialect::ngc);
  options.table.work.push_back({"G54.1P10", {1, 2, 0}});
  EXPECT_EQ(path_text(read_text("G54.1 P10\nG1 X5 Y0 F100\nM2\n", options)), "l6,2,0");
  const Program p =
      read_text("G28.2 X0 Y0\nG0 X5 Y5\nG28.3 X0\nG1 X9 F9\n", at_origin(Dialect::iso));
  ASSERT_EQ(p.motions.size(), 2U);
  EXPECT_TRUE(p.motions[0].assumed_start);
  EXPECT_EQ(p.motions[1].end.x, 14);
}

}  // namespace
}  // namespace mrsim
