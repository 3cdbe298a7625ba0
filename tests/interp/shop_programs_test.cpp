// Programs as shops and posts write them, which were refused or misread.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string path_of(const std::string& text, const std::string& name) {
  InterpOptions options = at_origin(Dialect::automatic);
  options.machine = MachineKind::automatic;
  return path_text(read_text(text, options, name));
}

// On a SINUMERIK programs in ISO mode have its file names and headers, too.
TEST(ShopPrograms, TheIsoModeOfAMainProgramFileIsFanucs) {
  const std::string body = "G21 G17 G90 G54\nG0 X5. Y0\nG2 X10. Y-5. R5. F100\nM30\n";
  const std::string path = "r5,0,0 a10,-5,0";
  EXPECT_EQ(path_of("%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\nG291\n" + body, "PART.MPF"), path);
  EXPECT_EQ(path_of("%_N_PART_MPF\nG291\nO0012 (PART)\n" + body, "PART.MPF"), path);
  const std::string siemens = "G0 X5 Y0\nG2 X10 Y-5 CR=5 F100\nM30\n";
  EXPECT_EQ(path_of("%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\nG17 G90 G54\n" + siemens, "PART.MPF"), path);
}

// Posts write "G91 G30 Z0" and "G91 G53 X-800. Y0" behind it: some controls go there, others stay.
TEST(ShopPrograms, AxesUnderG53InG91AreUnknown) {
  const std::string text =
      "G0 X0 Y0 Z5\nG1 Z-1 F1\nG0 Z5\nG91 G30 Z0\nG91 G53 X-800. Y0\nG90 G0 X5 Y0\nZ5\nG1 Z-1\n";
  for (const bool zero_known : {false, true}) {
    InterpOptions options = at_origin(Dialect::fanuc);
    if (zero_known) options.places.zero = {{"G54", {-350, -200, -400}}};
    const Program p = read_text(text, options);
    EXPECT_EQ(codes(p), "machine-incremental");
    for (const Motion& m : p.motions) EXPECT_LT(-800, m.end.x);
    EXPECT_EQ(p.motions.back().end.z, -1);
    EXPECT_FALSE(p.motions.back().assumed_start);
  }
  EXPECT_EQ(codes(read_text("G1 X1 F1\nG91 G53 X0\nG90 G1 Y5\nY6\n", at_origin(Dialect::fanuc))),
            "machine-incremental leaves-in-cut start-unknown");
  EXPECT_EQ(codes(read_text("G1 X1 F1\nG91 G53 Z0\n", at_origin(Dialect::ngc))),
            "machine-incremental");
}

// Haas's controls ask for no THEN.
TEST(ShopPrograms, ConditionsWithoutThenHoldForTheirBlock) {
  const std::string loop =
      "#1=0\nN10 #1=#1+4\nIF [#1 GT 10] #1=10\nG1 X#1 F9\nIF [#1 LT 10] GOTO 10\n"
      "IF [#1 EQ 3] X99\nIF [#1 EQ 10] Y5\n";
  EXPECT_EQ(mill(loop), "l4,0,0 l8,0,0 l10,0,0 l10,5,0 | statement");
  for (const char* const wrong : {"THAN X5", ",R5", ""})
    EXPECT_EQ(mill("#1=1\nIF [#1 EQ 2] " + std::string(wrong) + "\n"), " | statement") << wrong;
}

}  // namespace
}  // namespace mrsim
