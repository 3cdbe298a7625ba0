// Radius compensation as LinuxCNC's interpreter does it, where other controls do otherwise.
#include "interp/support.h"

#include <cmath>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// A tool of radius 2 goes along X to 20, left of the contour.
std::string beside(const std::string& text) {
  return path_text(
      read_text("F9\nG41.1 D4\nG1 X20\n" + text + "M2\n", at_origin(Dialect::ngc), "part.ngc"));
}

// Below 0.05 radians there is no corner, neither outside nor inside.
TEST(LinuxCncCompensation, SmallTurnsHaveNoCorner) {
  EXPECT_EQ(beside("X40\nX59.9761 Y-0.977\n"), "l20,2,0 l40,2,0 l60.07,1.021,0");
  EXPECT_EQ(beside("X40\nX59.9749 Y-1.0014\n"), "l20,2,0 l40,2,0 a40.1,1.997,0 l60.08,0.9961,0");
  EXPECT_EQ(beside("X40\nX59.9761 Y0.977\n"), "l20,2,0 l40,2,0 l59.88,2.975,0");
  EXPECT_EQ(beside("X40\nX59.9749 Y1.0014\n"), "l20,2,0 l39.95,2,0 l59.87,2.999,0");
}

// A turn back is an outside corner, and so is one a little less; which arcs shift.
TEST(LinuxCncCompensation, TurnsBackAreOutside) {
  EXPECT_EQ(beside("X40\nX30.0015 Y0.1745\n"), "l20,2,0 l40,2,0 a39.97,-2,0 l29.97,-1.825,0");
  EXPECT_EQ(beside("X40\nG3 X32 Y-8 J-8\n"), "l20,2,0 l40,2,0 a40,-2,0 a34,-8,0");
  EXPECT_EQ(beside("X40\nG2 X32 Y8 J8\n"), "l20,2,0 l32,2,0 a30,8,0");
}

TEST(LinuxCncCompensation, RapidsGoStraightAboutACorner) {
  EXPECT_EQ(beside("X40\nG0 Y-20\n"), "l20,2,0 l40,2,0 r42,0,0 r42,-20,0");
  EXPECT_EQ(beside("G0 X40\nG1 Y-20\n"), "l20,2,0 r40,2,0 a42,0,0 l42,-20,0");
}

// No element is left out: one that is too short for its inside corners is refused, but not before
// a line straight on, nor before an arc behind an outside corner.
TEST(LinuxCncCompensation, AnElementSeesTheNextOneAlone) {
  EXPECT_EQ(beside("X40\nY3\nX10\n"), "l20,2,0 l38,2,0 l38,1,0 l10,1,0 | comp-interference");
  EXPECT_EQ(beside("X40\nY1\n"), "l20,2,0 l38,2,0 l38,1,0 | comp-interference");
  EXPECT_EQ(beside("X40\nY1\nY30\n"), "l20,2,0 l38,2,0 l38,1,0 l38,30,0");
  EXPECT_EQ(beside("X40\nY1\nG2 X50 Y11 I10\n"), "l20,2,0 l38,2,0 l38,1,0 a50,13,0");
  EXPECT_EQ(beside("X20.1 Y-1\nX10\nY30\n"),
            "l20,2,0 a21.99,0.199,0 l22.09,-0.801,0 a20.1,-3,0 l10,-3,0 a8,-1,0 l8,30,0");
}

TEST(LinuxCncCompensation, AnInsideCornerLiesBeforeTheEndOfALine) {
  EXPECT_EQ(beside("X40\nG2 X36 Y4 J4 I0\n"), "l20,2,0 l34.34,2,0 a34,4,0");
}

// The entry may be an arc: it ends beside its own end, in the same direction.
TEST(LinuxCncCompensation, AnArcMayBeginIt) {
  const auto entry = [](const std::string& text) {
    return path_text(read_text("F9\nG41.1 D2\n" + text + "M2\n", at_origin(Dialect::ngc)));
  };
  EXPECT_EQ(entry("G3 X10 Y10 J10\nG1 Y20\n"), "a9,10,0 l9,20,0");
  EXPECT_EQ(entry("G2 X10 Y-10 J-10\nG1 Y-20\n"), "a11,-10,0 l11,-20,0");
  EXPECT_NE(entry("G2 J-5\nG1 X10\n").find("comp-entry"), std::string::npos);
  EXPECT_EQ(entry("G3 X10 Y-1 I10 J49.5\nG1 X20\n"), "l10,0,0 l20,0,0");  // along its end
  const Program p =
      read_text("F9\nG41.1 D2\nG3 X10 Y10 J10\nG1 Y20\nM2\n", at_origin(Dialect::ngc));
  expect_near(p.motions[0].center, {-95.0 / 90, 10, 0});
}

// The nose of a lathe's tool stands at the end of its entry.
TEST(LinuxCncCompensation, AnEntryThatLeadsNowhereIsAnError) {
  InterpOptions options = at_origin(Dialect::ngc);
  options.machine = MachineKind::lathe;
  Tool tool;
  tool.type = ToolType::turning;
  tool.nose_radius = 0.4;
  options.table.tools.push_back(tool);
  const Program p = read_text("F9\nG42 D1\nG2 I1\nG1 X5 Z-11.4\nM2\n", options);
  for (const Motion& motion : p.motions) EXPECT_TRUE(std::isfinite(motion.end.z + motion.radius));
  EXPECT_NE(path_text(p).find("comp-"), std::string::npos);
}

// L of G42.1 is LinuxCNC's orientation of the tip: 2 lies towards -X and -Z. Without L, and with 0
// or 9, the path is that of the nose's centre.
TEST(LinuxCncCompensation, LBesideG421IsTheTipOfALathe) {
  InterpOptions options = at_origin(Dialect::ngc);
  options.machine = MachineKind::lathe;
  options.table.tools[0].type = ToolType::turning;
  options.table.tools[0].nose_radius = 0.8;
  const auto turned = [&](const std::string& words) {
    return path_text(
        read_text("G7 G18 G21\nF9\nG0 X30 Z5\n" + words + " G1 X20 Z2\nZ-10\nX30\nG40 G0 X60\nM2\n",
                  options));
  };
  EXPECT_EQ(turned("G42.1 D1.6 L2"), turned("G42 D1"));
  EXPECT_EQ(turned("G41.1 D-1.6 L2"), turned("G42 D1"));
  EXPECT_NE(turned("G42.1 D1.6"), turned("G42 D1"));
  EXPECT_NE(turned("G42.1 D1.6").find("| nose-differs"), std::string::npos);
  EXPECT_NE(turned("G42.1 D1.6 L3").find("| nose-differs"), std::string::npos);
  EXPECT_NE(turned("G42.1 D1.6 L10").find("| value-range"), std::string::npos);
  options.table.tools[0].tip_is_nose_centre = true;
  EXPECT_EQ(turned("G42.1 D1.6").find('|'), std::string::npos);
  EXPECT_EQ(path_text(read_text("F9\nG42.1 D2 L2\nG1 X5\nM2\n", at_origin(Dialect::ngc))),
            "l5,0,0 | comp-plane");
}

// What its interpreter, and that of Mach, refuse between G41 and G40.
TEST(LinuxCncCompensation, WhatMustNotStandWithinIt) {
  for (const char* text : {"T1 M6", "G55", "G92 X3", "G52 X3", "G28", "G53 G0 X5", "G42.1 D4"})
    EXPECT_EQ(beside("X40\n" + std::string(text) + "\n"), "l20,2,0 l40,2,0 | comp-active") << text;
  EXPECT_EQ(beside("X40\nG41.1 D4\nX50\n"), "l20,2,0 l40,2,0 l50,2,0 | comp-active");
  EXPECT_EQ(beside("X40\nG40 G55 G0 X60\n"), "l20,2,0 l40,2,0 r60,0,0");
  EXPECT_EQ(beside("X40\nG50 G69\nX50\n"), "l20,2,0 l40,2,0 l50,2,0");
  EXPECT_EQ(path_text(read_text("F9\nG19\nG41.1 D2\nG1 Y5\nM2\n", at_origin(Dialect::ngc))),
            "l0,5,0 | comp-plane");
}

}  // namespace
}  // namespace mrsim
