// What lathes' programs of all makers write beside the cycles. X of the paths is a radius.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

Program on_lathe(const std::string& text, Dialect dialect = Dialect::fanuc) {
  return read_text(text, at_origin(dialect, MachineKind::lathe));
}

std::string lathe_moves(const std::string& text) {
  const Program p = on_lathe(text);
  return path_text(p) + (codes(p).empty() ? "" : " | " + codes(p));
}

std::string lathe_notes(const std::string& text, Dialect dialect = Dialect::fanuc) {
  return codes(on_lathe(text, dialect), Severity::note);
}

// The pass to X0 was run in the part's own zero: it cut the part off.
TEST(LatheHabits, G53IsNoPassOfTheCycleInForce) {
  EXPECT_EQ(lathe_moves("G0 X40 Z2\nG90 X36 Z-10 F.2\nG53 X0\nG53 Z0\n"),
            "r20,0,2 r18,0,2 l18,0,-10 l20,0,-10 r20,0,2");
  EXPECT_EQ(lathe_moves("G0 X0 Z2\nG81 Z-10 R1 F.1\nG53 X0 Z0\n"), "r0,0,2 r0,0,1 l0,0,-10 r0,0,2");
}

// Mastercam posts the lead in E in inches, as the 0T reads it; Haas has E as well. In the format of
// series 15 it counts the threads in an inch.
TEST(LatheHabits, EIsTheLeadOfAThread) {
  const std::string cuts[] = {"G32 Z-1.", "G92 X1. Z-1.",
                              "G76 P010060 Q50 R0\nG76 X1. Z-1. P500 Q90"};
  for (const std::string& cut : cuts) {
    for (const char* lead : {"E.0625", "E16", "F.0625"}) {
      const Program p = on_lathe("G20 G99\nG0 X1.2 Z.2\n" + cut + " " + lead + "\n");
      EXPECT_EQ(codes(p), "") << cut << lead;
      double found = 0;
      for (const Motion& m : p.motions) found = std::max(found, m.lead);
      EXPECT_NEAR(found, 1.5875, 1e-12) << cut << lead;
    }
  }
  EXPECT_EQ(lathe_notes("G0 X12 Z2\nG32 Z-10. E1.5\n"), "thread-lead");
}

// F is one word for feeds and leads: what it last said counts for a thread without it.
TEST(LatheHabits, TheLeadOfAThreadIsTheFInForce) {
  const auto leads = [](const std::string& text) {
    std::string out;
    const Program p = on_lathe("G99 G97 S500 M3\nG0 X30 Z2\n" + text);
    for (const Motion& m : p.motions)
      if (m.kind != MotionKind::rapid)
        out += m.lead != 0 ? fmt::format("t{:g} ", m.lead) : fmt::format("f{:g} ", m.feed);
    return out + codes(p);
  };
  EXPECT_EQ(leads("F1.5\nG92 X28 Z-9\n"), "t1.5 ");
  EXPECT_EQ(leads("G92 X28 Z-9 F1.5\nG0 X30 Z5\nG92 X27 Z-9\nX26\n"), "t1.5 t1.5 t1.5 ");
  EXPECT_EQ(leads("G32 Z-9 F1.5\nX40\nG1 X50 F.2\nG32 Z-12\n"), "t1.5 t1.5 f0.2 t0.2 ");
  EXPECT_EQ(leads("F2.\nG76 P010000 Q50 R0\nG76 X28 Z-9 P500 Q900\n"), "t2 ");
  EXPECT_EQ(leads("G32 Z-9 F1.5\nG1 X40\n"), "t1.5 f1.5 ");
  EXPECT_EQ(leads("G98 G1 X29 F100\nG92 X28 Z-9\n"), "f100 thread-lead");
  EXPECT_EQ(leads("G98 G1 X29 F100\nG99 G92 X28 Z-9\n"), "f100 thread-lead");
  EXPECT_EQ(leads("G76 P010000 Q50 R0\nG76 X28 Z-9 P500 Q900 F2\nG1 X27\nG92 X26 Z-9\n"),
            "t2 f2 t2 ");
  EXPECT_EQ(leads("G1 X29 F.2\nG32 Z-9 E1.5\nX40\n"), "f0.2 t1.5 t1.5 ");
}

// X, Z and R are common to G90, G92 and G94 until another motion word ends the cycle.
TEST(LatheHabits, OneTurningCycleAfterAnotherKeepsItsEnd) {
  EXPECT_EQ(lathe_moves("G0 X40 Z2\nG90 X36 Z-10 F.2\nG94 Z-11\n"),
            "r20,0,2 r18,0,2 l18,0,-10 l20,0,-10 r20,0,2 r20,0,-11 l18,0,-11 l18,0,2 r20,0,2");
  EXPECT_EQ(lathe_moves("G0 X40 Z2\nG90 X36 Z-10 R-1 F.2\nG92 X35 F1.5\n"),
            "r20,0,2 r17,0,2 l18,0,-10 l20,0,-10 r20,0,2 r16.5,0,2 l17.5,0,-10 r20,0,-10 r20,0,2 | "
            "cycle-taper | cycle-taper");
  EXPECT_EQ(lathe_moves("G0 X40 Z2\nG90 X36 Z-10 R-1 F.2\nG0 X40\nG94 X35 Z-11 F.2\n"),
            "r20,0,2 r17,0,2 l18,0,-10 l20,0,-10 r20,0,2 r20,0,-11 l17.5,0,-11 l17.5,0,2 r20,0,2");
}

// Of the table without tools: T0 ends the offset, the turret stays.
// A stop is looked for by increments, and by the axis of a sub-spindle, which is told of once.
TEST(LatheHabits, ProbingMovesByIncrements) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  for (const char* probe : {"G98 G31 W-20. F200\n", "G31 U-2. F50\n"})
    EXPECT_EQ(codes(read_text(std::string(probe) + "G0 X50. Z2.\nG1 X40. F.1\n", options)), "")
        << probe;
  EXPECT_EQ(codes(read_text("G31 B-350. F500\n", options)), "not-supported");
  EXPECT_EQ(codes(read_text("G31 F500\n", options)), "motion-missing");
}

TEST(LatheHabits, TZeroChangesNoTool) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools.clear();
  const Program p =
      read_text("T0101\nG0 X20 Z0\nG1 X10 F.1\nG0 X50 T0\nT0000\nG1 X40\nT0202\nX10\n", options);
  ASSERT_EQ(p.tools.size(), 2U);
  EXPECT_EQ(p.tools[0].id + p.tools[1].id, "12");
}

// A bar stop runs to X0 Z1 with the feed, a bar puller 8 mm along the bar and back with it.
TEST(LatheHabits, BarStopsAndPullersCutNothing) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools.clear();
  const std::string work =
      "G0 X0 Z5\nG1 Z1 F2\nG0 Z50\nT0101 (CNMG 120408)\nG0 X20 Z0\nG1 X0 F.1\n";
  for (const char* tool :
       {"BAR STOP", "STOPPER", "BAR PULLER", "STANGENGREIFER", "ANSCHLAG", "TOPE", "BAR FEED"}) {
    const Program p = read_text("(T0909 " + std::string(tool) + ")\nT0909\n" + work, options);
    EXPECT_EQ(path_text(p), "r0,0,5 r0,0,1 r0,0,50 r10,0,0 l0,0,0") << tool;
    EXPECT_EQ(codes(p, Severity::note), "tool-touches tool-inferred") << tool;
    EXPECT_EQ(p.motions[1].tool, -1);
  }
  options.dialect = Dialect::sinumerik;
  EXPECT_EQ(codes(read_text("T=\"BAR_STOP\" D1\nG95\nG0 X0 Z5\nG1 Z1 F2\nT=\"BUTTON_8\" D1\n"
                            "G0 X20 Z0\nG1 X0 F.1\n",
                            options)),
            "tool-unknown");
  options.dialect = Dialect::fanuc;
  // A comment that speaks of one names no tool: the next tool cuts.
  EXPECT_EQ(path_text(read_text("(USES BAR PULLER)\n" + work.substr(work.find("T0101")), options)),
            "r10,0,0 l0,0,0");
  EXPECT_EQ(codes(read_text("(NOW BAR STOP GOES BACK)\nT0303\nG0 X9 Z5\nG1 Z1 F2\n", options),
                  Severity::note),
            "tool-inferred");
  EXPECT_EQ(codes(read_text("(N3 BAR STOP)\nT0303\nG0 X0 Z5\nG1 Z1 F2\n" + work, options),
                  Severity::note),
            "tool-touches tool-inferred");
  // With a second trade, and in the tool table, it may cut.
  EXPECT_EQ(codes(read_text("T0909 (BAR STOP AND CENTER DRILL 3MM)\n" + work, options)),
            "tool-unknown");
  EXPECT_EQ(codes(read_text("(T0909 BAR STOP)\nT0909\n" + work,
                            [&] {
                              InterpOptions table = options;
                              Tool drill;
                              drill.id = "9";
                              drill.type = ToolType::drill;
                              drill.diameter = 10;
                              table.table.tools.push_back(drill);
                              return table;
                            }()),
                  Severity::note),
            "tool-inferred");
}

// Turrets without geometry offsets: each tool's G50 says where its tip is at the index place, where
// T1's is at (100, 75) and T3's 10 mm farther out in Z.
TEST(LatheHabits, EachToolsG50SaysWhereItsTipIs) {
  const std::string head = "G50 X200 Z150\nT0100\nG0 X50 Z2\nG1 Z-20 F.2\nG0 X200 Z150 T0100\n";
  const std::string tail = "G0 X40 Z2\nG1 Z-10\n";
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.start.reset();
  for (const std::string& change :
       {std::string("G50 X200 Z160\nT0300\n"), std::string("T0300\nG50 X200 Z160\n"),
        std::string("G50 X200 Z160 T0300\n"), std::string("G50 X200 Z160 S1500\nM8\nT0300 M3\n")}) {
    const Program p = read_text(head + change + tail, options);
    EXPECT_EQ(path_text(p), "r25,0,2 l25,0,-20 r100,0,150 r20,0,2 l20,0,-10") << change;
    EXPECT_NE(codes(p, Severity::note).find("touch-off"), std::string::npos) << change;
  }
  // Of the same tool it shifts the zero, as for the next part of the bar.
  EXPECT_EQ(path_text(read_text(head + "G50 X200 Z160\n" + tail, options)),
            "r25,0,2 l25,0,-20 r100,0,150 r20,0,-8 l20,0,-20");
  EXPECT_EQ(path_text(read_text(head + "G50 X200 Z160\nG0 X180\nT0300\n" + tail, options)),
            "r25,0,2 l25,0,-20 r100,0,150 r90,0,150 r20,0,-8 l20,0,-20")
      << "a move lies between";
}

// G71 U2000 R500 is 2 mm deep and goes 0.5 aside, U400 W100 leave 0.2 and 0.1.
TEST(LatheHabits, LongDepthsOfRoughingCountThousandths) {
  const std::string contour = "N1 G0 X30\nG1 Z-10\nN2 X40\n";
  const std::string start = "G0 X40 Z1\nG1 F.2\n";
  const Program p = on_lathe(start + "G71 U2000 R500\nG71 P1 Q2 U400 W100\n" + contour);
  EXPECT_EQ(path_text(p),
            path_text(on_lathe(start + "G71 U2. R.5\nG71 P1 Q2 U.4 W.1\n" + contour)));
  EXPECT_EQ(codes(p, Severity::note), "number-without-point");
  const std::string faces = "N1 G0 Z-5\nG1 X20\nN2 Z1\n";
  EXPECT_EQ(path_text(on_lathe(start + "G72 W1000 R200\nG72 P1 Q2 U60 W40\n" + faces)),
            path_text(on_lathe(start + "G72 W1. R.2\nG72 P1 Q2 U.06 W.04\n" + faces)))
      << "what counts in the first line counts in the second";
  EXPECT_EQ(path_text(on_lathe(start + "G71 P1 Q2 U400 W100 D2000\n" + contour)),
            path_text(on_lathe(start + "G71 P1 Q2 U.4 W.1 D2.\n" + contour)));
  EXPECT_EQ(path_text(on_lathe(start + "G73 U5000 W2000 R2\nG73 P1 Q2 U400 W0\n" + contour)),
            path_text(on_lathe(start + "G73 U5. W2. R2\nG73 P1 Q2 U.4 W0\n" + contour)));
  EXPECT_EQ(lathe_notes(start + "G71 U2 R1\nG71 P1 Q2 U1 W0\n" + contour), "")
      << "short ones are millimetres";
}

// A quarter of a circle about (25, -20) from (20, -20): the straight line was run.
TEST(LatheHabits, RadiiOfOkumaStandBehindL) {
  const Program p = on_lathe("G0 X40 Z-20\nG2 X50 Z-25 L5 F.2\n");
  ASSERT_EQ(p.motions.size(), 2U);
  EXPECT_EQ(p.motions[1].kind, MotionKind::arc);
  expect_near(p.motions[1].center, {25, 0, -20}, 1e-9);
  EXPECT_EQ(codes(p, Severity::note), "okuma-radius");
  EXPECT_EQ(codes(on_lathe("G0 X40 Z-20\nG2 X50 Z-25 R5 L5 F.2\n")), "not-supported");
}

TEST(LatheHabits, BlocksOfOkumaHaveNames) {
  const InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  const Program p = read_text("NAT01 G0 X40. Z2.\nNA1 (NEXT)\nG1 Z-5. F.2\n", options);
  EXPECT_EQ(path_text(p), "r20,0,2 l20,0,-5");
  EXPECT_EQ(codes(p, Severity::note), "block-name");
  for (const char* block :
       {"G1 X40. NAT01\n", "N1 NAT01 G1 X40.\n", "NMUCHTOOLONG G1 X40.\n", "GOTO NAT01\nG1 X40.\n"})
    EXPECT_NE(codes(read_text(block, options), Severity::error), "") << block;
}

TEST(LatheHabits, OnlyTheFirstTurretAndSpindleOfOkumaAreRead) {
  EXPECT_EQ(lathe_moves("G13\nG140\nG0 X20 Z0\nG1 X10 F.1\n"), "r10,0,0 l5,0,0");
  EXPECT_EQ(codes(on_lathe("G14\nG0 X20\nG1 X10 F.1\n")), "not-supported");
  EXPECT_EQ(codes(on_lathe("G141\nG0 X20\nG1 X10 F.1\n")), "not-supported");
}

// Mitsubishi: the least speed, and whether there are pockets; Mazak: which spindle.
TEST(LatheHabits, WordsBesideSpeedsAndRoughingAreReadOver) {
  EXPECT_EQ(lathe_notes("G92 S2500 Q500\nG50 S2000 R1\nG0 X40 Z1\nG71 U2. R1. H0\n"
                        "G71 P1 Q2 U.4 W.1 F.2\nN1 G0 X30\nG1 Z-10\nN2 X40\n"),
            "");
}

TEST(LatheHabits, LeadsOfFagorStandBehindL) {
  const Program p = on_lathe("G0 X20 Z5\nG33 Z-20 L1.5 Q0\n", Dialect::iso);
  ASSERT_EQ(p.motions.size(), 2U);
  EXPECT_EQ(p.motions[1].lead, 1.5);
}

// D of G96 is the highest speed, not the tool of G42: that in the spindle counts.
TEST(LatheHabits, TheSpeedLimitOfG96IsNoRegister) {
  InterpOptions options = at_origin(Dialect::ngc, MachineKind::lathe);
  options.comp = CompRadius::automatic;
  options.table.tools[0].id = "1";
  options.table.tools[0].nose_radius = 0.4;
  options.table.tools[0].tip = 3;
  const Program p = read_text(
      "G7 G18 G40\nT1 M6\nG96 D2500 S200\nG95 F.2\nG0 X30 Z5\nG42 G1 X20 Z2\nZ-10\nG40 X40\nM2\n",
      options);
  EXPECT_EQ(codes(p), "");
}

// Which corner of the blade offset 13 is for, no program tells.
TEST(LatheHabits, ASecondOffsetOfABladeIsToldOf) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools.clear();
  const std::string cut = "G0 X54 Z-20\nG1 X40 F.1\nG0 X54\n";
  const std::string blade = "T0303 (GROOVE 3MM)\n", insert = "T0101 (CNMG 120408)\n";
  EXPECT_EQ(codes(read_text(blade + cut + "T0313\n" + cut, options)), "second-offset");
  EXPECT_EQ(codes(read_text(blade + cut + "T0300\nT0303\n" + cut, options)), "");
  EXPECT_EQ(codes(read_text(insert + cut + "T0111\n" + cut, options)), "") << "a wear";
  Tool right;
  right.id = "313";
  right.type = ToolType::grooving;
  right.width = 3;
  right.tip = 4;
  options.table.tools.push_back(right);
  const Program told = read_text(blade + cut + "T0313\n" + cut, options);
  EXPECT_EQ(codes(told), "");
  ASSERT_EQ(told.tools.size(), 2U);
  EXPECT_EQ(told.tools[1].tip, 4);
}

TEST(LatheHabits, ASecondEdgeOfABladeIsToldOf) {
  InterpOptions options = at_origin(Dialect::sinumerik, MachineKind::lathe);
  options.table.tools.clear();
  const std::string cut = "G0 X54 Z-20\nG1 X40 F0.1\nG0 X54\n";
  const auto run = [&](const std::string& tool, const std::string& next) {
    return read_text("G18 G90 G95 DIAMON\nT=\"" + tool + "\" D1\n" + cut + next + cut, options);
  };
  EXPECT_EQ(codes(run("STECHER_3", "D2\n")), "second-offset");
  EXPECT_EQ(codes(run("STECHER_3", "T=\"STECHER_3\" D2\n")), "second-offset");
  EXPECT_EQ(codes(run("STECHER_3", "D0\nD1\n")), "");
  EXPECT_EQ(codes(run("ROUGHING_T80_A", "D2\n")), "") << "a wear";
  Tool right;
  right.id = "STECHER_3.D2";
  right.type = ToolType::grooving;
  right.width = 3;
  right.tip = 4;
  options.table.tools.push_back(right);
  const Program told = run("STECHER_3", "D2\nG0 Z-10\nG1 X50\nD1\n");
  EXPECT_EQ(codes(told), "");
  ASSERT_EQ(told.tools.size(), 2U);
  EXPECT_EQ(told.tools[1].tip, 4);
  EXPECT_EQ(told.motions[4].tool, 1);
  EXPECT_EQ(told.motions.back().tool, 0);
}

// G20 is a cycle there, and was a rapid in inches; G20 beside a motion word is the unit.
TEST(LatheHabits, CyclesOfCodeSystemCAreRefused) {
  EXPECT_EQ(codes(on_lathe("G0 X52. Z2.\nG20 X46. Z-30. F.25\nX42.\n")), "not-supported");
  EXPECT_EQ(codes(on_lathe("G0 X44. Z2.\nG21 X39. Z-25. F1.5\n")), "not-supported");
  EXPECT_EQ(codes(on_lathe("G20 G1 X1. Z-1. F.01\nG21 G99 G40\nG1 X20. Z-20.\n")), "");
}

TEST(LatheHabits, TheBarFeederOfHaasMovesNoTool) {
  EXPECT_EQ(lathe_moves("G105 J2. K1. R.1\nG0 X40 Z2\nG1 Z0 F.1\n"), "r20,0,2 l20,0,0");
  EXPECT_EQ(lathe_notes("G105 P100\nG0 X40 Z2\nG1 Z0 F.1\n"), "not-supported");
}

TEST(LatheHabits, G95WithRIsACycleOfHaas) {
  EXPECT_EQ(lathe_notes("G0 X40 Z2\nG95 Z-5. R1. F1.\n"), "not-supported");
  EXPECT_EQ(lathe_moves("G0 X40 Z2\nG95 Z1. F.1\nG1 Z0\n"), "r20,0,2 r20,0,1 l20,0,0");
}

TEST(LatheHabits, G29LeavesTheReferencePoint) {
  EXPECT_EQ(lathe_moves("G1 X40 Z2 F.2\nG28 U4. W3.\nG29 X30. W-1.\nG1 Z0\n"),
            "l20,0,2 r22,0,5 r15,0,4 l15,0,0");
}

// "G28 U0;" and "W0;" in a block of its own: nothing moves, and Z stays unknown.
TEST(LatheHabits, AnIncrementOfZeroMovesNothing) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.start.reset();
  const Program p = read_text("G28 U0\nW0\nG0 X40\nZ2\nG1 X20 F.1\n", options);
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.motions.size(), 3U);
  EXPECT_TRUE(p.motions[1].assumed_start);
}

// On the far side of the axis: the cuts are those of the same program with X above 0, arcs turn the
// other way, and G41 is G42.
TEST(LatheHabits, XBelowZeroIsTheOtherSideOfTheAxis) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools[0].nose_radius = 0.8;
  const auto run = [&](const std::string& text) { return read_text(text, options); };
  const std::string contour_above =
      "G71 U2. R1.\nG71 P1 Q2 U.4 W.1 F.2\nN1 G1 X20.\nZ-10.\nG2 X30. Z-15. R5.\nN2 G1 X52.\nG70 "
      "P1 Q2\n";
  const std::string contour_below =
      "G71 U2. R1.\nG71 P1 Q2 U-.4 W.1 F.2\nN1 G1 X-20.\nZ-10.\nG3 X-30. Z-15. R5.\nN2 G1 "
      "X-52.\nG70 P1 Q2\n";
  const Program above = run("G0 X52. Z0\nG1 X-1.6 F.2\nG0 Z2.\nX52.\n" + contour_above);
  const Program below = run("G0 X-52. Z0\nG1 X1.6 F.2\nG0 Z2.\nX-52.\n" + contour_below);
  EXPECT_EQ(path_text(below), path_text(above));
  EXPECT_EQ(codes(above, Severity::note), "");
  EXPECT_EQ(codes(below, Severity::note), "x-below-zero");
  ASSERT_EQ(above.motions.size(), below.motions.size());
  for (std::size_t i = 0; i < above.motions.size(); ++i)
    EXPECT_NEAR(above.motions[i].sweep, below.motions[i].sweep, 1e-9);
  EXPECT_EQ(path_text(run("G0 X-40. Z2.\nG41 G1 X-20. Z0 F.2\nX-30. Z-10.\nG40 X-50.\n")),
            path_text(run("G0 X40. Z2.\nG42 G1 X20. Z0 F.2\nX30. Z-10.\nG40 X50.\n")));
  // The next tool starts where this one was left.
  const Program two = run("T0101\nG0 X-40. Z2.\nG1 Z-5. F.2\nG0 X-60. Z9.\nT0202\nX-40. Z2.\n");
  EXPECT_EQ(two.motions.back().start.x, 30);
  EXPECT_EQ(two.motions.back().end.x, 20);
  // Back to the near side; and a tip that is given is that of the far side.
  EXPECT_EQ(path_text(run("G0 X-40. Z2.\nG1 Z-5. F.2\nG0 X60. Z9.\nX30.\n")),
            "r20,0,2 l20,0,-5 r30,0,9 r15,0,9");
  options.table.tools[0].tip = 2;
  EXPECT_EQ(path_text(run("G0 X-40. Z2.\nG1 Z-5. F.2\n")), "r-20,0,2 l-20,0,-5");
}

TEST(LatheHabits, WidthsAsOfBladesAreAskedFor) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools.clear();
  const auto told = [&](const std::string& comment) {
    return codes(read_text("T0303 (" + comment + ")\nG0 X30. Z2.\nG1 Z-5. F.1\nX32.\n", options));
  };
  for (const char* blade : {"LAMA 3MM", "Corte 2.5 mm", "KNIFE 6MM"})
    EXPECT_EQ(told(blade), "tool-unknown") << blade;
  for (const char* other : {"KNIFE 20MM", "OP 2 5MM", "SIDE 2", "CNMG 120408 3MM"})
    EXPECT_EQ(told(other), "") << other;
}

// The insert that tools without data are taken to have bored through the part.
TEST(LatheHabits, DrillsWithoutDataAreAskedFor) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools.clear();
  for (const char* hole : {"G1 Z-20. F.1\nG0 Z2.\n", "G83 Z-20. Q5000 R0 F.1\nG80\n",
                           "G74 R.5\nG74 Z-20. Q5000 F.1\n", "G1 Z-20. F.1\nZ2. F1.\n"}) {
    const Program p = read_text("T0303 (DRLL)\nG0 X0 Z2.\n" + std::string(hole), options);
    EXPECT_EQ(codes(p), "tool-unknown") << hole;
    EXPECT_EQ(p.diagnostics.back().place.line, 1);
  }
  EXPECT_EQ(codes(read_text("T0303\nG0 X0 Z2.\nG1 Z0 F.1\nG3 X20. Z-10. R10.\nG1 Z-20.\nG0 X30.\n",
                            options)),
            "")
      << "the way to the tip of a ball";
  EXPECT_EQ(codes(read_text("T0303 (DRILL 8MM)\nG0 X0 Z2.\nG1 Z-20. F.1\nG0 Z2.\n", options)), "");
}

// "COATED CARBIDE" is no Carbide Create, and "MACH: LB3000" no Mach3.
TEST(LatheHabits, WordsOfToolsNameNoControl) {
  const std::string text =
      "(MACH : LB3000)\n(CNMG432 COATED CARBIDE)\nG20\nG50 S3800\nN1 T0101\nG96 S150 M3\n"
      "G0 X.62 Z.1\nG1 Z-1. F.01\nM2\n";
  EXPECT_EQ(read_text(text, {}).dialect, Dialect::fanuc);
}

// Couplings of spindles and other axes do nothing to the part.
TEST(LatheHabits, SpindlesOfSinumerikChangeOver) {
  EXPECT_EQ(codes(on_lathe("G0 X40 Z2\nG1 X20 F0.2\nCOUPDEF(S3,S1,1,1,\"FINE\")\nCOUPON(S3,S1)\n"
                           "POS[Z3]=-200 FA[Z3]=1000\nPOSA[Q1]=0\nFXS[Z3]=1\nCOUPOF(S3,S1)\nM30\n",
                           Dialect::sinumerik),
                  Severity::note),
            "");
  EXPECT_EQ(codes(on_lathe("POS[Z]=-200\nM30\n", Dialect::sinumerik)).substr(0, 13),
            "not-supported");
}

}  // namespace
}  // namespace mrsim
