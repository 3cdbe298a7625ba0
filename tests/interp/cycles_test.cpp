// Drilling, tapping and boring cycles against the pictures of the controls' manuals.
#include "core/numbers/vec.h"
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// "r X Y Z" for a rapid, "l X Y Z" for a line, to the end of each motion.
std::string ends(const Program& program) {
  std::string out;
  for (const Motion& m : program.motions) {
    char text[80];
    std::snprintf(text, sizeof text, "%c%g,%g,%g ", m.kind == MotionKind::rapid ? 'r' : 'l',
                  m.end.x + 0.0, m.end.y + 0.0, m.end.z + 0.0);
    out += text;
  }
  if (!out.empty()) out.pop_back();
  return out;
}

std::string run(Dialect dialect, const std::string& text) {
  const Program p = read_text(text, at_origin(dialect));
  return ends(p) + (codes(p).empty() ? "" : " | " + codes(p));
}

TEST(Cycles, FanucG81ReturnsToTheLevelOfG98OrG99) {
  EXPECT_EQ(run(Dialect::fanuc, "G0 Z50\nG98 G81 X10 Y0 Z-5 R2 F100\nX20\nG99 X30\nX40\nG80\nX0\n"),
            "r0,0,50 r10,0,50 r10,0,2 l10,0,-5 r10,0,50 r20,0,50 r20,0,2 l20,0,-5 r20,0,50 "
            "r30,0,50 r30,0,2 l30,0,-5 r30,0,2 r40,0,2 l40,0,-5 r40,0,2 r0,0,2");
}

TEST(Cycles, IncrementalLevelsRepeatAtEachHole) {
  // R from the initial level, Z from R; K3 makes three holes 10 apart.
  EXPECT_EQ(run(Dialect::fanuc, "G0 Z20\nG91 G99 G81 X10 Z-7 R-18 K3 F100\n"),
            "r0,0,20 r10,0,20 r10,0,2 l10,0,-5 r10,0,2 r20,0,2 l20,0,-5 r20,0,2 r30,0,2 l30,0,-5 "
            "r30,0,2");
  EXPECT_EQ(run(Dialect::iso, "G0 Z20\nG91 G99 G81 X10 Z-7 R-18 L0 F100\nG90 G1 X5\n"),
            "r0,0,20 l5,0,20 | cycle-not-run");
}

TEST(Cycles, PecksRetractFullyOrBreakChips) {
  EXPECT_EQ(run(Dialect::fanuc, "G0 Z5\nG83 Z-5 R1 Q2.5 F100\n"),
            "r0,0,5 r0,0,1 l0,0,-1.5 r0,0,1 r0,0,-1.246 l0,0,-4 r0,0,1 r0,0,-3.746 l0,0,-5 r0,0,5");
  EXPECT_EQ(run(Dialect::fanuc, "G0 Z5\nG73 Z-5 R1 Q3 F100\n"),
            "r0,0,5 r0,0,1 l0,0,-2 r0,0,-1.746 l0,0,-5 r0,0,5");
  // Haas: first stroke I, each next one J less, at least K.
  // They hold for the holes that follow, also those of a cycle stored with L0.
  EXPECT_EQ(run(Dialect::fanuc, "G0 Z5\nG83 G99 Z-10 R1 I4 J1 K2 F100 L0\nX5\n"),
            "r0,0,5 r5,0,5 r5,0,1 l5,0,-3 r5,0,1 r5,0,-2.746 l5,0,-6 r5,0,1 r5,0,-5.746 l5,0,-8 "
            "r5,0,1 r5,0,-7.746 l5,0,-10 r5,0,1");
  EXPECT_EQ(run(Dialect::fanuc, "G0 Z5\nG73 Z-6 R0 I3 J1 K1.5 F100\n"),
            "r0,0,5 r0,0,0 l0,0,-3 r0,0,-2.746 l0,0,-5 r0,0,-4.746 l0,0,-6 r0,0,5");
}

TEST(Cycles, EachCycleHasItsWayOut) {
  for (const char* g : {"G84", "G85", "G89", "G74"})
    EXPECT_EQ(run(Dialect::fanuc, std::string("G0 Z5\nS100 M3\n") + g + " Z-5 R1 F100\n"),
              "r0,0,5 r0,0,1 l0,0,-5 l0,0,1 r0,0,5")
        << g;
  for (const char* g : {"G81", "G82", "G86", "G88", "G76"})
    EXPECT_EQ(run(Dialect::fanuc, std::string("G0 Z5\n") + g + " Z-5 R1 P100 Q0.1 F100\n"),
              "r0,0,5 r0,0,1 l0,0,-5 r0,0,5")
        << g;
  EXPECT_EQ(path_text(read_text("G0 Z5\nG87 X2 Z-5 R1 F100\nX4\n", at_origin(Dialect::fanuc))),
            path_text(read_text("G0 Z5\nG88 X2 Z-5 R1 F100\nX4\n", at_origin(Dialect::fanuc))))
      << "of Haas: a bore, out by hand";
  EXPECT_EQ(path_text(read_text("G0 Z5\nG83 Z-5 R1 Q-2. F100\n", at_origin(Dialect::fanuc))),
            path_text(read_text("G0 Z5\nG83 Z-5 R1 Q2. F100\n", at_origin(Dialect::fanuc))));
  EXPECT_EQ(codes(read_text("G0 Z5\nG87 Z-5 R1 Q.5 F100\n", at_origin(Dialect::fanuc))),
            "not-supported");
  EXPECT_EQ(codes(read_text("G0 Z5\nG87 Z-5 R-8 F100\n", at_origin(Dialect::fanuc))),
            "not-supported");
}

TEST(Cycles, TappingHasItsLead) {
  const Program p =
      read_text("G0 Z5\nS500 M3\nG84 Z-5 R1 F625\nG74 X5 Z-5 R1 F625\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(p.motions.size(), 10U);
  EXPECT_DOUBLE_EQ(p.motions[2].lead, 1.25);
  EXPECT_DOUBLE_EQ(p.motions[7].lead, -1.25);
  EXPECT_EQ(p.motions[1].lead, 0);
}

// Along Z from X0, R counted from the start; along X from the side. Ends are radii.
TEST(Cycles, LathesDrillAlongZOrX) {
  const auto turned = [](const std::string& text) {
    const Program p = read_text(text, at_origin(Dialect::fanuc, MachineKind::lathe));
    return ends(p) + (codes(p).empty() ? "" : " | " + codes(p));
  };
  EXPECT_EQ(turned("G0 X0 Z5.\nG83 Z-8. R-3. Q5000 F.1\nG80\nG0 Z10.\n"),
            "r0,0,5 r0,0,2 l0,0,-3 r0,0,2 r0,0,-2.746 l0,0,-8 r0,0,5 r0,0,10");
  EXPECT_EQ(turned("G0 X0 Z5.\nG83 W-10. R-3. F.1\n"),
            "r0,0,5 r0,0,2 l0,0,-8 r0,0,5 | value-missing")
      << "no Q";
  EXPECT_EQ(turned("G0 X0 Z5.\nG81 Z-8. R1. F.1\nG80\nG85 Z-9. R-4. F.2\n"),
            "r0,0,5 r0,0,1 l0,0,-8 r0,0,5 r0,0,1 l0,0,-9 l0,0,1 r0,0,5")
      << "R above 0 is a level";
  EXPECT_EQ(turned("G0 X52. Z-10.\nG87 X40. R-1. Q3000 F100.\nZ-20.\n"),
            "r26,0,-10 r25,0,-10 l22,0,-10 r25,0,-10 r22.254,0,-10 l20,0,-10 r26,0,-10 r26,0,-20 "
            "r25,0,-20 l22,0,-20 r25,0,-20 r22.254,0,-20 l20,0,-20 r26,0,-20");
}

TEST(Cycles, CyclesDrillAcrossThePlaneInForce) {
  EXPECT_EQ(run(Dialect::fanuc, "G0 X5 Y20\nG18 G81 X10 Z3 Y-5 R2 F100\nG80\n"),
            "r5,20,0 r10,20,3 r10,2,3 l10,-5,3 r10,20,3");
  EXPECT_EQ(run(Dialect::fanuc, "G0 X20\nG19 G81 Y10 Z3 X-5 R2 F100\nG80\n"),
            "r20,0,0 r20,10,3 r2,10,3 l-5,10,3 r20,10,3");
}

TEST(Cycles, EachMotionNamesTheCycleCalledFromThePoint) {
  const Program p = read_text("G0 Z5\nG81 X1 Z-5 R1 F100\nX2\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(p.motions.size(), 9U);
  EXPECT_EQ(p.motions[3].line, 2);
  EXPECT_EQ(p.motions[3].call, -1);
  EXPECT_EQ(p.motions[5].line, 3);  // to the point
  EXPECT_EQ(p.motions[7].line, 2);
  ASSERT_GE(p.motions[7].call, 0);
  EXPECT_EQ(p.calls[static_cast<std::size_t>(p.motions[7].call)].line, 3);
}

TEST(Cycles, LinuxCncLeavesTheWorkFirst) {
  // Its manual: below R the tool rises to R before it goes aside; G98 returns to R then.
  EXPECT_EQ(run(Dialect::ngc, "G0 Z1\nG98 G81 X4 Y5 Z-3 R2.8 F100\n"),
            "r0,0,1 r0,0,2.8 r4,5,2.8 l4,5,-3 r4,5,2.8");
  // G91 G81 G98 X4 Y5 Z-0.6 R1.8 L3 from X1 Y2 Z3, as in its manual.
  EXPECT_EQ(run(Dialect::ngc, "G0 X1 Y2 Z3\nG91 G81 G98 X4 Y5 Z-0.6 R1.8 L3 F100\n"),
            "r1,2,3 r1,2,4.8 r5,7,4.8 l5,7,4.2 r5,7,4.8 r9,12,4.8 l9,12,4.2 r9,12,4.8 "
            "r13,17,4.8 l13,17,4.2 r13,17,4.8");
  // R of G91 counts from the level before the first cycle, however often the cycle is written.
  EXPECT_EQ(
      run(Dialect::ngc, "G0 Z0.25\nG91 G99 G81 X1 Z-1 R0.25 F100\nG91 G99 G81 X1 Z-1 R0.25\n"),
      "r0,0,0.25 r0,0,0.5 r1,0,0.5 l1,0,-0.5 r1,0,0.5 r2,0,0.5 l2,0,-0.5 r2,0,0.5");
  EXPECT_EQ(codes(read_text("G0 Z5\nG81 X1 Z3 R2 F100\n", at_origin(Dialect::ngc))), "value-range");
  EXPECT_EQ(codes(read_text("G0 Z5\nG83 X1 Z-3 R2 F100\n", at_origin(Dialect::ngc))),
            "value-missing");
}

TEST(Cycles, McallDrillsAtEachPlace) {
  const auto s = Dialect::sinumerik;
  EXPECT_EQ(run(s, "G0 X10 Y5 Z40\nF100\nCYCLE81(30,0,2,-15)\n"),
            "r10,5,40 r10,5,2 l10,5,-15 r10,5,30");
  EXPECT_EQ(run(s, "G0 Z40\nF100\nMCALL CYCLE82(30,0,2,,15,0.5)\nX10\nX20 Y5\nMCALL\nX0 Y0\n"),
            "r0,0,40 r10,0,40 r10,0,2 l10,0,-15 r10,0,30 r20,5,30 r20,5,2 l20,5,-15 r20,5,30 "
            "r0,0,30");
  EXPECT_EQ(run(s, "G0 Z40\nF100\nMCALL CYCLE81(30,0,2,-5)\nHOLES1(10,0,0,0,5,2)\nMCALL\n"),
            "r0,0,40 r10,0,40 r10,0,2 l10,0,-5 r10,0,30 r15,0,30 r15,0,2 l15,0,-5 r15,0,30");
  EXPECT_EQ(run(s, "G0 X20 Z9\nF100\nMCALL CYCLE81(9,0,2,-5)\nHOLES1(10,0,0,0,5,2)\nMCALL\n"),
            "r20,0,9 r15,0,9 r15,0,2 l15,0,-5 r15,0,9 r10,0,9 r10,0,2 l10,0,-5 r10,0,9")
      << "a row begins at its nearer end";
  EXPECT_EQ(run(s, "G0 Z9\nF100\nMCALL CYCLE81(9,0,2,-5,,,0,1,11)\nHOLES2(0,0,10,90,0,2)\n"),
            "r0,0,9 r0,10,9 r0,10,2 l0,10,-5 r0,10,9 r0,-10,9 r0,-10,2 l0,-10,-5 r0,-10,9")
      << "AMODE 1: the value in DP is incremental";
  const auto on_circle = [&](const std::string& last) {
    return run(s, "G0 Z9\nHOLES2(0,0,10,0," + last + ")\nG1 X0 Y0 F9\n");
  };
  EXPECT_EQ(run(s, "G0 Z9\nHOLES2(0,0,-10,90,0,2)\n"), "r0,0,9 | value-range");
  EXPECT_EQ(on_circle("90,2,2010"), "r0,0,9 r10,0,9 r0,10,9 l0,0,9");
  EXPECT_EQ(on_circle("90,2,1010"), "r0,0,9 r10,0,9 r-10,0,9 l0,0,9 | pattern-full-circle");
  EXPECT_EQ(on_circle("180,2,1010"), "r0,0,9 r10,0,9 r-10,0,9 l0,0,9");
}

TEST(Cycles, Cycle83DrillsInStrokes) {
  const auto s = Dialect::sinumerik;
  // First depth 5, each next one 1 less, chips out.
  EXPECT_EQ(run(s, "G0 Z5\nF100\nCYCLE83(5,0,1,-12,,-5,,1,0,0,1,1)\n"),
            "r0,0,5 r0,0,1 l0,0,-5 r0,0,1 r0,0,-4.746 l0,0,-9 r0,0,1 r0,0,-8.746 l0,0,-12 r0,0,5");
  // Chip breaking: 1 mm back.
  // By AMODE in percent, 4 2 1, and the first stroke from RFP.
  EXPECT_EQ(run(s, "G0 Z15\nF100\nCYCLE83(15,10,1,2.5,,4,,50,0,0,90,1,0,0.5,1,0,1,0,1,11211112)\n"),
            "r0,0,15 r0,0,11 l0,0,6 r0,0,11 r0,0,7 l0,0,4 r0,0,11 r0,0,5 l0,0,3 r0,0,11 r0,0,4 "
            "l0,0,2.5 r0,0,15");
  EXPECT_EQ(run(s, "G0 Z5\nF100\nCYCLE83(5,0,1,-8,,,5,0,0,0,1,0)\n"),
            "r0,0,5 r0,0,1 l0,0,-5 r0,0,-4 l0,0,-8 r0,0,5");
}

// The tens of GMODE: the diameter of a centring, the end of the full diameter of a hole; a point of
// 90 degrees is as long as its radius. AMODE 2 of all of them: DP counts, not DPR.
// FDEP above RFP stops the control (alarm 61107). Beyond DP the manual drills in one stroke.
TEST(Cycles, FirstDepthOfCycle83LiesBetweenRfpAndDp) {
  const auto found = [](const std::string& values) {
    return codes(read_text("G0 Z5\nF100\nCYCLE83(10,0,2,-15,," + values + ",0,0,0,1,0)\n",
                           at_origin(Dialect::sinumerik)));
  };
  EXPECT_EQ(found("-5,"), "");
  EXPECT_EQ(found("-15,"), "");
  EXPECT_EQ(found(",5"), "");
  EXPECT_EQ(found(",20"), "") << "a length";
  EXPECT_EQ(found("1,"), "value-range");
  EXPECT_EQ(found("0,"), "value-range");
  EXPECT_EQ(found("-20,"), "cycle-first-depth");
}

TEST(Cycles, SinumerikDepthsMayCountToTheToolsShoulder) {
  const auto end = [](const std::string& call) {
    const Program p = read_text("T1 M6 ; SPOT DRILL D10 90 DEG\nG0 Z5\nF100\n" + call + "\n",
                                at_origin(Dialect::sinumerik));
    double low = 0;
    for (const Motion& m : p.motions) low = std::min(low, m.end.z);
    return fmt::format("{:g} {}", low, codes(p, Severity::error));
  };
  EXPECT_EQ(end("CYCLE81(5,0,1,8,,0,10,1,12)"), "-4 ");
  EXPECT_EQ(end("CYCLE81(5,0,1,-3,,0,0,1,12)"), "-3 ");
  EXPECT_EQ(end("CYCLE81(5,0,1,12,,0,10,1,12)"), "0 value-range");
  EXPECT_EQ(end("CYCLE82(5,0,1,-6,,0,10,1,12)"), "-11 ");
  EXPECT_EQ(end("CYCLE83(5,0,1,-6,,,3,0,0,0,1,0,0,0,1,0,0,10,1,11211112)"), "-11 ");
  EXPECT_EQ(end("CYCLE85(5,0,1,-6,9,0,50,50,0,1,12)"), "-6 ");
  EXPECT_EQ(end("CYCLE86(5,0,1,-6,9,0,3,0,0,0,0,0,1,12)"), "-6 ");
  EXPECT_EQ(end("CYCLE84(5,0,1,-6,9,0,5,,1,,300,300,0,1,0,0,,1,,\"\",\"\",0,1,1001002)"), "-6 ");
}

// What a pattern says of its places and is not read is an error by name.
TEST(Cycles, PatternsWithUnreadPlacesAreErrors) {
  const auto places = [](const std::string& call) {
    return run(Dialect::sinumerik, "G0 Z5\n" + call + "\n");
  };
  EXPECT_EQ(places("CYCLE801(0,0,0,10,10,2,1,0,0,0,0,\"\",0,1)"),
            "r0,0,5 r10,0,5 | program-without-cuts");
  EXPECT_EQ(places("CYCLE801(0,0,0,10,10,2,2,0,0,30,0,,,1)"), "r0,0,5 | not-supported");
  EXPECT_EQ(places("CYCLE801(0,0,0,10,10,2,2,0,0,0,0,\"2\",0,1)"), "r0,0,5 | not-supported");
  EXPECT_EQ(places("HOLES1(0,0,0,10,10,3,0,0,\"1,3\",0,1)"), "r0,0,5 | not-supported");
  EXPECT_EQ(places("HOLES2(0,0,9,0,0,3,0,0,\"1\",0,1)"), "r0,0,5 | not-supported");
  EXPECT_EQ(places("CYCLE802(111111111,111111111,1,2,3,4)"),
            "r0,0,5 r1,2,5 r3,4,5 | program-without-cuts");
  EXPECT_EQ(places("CYCLE802(122222222,111111111,1,2,3,4)"), "r0,0,5 | not-supported");
}

// AXN names the axis within the plane, DMODE the plane; a lathe has no Y to drill along in G18.
TEST(Cycles, SinumerikChoosesTheDrillsAxis) {
  InterpOptions lathe = at_origin(Dialect::sinumerik);
  lathe.machine = MachineKind::lathe;
  const auto end = [](const std::string& text, const InterpOptions& options) {
    const Program p = read_text("T1 ; DRILL D6\nG95 F0.1\n" + text, options);
    Vec3 low;
    for (const Motion& m : p.motions)
      for (int i = 0; i < 3; ++i)
        component(low, i) = std::min(component(low, i), component(m.end, i));
    return fmt::format("{:g} {:g} {:g} {}", low.x, low.y, low.z, codes(p, Severity::error));
  };
  EXPECT_EQ(end("G18\nG0 X0 Z5\nCYCLE82(5,0,1,-12)\n", lathe), "0 0 0 cycle-plane");
  EXPECT_EQ(end("G17\nG0 X0 Z5\nCYCLE82(5,0,1,-12)\nG18\n", lathe), "0 0 -12 ");
  EXPECT_EQ(end("G18\nG0 X0 Z5\nCYCLE82(5,0,1,-12,,0,0,1,0)\n", lathe), "0 0 -12 ");
  EXPECT_EQ(end("G18\nG0 X0 Z5\nCYCLE83(5,0,1,-12,,-4,,0,0,0,1,0,1)\n", lathe), "0 0 -12 ");
  EXPECT_EQ(end("G17\nG0 X5 Y0 Z-3\nCYCLE84(5,0,1,-12,,0,3,6,,,300,300,1)\n",
                at_origin(Dialect::sinumerik)),
            "-12 0 -3 ");
  EXPECT_EQ(
      end("G17\nG0 X5 Y0 Z5\nCYCLE83(5,0,1,-12,,-4,,0,0,0,1,0,3)\n", at_origin(Dialect::sinumerik)),
      "0 0 -12 ");
}

TEST(Cycles, SinumerikTapsAndBores) {
  const auto s = Dialect::sinumerik;
  const Program tap = read_text("G0 Z5\nCYCLE84(5,0,2,-10,,0,3,8,,0,500,500)\n", at_origin(s));
  EXPECT_EQ(ends(tap), "r0,0,5 r0,0,2 l0,0,-10 l0,0,2 r0,0,5");
  EXPECT_DOUBLE_EQ(tap.motions[2].lead, 1.25);  // MPIT 8
  // The thread was chosen from a table of the control: its name stands in texts.
  const auto lead_of = [&](const std::string& call) {
    const Program p = read_text("G0 Z5\n" + call + "\n", at_origin(s));
    return p.motions.size() > 2 ? fmt::format("{:g} ", p.motions[2].lead) + codes(p) : codes(p);
  };
  const std::string rigid = "CYCLE84(5,0,2,-10,,0,5,,";
  EXPECT_EQ(lead_of(rigid + "1.25,0,500,500,0,1,0,0,5,1.4,\"1.25\",\"ISO_METRIC\",\"M8\",,1001,2)"),
            "1.25 ");
  EXPECT_EQ(lead_of(rigid + "20,0,500,500,0,2,0,0,5,1.4,,\"UNC\",\"1/4\",,1001,2)"), "1.27 ");
  EXPECT_EQ(lead_of(rigid + "0.05,0,500,500,0,3)"), "1.27 ");
  EXPECT_EQ(lead_of(rigid + "1,0,500,500,0,4)"), "3.14159 ");
  EXPECT_EQ(lead_of("F500 S400\nCYCLE84(5,0,2,-10,,0,5)"), "1.25 thread-lead");
  EXPECT_EQ(lead_of("G70\n" + rigid + "1.25,0,500,500,0,1)"), "1.25 ");
  EXPECT_EQ(lead_of("CYCLE840(5,0,2,-10,,0,0,3,11,,1.25,3,1,,,\"ISO_METRIC\",\"M8\",,1001,2)"),
            "1.25 ");
  const Program ream = read_text("G0 Z5\nCYCLE85(5,0,2,-10,,0,150,600)\n", at_origin(s));
  EXPECT_EQ(ends(ream), "r0,0,5 r0,0,2 l0,0,-10 l0,0,2 r0,0,5");
  EXPECT_EQ(ream.motions[2].feed, 150);
  EXPECT_EQ(ream.motions[3].feed, 600);
  EXPECT_EQ(run(s, "F100\nG0 Z5\nCYCLE86(5,0,2,-10,,0,3,-1,0,1,0)\n"),
            "r0,0,5 r0,0,2 l0,0,-10 r-1,0,-9 r-1,0,5 r0,0,5");
}

// LinuxCNC feeds up to where the cycle ends; G85 feeds to R and leaves with a rapid.
TEST(Cycles, TapsOfLinuxCncFeedUpToTheEnd) {
  const auto path = [](const std::string& text) {
    return path_text(
        read_text("G0 X0 Y0 Z5\nS500 M3 F625\n" + text + "M2\n", at_origin(Dialect::ngc)));
  };
  EXPECT_EQ(path("G98 G84 Z-5 R1\n"), "r0,0,5 r0,0,1 l0,0,-5 l0,0,5");
  EXPECT_EQ(path("G99 G84 Z-5 R1\n"), "r0,0,5 r0,0,1 l0,0,-5 l0,0,1");
  EXPECT_EQ(path("G98 G85 Z-5 R1\n"), "r0,0,5 r0,0,1 l0,0,-5 l0,0,1 r0,0,5");
  EXPECT_EQ(path("G18 G84 Y-5 R1\n"), "r0,0,5 | not-supported");
}

// Across the spindle both ways are down: R lies on the side that the tool comes from.
TEST(Cycles, HolesMayGoTowardPlusInG18AndG19) {
  const auto run = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(run("G18\nG0 Y-10.\nG81 X1. Y5. Z1. R-2. F100\nG80\n"),
            "r0,-10,0 r1,-10,1 r1,-2,1 l1,5,1 r1,-10,1");
  EXPECT_EQ(run("G19\nG99 G83 X3. R-2. Q2. F100\n"),
            "r-2,0,0 l0,0,0 r-2,0,0 r-0.254,0,0 l2,0,0 r-2,0,0 r1.746,0,0 l3,0,0 r-2,0,0");
  EXPECT_EQ(codes(read_text("G0 Z-9.\nG81 Z5. R-2. F100\n", at_origin(Dialect::fanuc))),
            "cycle-upwards");
}

}  // namespace
}  // namespace mrsim
