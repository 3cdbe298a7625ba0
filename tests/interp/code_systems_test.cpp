// Code systems B and C of FANUC lathes give the words of system A other numbers.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(CodeSystems, BHasTheTurningCyclesOfA) {
  const auto turn = [](const std::string& text) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    return path_text(read_text("G0 X50 Z5\n" + text, options));
  };
  EXPECT_EQ(turn("G77 X40 Z-20 F0.2\nX36\n"), turn("G90 X40 Z-20 F0.2\nX36\n"));
  EXPECT_EQ(turn("G78 X40 Z-20 F1.5\nX39\n"), turn("G92 X40 Z-20 F1.5\nX39\n"));
  EXPECT_EQ(turn("G79 X10 Z-2 F0.2\nZ-4\n"), turn("G94 X10 Z-2 F0.2\nZ-4\n"));
}

// System A has no G95 and no G91; its G94 is the facing cycle, and G98 and G99 are feeds.
TEST(CodeSystems, BHasFeedsOfItsOwn) {
  const auto turn = [](const std::string& text) {
    const Program p =
        read_text("G97 S500 M3\n" + text, at_origin(Dialect::fanuc, MachineKind::lathe));
    std::string out = path_text(p);
    for (const Motion& m : p.motions)
      out += fmt::format(" F{:g} {}", m.feed, static_cast<int>(m.feed_unit));
    return out;
  };
  const auto same = [&](const std::string& b, const std::string& a) {
    EXPECT_EQ(turn(b), turn(a)) << b;
  };
  same("G95\nG0 X50. Z5.\nG94 X40. Z-10. F100.\nG1 X42.\nG95 X44. F.2\n",
       "G99\nG0 X50. Z5.\nG98 X40. Z-10. F100.\nG1 X42.\nG99 X44. F.2\n");
  same("G0 X50. Z5.\nG91\nG90\nG94 G1 X40. F100.\n", "G0 X50. Z5.\n\n\nG98 G1 X40. F100.\n");
  same("G0 X50. Z5.\nG1 G94 X40. F100.\n", "G0 X50. Z5.\nG1 G98 X40. F100.\n");
  same("G95\nG0 X50. Z5.\nG90 X40. Z-10.\n", "G99\nG0 X50. Z5.\nX40. Z-10.\n");
  const std::string hole = "G83 Z-20. R-3. F.1\nG80\nG1 X10.\n";
  same("G95\nG0 X0. Z5.\nG98 " + hole, "G99\nG0 X0. Z5.\n" + hole);
}

// G70 and G71 alone are the units there. G90 stays absolute, and G92 sets the zero.
TEST(CodeSystems, CHasTheTurningCyclesOfA) {
  const auto turn = [](const std::string& text) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    const std::string path = path_text(read_text("G97 S500 M3\n" + text, options));
    return path.substr(0, path.find(" | "));
  };
  const std::string in_c = "G71\nG0 X50. Z5.\n", in_a = "G21\nG0 X50. Z5.\n";
  const std::string contour = "N1 G0 X30.\nG1 Z-10. F.1\nN2 X50.\n";
  const auto same = [&](const std::string& c, const std::string& a) {
    EXPECT_EQ(turn(in_c + c), turn(in_a + a)) << c;
  };
  same("G20 X40. Z-20. F.2\nX36.\n", "G90 X40. Z-20. F.2\nX36.\n");
  same("G21 X40. Z-20. F1.5\nX39.\n", "G92 X40. Z-20. F1.5\nX39.\n");
  same("G24 X10. Z-2. F.2\nZ-4.\n", "G94 X10. Z-2. F.2\nZ-4.\n");
  same("G73 U2. R.5\nG73 P1 Q2 U.4 W.1 F.2\n" + contour + "G72 P1 Q2\n",
       "G71 U2. R.5\nG71 P1 Q2 U.4 W.1 F.2\n" + contour + "G70 P1 Q2\n");
  same("G76 R1.\nG76 Z-40. Q10000 F.1\n", "G74 R1.\nG74 Z-40. Q10000 F.1\n");
  same("G77 R1.\nG77 X30. Z-9. P2000 Q2500 F.1\n", "G75 R1.\nG75 X30. Z-9. P2000 Q2500 F.1\n");
  same("G78 P020060 Q100 R.05\nG78 X38. Z-9. P900 Q300 F1.5\n",
       "G76 P020060 Q100 R.05\nG76 X38. Z-9. P900 Q300 F1.5\n");
  same("G90 X40. Z-20.\nG98\nX50.\n", "X40. Z-20.\nX50.\n");
  const InterpOptions lathe = at_origin(Dialect::fanuc, MachineKind::lathe);
  EXPECT_EQ(
      codes(read_text("G71\nG0 X50. Z5.\nG20 X40. Z-20. F.2\nX36.\n", lathe), Severity::warning),
      "code-system");
  EXPECT_EQ(turn("G0 X50. Z5.\nG91 G1 Z-5. F.2\nG90 G92 X10. Z0.\nG1 X12.\n"),
            turn("G0 X50. Z5.\nG1 W-5. F.2\nG50 X10. Z0.\nG1 X12.\n"));
}

}  // namespace
}  // namespace mrsim
