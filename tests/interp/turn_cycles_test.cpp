// SINUMERIK's grooves, corners and threads, as worked out by hand from the pictures of its manual.
#include "interp/support.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

/// The ends of the motions as X (radius) and Z, then the codes of what was said.
std::string lathe_path(const std::string& text, const Tool& tool = {}) {
  InterpOptions options = at_origin(Dialect::sinumerik, MachineKind::lathe);
  if (tool.type != ToolType::endmill) options.table.tools = {tool};
  const Program p = read_text("F0.2 G0 X70 Z-10\n" + text + "\n", options);
  std::string out;
  for (const Motion& m : p.motions)
    out += fmt::format("{}{:.6g},{:.6g} ", m.kind == MotionKind::rapid ? "r" : "l", m.end.x + 0.0,
                       m.end.z + 0.0);
  return out.substr(0, 8) == "r35,-10 " ? out.substr(8) + codes(p) : "other start: " + out;
}

Tool grooving_tool(double width, int tip) {
  Tool tool;
  tool.type = ToolType::grooving;
  tool.width = width;
  tool.tip = tip;
  tool.origin = "test";
  return tool;
}

TEST(TurnCycles, Cycle951RoughsACorner) {
  EXPECT_EQ(lathe_path("CYCLE951(60,0,40,-20,0,0,1,4,2,0.5,11,0,0,0,1,0.3,0,2,1110000)"),
            "r31,1 r26,1 l26,-19.5 r27,-18.5 r27,1 r22,1 l22,-19.5 r23,-18.5 r23,1 r31,1 ");
  // A face, beyond its centre; and a bore.
  EXPECT_EQ(lathe_path("CYCLE951(60,2,-2,0,,,1,1,0,0,12,,,,1,0.3)"),
            "r31,3 r31,1 l-1,1 r0,2 r31,2 r31,0 l-1,0 r0,1 r31,1 r31,3 ");
  EXPECT_EQ(lathe_path("CYCLE951(20,0,30,-15,,,3,5,0,0,11,,,,1)"),
            "r9,1 r15,1 l15,-15 r14,-14 r14,1 r9,1 ");
}

TEST(TurnCycles, Cycle951FinishesACorner) {
  EXPECT_EQ(lathe_path("CYCLE951(60,0,40,-20,0,0,1,1,2,0.5,21,0,0,0,1,0.3,0,2,1110000)"),
            "r31,1 r20,1 l20,-20 l31,-20 r31,1 ");
  EXPECT_EQ(lathe_path("CYCLE951(60,0,40,-20,0,0,1,1,0,0,22,0,0,0,1,0.3,0,2,1110000)"),
            "r31,1 r31,-20 l20,-20 l20,1 r31,1 ");
}

TEST(TurnCycles, CornersThatAreNotRead) {
  EXPECT_EQ(lathe_path("CYCLE951(60,0,40,-20,0,0,1,4,0,0,11,0,0,0,1,0.3,1,2,1110000)"),
            "not-supported");
  EXPECT_EQ(lathe_path("CYCLE951(60,0,40,20,0,0,1,4,0,0,11,0,0,0,1,0.3,0,2,1111000)"),
            "not-supported");
  EXPECT_EQ(lathe_path("CYCLE951(60,0,40,-20,0,0,1,4,0,0,31)"), "not-supported");
  EXPECT_EQ(lathe_path("CYCLE951(60,0,60,-20,0,0,1,4,0,0,11)"), "value-range");
  EXPECT_EQ(lathe_path("CYCLE951(60,0,40,-20,0,0,1,,0,0,11)"), "value-missing");
  EXPECT_EQ(lathe_path("CYCLE951(60)"), "value-missing");
  Tool round = grooving_tool(4, 3);
  round.nose_radius = 0.4;
  const std::string text =
      lathe_path("T1 D1\nG42 G1 X66 Z-10\nCYCLE951(60,0,40,-20,0,0,1,4,0,0,11)", round);
  EXPECT_NE(text.find(" cycle-compensation"), std::string::npos) << text;
}

TEST(TurnCycles, GrooveInEqualPlunges) {
  // From the left, the point at the left corner of a blade of 4 in a groove of 10.
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,,,,,,,,,,,,1)", grooving_tool(4, 3)),
            "r31,-10 r31,-30 l25,-30 r31,-30 r31,-27 l25,-27 r31,-27 r31,-24 l25,-24 r31,-24 ");
  // The same groove with the point at the right corner, and in the middle of the blade.
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,,,,,,,,,,,,11)", grooving_tool(4, 4)),
            "r31,-10 r31,-26 l25,-26 r31,-26 r31,-23 l25,-23 r31,-23 r31,-20 l25,-20 r31,-20 ");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,4,5,,,,,,,,,,,,1)", grooving_tool(4, 8)),
            "r31,-10 r31,-28 l25,-28 r31,-28 ");
  // Inside, in radius.
  EXPECT_EQ(lathe_path("DIAMOF\nCYCLE93(20,-30,4,5,,,,,,,,,,,,3)", grooving_tool(4, 2)),
            "r19,-10 r19,-30 l25,-30 r19,-30 ");
}

TEST(TurnCycles, Cycle93LeavesAllowances) {
  EXPECT_EQ(lathe_path("CYCLE93(60,-20,10,5,0,0,0,0,0,0,0,1,0.5,2,0,5,1)", grooving_tool(4, 3)),
            "r31,-10 r31,-24.5 l28,-24.5 r29,-24.5 l26,-24.5 r31,-24.5 r31,-27 l28,-27 r29,-27 "
            "l26,-27 r31,-27 r31,-29.5 l28,-29.5 r29,-29.5 l26,-29.5 r31,-29.5 r31,-24 l25,-24 "
            "l25,-27 r31,-27 r31,-30 l25,-30 l25,-27 r31,-27 ");
}

// Chamfers by their length (VARI 1) or leg (11), radii, at the edge (RCO) and at the bottom (RCI).
TEST(TurnCycles, Cycle93CutsCorners) {
  const Tool sharp = grooving_tool(4, 3);
  const double leg = std::sqrt(2.0);
  EXPECT_EQ(lathe_path("CYCLE93(60,-20,10,5,0,0,0,-1,-2,0,0,0,0,,,15)", sharp),
            "r31,-10 r31,-24 l25,-24 r31,-24 r31,-27 l25,-27 r31,-27 r31,-30 l25,-30 r31,-30 "
            "r31,-22 l29,-24 l25,-24 l25,-27 r31,-27 r31,-33 l28,-30 l25,-30 l25,-27 r31,-27 ")
      << "SPL on the right: its corner is the first";
  EXPECT_EQ(lathe_path(fmt::format("CYCLE93(60,-30,10,5,0,0,0,{},0,0,0,0,0,,,1)", -leg), sharp),
            lathe_path("CYCLE93(60,-30,10,5,0,0,0,-1,0,0,0,0,0,,,11)", sharp));
  EXPECT_EQ(
      lathe_path("CYCLE93(60,-30,10,5,0,0,0,1,0,0.5,-1,0,0,,,11)", sharp),
      "r31,-10 r31,-29.5 l25,-29.5 r31,-29.5 r31,-27.25 l25,-27.25 r31,-27.25 r31,-25 l25,-25 "
      "r31,-25 r31,-31 l30,-31 l29,-30 l25.5,-30 l25,-29.5 l25,-27.25 r31,-27.25 r31,-24 "
      "l26,-24 l25,-25 l25,-27.25 r31,-27.25 ");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,0,0,0,0,0,3,3.1,0,0,,,11)", sharp), "value-range");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,0,0,0,3,0,3,0,0,0,,,11)", sharp), "value-range");
}

// What a groove with corners removes is the rectangle and its corners, turned: with a sharp blade,
// and with one whose corners are round, which stay at the bottom.
TEST(TurnCycles, CornersOfRoundBladesKeepTheirSize) {
  const auto path = [](double nose, const char* corners) {
    Tool tool = grooving_tool(4, 3);
    tool.nose_radius = nose;
    InterpOptions options = at_origin(Dialect::sinumerik, MachineKind::lathe);
    options.table.tools = {tool};
    return read_text(
        fmt::format("F0.2 G0 X70 Z-10\nCYCLE93(60,-30,10,5,0,0,0,{},0,0,,,11)\n", corners),
        options);
  };
  // The centre of the blade's corner stays its radius off the chamfer's line, from X30 Z-31 to X29
  // Z-30.
  const Program chamfer = path(0.4, "-1,-1,-2,-2");
  double nearest = 1e9;
  for (const Motion& m : chamfer.motions) {
    if (m.kind == MotionKind::rapid || m.start.x == m.end.x || m.start.z == m.end.z) continue;
    if (m.end.z < m.start.z || m.start.x < 28) continue;  // the left flank's
    const double x = m.start.x + 0.4, z = m.start.z + 0.4;
    nearest = std::abs(x - 30 + z + 31) / std::sqrt(2.0);
  }
  EXPECT_NEAR(nearest, 0.4, 1e-9);
  const Program round = path(0.4, "1,1,2,2");
  std::string radii;
  for (const Motion& m : round.motions)
    if (m.kind == MotionKind::arc)
      radii += fmt::format("{:.6g} ", std::hypot(m.center.x - m.start.x, m.center.z - m.start.z));
  EXPECT_EQ(radii, "1.4 1.6 1.4 1.6 ");
}

// LCYC95 and LCYC97 of 802S and 802C; G22 and G23 are its radius and diameter.
TEST(TurnCycles, TheCyclesOf802AreThoseOf840) {
  const std::string contour = "\nM2\n%_N_KONT1_SPF\nG1 X30 Z0\nZ-30\nX60 Z-40\nM17";
  const std::string by_list =
      lathe_path("CYCLE95(\"KONT1\",2,0,0,0.3,0.25,0.25,0.1,9,,,0.5)" + contour);
  EXPECT_NE(by_list.find(" l15,-30 "), std::string::npos) << by_list;
  EXPECT_EQ(lathe_path("_CNAME=\"KONT1\" R105=9 R106=0.3 R108=2 R109=0 R110=0.5 R111=0.25 "
                       "R112=0.1\nLCYC95" +
                       contour),
            by_list);
  EXPECT_EQ(lathe_path("S500 M3 R100=40 R101=0 R102=40 R103=-30 R104=1.5 R105=1 R106=0.05 R109=2 "
                       "R110=1 R111=0.92 R112=0 R113=5 R114=1\nLCYC97"),
            lathe_path("S500 M3\nCYCLE97(1.5,,0,-30,40,40,2,1,0.92,0.05,0,0,5,0,3,1)"));
  EXPECT_EQ(lathe_path("G22 G0 X20\nG23 X20"), "r20,-10 r10,-10 program-without-cuts");
}

TEST(TurnCycles, GroovesThatAreNotRead) {
  const Tool tool = grooving_tool(4, 3);
  // The manual's example: in a cone, with oblique flanks and chamfers.
  EXPECT_EQ(lathe_path("CYCLE93(35,60,30,25,5,10,20,0,0,-2,-2,1,1,10,1,5,0.2)", tool),
            "not-supported");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,0,10,10,,,,,,,,,1)", tool), "not-supported");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,,,,,,,,,,,,2)", tool), "not-supported");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,,,,,,,,,,,,9)", tool), "value-range");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,3,5,,,,,,,,,,,,1)", tool), "value-range");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,,,,,,,,,,,,1)", grooving_tool(4, 2)), "value-range");
  EXPECT_EQ(lathe_path("CYCLE93(60,-30,10,5,,,,,,,,,,,,1)"), "tool-unknown");
  EXPECT_EQ(lathe_path("CYCLE930(60,-30)\nCYCLE950(\"\")\nCYCLE94(20,60,\"E\")\nCYCLE96(40)\n"
                       "CYCLE940(20,60)"),
            "not-supported not-supported not-supported not-supported not-supported");
}

TEST(TurnCycles, Cycle92PartsOff) {
  // The part ends at Z-30: the blade of 3 stands left of it, its point at the left corner; the feed
  // falls at Ø10, the cut ends beyond the axis.
  EXPECT_EQ(
      lathe_path("CYCLE92(40,-30,10,-1,0,2,120,2000,3,0.12,0.05,500,,,1,2,0)", grooving_tool(3, 3)),
      "r22,-10 r22,-33 l5,-33 l-0.5,-33 r22,-33 ");
  // The point at the right corner; a tube, its wall of 6 mm as an increment.
  EXPECT_EQ(
      lathe_path("CYCLE92(40,-30,,6,0,2,120,2000,3,0.12,0.05,500,,,1,2,10)", grooving_tool(3, 4)),
      "r22,-10 r22,-30 l14,-30 r22,-30 ");
  const Tool blade = grooving_tool(3, 3);
  EXPECT_EQ(lathe_path("CYCLE92(40,-30,10,-1,0.3,2)", blade), "not-supported");
  EXPECT_EQ(lathe_path("CYCLE92(40,-30,10)", blade), "value-missing");
  EXPECT_EQ(lathe_path("CYCLE92(40,-30,10,41,0,2)", blade), "value-range");
  EXPECT_EQ(lathe_path("CYCLE92(40,-30,10,-1,0,2)"), "tool-unknown");
}

TEST(TurnCycles, Cycle98CutsAChainOfThreads) {
  // The manual's example: five cuts of equal cross-section and one more, 10 before and behind.
  const std::string text =
      lathe_path("S500 M3\nCYCLE98(0,30,-30,30,-60,36,-80,50,10,10,0.92,,,,5,1,1.5,2,2,3,1)");
  EXPECT_EQ(std::count(text.begin(), text.end(), 'l'), 6 * 3);
  const std::string last = "r29.5,10 r14.08,10 l14.08,-30 l17.08,-60 l27.58,-90 r29.5,-90 ";
  EXPECT_EQ(text.substr(text.size() - 2 * last.size() - 9), last + last + "r29.5,10 ");
  EXPECT_EQ(lathe_path("CYCLE98(0,30,-30,30,-20,36,-80,50,10,10,0.92,,,,5,1,1.5,2,2,3,1)"),
            "value-range");
  EXPECT_EQ(lathe_path("CYCLE98(0,30,-30,30,-60,36,-80,50,10,10,0.92,,,,5,1,1.5,2,,3,1)"),
            "thread-lead");
  EXPECT_EQ(lathe_path("CYCLE98(0,30,-30,30,-60,36)"), "value-missing");
}

TEST(TurnCycles, ThreadsOfTheCurrentListAreThoseOfTheOld) {
  const std::string old =
      lathe_path("S500 M3\nCYCLE97(1.5,,0,-30,40,40,2,1,0.92,0.05,30,0,5,1,1,1,1)");
  EXPECT_NE(old, "");
  EXPECT_EQ(lathe_path("S500 M3\nCYCLE99(0,40,-30,40,2,1,0.92,0.05,30,0,5,1,1.5,1300101,1)"), old);
  // Without FPD the thread is cylindrical.
  EXPECT_EQ(
      lathe_path("S500 M3\nCYCLE99(0,40,-30,,2,1,0.92,0.05,30,0,5,1,1.5,1300101,1,1,0.3,0.46,0,0,1,"
                 "0,0.53,1,,,,2,0)"),
      old);
  // Texts name a thread of the control's tables.
  EXPECT_EQ(
      lathe_path("S500 M3\nCYCLE99(0,40,-30,40,2,1,0.92,0.05,30,0,5,1,1.5,1300101,1,,,,,,,,,1,"
                 "\"1.5\",\"ISO_METRIC\",\"M40\",2,0)"),
      old);
  // Roughing and finishing apart are the whole.
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), 'l');
  };
  EXPECT_EQ(lines(old), 7);
  EXPECT_EQ(lines(lathe_path("S500 M3\nCYCLE99(0,40,-30,40,2,1,0.92,0.05,30,0,5,1,1.5,1100101,1)")),
            5);
  EXPECT_EQ(lines(lathe_path("S500 M3\nCYCLE99(0,40,-30,40,2,1,0.92,0.05,30,0,5,1,1.5,1200101,1)")),
            2);
}

TEST(TurnCycles, ThreadsThatAreNotRead) {
  const auto with = [](const std::string& vari, const std::string& rest) {
    return lathe_path("S500 M3\nCYCLE99(0,40,-30,40,2,1,0.92,0.05,30,0,5,1,1.5," + vari + ",1,1" +
                      rest + ")");
  };
  EXPECT_EQ(with("1310101", ""), "not-supported");
  EXPECT_EQ(with("1300101", ",0,0,0.1"), "not-supported");
  EXPECT_EQ(with("1300101", ",0,0,0,0,0,0,0,2"), "not-supported");
  EXPECT_EQ(with("1300101", ",0,0,0,0,0,0,0,1,,,,0,1"), "not-supported");
  EXPECT_EQ(lathe_path("CYCLE99(0,40,0,60,2,1,0.92,0.05,30,0,5,1,1.5,1300101,1)"), "not-supported");
  EXPECT_EQ(lathe_path("CYCLE99(0)"), "value-missing");
}

// Controls stop at such a contour (alarm 064); G70 and G73 run it as it stands.
TEST(TurnCycles, AContourThatEndsWithARapidHomeIsCutWithoutIt) {
  const std::string contour = " P1 Q3 U0 W0 F.2\nN1 G0 X20.\nG1 Z-20.\nX40.\nN3 G0 X100. Z5.\n";
  const auto run = [&](const std::string& cycle) {
    return read_text("G0 X100. Z5.\n" + cycle + contour,
                     at_origin(Dialect::fanuc, MachineKind::lathe));
  };
  const Program p = run("G71 U2. R1.\nG71");
  ASSERT_EQ(codes(p), "cycle-contour");
  EXPECT_NE(p.diagnostics[0].text.find("alarm 064"), std::string::npos);
  EXPECT_EQ(codes(run("G73 U2. W1. R2\nG73")), "");
}

// The passes go to their levels as the first block of the contour says: an arc without a radius cut
// nothing there.
TEST(TurnCycles, AContourThatBeginsWithAnArcIsRefused) {
  const Program p = read_text(
      "G0 X40. Z2.\nG71 U2. R1.\nG71 P1 Q3 U0 W0 F.2\nN1 G0\nG3 X20. Z-5. R20.\nG1 Z-20.\nN3 "
      "X42.\n",
      at_origin(Dialect::fanuc, MachineKind::lathe));
  ASSERT_EQ(codes(p), "cycle-contour");
  EXPECT_EQ(p.diagnostics[0].place.line, 5);
}

// U of a bore is below 0, of X below 0 too: else the roughing cuts beyond the contour.
TEST(TurnCycles, AnAllowanceIntoThePartIsToldOf) {
  const auto run = [&](const std::string& start, const std::string& cycle) {
    return codes(read_text(start + cycle + "N1 G0 X30.\nG1 Z-20.\nN2 " + start.substr(3, 4) + "\n",
                           at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  const std::string bore = "G0 X20. Z2.\n", shaft = "G0 X44. Z2.\n";
  EXPECT_EQ(run(bore, "G71 U2. R1.\nG71 P1 Q2 U.4 W.1 F.2\n"), "cycle-allowance");
  EXPECT_EQ(run(bore, "G71 U2. R1.\nG71 P1 Q2 U-.4 W.1 F.2\n"), "");
  EXPECT_EQ(run(shaft, "G71 U2. R1.\nG71 P1 Q2 U.4 W.1 F.2\n"), "");
  EXPECT_EQ(run(shaft, "G71 U2. R1.\nG71 P1 Q2 U-.4 W.1 F.2\n"), "cycle-allowance");
}

// The radius of the nose does not count on the way back: the contour is finished to its end, also
// where the way back would meet it in a sharp corner. The next move starts the compensation again.
TEST(TurnCycles, TheWayBackOfG70IsNotCompensated) {
  InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
  options.table.tools[0].nose_radius = 0.4;
  options.table.tools[0].tip = 3;
  const std::string contour = "M30\nN1 G0 X20.\nN2 G1 Z-20. F.1\n";
  EXPECT_EQ(path_text(read_text("G0 X40. Z2.\nG42\nG70 P1 Q2\nG40\nG0 X50.\n" + contour, options)),
            "r20,0,2 r10,0,1.6 l10,0,-20.4 r20,0,2 r25,0,2");
  EXPECT_EQ(
      path_text(read_text("G0 X40. Z2.\nG42\nG70 P1 Q2\nG0 X30.\nG1 Z-5. F.1\nG40 X50.\n" + contour,
                          options)),
      "r20,0,2 r10,0,1.6 l10,0,-20.4 r20,0,2 r15,0,1.6 l15,0,-5.4 l25,0,-5");
}

// Haas goes back so: "N20 G0 G40 Z0.1".
TEST(TurnCycles, AContourMayGoBackAboveAllOfIt) {
  const auto run = [&](const std::string& end, const char* top = "X44.\n") {
    return read_text(
        "G0 X44. Z2.\nG71 U2. R1.\nG71 P1 Q3 U0 W0 F.2\nN1 G0 X20.\nG1 Z-20.\n" + (top + end),
        at_origin(Dialect::fanuc, MachineKind::lathe));
  };
  const Program p = run("N3 G0 Z2.\n"), plain = run("N3\n");
  EXPECT_EQ(codes(p), "cycle-contour");
  EXPECT_EQ(path_text(p).substr(0, path_text(p).find(" | ")), path_text(plain));
  EXPECT_EQ(codes(plain), "");
  EXPECT_EQ(codes(run("N3 G0 Z5.\n")), "cycle-contour") << "beyond the start";
  EXPECT_EQ(codes(run("N3 G0 Z2.\n", "X42.\n")), "cycle-contour") << "inside of the start";
  EXPECT_EQ(codes(run("N3 G0 X44. Z2.\n", "X42.\n")), "cycle-contour") << "and out";
  EXPECT_EQ(codes(run("N3 G0 Z2.\n", "X42.\nZ-30.\nX30. Z-40.\n")), "not-supported") << "below";
}

// FANUC allows no point in P and Q of its cycles, so that a computed value counts thousandths
// there.
TEST(TurnCycles, ComputedValuesCountLeastIncrements) {
  const auto lathe = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  const std::string values = "#1=1.5\n#2=.5\n#3=1500\n#4=500\n";
  const std::string thread = values + "G0 X32. Z5.\nG76 P010060 Q100 R.05\nG76 X27. Z-20. ";
  const std::string said = lathe(thread + "P1500 Q500 F2.\n");
  EXPECT_EQ(lathe(thread + "P[#1*1000] Q[#2*1000] F2.\n"), said);
  EXPECT_EQ(lathe(thread + "P#3 Q#4 F2.\n"), said);
  EXPECT_EQ(lathe(thread + "P#1 Q#2 F2.\n"), said) << "lengths, on controls that allow a point";
  EXPECT_EQ(lathe(thread + "K#1 D#4 F2. A60\n"), lathe(thread + "K1.5 D500 F2. A60\n"));
  const std::string groove = values + "G0 X52. Z-20.\nG75 R.5\nG75 X40. Z-23. F.1 ";
  EXPECT_EQ(lathe(groove + "P#3 Q#3\n"), lathe(groove + "P1500 Q1500\n"));
  const std::string rough = "\nN1 G0 X40.\nN2 G1 Z-10. F.1\n", start = values + "G0 X52. Z2.\n";
  EXPECT_EQ(lathe(start + "G71 P1 Q2 U.4 W.1 D#3" + rough),
            lathe(start + "G71 P1 Q2 U.4 W.1 D1500" + rough));
  EXPECT_EQ(lathe(start + "G71 U#1 R#2\nG71 P1 Q2 U#2 W.1" + rough),
            lathe(start + "G71 U1.5 R.5\nG71 P1 Q2 U.5 W.1" + rough));
  EXPECT_EQ(lathe(values + "G0 X0 Z2.\nG83 Z-9. Q#3 F.1\n"),
            lathe("G0 X0 Z2.\nG83 Z-9. Q1500 F.1\n"));
}

}  // namespace
}  // namespace mrsim
