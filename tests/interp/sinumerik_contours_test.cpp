// SINUMERIK's cycles along a contour, and its thread, as worked out by hand.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

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

const char* const kSquare = "G1 X0 Y0\nY20\nX20\nY0\nX0\n";

TEST(SinumerikContours, MillingAlongAContour) {
  // Clockwise with the cutter outside; straight in and out over 7 mm, two infeeds.
  const std::string cycle =
      "CYCLE72(\"SQUARE\",50,0,2,-4,2,0,0,500,200,11,41,1,7,200,1,7)\nM30\n%_N_SQUARE_SPF\n";
  const std::string once =
      "l-5,-7,{0} l-5,0,{0} l-5,20,{0} a0,25,{0} l20,25,{0} a25,20,{0} l25,0,{0} a20,-5,{0} "
      "l0,-5,{0} l-7,-5,{0} r-7,-5,50 ";
  const std::string expected = "r50,50,50 r-5,-7,50 r-5,-7,2 " +
                               fmt::format(fmt::runtime(once.substr(0)), -2) +
                               "r-5,-7,50 r-5,-7,2 " + fmt::format(fmt::runtime(once), -4);
  EXPECT_EQ(milled(cycle + kSquare + "M17\n"), expected);
  // The same between labels, of the contour editor, and named by CYCLE62.
  EXPECT_EQ(milled("CYCLE72(\"ONE:TWO\",50,0,2,-4,2,0,0,500,200,11,41,1,7,200,1,7)\nM30\nONE:\n" +
                   std::string(kSquare) + "TWO:\n"),
            expected);
  EXPECT_EQ(
      milled("CYCLE62(\"PART\",1,,)\nCYCLE72(\"\",50,0,2,4,2,0,0,500,200,11,41,1,7,200,1,7,,,,,,"
             "1)\nM30\nE_LAB_A_PART: ;#SM Z:4\n" +
             std::string(kSquare) + "E_LAB_E_PART:\n"),
      expected);
}

TEST(SinumerikContours, AllowanceAndQuarterCircles) {
  EXPECT_EQ(milled("CYCLE72(\"ONE:TWO\",50,0,2,-4,4,1,0,500,200,1,41,2,3,200,2,3)\nM30\nONE:\n" +
                   std::string("G1 X0 Y0\nY20\n") + "TWO:\n"),
            "r50,50,50 r-9,-3,50 r-9,-3,2 l-9,-3,-4 a-6,0,-4 l-6,20,-4 a-9,23,-4 r-9,23,50 ");
  EXPECT_EQ(milled("CYCLE72(\"MISSING\",50,0,2,-4,4)\n"), "r50,50,50 subprogram-missing");
  // The contour backwards: the cutter would run on the other side.
  EXPECT_EQ(
      milled("CYCLE72(\"ONE:TWO\",50,0,2,-4,4,1,0,500,200,10001,41)\nM30\nONE:\nG1 X0\nX5\nTWO:\n"),
      "r50,50,50 not-supported");
  EXPECT_EQ(milled("CYCLE72(\"ONE:TWO\",50,0,2,-4,4,1,0,500,200,15)\nM30\nONE:\nG1 X0\nX5\nTWO:\n"),
            "r50,50,50 not-supported");
}

const char* const kShaft = "M30\nONE:\nG1 X20 Z0\nZ-20\nX40 Z-30\nX44\nTWO:\n";

TEST(SinumerikContours, StockRemoval) {
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

TEST(SinumerikContours, Thread) {
  // M20 x 2: two rough cuts of equal cross-section, one finishing cut, one spare.
  EXPECT_EQ(turned("S500 M3 G0 X30 Z10\nCYCLE97(2,,0,-20,20,20,4,2,1.2,0.2,0,0,2,1,3,1,2)\n"),
            "r15,10 r12,10 r12,4 r9.29289,4 l9.29289,-22 r12,-22 r12,4 r9,4 l9,-22 r12,-22 r12,4 "
            "r8.8,4 l8.8,-22 r12,-22 r12,4 r8.8,4 l8.8,-22 r12,-22 r12,4 ");
  EXPECT_EQ(turned("S500 M3 G0 X30 Z10\nCYCLE97(,12,0,-20,20,20,4,2,1.2,0,0,0,1,0,1,1,2)\n"),
            "r15,10 r12,10 r12,4 r8.8,4 l8.8,-22 r12,-22 r12,4 ");
  EXPECT_EQ(turned("S500 M3 G0 X30 Z10\nCYCLE97(2,,0,-20,20,20,4,2,1.2,0,0,0,2,1,9)\n"),
            "r15,10 not-supported");
}

}  // namespace
}  // namespace mrsim
