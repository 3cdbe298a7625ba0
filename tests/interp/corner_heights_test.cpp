// Roundings and chamfers where a neighbour leaves the plane: the inserted element goes no deeper
// than the moves beside it.
#include "interp/support.h"

#include <algorithm>

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string path(const std::string& text, Dialect dialect = Dialect::sinumerik) {
  return path_text(read_text(text, at_origin(dialect)));
}

// The arc stays at the depth of the move before; the ramp begins at the height of the retract.
TEST(CornerHeights, ARetractComesBeforeTheSlopeOfARamp) {
  const char* ramp = "G0 Z5\nG1 X10 Z-1\n";
  const std::string expected = "l0,20,-1 l0,2,-1 a2,0,-1 r2,0,5 l10,0,-1";
  EXPECT_EQ(path(fmt::format("F1\nG1 Y20 Z-1\nY0 RND=2\n{}", ramp)), expected);
  EXPECT_EQ(path(fmt::format("F1\nG1 Y20 Z-1\nRNDM=2\nY0\n{}", ramp)), expected);
  EXPECT_EQ(path(fmt::format("F1\nG1 Y20 Z-1\nY0 CHR=2\n{}", ramp)),
            "l0,20,-1 l0,2,-1 l2,0,-1 r2,0,5 l10,0,-1");
  EXPECT_EQ(path("F1\nG1 X50 Z10 RND=5\nY60 Z16\n"), "l45,0,9 a50,5,10.5 l50,60,16")
      << "without a block between, the arc joins the slopes";
  // A lift by G1 between, and a ramp before the corner.
  EXPECT_EQ(path("F1\nG1 Y20 Z-3\nY0 RND=2\nZ-1\nX10 Z-5\n"),
            "l0,20,-3 l0,2,-3 a2,0,-3 l2,0,-1 l10,0,-5");
  EXPECT_EQ(path("F1\nG1 Y20\nY0 Z-10 RND=2\nZ5\nX10\n"),
            "l0,20,0 l0,2,-9 a2,0,-10 l2,0,5 l10,0,5");
}

// Nothing goes deeper than the programmed moves, whatever stands between.
TEST(CornerHeights, NothingIsDeeperThanTheProgrammedMoves) {
  for (const char* between : {"", "Z5\n", "G0 Z5\nG1 Z1\n", "Z-7\n"})
    for (const char* after : {"X10", "X10 Z-6", "X10 Z9", "G2 X-10 Y10 I0 J10 Z-6"}) {
      const Program p =
          read_text(fmt::format("F1\nG1 Y20 Z-2\nY0 Z-3 RND=2\n{}{}\n", between, after),
                    at_origin(Dialect::sinumerik));
      double programmed = -3, deepest = 0;
      for (const Motion& motion : p.motions) deepest = std::min(deepest, motion.end.z);
      if (std::string(between) == "Z-7\n") programmed = -7;
      if (std::string(after).find("Z-6") != std::string::npos)
        programmed = std::min(programmed, -6.0);
      EXPECT_GE(deepest, programmed - 1e-9) << between << after << listing(p);
    }
}

// FANUC's controls stop where no move in the plane follows at once.
TEST(CornerHeights, AFanucCornerBeforeAnInfeedIsLeftOut) {
  EXPECT_EQ(path("F1\nG1 Y20. Z-1.\nY0 ,R2.\nG0 Z5.\nG1 X10. Z-1.\n", Dialect::fanuc),
            "l0,20,-1 l0,0,-1 r0,0,5 l10,0,-1 | corner-void");
  EXPECT_EQ(path("F1\nG1 Y20. Z-1.\nY0 ,C2.\nG0 Z5.\nG0 X10.\n", Dialect::fanuc),
            "l0,20,-1 l0,0,-1 r0,0,5 r10,0,5 | corner-void");
  EXPECT_EQ(path("F1\nG1 Y20.\nY0 ,R2.\nM8\nX10.\n", Dialect::fanuc),
            "l0,20,0 l0,2,0 a2,0,0 l10,0,0");
}

TEST(CornerHeights, ACornerInABlockOutOfThePlaneIsReported) {
  EXPECT_EQ(path("F1\nG1 X10. ,R1.\nG0 X20. Y9.\n", Dialect::fanuc),
            "l10,0,0 r20,9,0 | corner-void");
  EXPECT_EQ(path("F1\nG1 X10. ,C1.\nG0 Y9.\n", Dialect::fanuc), "l10,0,0 r10,9,0 | corner-void");
  EXPECT_EQ(path("F1\nG1 Z-2. ,R1.\nX10.\n", Dialect::fanuc), "l0,0,-2 l10,0,-2 | corner-void");
  EXPECT_EQ(path("F1\nG1 Z-2 RND=1\nX10\n"), "l0,0,-2 l10,0,-2 | corner-void");
  EXPECT_EQ(path("F1\nRNDM=1\nG1 Z-2\nX10\n"), "l0,0,-2 l10,0,-2") << "RNDM holds for each corner";
}

}  // namespace
}  // namespace mrsim
