// G70 to G72.2 of LinuxCNC: passes worked out by hand from its manual. Places are X,Y,Z with X as
// a radius.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// A shaft of radius 8 and a collar of radius 14; the stock has radius 20.
constexpr char kCollar[] =
    "G18 G21 G8 F100\n"
    "O100 sub\nG0 X8\nG1 Z-10\nX14\nZ-20\nX20\nO100 endsub\n"
    "G0 X20 Z2\n";

Program run_profile(const std::string& text) {
  return read_text(text, at_origin(Dialect::ngc, MachineKind::lathe), "part.ngc");
}

std::string turned_path(const std::string& text) { return path_text(run_profile(text)); }

TEST(LinuxCncTurning, G71CutsLevelsFromTheStartDownAndThenAlongTheContour) {
  EXPECT_EQ(turned_path(std::string(kCollar) + "G71 Q100 I4 R1\nM2\n"),
            "r20,0,2 "
            "l20,0,-20 r21,0,-19 r21,0,1 r20,0,2 "
            "r16,0,2 l16,0,-20 r17,0,-19 r17,0,1 r16,0,2 "
            "r12,0,2 l12,0,-10 r13,0,-9 r13,0,1 r12,0,2 "
            "r8,0,2 l8,0,-10 l14,0,-10 l14,0,-20 l20,0,-20");
}

TEST(LinuxCncTurning, XAndZOfTheCycleAreWhereItBegins) {
  EXPECT_EQ(turned_path(std::string(kCollar) + "G0 X30 Z10\nG71 Q100 X20 Z2 I20 R1\nM2\n"),
            "r20,0,2 r30,0,10 r20,0,2 l20,0,-20 r21,0,-19 r21,0,1 r20,0,2 "
            "r8,0,2 l8,0,-10 l14,0,-10 l14,0,-20 l20,0,-20");
}

TEST(LinuxCncTurning, DiametersHoldForXAndU) {
  EXPECT_EQ(turned_path("G18 G7 F100\nO1 sub\nX16\nG1 W-12\nU12\nZ-20\nX40\nO1 endsub\n"
                        "G71 Q1 X40 Z2 I20 R1\nM2\n"),
            "r20,0,2 l20,0,-20 r21,0,-19 r21,0,1 r20,0,2 "
            "r8,0,2 l8,0,-10 l14,0,-10 l14,0,-20 l20,0,-20");
}

TEST(LinuxCncTurning, TheContourMayBeInInchesAndIncrements) {
  EXPECT_EQ(turned_path("G18 G20 F4\nO1 sub\nX-12\nG1 Z-12\nX6\nZ-10\nX6\nO1 endsub\n"
                        "G0 X20 Z2\nG91\nG71 Q1 X0 I20 R1\nM2\n"),
            "r508,0,50.8 l508,0,-508 r533.4,0,-482.6 r533.4,0,25.4 r508,0,50.8 "
            "r203.2,0,50.8 l203.2,0,-254 l355.6,0,-254 l355.6,0,-508 l508,0,-508");
}

TEST(LinuxCncTurning, G72CutsLevelsAlongX) {
  EXPECT_EQ(turned_path("G18 F100\nO1 sub\nG1 Z-4\nX30\nZ0\nO1 endsub\nG72 Q1 X50 Z0 I2 R1\nM2\n"),
            "r50,0,0 l30,0,0 r31,0,1 r49,0,1 r50,0,0 "
            "r50,0,-2 l30,0,-2 r31,0,-1 r49,0,-1 r50,0,-2 "
            "r50,0,-4 l30,0,-4 l30,0,0");
}

TEST(LinuxCncTurning, BoresAreCutOutwards) {
  EXPECT_EQ(turned_path("G18 F100\nO1 sub\nG1 X10\nZ-10\nX5\nO1 endsub\nG71 Q1 X5 Z1 I3 R1\nM2\n"),
            "r5,0,1 l5,0,-10 r4,0,-9 r4,0,0 r5,0,1 "
            "r8,0,1 l8,0,-10 r7,0,-9 r7,0,0 r8,0,1 "
            "r10,0,1 l10,0,-10 l5,0,-10");
}

// Radius 8 with a groove down to radius 6 between slopes of 45 degrees.
constexpr char kGroove[] =
    "G18 G21 F100\n"
    "O7 sub\nG0 X8\nG1 Z-10\nX6 Z-12\nZ-14\nX8 Z-16\nZ-20\nX10\nO7 endsub\n"
    "G0 X10 Z2\n";

TEST(LinuxCncTurning, G71_1LeavesPocketsAndG71_2CutsThem) {
  const std::string first =
      "r10,0,2 l10,0,-20 r10.5,0,-19.5 r10.5,0,1.5 r10,0,2 r9,0,2 l9,0,-20 r9.5,0,-19.5 r9.5,0,1.5 "
      "r9,0,2 r8,0,2 ";
  const std::string pocket =
      "l8,0,-10 l8,0,-16 r8.5,0,-15.5 r8.5,0,-10.5 l8,0,-10 "
      "l7,0,-11 l7,0,-15 r7.5,0,-14.5 r7.5,0,-11.5 l7,0,-11 "
      "l6,0,-12 l6,0,-14 l8,0,-16 l8,0,-20 l10,0,-20";
  EXPECT_EQ(turned_path(std::string(kGroove) + "G71.1 Q7 R0.5\nM2\n"),
            first + "l8,0,-10 l8,0,-16 l8,0,-20 l10,0,-20");
  EXPECT_EQ(turned_path(std::string(kGroove) + "G71.2 Q7 R0.5\nM2\n"), "r10,0,2 r8,0,2 " + pocket);
  EXPECT_EQ(turned_path(std::string(kGroove) + "G71 Q7 R0.5\nM2\n"), first + pocket);
}

TEST(LinuxCncTurning, DIsLeftOnTheContour) {
  // An inner corner stays sharp, an outer one is rounded with D.
  const Program p = run_profile(std::string(kCollar) + "G71 Q100 D0.5 I20 R1\nM2\n");
  EXPECT_EQ(path_text(p),
            "r20,0,2 l20,0,-19.5 r21,0,-18.5 r21,0,1 r20,0,2 "
            "r8.5,0,2 l8.5,0,-9.5 l14,0,-9.5 a14.5,0,-10 l14.5,0,-19.5 l20,0,-19.5");
  const Motion& arc = p.motions[p.motions.size() - 3];
  expect_near(arc.center, {14, 0, -10});
  EXPECT_NEAR(arc.radius, 0.5, 1e-12);
}

TEST(LinuxCncTurning, G70RunsPassesAtDistancesFromDToE) {
  const std::string contour = "G18 F100\nO1 sub\nX8\nG1 Z-10\nX14\nO1 endsub\n";
  EXPECT_EQ(turned_path(contour + "G70 Q1 X20 Z2 D1 E0 P2\nM2\n"),
            "r20,0,2 r8.5,0,2 l8.5,0,-9.5 l14,0,-9.5 "
            "r20,0,2 r8,0,2 l8,0,-10 l14,0,-10");
}

TEST(LinuxCncTurning, FilletsAndChamfersStandAtTheEndOfTheirBlock) {
  const std::string before = "G18 F100\nO1 sub\nX8\nG1 Z-10 ", behind = "\nX14\nO1 endsub\n";
  EXPECT_EQ(turned_path(before + "C1" + behind + "G70 Q1 X20 Z2\nM2\n"),
            "r20,0,2 r8,0,2 l8,0,-9 l9,0,-10 l14,0,-10");
  const Program p = run_profile(before + "A1" + behind + "G70 Q1 X20 Z2\nM2\n");
  EXPECT_EQ(path_text(p), "r20,0,2 r8,0,2 l8,0,-9 a9,0,-10 l14,0,-10");
  expect_near(p.motions[3].center, {9, 0, -9});
}

TEST(LinuxCncTurning, TheContourMayBranchAndCountAndKeepsNoFeed) {
  const Program p = run_profile(
      "G18 F100\nO1 sub\n#1=8\nX#1\nO2 while [#1 lt 14]\n#1=[#1+3]\nG1 X#1 F999\nZ[-5*#1]\n"
      "O2 endwhile\nO1 endsub\nG70 Q1 X20 Z2\nM2\n");
  EXPECT_EQ(path_text(p), "r20,0,2 r8,0,2 l11,0,2 l11,0,-55 l14,0,-55 l14,0,-70");
  for (const Motion& m : p.motions) EXPECT_EQ(m.feed, 100);
}

TEST(LinuxCncTurning, TheMotionInForceIsThatOfTheLastMove) {
  EXPECT_EQ(turned_path(std::string(kCollar) + "G70 Q100\nX25\nM2\n"),
            "r20,0,2 r8,0,2 l8,0,-10 l14,0,-10 l14,0,-20 l20,0,-20 l25,0,-20");
}

TEST(LinuxCncTurning, G76OfMach3IsNotThatOfLinuxCnc) {
  InterpOptions options = at_origin(Dialect::ngc);
  options.machine = MachineKind::lathe;
  EXPECT_EQ(codes(read_text("G18 G0 X24 Z4\nG76 X20.16 Z-15 Q1 P1.5 J0.1 L0 H0.3 I29.5 C1 B0 T0\n",
                            options)),
            "not-supported");
}

TEST(LinuxCncTurning, WhatCanNotBeCutIsRefused) {
  const auto refused = [](const std::string& text) {
    return codes(run_profile("F100\n" + text + "\nM2\n"), Severity::error);
  };
  const std::string sub = "O1 sub\nG1 X8\nZ-10\nX14\nO1 endsub\n";
  EXPECT_EQ(refused("G18\n" + sub + "G71.1 X20 Z2"), "value-missing");
  EXPECT_EQ(refused("G18\n" + sub + "G71 Q2 X20 Z2"), "subprogram-missing");
  EXPECT_EQ(refused("G17\n" + sub + "G71 Q1 X20 Z2"), "cycle-plane");
  EXPECT_EQ(refused("G18\n" + sub + "G42\nG71 Q1 X20 Z2\nG40"), "cycle-compensation");
  EXPECT_EQ(refused("G18\n" + sub + "G71 Q1 X20 Z2 I0"), "value-range");
  EXPECT_EQ(refused("G18\n" + sub + "G71 Q1 X20 Z2 U1"), "not-supported");
  EXPECT_EQ(refused("G18\n" + sub + "G70 Q1 X20 Z2 P0"), "value-range");
  EXPECT_EQ(refused("G18\n" + sub + "G70 Q1 X20 Z2 M2"), "call-not-alone");
  EXPECT_EQ(refused("G18\n" + sub + "G70 Q1 X20 Z2 M98 P1"), "call-not-alone");
  EXPECT_EQ(refused("G18\nO1 sub\nG1 X8\nZ-10\nX9 Z-5\nX14\nO1 endsub\nG71 Q1 X20 Z2"),
            "cycle-contour");
  EXPECT_EQ(refused("G18\nO1 sub\nG1 X8\nG33 Z-10 K1\nX14\nO1 endsub\nG71 Q1 X20 Z2"),
            "cycle-contour");
  EXPECT_EQ(refused("G18\nO1 sub\nG1 X8\nZ-10 A1 C1\nX14\nO1 endsub\nG71 Q1 X20 Z2"),
            "cycle-contour");
  EXPECT_EQ(refused("G18\nO1 sub\nG1 X8\nZ-10 A50\nX14\nO1 endsub\nG71 Q1 X20 Z2"),
            "cycle-contour");
  EXPECT_EQ(refused("G18\nO1 sub\nG1 X8\nG2 X9 Z-10 R0.5\nG1 X14\nO1 endsub\nG71 Q1 X20 Z2"),
            "arc-radius-too-small");
}

}  // namespace
}  // namespace mrsim
