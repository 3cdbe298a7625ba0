// What makers of mills read in their own way under a control of FANUC's kind: Okuma's OSP,
// Mitsubishi and Mazak, Centroid.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// NCYL: the tool goes to the place, no hole is made there; the cycle is in force behind it.
TEST(MillMakers, NcylOfOkumaDrillsNoHole) {
  const std::string holes = "G15 H1\nG0 X0 Y0 Z9\nG71 Z50\nNCYL G81 X1 Z-5 R2 F100 M53\nX3\n";
  EXPECT_EQ(mill(holes), "r0,0,9 r1,0,9 r3,0,9 r3,0,2 l3,0,-5 r3,0,50");
  EXPECT_EQ(mill("G15 H1\nG0 X0 Y0 Z9\nG71 Z50\nNCYL G81 Z-5 R2 F100 M53\nX3\nNCYL X4\nX5\n"),
            "r0,0,9 r3,0,9 r3,0,2 l3,0,-5 r3,0,50 r4,0,50 r5,0,50 r5,0,2 l5,0,-5 r5,0,50");
  EXPECT_EQ(mill("NCYL G1 X5 F100\n"), "l5,0,0") << "without a cycle it says nothing";
}

// G11 X Y Z P shifts the zero and turns about it, G10 ends that.
TEST(MillMakers, G11OfOkumaShiftsAndTurnsTheZero) {
  EXPECT_EQ(mill("G15 H1\nG11 X50 Y20 P90\nG1 X10 Y0 F100\nG11 X0 Y0 Z-1 P180\nX1 Y0 Z0\nG10\n"
                 "X2 Y0 Z0\n"),
            "l50,30,0 l-1,0,-1 l2,0,0");
  EXPECT_EQ(mill("G11 X50 P90\nG1 X10 Y0 F100\nG11 X20\nG10\nG1 X1 Y0\n"),
            "l50,10,0 l1,0,0 | not-supported")
      << "whether P90 holds on is not known";
  EXPECT_EQ(mill("G11 X5\nG1 X1 F100\nG10\nX1\n"), "l6,0,0 l1,0,0") << "G15 H is not needed";
  EXPECT_EQ(mill("G18 G11 X5 P90\nG1 Z1 F100\n"), "l6,0,0") << "from Z towards X";
  EXPECT_EQ(mill("G91 G11 X5\nG1 X1 F100\n"), "l1,0,0 | not-supported");
  EXPECT_EQ(mill("G10 L13 P1 R0.2\nG11\nG1 X1 F100\n"), "l1,0,0") << "FANUC's end of data";
  EXPECT_EQ(mill("G10\nG1 X1 F100\n"), "l1,0,0 | value-missing");
}

// G62 X1 mirrors on Okuma's; elsewhere G62 slows corners down, and its axes move.
TEST(MillMakers, MirrorOfOkumaIsRefused) {
  EXPECT_EQ(mill("G15 H1\nG62 X1 Y0\nG1 X5 F100\n"), "l5,0,0 | not-supported");
  EXPECT_EQ(mill("G62 G1 X5. F100\n"), "l5,0,0");
}

// HA and DA are the registers of the tool in the spindle.
TEST(MillMakers, HaAndDaAreRegistersOfTheToolInTheSpindle) {
  InterpOptions options = at_origin(Dialect::fanuc);
  for (const char* name : {"D7", "H7"}) {
    OffsetRegister offset;
    offset.name = name;
    offset.radius = 2;
    offset.length = 3;
    options.table.offsets.push_back(offset);
  }
  options.table.tools[0].id = "7";
  const std::string start = "G15 H1\nT7 M6\n";
  EXPECT_EQ(path_text(read_text(start + "G56 Z15. HA\nG1 G41 DA X20. F100\nX30.\n", options)),
            "r0,0,18 l20,2,18 l30,2,18");
  EXPECT_EQ(codes(read_text(start + "G1 G41 DB X20. F100\n", options)), "value-missing");
  EXPECT_EQ(codes(read_text("G1 G41 DA X20. F100\n", options)), "value-missing");
}

// G20 HP=1 is a home position, not inches; G131 tells how exact a path is.
TEST(MillMakers, G20OfOkumaGoesToAHomePosition) {
  const Program p = read_text(
      "G15 H1\nG20 HP=1\nG1 X5. Y0 Z0 F100\nG131 F.01 E.01 J3 D1\nX6.\n"
      "G130\nG30 HP=3\n",
      at_origin(Dialect::fanuc));
  EXPECT_EQ(path_text(p), "l5,0,0 l6,0,0");
  EXPECT_TRUE(p.motions[0].assumed_start);
  EXPECT_EQ(p.motions[1].feed, 100);
  EXPECT_EQ(mill("g15 h1\ng20 hp=1\ng1 x5. y0 z0 f100\n"), "l5,0,0");
  EXPECT_EQ(mill("G15 H1\nG0 Z9\nG81 X1 Z-5 R2 F100 M54\n"), "r0,0,9 r1,0,9 r1,0,2 l1,0,-5 r1,0,2");
}

// E chooses a work offset on Fadal and Centroid.
TEST(MillMakers, EChoosesAWorkOffset) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.table.work.push_back({"E2", {10, 20, 0}});
  const std::string path = "G0 G90 S1000 M3 E2 X1. Y2.\nH1 Z5.\nG1 Z-1. F100\nE1 X3. Y0\n";
  const Program p = read_text("T1 M6\n" + path, options);
  EXPECT_EQ(path_text(p), "r11,22,0 r11,22,5 l11,22,-1 l3,0,-1");
  EXPECT_NE(codes(p, Severity::note).find("work-offset-unset"), std::string::npos);
  const Program home = read_text(path + "G0 E0 X0 Y0\nG1 Z-2.\n", options);
  EXPECT_TRUE(home.motions.back().assumed_start);
  EXPECT_EQ(mill("G1 X1.5E-2 F100\n"), " | number-malformed");
}

// R0+.1 of Fadal is R.1.
TEST(MillMakers, FadalGivesTheLevelOfACycleInR0) {
  const std::string hole = "r1,0,2 l1,0,-5 r1,0,2 r3,0,2 l3,0,-5 r3,0,2";
  EXPECT_EQ(mill("G99 G81 X1. R0+2. Z-5. F100\nX3.\n"), "r1,0,0 " + hole);
}

// G59 P of Mach: P1 to P6 are G54 to G59, those behind them the offsets of G10 L2 P7 to P9.
TEST(MillMakers, G59OfMachChoosesAWorkOffsetByP) {
  const auto mach = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::ngc)));
  };
  EXPECT_EQ(mach("G10 L2 P7 X5\nG59 P7\nG1 X1 F100\n"), "l6,0,0");
  EXPECT_EQ(mach("G10 L2 P2 X5\nG59 P2\nG1 X1 F100\nG54 X1\n"), "l6,0,0 l1,0,0");
  EXPECT_EQ(mach("G59 P10\nG1 X1 F100\n"), "l1,0,0 | value-range");
  EXPECT_EQ(mill("G10 L2 P3 X5.\nG59 P3\nG1 X1. F100\n"), "l6,0,0");
}

// Programs of Mach are read as LinuxCNC's, which lacks these words. X Y Z of G51 are factors.
TEST(MillMakers, MachTurnsScalesAndMillsCircles) {
  const auto mach = [](const std::string& text) {
    return path_text(read_text("(MACH3)\nF100\n" + text + "M30\n", at_origin(Dialect::ngc)));
  };
  EXPECT_EQ(mach("G68 A10 B10 R90\nG1 X20 Y10\nG69\nX0\n"), "l10,20,0 l0,20,0");
  EXPECT_EQ(mach("G68 X10 Y10 R90\nG1 X20 Y10\nG69 X0\n"), "l10,20,0 l0,20,0");
  EXPECT_EQ(mach("G20 G51 X2 Y.5\nG1 X1 Y1\nG50\nX1\n"), "l50.8,12.7,0 l25.4,12.7,0");
  EXPECT_EQ(mach("G51 X0 Y0 P2.\nG1 X1 Y1\nG91 X1\nG50\n"), "l2,2,0 l4,2,0");
  EXPECT_EQ(mach("G51\nG1 X1\n"), "l1,0,0 | value-missing");
  EXPECT_EQ(mach("G51 Z0\nG1 X1\n"), "l1,0,0 | value-range");
  EXPECT_EQ(mach("G1 X3\nG12 I5\n"), "l3,0,0 l8,0,0 a8,0,0 l3,0,0");
  EXPECT_EQ(mach("G16\nG1 X1\n"), "l1,0,0 | g-unknown") << "its pole is where the tool is";
}

// A program that names no control may be one of Mach's.
TEST(MillMakers, ThePoleOfG16OffTheZeroIsAWarning) {
  const auto iso = [](const std::string& text) {
    return path_text(read_text("F100\n" + text, at_origin(Dialect::iso)));
  };
  EXPECT_EQ(iso("G1 X3 Y4\nG16\nG1 X10 Y90\n"), "l3,4,0 l0,10,0 | polar-pole");
  EXPECT_EQ(iso("G1 Z-1\nG16\nG1 X10 Y90\n"), "l0,0,-1 l0,10,-1");
  EXPECT_EQ(mill("G1 X3. Y4. F100\nG16\nG1 X10. Y90.\n"), "l3,4,0 l0,10,0");
}

// What the controls of this kind do not read alike is told.
TEST(MillMakers, WordsThatControlsReadDifferentlyAreWarnings) {
  EXPECT_EQ(mill("G1 X5. F100\nG90 X10. G91 Y5.\n"), "l5,0,0 l15,5,0 | group-twice");
  EXPECT_EQ(mill("G1 X5. F100\nX10. G90 G91 Y5.\n"), "l5,0,0 l15,5,0");
  EXPECT_EQ(mill("G1 X5. F100\nG91 G92 X10.\nG90 X12.\n"), "l5,0,0 l7,0,0 | position-added");
  EXPECT_EQ(mill("G1 X5. F100\nG91 G92 X0\nG90 X2.\n"), "l5,0,0 l7,0,0");
}

// Behind G49 and H0 lengths are those of the spindle's nose: Z0 is its upper end.
TEST(MillMakers, ZeroWithoutTheToolsLengthIsTheMachines) {
  const auto unknown = [](const std::string& leave, Dialect dialect = Dialect::fanuc) {
    const Program p = read_text("G43 H1 G0 Z9.\nG1 Z-1. F100\n" + leave + "\nX5.\nG0 Z3.\nG1 X6.\n",
                                at_origin(dialect));
    std::string out;
    for (const Motion& m : p.motions) out += m.assumed_start ? '?' : '.';
    return out;
  };
  EXPECT_EQ(unknown("G0 G49 Z0"), "..??.");
  EXPECT_EQ(unknown("G0 H0 Z0."), "..??.");
  EXPECT_EQ(unknown("G49\nG0 Z0"), "......");
  EXPECT_EQ(unknown("G49\nG0 H0 Z0"), "..??.") << "Fadal's lengths need no G43";
  EXPECT_EQ(unknown("G0 G43 H0 Z0"), "......");
  EXPECT_EQ(unknown("G0 G49 Z50."), "......");
  EXPECT_EQ(unknown("G0 Z0"), "......");
  EXPECT_EQ(unknown("G91 G0 G49 Z0\nG90"), ".....");
  EXPECT_EQ(unknown("G0 G49 Z0 X3."), "..???.");
}

// A helix of Mitsubishi and Mazak: P full turns, and the arc that is written.
TEST(MillMakers, TurnsOfAHelixComeBesideItsArc) {
  const auto sweep = [](const std::string& arc) {
    return degrees(
        read_text("G1 X10 F100\n" + arc, at_origin(Dialect::fanuc)).motions.back().sweep);
  };
  EXPECT_NEAR(sweep("G3 X-10 I-10 Z-3 P1\n"), 540, 1e-9);
  EXPECT_NEAR(sweep("G2 X-10 R10 Z-3 P2\n"), -900, 1e-9);
  EXPECT_NEAR(sweep("G3 X-10 I-10 Z-3 P0\n"), 180, 1e-9);
  EXPECT_NEAR(sweep("G3 X10 I-10 Z-3 P1\n"), 360, 1e-9) << "no arc beside the turn";
  EXPECT_NEAR(sweep("G3 I-10 Z-3 P3\n"), 1080, 1e-9);
  EXPECT_EQ(mill("G1 X10 F100\nG3 X-10 I-10 Z-3 P1\n"), "l10,0,0 a-10,0,-3 | arc-turns");
  EXPECT_EQ(mill("G1 X10 F100\nG3 I-10 Z-3 P2\n"), "l10,0,0 a10,0,-3");
}

// G51 P2000 is FANUC's factor 2; P2 of Centroid and Okuma is 2, which FANUC would call 0.002.
TEST(MillMakers, ScaleFactorsWithoutAPointAreDoubted) {
  EXPECT_EQ(mill("G51 X0 Y0 P2000\nG1 X5 F100\n"), "l10,0,0");
  EXPECT_EQ(mill("G51 X0 Y0 P500\nG1 X5 F100\n"), "l2.5,0,0");
  EXPECT_EQ(mill("G51 X0 Y0 P2\nG1 X5 F100\n"), "l10,0,0 | number-without-point");
  EXPECT_EQ(mill("G51 X0 Y0 I2 J-1 K1\nG1 X5 Y5 F100\n"), "l10,-5,0 | number-without-point");
  EXPECT_EQ(mill("G51 X0 Y0 P2.\nG1 X5 F100\n"), "l10,0,0");
}

}  // namespace
}  // namespace mrsim
