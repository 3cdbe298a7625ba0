// SINUMERIK's cycles along a contour, and its thread, as worked out by hand.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string ends(const Program& p, bool lathe) {
  std::string out;
  for (const Motion& m : p.motions)
    out += fmt::format("{}{:.6g},{:.6g}{} ",
                       m.kind == MotionKind::rapid  ? "r"
                       : m.kind == MotionKind::line ? "l"
                                                    : "a",
                       m.end.x + 0.0, (lathe ? m.end.z : m.end.y) + 0.0,
                       lathe ? "" : fmt::format(",{:.6g}", m.end.z + 0.0));
  return out + codes(p);
}

std::string milled(const std::string& text) {
  return ends(read_text("T1 D1 M6\nG0 X50 Y50 Z50\n" + text, at_origin(Dialect::sinumerik)), false);
}

std::string turned(const std::string& text) {
  return ends(read_text(text, at_origin(Dialect::sinumerik, MachineKind::lathe)), true);
}

const char* const kSquareContour = "G1 X0 Y0\nY20\nX20\nY0\nX0\n";

TEST(SinumerikContours, Cycle72MillsAlongAContour) {
  // Clockwise with the cutter outside; straight in and out over 7 mm, two infeeds.
  const std::string cycle =
      "CYCLE72(\"SQUARE\",50,0,2,-4,2,0,0,500,200,11,41,1,7,200,1,7)\nM30\n%_N_SQUARE_SPF\n";
  const std::string once =
      "l-5,-7,{0} l-5,0,{0} l-5,20,{0} a0,25,{0} l20,25,{0} a25,20,{0} l25,0,{0} a20,-5,{0} "
      "l0,-5,{0} l-7,-5,{0} r-7,-5,50 ";
  const std::string expected = "r50,50,50 r-5,-7,50 r-5,-7,2 " +
                               fmt::format(fmt::runtime(once.substr(0)), -2) +
                               "r-5,-7,50 r-5,-7,2 " + fmt::format(fmt::runtime(once), -4);
  EXPECT_EQ(milled(cycle + kSquareContour + "M17\n"), expected);
  // The same between labels, of the contour editor, and named by CYCLE62.
  EXPECT_EQ(milled("CYCLE72(\"ONE:TWO\",50,0,2,-4,2,0,0,500,200,11,41,1,7,200,1,7)\nM30\nONE:\n" +
                   std::string(kSquareContour) + "TWO:\n"),
            expected);
  EXPECT_EQ(
      milled("CYCLE62(\"PART\",1,,)\nCYCLE72(\"\",50,0,2,4,2,0,0,500,200,11,41,1,7,200,1,7,,,,,,"
             "1)\nM30\nE_LAB_A_PART: ;#SM Z:4\n" +
             std::string(kSquareContour) + "E_LAB_E_PART:\n"),
      expected);
}

TEST(SinumerikContours, Cycle72LeavesAllowancesAndComesInQuarterCircles) {
  EXPECT_EQ(milled("CYCLE72(\"ONE:TWO\",50,0,2,-4,4,1,0,500,200,1,41,2,3,200,2,3)\nM30\nONE:\n" +
                   std::string("G1 X0 Y0\nY20\n") + "TWO:\n"),
            "r50,50,50 r-9,-3,50 r-9,-3,2 l-9,-3,-4 a-6,0,-4 l-6,20,-4 a-9,23,-4 r-9,23,50 ");
  EXPECT_EQ(milled("CYCLE72(\"MISSING\",50,0,2,-4,4)\n"), "r50,50,50 subprogram-missing");
  // The contour backwards: the cutter would run on the other side.
  EXPECT_EQ(
      milled("CYCLE72(\"ONE:TWO\",50,0,2,-4,4,1,0,500,200,10001,41)\nM30\nONE:\nG1 X0\nX5\nTWO:\n"),
      "r50,50,50 not-supported");
  // A chamfer needs a tool with a cone.
  EXPECT_EQ(milled("CYCLE72(\"ONE:TWO\",50,0,2,-4,4,1,0,500,200,15)\nM30\nONE:\nG1 X0\nX5\nTWO:\n"),
            "r50,50,50 tool-unknown");
}

const char* const kShaft = "M30\nONE:\nG1 X20 Z0\nZ-20\nX40 Z-30\nX44\nTWO:\n";

TEST(SinumerikContours, Cycle95RemovesStockInPasses) {
  // From radius 22 to 10 in three passes of 4; the allowance of 0 leaves the contour itself.
  EXPECT_EQ(turned("F0.2 G0 X50 Z2\nCYCLE95(\"ONE:TWO\",4,0,0,,0.3,0.2,0.1,1,,,1)\n" +
                   std::string(kShaft)),
            "r25,2 r25,1 r18,1 l18,-28 r19,-27 r19,1 r14,1 l14,-24 r15,-23 r15,1 r10,1 l10,0 "
            "l10,-20 l20,-30 l22,-30 r23,-30 r23,2 r25,2 ");
  // The finishing cut alone.
  EXPECT_EQ(turned("F0.2 G0 X50 Z2\nCYCLE95(\"ONE:TWO\",4,0,0,,0.3,0.2,0.1,5,,,1)\n" +
                   std::string(kShaft)),
            "r25,2 r10,1 l10,0 l10,-20 l20,-30 l22,-30 r23,-30 r23,2 r25,2 ");
  // Both: over the material back to the contour's start.
  EXPECT_EQ(
      turned("F0.2 G0 X50 Z2\nCYCLE95(\"ONE:TWO\",12,0,0,,0.3,0.2,0.1,9,,,1)\n" +
             std::string(kShaft)),
      "r25,2 r25,1 r10,1 l10,0 l10,-20 l20,-30 l22,-30 r23,-30 r23,1 r10,1 l10,0 l10,-20 l20,-30 "
      "l22,-30 r23,-30 r23,2 r25,2 ");
  // A relief cut of 1 mm, in levels of its own.
  EXPECT_EQ(
      turned("F0.2 G0 X50 Z2\nCYCLE95(\"ONE:TWO\",1,0,0,,0.3,0.2,0.1,1,,,1)\nM30\nONE:\nG1 X20 "
             "Z0\nZ-5\nX16 Z-10\nZ-20\nX20 Z-22\nZ-30\nTWO:\n"),
      "r25,2 r25,1 r11,1 r11,-7.5 l9,-7.5 l9,-21 r10,-20 r10,-7.5 r11,-7.5 r11,1 r10,1 l10,0 "
      "l10,-5 l8,-10 l8,-20 l10,-22 l10,-30 r11,-30 r11,2 r25,2 ");
  // An undercut is named.
  EXPECT_EQ(turned("F0.2 G0 X50 Z2\nCYCLE95(\"ONE:TWO\",2,0,0,,0.3,0.2,0.1,1)\nM30\nONE:\nG1 X20 "
                   "Z0\nZ-20\nX30 Z-18\nX40 Z-30\nTWO:\n"),
            "r25,2 not-supported");
}

// The nose of radius 1 touches the contour: along the cylinder its point is as far in, at the feet
// of the cone 1 * (sqrt(2) - 1) - 1 behind and before, at the ends 1 less.
TEST(SinumerikContours, TheNoseIsTakenIntoAccount) {
  InterpOptions options = at_origin(Dialect::sinumerik, MachineKind::lathe);
  options.table.tools[0].nose_radius = 1;
  options.table.tools[0].tip = 3;
  const std::string start = "F0.2 G0 X50 Z2\n";
  const std::string finished =
      "r25,2 r10,1 l10,-1 l10,-20.5858 l19.4142,-30 l21,-30 r22,-30 r22,2 r25,2 ";
  EXPECT_EQ(
      ends(read_text(start + "CYCLE95(\"ONE:TWO\",4,0,0,,0.3,0.2,0.1,5,,,1)\n" + kShaft, options),
           true),
      finished);
  EXPECT_EQ(
      ends(read_text(start +
                         "CYCLE62(\"\",2,\"ONE\",\"TWO\")\nCYCLE952(\"P\",\"\",\"\",2101321,0.3,"
                         "0.2,0,4,,,,,,,1)\n" +
                         kShaft,
                     options),
           true),
      finished);
}

TEST(SinumerikContours, Cycle952RemovesStockAsCycle95Does) {
  const auto with = [](const std::string& values) {
    return turned("F0.2 G0 X50 Z2\nCYCLE62(\"\",2,\"ONE\",\"TWO\")\nCYCLE952(\"P\",\"\",\"\"," +
                  values + ")\n" + kShaft);
  };
  const std::string old = turned(
      "F0.2 G0 X50 Z2\nCYCLE95(\"ONE:TWO\",4,0.5,0.2,,0.3,0.2,0.1,1,,,1)\n" + std::string(kShaft));
  // Along Z and inwards; the blank reaches to the contour's end; SC is 1.
  EXPECT_EQ(
      with("2101311,0.3,0.15,0,4,0.1,0.1,0.2,0.5,0,0,1,0,0,,,,,2,2,,,0,1,,0,12,1100010,1,0,0.1"),
      old);
  // From a radius of 24 in passes of at most 3.6: the blank is of Ø48, or 2 mm above the contour.
  const std::string larger = "r25,2 r25,1 r20.5,1 l20.5,-29.8 ";
  EXPECT_EQ(with("2101311,0.3,0.15,0,3.6,0.1,0.1,0,0.2,0,0,1,48,0,,,,,2,2,,,0,1,,0,12,10,1")
                .substr(0, larger.size()),
            larger);
  EXPECT_EQ(with("2101311,0.3,0.15,0,3.6,0.1,0.1,0,0.2,0,0,1,2,0,,,,,2,2,,,0,1,,0,12,1100010,1")
                .substr(0, larger.size()),
            larger);
}

TEST(SinumerikContours, StockRemovalThatIsNotRead) {
  const auto found = [](const std::string& values) {
    return turned("F0.2 G0 X50 Z2\nCYCLE62(\"\",2,\"ONE\",\"TWO\")\nCYCLE952(\"P\",\"\",\"\"," +
                  values + ")\n" + kShaft);
  };
  EXPECT_EQ(found("2101111,0.3,0.15,0,4"), "r25,2 not-supported");  // both ways along X
  EXPECT_EQ(found("2103312,0.3,0.15,0,4"), "r25,2 not-supported");
  EXPECT_EQ(found("2101341,0.3,0.15,0,4"), "r25,2 not-supported");
  EXPECT_EQ(found("2101311,0.3,0.15,0,4,,,,,,,1,0,0,,-20"), "r25,2 not-supported");  // a limit
  EXPECT_EQ(found("2101311,0.3,0.15,0,4,,,,,,,1,0,0,,,,,2,2,,,0,1,,0,22,1100010"),
            "r25,2 not-supported");  // grooving
  EXPECT_EQ(found("2101311,0.3,0.15,0,4,,,,,,,3"), "r25,2 value-missing");
  EXPECT_EQ(found("2101311,0.3,0.15,0,0"), "r25,2 value-missing");
}

TEST(SinumerikContours, Cycle97CutsAThreadInPasses) {
  // M20 x 2: two rough cuts of equal cross-section, one finishing cut, one spare.
  EXPECT_EQ(turned("S500 M3 G0 X30 Z10\nCYCLE97(2,,0,-20,20,20,4,2,1.2,0.2,0,0,2,1,3,1,2)\n"),
            "r15,10 r12,10 r12,4 r9.29289,4 l9.29289,-22 r12,-22 r12,4 r9,4 l9,-22 r12,-22 r12,4 "
            "r8.8,4 l8.8,-22 r12,-22 r12,4 r8.8,4 l8.8,-22 r12,-22 r12,4 ");
  EXPECT_EQ(turned("S500 M3 G0 X30 Z10\nCYCLE97(,12,0,-20,20,20,4,2,1.2,0,0,0,1,0,1,1,2)\n"),
            "r15,10 r12,10 r12,4 r8.8,4 l8.8,-22 r12,-22 r12,4 ");
  EXPECT_EQ(turned("S500 M3 G0 X30 Z10\nCYCLE97(2,,0,-20,20,20,4,2,1.2,0,0,0,2,1,9)\n"),
            "r15,10 not-supported");
}

// VARI's ten thousands: on the contour it makes no difference to what is cut; beside it, which side
// RL counts from is not certain.
TEST(SinumerikContours, Cycle72MayRunBackwards) {
  const auto run_along = [](const char* vari, int rl) {
    return path_text(read_text(
        fmt::format("T1 D1 M6\nG0 X0 Y0 Z50\nCYCLE72(\"BEG:FIN\",50,0,2,-5,9,0,0,800,400,{},{},1,5,"
                    "1000,1,5)\nM30\nBEG:\nG0 X0 Y0\nG1 X30\nG3 X40 Y10 CR=10\nG1 Y20\nFIN:\n",
                    vari, rl),
        at_origin(Dialect::sinumerik)));
  };
  const std::string forward = run_along("111", 40), backward = run_along("10111", 40);
  EXPECT_NE(forward.find("l30,0,-5 a40,10,-5 l40,20,-5"), std::string::npos) << forward;
  EXPECT_NE(backward.find("l40,10,-5 a30,0,-5 l0,0,-5"), std::string::npos) << backward;
  EXPECT_EQ(run_along("10111", 41), "r0,0,50 | not-supported");
}

}  // namespace
}  // namespace mrsim
