// Blocks between a turning cycle and its contour, which the control never runs.
#include "interp/statements/blocks_between.h"

#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

Program lathe_program(const std::string& between) {
  return read_text("G0 X40. Z2.\nG71 U3. R1.\nG71 P10 Q20 F.3\n" + between +
                       "N10 G0 X20.\nG1 Z-10. F.1\nN20 X40.\nM30\n",
                   at_origin(Dialect::fanuc, MachineKind::lathe));
}

TEST(BlocksBetween, ACycleAndItsContourAreToldOf) {
  const Program p = lathe_program("G70 P10 Q20\nS500 (SLOW)\nG0 X100. Z100.\nM30\n");
  ASSERT_EQ(codes(p), "blocks-passed-over");
  for (const Diagnostic& d : p.diagnostics) {
    if (d.code != "blocks-passed-over") continue;
    EXPECT_EQ(d.place.line, 3);
    EXPECT_NE(d.text.find("behind N20, so lines 4 to 7 (G70 P10 Q20; G0 X100. Z100.; M30)"),
              std::string::npos)
        << d.text;
    EXPECT_NE(d.text.find("N10 are never run: write N10 to N20"), std::string::npos) << d.text;
  }
  EXPECT_EQ(codes(lathe_program("T0202\n")), "blocks-passed-over");
  EXPECT_EQ(codes(lathe_program("G42\n")), "blocks-passed-over");
  EXPECT_EQ(codes(lathe_program("(X100. Z100. M30)\nS500 M8\n\n")), "");
  EXPECT_EQ(codes(lathe_program("")), "");
}

TEST(BlocksBetween, TheyAreToldOfOnceInALoop) {
  const Program p = lathe_program("M98 P9\n");
  EXPECT_EQ(codes(p), "blocks-passed-over");
  const Program loop = read_text(
      "#1=0\nWHILE[#1LT3]DO1\nG0 X40. Z2.\nG72 W3. R1.\nG72 P10 Q20 F.3\nG0 X50.\n"
      "N10 G0 Z-5.\nN20 G1 X20. F.1\n#1=#1+1\nEND1\nM30\n",
      at_origin(Dialect::fanuc, MachineKind::lathe));
  EXPECT_EQ(codes(loop), "blocks-passed-over") << listing(loop);
}

TEST(BlocksBetween, LinesAreShortened) {
  const TempFolder scratch;
  const std::string file = scratch.write(
      "a.nc", "G0 X1\n; X2\nM8\nT2\nM99\nX123456789 Z123456789 F123456789 S123456789\nN1\n");
  const std::vector<ActiveBlock> blocks = active_blocks(file, {}, {1000, 0, 0});
  ASSERT_EQ(blocks.size(), 4U);
  EXPECT_EQ(blocks.back().text.size(), 40U);
  EXPECT_EQ(lines_text(blocks), "lines 1 to 6 (G0 X1; T2; M99; ...)");
  EXPECT_EQ(lines_text({blocks[0]}), "line 1 (G0 X1)");
  EXPECT_TRUE(active_blocks(file, {}, {}).empty());
}

}  // namespace
}  // namespace mrsim
