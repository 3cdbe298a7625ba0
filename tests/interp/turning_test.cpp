// Turning cycles of FANUC lathes and LinuxCNC against the pictures of their manuals. Ends of the
// motions, worked out by hand; X as radius.
#include "interp/support.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// "r X Z" for a rapid, "l X Z" for a line, "t X Z" for a thread, "a X Z" for an arc.
std::string turned(const Program& program) {
  std::string out;
  for (const Motion& m : program.motions) {
    const char kind = m.kind == MotionKind::line && m.lead != 0 ? 't' : "rla"[int(m.kind)];
    out += fmt::format("{}{:.4g},{:.4g} ", kind, m.end.x + 0.0, m.end.z + 0.0);
  }
  if (!out.empty()) out.pop_back();
  return out + (codes(program).empty() ? "" : " | " + codes(program));
}

Program lathe(const std::string& text) {
  return read_text(text, at_origin(Dialect::fanuc, MachineKind::lathe));
}

TEST(Turning, G90CutsAlongZ) {
  // In X to 25, along Z to -20 with the feed, out to 30 with the feed, back; Z stays for X46.
  EXPECT_EQ(turned(lathe("G0 X60 Z2\nG90 X50 Z-20 F.2\nX46\nG0 X70\n")),
            "r30,2 r25,2 l25,-20 l30,-20 r30,2 r23,2 l23,-20 l30,-20 r30,2 r35,2");
  // the radius at the start is 4 less than at the end. U and W count from the start.
  EXPECT_EQ(turned(lathe("G0 X60 Z2\nG90 U-10 W-22 R-4 F.2\n")),
            "r30,2 r21,2 l25,-20 l30,-20 r30,2");
}

// G91 exists in code systems B and C and on Okuma's, where G90 is no cycle.
TEST(Turning, G90BehindG91IsAbsolute) {
  EXPECT_EQ(turned(lathe("G0 X60 Z2\nG91 G1 X-4 Z-1 F.2\nG90 X50 Z-20\nX46\n")),
            "r30,2 l28,1 l25,-20 l23,-20");
}

// R of a cycle's second block and of a peck is no rounding, although a G1 was in force.
TEST(Turning, RadiiOfCyclesAreNoCorners) {
  EXPECT_EQ(turned(lathe("G1 X60 Z2 F.2\nG90 X50 Z-20\nX48 R-1\n")),
            "l30,2 r25,2 l25,-20 l30,-20 r30,2 r23,2 l24,-20 l30,-20 r30,2");
  EXPECT_EQ(turned(lathe("G1 X0 Z2 F.2\nG74 R1\nG74 Z-10 Q6000 R0.5\n")),
            "l0,2 l0,-4 r0,-3 l0,-10 r-0.5,-10 r-0.5,2 r0,2")
      << "R of G74 is the relief at the bottom";
}

TEST(Turning, G94CutsAlongX) {
  EXPECT_EQ(turned(lathe("G0 X60 Z2\nG94 X20 Z-2 F.2\nZ-4\nG0 Z5\n")),
            "r30,2 r30,-2 l10,-2 l10,2 r30,2 r30,-4 l10,-4 l10,2 r30,2 r30,5");
  EXPECT_EQ(turned(lathe("G94\nG0 X60 Z2\nG1 X50 F100\n")), "r30,2 l25,2")
      << "without axes: feed per minute of code systems B and C";
}

TEST(Turning, G92CutsThreads) {
  const Program p = lathe("G0 X24 Z4\nG92 X19.3 Z-20 F1.5\nX18.9\nX18.4 R-1\nG0 X50\n");
  EXPECT_EQ(turned(p),
            "r12,4 r9.65,4 t9.65,-20 r12,-20 r12,4 r9.45,4 t9.45,-20 r12,-20 r12,4 "
            "r8.2,4 t9.2,-20 r12,-20 r12,4 r25,4");
  EXPECT_EQ(p.motions[2].lead, 1.5);
  EXPECT_EQ(p.motions[2].line, 2);
  EXPECT_EQ(turned(lathe("G0 X24 Z4\nG92 X19.3 Z-20\n")), "r12,4 | thread-lead");
}

// A shoulder: 20 diameter to Z-10, a face to 30, then to Z-20. Depth 3, escape 1, allowances 0.5 in
// radius and 0.2: the contour moves to radius 10.5 and 15.5, faces at -9.8; levels at 20.5 - 3 n
// (from the start moved by the allowances): 17.5, 14.5, 11.5.
// Q is the angle that the spindle has at the start: of threads with several starts.
TEST(Turning, ThreadsHaveAStartingAngle) {
  EXPECT_EQ(turned(lathe("G0 X20 Z5\nG32 Z-10 F4 Q180000\nG0 X30\n")), "r10,5 t10,-10 r15,-10");
  EXPECT_EQ(turned(lathe("G0 X30 Z5\nG92 X19 Z-10 F4 Q180000\n")),
            "r15,5 r9.5,5 t9.5,-10 r15,-10 r15,5");
}

TEST(Turning, G71RoughsToTheContour) {
  const std::string contour = "N10 G0 X20\nG1 Z-10 F.1\nX30\nZ-20\nN20 X40\nG0 X100\n";
  const std::string expected =
      "r20,2 r20.5,2.2 r17.5,2.2 l17.5,-19.8 r18.5,-18.8 r18.5,2.2 "
      "r14.5,2.2 l14.5,-9.8 r15.5,-8.8 r15.5,2.2 r11.5,2.2 l11.5,-9.8 r12.5,-8.8 r12.5,2.2 "
      "r10.5,2.2 l10.5,-9.8 l15.5,-9.8 l15.5,-19.8 l20.5,-19.8 r20,2 r50,2";
  const Program two = lathe("G0 X40 Z2\nG71 U3 R1\nG71 P10 Q20 U1 W.2 F.3\n" + contour);
  EXPECT_EQ(turned(two), expected);
  for (const Motion& m : two.motions) {
    if (m.kind == MotionKind::line) {
      EXPECT_EQ(m.feed, 0.3) << "F of the contour is for G70";
    }
  }
  EXPECT_EQ(two.motions[3].line, 3) << "a pass is the cycle's";
  EXPECT_EQ(two.motions[15].line, 5) << "the last one is the contour's, called from the cycle";
  ASSERT_GE(two.motions[15].call, 0);
  EXPECT_EQ(two.calls[static_cast<std::size_t>(two.motions[15].call)].line, 3);
  const std::string one = "G0 X40 Z2\nG71 P10 Q20 U1 W.2 D3 R1 F.3\n";
  // In one line D is the depth; the escape is that of the machine: none is known.
  EXPECT_EQ(turned(lathe(one + contour)).substr(0, 44),
            "r20,2 r20.5,2.2 r17.5,2.2 l17.5,-19.8 r17.5,");
}

// I and K in one line: the passes leave as much more, which the cut along the contour takes.
TEST(Turning, G71SemiFinishes) {
  EXPECT_EQ(turned(lathe("G0 X40 Z2\nG71 P10 Q20 U1 W.2 I1. K.3 D3. F.3\nN10 G0 X20\nG1 Z-10 F.1\n"
                         "X30\nZ-20\nN20 X40\nG0 X100\n")),
            "r20,2 r20.5,2.2 r17.5,2.2 l17.5,-19.5 r17.5,2.2 r14.5,2.2 l14.5,-9.5 r14.5,2.2 "
            "r10.5,2.2 l10.5,-9.8 l15.5,-9.8 l15.5,-19.8 l20.5,-19.8 r20,2 r50,2");
}

// A bore: the levels go outwards, the allowance is negative.
TEST(Turning, G71BoresAndMeetsSlopesAndArcs) {
  EXPECT_EQ(turned(lathe("G0 X20 Z1\nG71 U2 R.5\nG71 P1 Q2 U-.4 W.1 F.2\nN1 G0 X30\n"
                         "G1 Z-10\nN2 X20\n")),
            "r10,1 r9.8,1.1 r11.8,1.1 l11.8,-9.9 r11.3,-9.4 r11.3,1.1 r13.8,1.1 l13.8,-9.9 "
            "r13.3,-9.4 r13.3,1.1 r14.8,1.1 l14.8,-9.9 l9.8,-9.9 r10,1");
  // A cone of 45 degrees from radius 5, Z 0 meets the level 8 at Z-3; a quarter of radius 10 about
  // (15, -5) from (5, -5) to (15, -15) meets 9 at Z -5 - 8.
  EXPECT_EQ(turned(lathe("G0 X20 Z1\nG71 U2 R0\nG71 P1 Q2 F.2\nN1 G0 X10\nG1 Z0\nN2 X20 Z-5\n")),
            "r10,1 r8,1 l8,-3 r8,1 r6,1 l6,-1 r6,1 r5,1 l5,0 l10,-5 r10,1");
  EXPECT_EQ(turned(lathe("G0 X30 Z1\nG71 U6 R0\nG71 P1 Q2 F.2\nN1 G0 X10\nG1 Z-5\n"
                         "N2 G2 X30 Z-15 R10\n")),
            "r15,1 r9,1 l9,-13 r9,1 r5,1 l5,-5 a15,-15 r15,1");
}

// Depth 4 from radius 32: 28, 24 and 20 to the face at Z-50; the pocket between (20, -10) and
// (20, -38) has its bottom at 12, so that the level 16 lies in it from Z-14 to Z-34.
TEST(Turning, G71CutsPocketsBehindTheOtherPasses) {
  EXPECT_EQ(turned(lathe("G0 X64 Z2\nG71 U4 R1\nG71 P10 Q20 F.3\nN10 G0 X40 W0\nG1 Z-10 F.1\n"
                         "X24 Z-18\nZ-30\nX40 Z-38\nZ-50\nN20 X64\n")),
            "r32,2 r28,2 l28,-50 r29,-49 r29,2 r24,2 l24,-50 r25,-49 r25,2 r20,2 l20,-50 r21,-49 "
            "r21,2 r32,2 r32,-14 r21,-14 l16,-14 l16,-34 r17,-33 r32,-33 r32,2 "
            "r20,2 l20,-10 l12,-18 l12,-30 l20,-38 l20,-50 l32,-50 r32,2");
  // An arc of radius 12.5 about (25.5, -20), its bottom at 13: the level 16 lies in it for 8.124 on
  // both sides of Z-20.
  EXPECT_EQ(turned(lathe("G0 X40 Z2\nG71 U4 R1\nG71 P10 Q20 F.3\nN10 G0 X36 W0\nG1 Z-10 F.1\n"
                         "G2 Z-30 R12.5\nG1 Z-40\nN20 X40\n")),
            "r20,2 r20,-11.88 l16,-11.88 l16,-28.12 r17,-27.12 r20,-27.12 r20,2 "
            "r18,2 l18,-10 a18,-30 l18,-40 l20,-40 r20,2");
}

// Both axes in the first block of the contour make type II.
TEST(Turning, APocketUnderTypeOneIsAWarning) {
  const auto told = [](const std::string& cycle, const std::string& contour,
                       const std::string& last = "X64") {
    const Program p = lathe("G0 X64 Z2\n" + cycle + "\nN1 G0 " + contour + "\nN2 " + last + "\n");
    for (const Diagnostic& d : p.diagnostics)
      if (d.code == "cycle-contour")
        return fmt::format("{} {}", d.place.line, d.text.substr(0, d.text.find(" stops")));
    return codes(p);
  };
  const std::string g71 = "G71 U4 R1\nG71 P1 Q2 F.3", pocket = "\nG1 Z-10\nX24 Z-18\nX40 Z-38";
  const std::string warning =
      "6 the contour falls here, a pocket: G71 whose first block has no Z (type I)";
  EXPECT_EQ(told(g71, "X40" + pocket), warning);
  EXPECT_EQ(told(g71, "U-24" + pocket), warning);
  for (const char* both : {"X40 Z2", "X40 W0", "U-24 W0"}) EXPECT_EQ(told(g71, both + pocket), "");
  EXPECT_EQ(told("G71 U4 R1\nG71 P1 Q2 F.3 R1", "X40" + pocket), "") << "Haas";
  EXPECT_EQ(told("G71 U4 R1 H1\nG71 P1 Q2 F.3", "X40" + pocket), "") << "Mitsubishi";
  EXPECT_EQ(told(g71, "X20\nG1 Z-10\nG3 X40 Z-20 R10\nG1 Z-30"), "");
  EXPECT_EQ(told("G72 W2 R1\nG72 P1 Q2 F.3", "Z-30\nG1 X50\nX40 Z-20\nX30 Z-25", "X20 Z-10"),
            "7 the contour falls here, a pocket: G72 whose first block has no X (type I)");
}

TEST(Turning, G71RefusesUndercutsAndMissingBlocks) {
  EXPECT_EQ(turned(lathe("G0 X40 Z2\nG71 U3 R1\nG71 P10 Q20 F.3\nN10 G0 X20\nG1 Z-10 F.1\n"
                         "X16 Z-8\nZ-20\nN20 X40\nG1 X50\n")),
            "r20,2 l25,2 | not-supported");
  EXPECT_EQ(turned(lathe("G0 X40 Z2\nG71 U3 R1\nG71 P10 Q30 F.3\nN10 G0 X20\nN20 G1 X40\n")),
            "r20,2 r10,2 l20,2 | jump-target");
  EXPECT_EQ(turned(lathe("G0 X40 Z2\nG71 P10 Q20 F.3\nN10 G0 X20\nN20 G1 X40\n")),
            "r20,2 r10,2 l20,2 | value-missing feed-missing");
}

TEST(Turning, AContourThatEndsTheProgramIsAnError) {
  EXPECT_EQ(turned(lathe("G0 X40 Z2\nG71 U3 R1\nG71 P10 Q20 F.3\nN10 G0 X20\nM30\nN20 G1 X40\n")),
            "r20,2 | program-end-missing");
}

// Levels along Z; the contour runs inwards: from Z-4 at radius 20 to the face at Z0, radius 5.
TEST(Turning, G72RoughsFaces) {
  EXPECT_EQ(turned(lathe("G0 X44 Z2\nG72 W2 R.5\nG72 P1 Q2 U0 W.5 F.2\nN1 G0 Z-4\nG1 X20\n"
                         "Z0\nN2 X0\n")),
            "r22,2 r22,2.5 r22,0.5 l0,0.5 r0.5,1 r22,1 r22,-1.5 l10,-1.5 r10.5,-1 r22,-1 "
            "r22,-3.5 l10,-3.5 l10,0.5 l0,0.5 r22,2");
}

// Two passes: the first 3 in radius and 1 in Z away, the second at the allowance; G70 follows.
TEST(Turning, G73RepeatsThePatternAndG70Finishes) {
  const Program p = lathe(
      "G0 X40 Z5\nG73 U3 W1 R2\nG73 P1 Q2 U.4 W.1 F.3\nN1 G0 X20 Z1\nG1 Z-10 F.1\nN2 X30\n"
      "G70 P1 Q2\nG0 X80\n");
  EXPECT_EQ(turned(p),
            "r20,5 r23.2,6.1 r13.2,2.1 l13.2,-8.9 l18.2,-8.9 r20.2,5.1 r10.2,1.1 l10.2,-9.9 "
            "l15.2,-9.9 r20,5 r10,1 l10,-10 l15,-10 r20,5 r40,5");
  EXPECT_EQ(p.motions[3].feed, 0.3);
  EXPECT_EQ(p.motions[11].feed, 0.1);
}

TEST(Turning, G74AndG75Peck) {
  // Strokes of 4 with 1 back; P and Q without a point count micrometres.
  EXPECT_EQ(turned(lathe("G0 X0 Z2\nG74 R1\nG74 Z-8 Q4000 F.1\n")),
            "r0,2 l0,-2 r0,-1 l0,-6 r0,-5 l0,-8 r0,2");
  // A groove of three cuts 2.5 apart, each in strokes of 3.
  EXPECT_EQ(turned(lathe("G0 X42 Z-10\nG75 R.5\nG75 X30 Z-14 P3000 Q2500 F.1\nG0 X60\n")),
            "r21,-10 l18,-10 r18.5,-10 l15,-10 r21,-10 r21,-12.5 l18,-12.5 r18.5,-12.5 l15,-12.5 "
            "r21,-12.5 r21,-14 l18,-14 r18.5,-14 l15,-14 r21,-14 r21,-10 r30,-10");
}

// Height 1, passes at 0.5 and 0.5 sqrt 2 and so on, 0.9 before the allowance of 0.1; one at full
// depth. No angle and no chamfer: all start at Z 3.
TEST(Turning, G76CutsAThreadInPasses) {
  const Program p = lathe("G0 X24 Z3\nG76 P010000 Q100 R.1\nG76 X18 Z-20 P1000 Q500 F1.5\n");
  EXPECT_EQ(turned(p),
            "r12,3 r9.5,3 t9.5,-20 r12,-20 r12,3 r9.293,3 t9.293,-20 r12,-20 r12,3 "
            "r9.134,3 t9.134,-20 r12,-20 r12,3 r9.1,3 t9.1,-20 r12,-20 r12,3 "
            "r9,3 t9,-20 r12,-20 r12,3");
  // 60 degrees: Z moves by depth * tan 30; a chamfer of 1.0 leads at 45 degrees.
  const Program flank = lathe("G0 X24 Z3\nG76 P011060 Q100 R0\nG76 X18 Z-20 P1000 Q1000 F1.5\n");
  EXPECT_EQ(turned(flank), "r12,3 r12,2.423 r9,2.423 t9,-18.5 t10.5,-20 r12,-20 r12,3");
  EXPECT_EQ(flank.motions[2].lead, 0);
  EXPECT_EQ(flank.motions[3].lead, 1.5);
  // In one line: K height, D first depth.
  EXPECT_EQ(turned(lathe("G0 X24 Z3\nG76 X18 Z-20 K1. D1.0 F1.5 A60\n")),
            "r12,3 r12,2.423 r9,2.423 t9,-20 r12,-20 r12,3");
}

// Drive line at X 5, crest 1 inside of it, depths 0.2, 0.4 and the full 0.5 twice.
// P2: the passes touch the right flank of the groove and its left one in turn; both end at Z - 1
// tan 30.
TEST(Turning, G76InfeedsOnBothFlanks) {
  const auto starts = [](const char* p) {
    const Program program =
        lathe(std::string("G0 X24 Z3\nG76 X18 Z-20 K1. D.5 F1.5 A90 ") + p + "\n");
    std::string out;
    for (const Motion& m : program.motions)
      if (m.kind == MotionKind::line) out += fmt::format("{:.3f} ", m.start.z);
    return out + codes(program);
  };
  EXPECT_EQ(starts("P1"), "2.500 2.293 2.134 2.000 ");
  EXPECT_EQ(starts("P2"), "2.500 1.707 2.134 2.000 ");
  EXPECT_EQ(starts("P4"), "2.500 2.000 ");
  EXPECT_EQ(starts("P5"), "value-range");
  EXPECT_EQ(turned(lathe("G0 X24 Z3\nG76 X18 Z-20 K1000 D500 F1.5 A60\n")),
            turned(lathe("G0 X24 Z3\nG76 X18 Z-20 K1. D.5 F1.5 A60\n")));
}

TEST(Turning, G76OfLinuxCncCutsAThreadInPasses) {
  const InterpOptions options = at_origin(Dialect::ngc);
  EXPECT_EQ(turned(read_text("G18\nG0 X5 Z2\nG76 P1.5 Z-10 I-1 J0.2 K0.5 R1 H1\nM2\n", options)),
            "r5,2 r5.3,2 r3.8,2 t3.8,-10 r5.3,-10 r5.1,2 r3.6,2 t3.6,-10 r5.1,-10 "
            "r5,2 r3.5,2 t3.5,-10 r5,-10 r5,2 r3.5,2 t3.5,-10 r5,-10");
  EXPECT_EQ(codes(read_text("G18\nG0 X5 Z2\nG76 P1.5 Z-10 I-1 J0.2\nM2\n", options)),
            "value-missing");
}

// The contour would be read behind the program's end.
TEST(Turning, ACycleWithAContourDoesNotEndTheProgram) {
  for (const char* end : {"M30", "M99"})
    EXPECT_EQ(codes(read_text(fmt::format("G0 X20 Z2\nG70 P1 Q2 {}\nN1 X10\nN2 G1 Z-5 F1\n", end),
                              at_origin(Dialect::fanuc, MachineKind::lathe)),
                    Severity::error),
              "call-not-alone");
}

// C beside one axis is a chamfer with the sign of its direction, as I and K are.
TEST(Turning, ChamfersOfCHaveASign) {
  const auto run = [](const std::string& chamfer) {
    return path_text(read_text("G0 X16. Z2.\nG1 Z0 F.2\nX20. " + chamfer + "\nZ-20.\nX30.\n",
                               at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  EXPECT_EQ(run("C-1.5"), run("K-1.5"));
  EXPECT_EQ(run("C-1.5"), run(",C1.5"));
  EXPECT_NE(run("C-1.5"), run(""));
}

// A line from a point or by its angle ends in a rounding as one beside a single axis does: without
// the comma R has no other meaning there.
TEST(Turning, ARoundingNeedsNoCommaBesideTwoAxesOrAnAngle) {
  const auto run = [](const std::string& text) {
    return path_text(
        read_text("G0 X20. Z0\nG1 F.2\n" + text, at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  for (const char* line : {"X40. Z-10. {}R3.\nZ-30.\n", "X40. A135. {}R3.\nZ-30.\n",
                           "A150. {}R3.\nX60. Z-40. A170.\n"})
    EXPECT_EQ(run(fmt::format(fmt::runtime(line), "")), run(fmt::format(fmt::runtime(line), ",")));
  // 45 degrees of turn: the rounding begins r tan(22.5) before the corner, its centre r from X40.
  EXPECT_EQ(run("X40. Z-10. R3.\nZ-30.\n"), "r10,0,0 l19.12,0,-9.121 a20,0,-11.24 l20,0,-30");
}

TEST(Turning, G10SetsOffsetsOfToolsWithoutL) {
  const auto run = [](const char* words, const char* g10 = "G10 P3 ") {
    const Program p = read_text(std::string(g10) + words + "\nG0 X20. Z5.\nG1 Z0 F.1\n",
                                at_origin(Dialect::fanuc, MachineKind::lathe));
    return path_text(p) + " " + codes(p, Severity::note);
  };
  EXPECT_EQ(run("X100. Z50. R0 Q3"), "r10,0,5 l10,0,0 tool-length");
  EXPECT_EQ(run("X100. Z50."), "r10,0,5 l10,0,0 tool-length");
  EXPECT_EQ(run("U0.1 W0 R0"), "r10,0,5 l10,0,0 tool-length");
  EXPECT_EQ(run("Z0", "G10 P0 "), "r10,0,5 l10,0,0 tool-length");
  EXPECT_EQ(run("Z-25.", "G10 P0 "), "r10,0,5 l10,0,0 | not-supported not-supported");
}

// R of G10 P is compared with the nose that cuts.
TEST(Turning, ANoseOfG10ThatDiffersIsToldOf) {
  const auto run = [](const std::string& g10) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    options.table.tools.clear();
    return codes(read_text(g10 + "T0101 (CNMG 120408)\nG0 X20. Z5.\nG1 Z0 F.1\n", options));
  };
  EXPECT_EQ(run("G10 P1 X0 Z0 R0.8 Q3\n"), "");
  EXPECT_EQ(run("G10 P10001 X0 Z0 R0.4 Q3\n"), "nose-differs");
  EXPECT_EQ(run("G10 P2 X0 Z0 R0.4 Q3\n"), "");
}

// A round insert is given by its diameter, the length of its edge or its nose: of all three the
// centre keeps the distance.
TEST(Turning, CompensationTakesTheRadiusOfARoundInsert) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::sinumerik})
    for (double Tool::*size : {&Tool::diameter, &Tool::edge_length, &Tool::nose_radius}) {
      InterpOptions options = at_origin(dialect, MachineKind::lathe);
      Tool& tool = options.table.tools[0];
      tool.type = ToolType::turning;
      tool.insert = "RCMT";
      tool.diameter = 0;
      tool.*size = size == &Tool::nose_radius ? 1 : 2;
      tool.tip_is_nose_centre = true;
      const std::string path =
          path_text(read_text("G0 X20 Z5.\nG42 G1 X20. Z2. F.1\nZ-10.\nX30.\nG40 X40.\n", options));
      EXPECT_NE(path.find("l11,0,-9"), std::string::npos) << path;
    }
}

// The manuals forbid two contours of the same numbers; programs have them, one for each tool.
TEST(Turning, OfTwoContoursOfTheSameNumbersTheLastIsFinished) {
  const auto run = [](const char* second) {
    return path_text(read_text(
        fmt::format("G0 X20. Z2.\nG73 U1. R1\nG73 P1 Q2 F.1\nN1 G0 X16.\nN2 G1 Z-5.\n"
                    "G0 X20. Z2.\nG73 P{0} Q2 F.1\nN{0} G0 X12.\nN2 G1 Z-7.\nG70 P{0} Q2\n",
                    second),
        at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  const std::string path = run("3");
  EXPECT_EQ(path.substr(path.size() - 15), "l6,0,-7 r10,0,2");
  EXPECT_EQ(run("1"), path + " | contour-twice");
}

// FANUC: of X and U in one block the later one counts.
TEST(Turning, AnAxisGivenTwiceCountsAsItIsGivenLast) {
  const auto run = [](const char* text) {
    return path_text(read_text(std::string("G0 X20. Z5.\nG1 F.1 ") + text,
                               at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  EXPECT_EQ(run("X30. U4. Z0\n"), "r10,0,5 l12,0,0 | address-twice");
  EXPECT_EQ(run("U4. X30. W-1.\n"), "r10,0,5 l15,0,4 | address-twice");
}

// Mitsubishi: A is the program that holds the contour.
TEST(Turning, AContourMayStandInAnotherProgram) {
  const InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  const std::string shape = "N10 G0 X10.\nG1 Z-5.\nN20 X20.\n";
  const std::string head = "G0 X20. Z2.\nG71 U3. R1.\n";
  const Program own =
      read_text(head + "G71 P10 Q20 U.4 F.2\n" + shape + "G70 P10 Q20\nG0 Z9.\nM30\n", options);
  const Program other = read_text(head +
                                      "G71 A100 P10 Q20 U.4 F.2\nG70 A100 P10 Q20\nG0 Z9.\n"
                                      "M30\nO100\n" +
                                      shape + "M99\n",
                                  options);
  EXPECT_EQ(path_text(own), path_text(other));
  EXPECT_EQ(codes(other), "");
  EXPECT_EQ(codes(read_text(head + "G71 A7 P10 Q20 F.2\nM30\n", options)), "subprogram-missing");
  EXPECT_EQ(codes(read_text(head + "G71 A100 P10 Q20 F.2\nM30\nO100\nM99\n", options)),
            "jump-target");
}

// In code system C G73 roughs along Z, and U and R are its depth and its way out.
TEST(Turning, TheRepeatsOfG73AreAWholeNumber) {
  const auto run = [](const std::string& line) {
    return codes(read_text(
        "G0 X40. Z5.\n" + line + "\nG73 P1 Q2 F.3\nN1 G0 X20. Z1.\nG1 Z-10. F.1\nN2 X30.\n",
        at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  EXPECT_EQ(run("G73 U3. W1. R2"), "");
  EXPECT_EQ(run("G73 U3. W1. R.002"), "");
  EXPECT_EQ(run("G73 U2. R1."), "code-system");
  EXPECT_EQ(run("G73 U2. R.5").substr(0, 11), "value-range");
}

}  // namespace
}  // namespace mrsim
