// Corners of FANUC: ,R ,C ,A on mills and lathes, and the forms of lathes without a comma. Ends of
// the motions worked out by hand; X of lathes as radius.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string milled_corners(const std::string& text) {
  return path_text(read_text(text, at_origin(Dialect::fanuc)));
}
std::string turned_corners(const std::string& text) {
  return path_text(read_text(text, at_origin(Dialect::fanuc, MachineKind::lathe)));
}

TEST(CornerWords, MillsRoundAndChamferCorners) {
  EXPECT_EQ(milled_corners("G1 X30. F100. ,R5.\nY40. ,C2.\nX0\n"),
            "l25,0,0 a30,5,0 l30,38,0 l28,40,0 l0,40,0");
  EXPECT_EQ(milled_corners("#1=5\nG1 X30. , R #1 F100.\nY40.\n"), "l25,0,0 a30,5,0 l30,40,0");
  // A quarter circle into a line square to its end: the corner at (30, 10) turns by 90 degrees.
  EXPECT_EQ(milled_corners("G1 X20. F100.\nG3 X30. Y10. R10. ,C1.\nG1 X50.\n").substr(0, 9),
            "l20,0,0 a");
  EXPECT_EQ(milled_corners("G20\nG1 X3. ,C.5 F10.\nY1.\n"), "l63.5,0,0 l76.2,12.7,0 l76.2,25.4,0");
  EXPECT_EQ(milled_corners("G1 X10. Z-1. ,X5.\n"), " | not-supported");
}

TEST(CornerWords, AnAngleGivesTheEndOfALine) {
  EXPECT_EQ(milled_corners("G1 X10. ,A45. F100.\n"), "l10,10,0");
  EXPECT_EQ(milled_corners("G1 ,A0 F100.\nX10. Y10. ,A90. ,R2.\nX0\n"),
            "l10,0,0 l10,8,0 a8,10,0 l0,10,0");
}

TEST(CornerWords, LathesWriteThemWithoutAComma) {
  const std::string expected = "l10,0,0 l10,0,-18 a12,0,-20 l19,0,-20 l20,0,-21 l20,0,-30";
  EXPECT_EQ(turned_corners("G1 X20. F.2\nZ-20. R2.\nX40. C1.\nZ-30.\n"), expected);
  EXPECT_EQ(turned_corners("G1 X20. F.2\nZ-20. ,R2.\nX40. ,C1.\nZ-30.\n"), expected);
  EXPECT_EQ(turned_corners("G1 X20. F.2\nZ-20. R2.\nX40. K-1.\nZ-30.\n"), expected);
  EXPECT_EQ(turned_corners("G1 X20. F.2\nW-20. I1.\nU20. K-1.\nZ-30.\n"),
            "l10,0,0 l10,0,-19 l11,0,-20 l19,0,-20 l20,0,-21 l20,0,-30");
  // 135 degrees from +Z: up and to the left.
  EXPECT_EQ(turned_corners("G1 X20. F.2\nX40. A135.\n"), "l10,0,0 l20,0,-10");
  EXPECT_EQ(turned_corners("G1 X20. F.2\nA180.\nX40. Z-30. A135.\n"),
            "l10,0,0 l10,0,-20 l20,0,-30");
  // The slope alone counts: shops write A-45 for A135, and A45 for A225 in a bore.
  EXPECT_EQ(turned_corners("G1 X20. F.2\nX40. A-45.\n"), "l10,0,0 l20,0,-10 | angle-behind");
  EXPECT_EQ(turned_corners("G1 X40. F.2\nX20. A45. R1.\nZ-20.\n").substr(0, 15), "l20,0,0 l10.29,");
  EXPECT_EQ(turned_corners("G1 X20. F.2\nA0\nX40. Z-30. A-45.\n"),
            "l10,0,0 l10,0,-20 l20,0,-30 | angle-behind");
  EXPECT_EQ(turned_corners("G1 X20. Z0 C90. F.2\n"), " | not-supported")
      << "C beside both axes is an axis";
  EXPECT_EQ(turned_corners("G0 C0\nG1 Z-5. C45. F.2\n"), " | not-supported") << "C is an axis here";
}

// A scale makes a shape larger as a whole, its corners, too.
TEST(CornerWords, AScaleCountsForRoundingsAndChamfers) {
  const auto path = [](Dialect dialect, const std::string& text) {
    return path_text(read_text(text, at_origin(dialect)));
  };
  EXPECT_EQ(path(Dialect::sinumerik, "SCALE X2 Y2\nG1 X10 RND=2 F9\nY10 CHR=1\nX0\n"),
            path(Dialect::sinumerik, "G1 X20 RND=4 F9\nY20 CHR=2\nX0\n"));
  EXPECT_EQ(path(Dialect::sinumerik, "SCALE X2 Y2\nRNDM=2\nG1 X10 F9\nY10 CHF=1\nX0\n"),
            path(Dialect::sinumerik, "RNDM=4\nG1 X20 F9\nY20 CHF=2\nX0\n"));
  EXPECT_EQ(path(Dialect::fanuc, "G51 X0 Y0 P2.\nG1 X10. ,R2. F9\nY10. ,C1.\nX0\n"),
            path(Dialect::fanuc, "G1 X20. ,R4. F9\nY20. ,C2.\nX0\n"));
  EXPECT_EQ(path(Dialect::sinumerik, "MIRROR X0\nG1 X10 RND=2 F9\nY10\n"),
            path(Dialect::sinumerik, "G1 X-10 RND=2 F9\nY10\n"));
  EXPECT_EQ(path(Dialect::sinumerik, "SCALE X2\nG1 X10 RND=2 F9\nY10\n"),
            "l20,0,0 l20,10,0 | arc-scaled-unequally");
}

}  // namespace
}  // namespace mrsim
