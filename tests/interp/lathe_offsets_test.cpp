// What programs of lathes say of the offsets of their tools.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// Q of G10 is the orientation of the tip: 2 is that of a bar that bores. LinuxCNC's 3 is the same.
TEST(LatheOffsets, TheTipThatG10Tells) {
  const auto bore = [](const std::string& text, Dialect dialect = Dialect::fanuc, int tip = 0) {
    InterpOptions options = at_origin(dialect, MachineKind::lathe);
    Tool& tool = options.table.tools.front();
    tool.id = "1";
    tool.tip = tip;
    tool.nose_radius = 0.8;
    if (tip == 0) options.table.tools.clear();
    const Program p = read_text(text, options);
    return fmt::format("{:g} ", p.motions[1].end.x) + codes(p);
  };
  const std::string cut = "G0 X20. Z2. F.2\nG41 G1 X30. Z0\nG1 Z-10.\nX20.\nG40 Z2.\n";
  EXPECT_EQ(bore("G10 P1 X0 Z0 R.8 Q2\nT0101 (CNMG 120408)\n" + cut), "15 ");
  EXPECT_EQ(bore("T0101 (CNMG 120408)\n" + cut), "13.4 ");
  EXPECT_EQ(bore("G10 P1 X0 Z0 R.8 Q3\nT0101\n" + cut, Dialect::fanuc, 2), "15 nose-differs");
  EXPECT_EQ(
      bore("(T1 CNMG 120408)\nG18 G7\nG10 L1 P1 R.8 Q3\nT1 M6 G43\n" + cut + "M2\n", Dialect::ngc),
      "15 ");
  const std::string path = "G95 F0.2 G0 X20 Z2\nG41 G1 X30 Z0\nZ-10\nX20\nG40 Z2\n";
  EXPECT_EQ(
      bore("$TC_DP2[1,1]=2 $TC_DP6[1,1]=0.8\nT1 D1 ; CNMG 120408\n" + path, Dialect::sinumerik),
      "15 ");
  EXPECT_EQ(bore("$TC_DP2[101,1]=2\nT1 D1 ; CNMG 120408\n" + path, Dialect::sinumerik), "13.4 ");
  EXPECT_EQ(bore("$TC_DP2[1,2]=2\nT1 D1 ; CNMG 120408\n" + path, Dialect::sinumerik),
            "13.4 variable-unset");
}

}  // namespace
}  // namespace mrsim
