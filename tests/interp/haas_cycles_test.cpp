// G12, G13 and G70 to G72 of Haas mills: the motions of the manual's pictures, by hand.
#include "interp/recognise/recognise.h"
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string haas_path(const std::string& text) {
  return path_text(read_text(text, at_origin(Dialect::fanuc)));
}

// One hole: rapid beside, to R, down, out to R.
std::string hole(const std::string& at) {
  return fmt::format(" r{0},10 r{0},2 l{0},-5 r{0},10", at);
}

TEST(HaasCycles, G70ToG72DrillOnACircleAnArcAndALine) {
  const std::string start = "G0 X50. Y10. Z10.\nG81 G98 Z-5. R2. F100. L0\n";
  EXPECT_EQ(haas_path(start + "G70 I10. J90. L4\nG80\n"),
            "r50,10,10" + hole("50,20") + hole("40,10") + hole("50,0") + hole("60,10"));
  EXPECT_EQ(haas_path(start + "G71 X0 Y0 I10. J0 K-90. L2\nG80\n"),
            "r50,10,10" + hole("10,0") + hole("0,-10"));
  EXPECT_EQ(haas_path(start + "G72 I5. J90. L3\nG80\n"),
            "r50,10,10" + hole("50,10").substr(10) + hole("50,15") + hole("50,20"));
  EXPECT_EQ(haas_path("G0 Z10.\nG81 G98 G70 I10. L1 Z-5. R2. F100.\n"), "r0,0,10" + hole("10,0"));
  EXPECT_EQ(haas_path("G0 Z10.\nG70 I10. L4\n"), "r0,0,10 | value-missing") << "no cycle";
}

TEST(HaasCycles, MitsubishisPatternsDrillTheirHoles) {
  const std::string start = "G0 X50. Y10. Z10.\nG82 G98 Z-5. R2. F100. L0\n", at = "r50,10,10";
  EXPECT_EQ(haas_path(start + "G34 X0 Y0 I10. J90. K4\nG80\n"),
            at + hole("0,10") + hole("-10,0") + hole("0,-10") + hole("10,0"));
  EXPECT_EQ(haas_path(start + "G34 X0 Y0 I10. J90. K-4\nG80\n"),
            at + hole("0,10") + hole("10,0") + hole("0,-10") + hole("-10,0"));
  EXPECT_EQ(haas_path(start + "G35 X20. Y0 I5. J90. K3\nG80\n"),
            at + hole("20,0") + hole("20,5") + hole("20,10"));
  EXPECT_EQ(haas_path(start + "G36 X0 Y0 I10. J0 P90. K2\nG80\n"),
            at + hole("10,0") + hole("0,10"));
  EXPECT_EQ(haas_path(start + "G37.1 X0 Y0 I10. P2 J20. K2\nG80\n"),
            at + hole("0,0") + hole("10,0") + hole("10,20") + hole("0,20"));
  EXPECT_EQ(haas_path(start + "G36 X0 Y0 I10. J0 K2\nG80\n"), at + " | value-missing");
  EXPECT_EQ(haas_path(start + "G34 X0 Y0 I10. J0 K0\nG80\n"), at + " | value-range");
  EXPECT_EQ(haas_path("G0 Z10.\nG34 I10. J0 K4\n"), "r0,0,10 | value-missing") << "no cycle";
  const Program p =
      read_text(start + "G36 X0 Y0 I10. J0 P90. K2\nG80\n", at_origin(Dialect::fanuc));
  EXPECT_TRUE(dwells_of(p).empty()) << "P is the pattern's";
}

TEST(HaasCycles, AloneG70AndG71AreTheUnits) {
  EXPECT_EQ(haas_path("G40 G17 G90 G70\nG1 X1. F10.\nG71\nX1.\n"), "l25.4,0,0 l1,0,0");
}

// Tool radius 5: the path's radii are 3, 7, 10; each circle begins and ends towards +X.
TEST(HaasCycles, G12AndG13ClearCircularPockets) {
  EXPECT_EQ(haas_path("G0 Z1.\nG13 Z-2. I8. F100. D1\n"), "r0,0,1 l0,0,-2 a3,0,-2 a3,0,-2 a0,0,-2");
  EXPECT_EQ(haas_path("G0 Z0\nG12 G91 Z-2. I8. K15. Q4. L2 D1 F100.\nG90\n"),
            "l0,0,-2 a3,0,-2 a3,0,-2 l7,0,-2 a7,0,-2 l10,0,-2 a10,0,-2 a0,0,-2 "
            "l0,0,-4 a3,0,-4 a3,0,-4 l7,0,-4 a7,0,-4 l10,0,-4 a10,0,-4 a0,0,-4");
  EXPECT_EQ(haas_path("G51 X0 Y0 I2. J2. K1.\nG13 Z-2. I8. F100. D1\n"),
            "l0,0,-2 a11,0,-2 a11,0,-2 a0,0,-2")
      << "G51 scales I, not the tool";
  EXPECT_EQ(haas_path("G51 X0 Y0 I2. J1. K1.\nG13 Z-2. I8. F100. D1\n"), " | arc-scaled-unequally");
  const Program p = read_text("G13 Z-2. I8. F100. D1\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(p.motions.size(), 4U);
  EXPECT_NEAR(p.motions[2].sweep, kTwoPi, 1e-12);
  EXPECT_NEAR(p.motions[2].radius, 3, 1e-12);
  EXPECT_EQ(haas_path("G13 Z-2. I4. F100. D1\n"), " | value-range");
  EXPECT_EQ(haas_path("G1 Z-3. F9.\nG13 I8. F100. D1\nX1.\n"),
            "l0,0,-3 a3,0,-3 a3,0,-3 a0,0,-3 l1,0,-3")
      << "without Z: where the tool stands";
  EXPECT_EQ(haas_path("G1 Z-3. F9.\nG13 I8. F100.\n"), "l0,0,-3 | value-missing") << "or Mach's";
  EXPECT_EQ(haas_path("G13 Z-2. I5. K9. Q2.5 F100. D1\n"),
            "l0,0,-2 a2.5,0,-2 a2.5,0,-2 l4,0,-2 a4,0,-2 a0,0,-2")
      << "I is the tool's radius: no first circle";
  EXPECT_EQ(codes(read_text("G13 Z-2. I30. F100. D1\n", at_origin(Dialect::fanuc)), Severity::note),
            "cycle-entry");
}

// Mach: along X by I, round, and back, at the depth where the tool is.
TEST(HaasCycles, G12OfMachGoesRoundOnce) {
  const auto mach = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::iso)));
  };
  EXPECT_EQ(mach("G1 X20 Y20 F9\nG12 I10\nG1 X0\n"),
            mach("G1 X20 Y20 F9\nG1 X30\nG2 I-10 J0\nG1 X20\nX0\n"));
  EXPECT_EQ(mach("G20 G1 X2 Y0 F9\nG91 G13 I1.\nG1 X1\n"),
            mach("G20 G1 X2 Y0 F9\nG1 X3\nG3 I-1. J0\nG1 X2\nX3\n"));
  EXPECT_EQ(mach("G1 X5 F9\nG12 I0\n"), "l5,0,0 | value-range");
  EXPECT_EQ(mach("G1 X5 F9\nG12 I5 X9\n"), "l5,0,0 | not-supported");
  const std::string text = "G21 G90\nM3 S900\nG1 X20 Y20 F9\nG12 I10\nM30\n";
  EXPECT_EQ(recognise(TempFolder().write("a.tap", "(Mach3)\n" + text), {}).dialect, Dialect::iso);
  EXPECT_EQ(recognise(TempFolder().write("a.nc", text), {}).dialect, Dialect::iso);
}

// The wall keeps the radius of 5; two cuts of 3 leave 1 mm, which the last one takes at the depth.
TEST(HaasCycles, G150ClearsThePocketOfAContour) {
  const std::string contour = "N100 G1 Y20.\nX0\nY0\nX20.\nY20.\nX10.\nM99\n";
  const std::string expected =
      "r10,10,0 r10,10,1 r10,14,1 l10,14,-2 l6,14,-2 l6,6,-2 l14,6,-2 l14,14,-2 l10,14,-2 "
      "r10,14,1 r10,14,-2 l10,14,-5 l6,14,-5 l6,6,-5 l14,6,-5 l14,14,-5 l10,14,-5 r10,14,1 "
      "r10,15,1 l10,15,-5 l5,15,-5 l5,5,-5 l15,5,-5 l15,15,-5 l10,15,-5 r10,15,1 r10,10,1 "
      "r10,10,20";
  const std::string call = "G150 P100 X10. Y10. Z-5. G41 J5. K1. Q3. R1. D1 F100.\nG40 X10. Y10.\n";
  EXPECT_EQ(haas_path(call + "G0 Z20.\nM30\n" + contour), expected);
  EXPECT_EQ(haas_path("G150 P100 X10. Y10. Z-5. J5. Q3. R1. F100.\nM30\n" + contour),
            " | not-supported");
  EXPECT_EQ(haas_path("G150 P100 X10. Y10. Z-5. G41 D1 Q3. R1. F100.\nM30\n" + contour),
            " | value-missing");
  EXPECT_EQ(haas_path("G150 P99 X10. Y10. Z-5. G41 J5. Q3. R1. D1 F100.\nM30\n" + contour),
            " | subprogram-missing");
  // With G42 the cutter would run outside; so would it along an open contour.
  EXPECT_EQ(haas_path("G150 P100 X10. Y10. Z-5. G42 J5. Q3. R1. D1 F100.\nM30\n" + contour),
            "r10,10,0 r10,10,1 | pocket-contour");
  EXPECT_EQ(
      haas_path("G150 P100 X10. Y10. Z-5. G41 J5. Q3. R1. D1 F100.\nM30\nN100 G1 Y20.\nX0\nY0\n"
                "M99\n"),
      "r10,10,0 r10,10,1 | pocket-contour");
}

// Beside Q of G73 Haas' K is the depth after which the tool comes out to R; it was 3 repeats.
TEST(HaasCycles, KOfG73IsTheDepthBetweenWaysOut) {
  const std::string start = "G0 Z10.\nG73 G98 Z-6. R2. Q2. ";
  EXPECT_EQ(haas_path(start + "K4. F9.\nG80\n"),
            "r0,0,10 r0,0,2 l0,0,0 r0,0,0.254 l0,0,-2 r0,0,2 r0,0,-1.746 l0,0,-4 r0,0,-3.746 "
            "l0,0,-6 r0,0,10");
  EXPECT_EQ(haas_path("G91 " + start.substr(0, start.find("Z-6")) + "X5. Z-4. R-8. Q9. K3.5 F9.\n"),
            "r0,0,10 r5,0,10 r5,0,2 l5,0,-2 r5,0,10");
  EXPECT_EQ(haas_path(start + "K2 F9. X5.\nG80\n"), haas_path(start + "F9. X5.\nX5.\nG80\n"))
      << "FANUC's repeats have no point";
  EXPECT_EQ(haas_path("#1=3\nG91 " + start + "K#1 F9. X5.\nG80\n").find("r5"), std::string::npos)
      << "three holes, or one";
}

}  // namespace
}  // namespace mrsim
