// Comments about one tool that contradict each other.
#include "interp/support.h"
#include "interp/tool_readings.h"

#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// The first tool's data, or the error's text.
std::string tool_of(const std::string& text, MachineKind machine = MachineKind::mill) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = machine;
  const Program p = read_text(text, options);
  for (const Diagnostic& d : p.diagnostics)
    if (d.code == "tool-unknown") return d.text;
  if (p.tools.empty()) return "none";
  const Tool& t = p.tools.front();
  return fmt::format("{} corner {:g} nose {:.4g} tip {:g} width {:g}", t.diameter, t.corner_radius,
                     t.nose_radius, t.tip_diameter, t.width);
}

std::string listed(const std::string& first, const std::string& second) {
  return tool_of(fmt::format("({})\n({})\nT1 M6\n{}", first, second, kCut));
}

std::string called(const std::string& list, const std::string& call) {
  return tool_of(fmt::format("({})\nT1 M6\n({})\n{}", list, call, kCut));
}

std::string turned(const std::string& list, const std::string& call) {
  return tool_of(
      fmt::format("({})\nT0101 ({})\nG0 X20 Z1\nG1 Z-5 F.1\nX22\nG0 X50 Z50\n", list, call),
      MachineKind::lathe);
}

void expect_doubt(const std::string& said, const char* why) {
  EXPECT_NE(said.find(why), std::string::npos) << said;
}

TEST(ToolContradictions, CornersAreInDoubt) {
  expect_doubt(listed("T1 D=10. CR=0. - FLAT END MILL", "T1 D=10. CR=0.5 - BULLNOSE END MILL"),
               "corner radius 0 and 0.5");
  expect_doubt(listed("T1 D=10. CR=0.5 - BULLNOSE END MILL", "T1 D=10. CR=0. - FLAT END MILL"),
               "corner radius 0.5 and 0");
  expect_doubt(listed("T1 D=10. CR=1. - BULLNOSE END MILL", "T1 D=10. CR=0.5 - BULLNOSE END MILL"),
               "corner radius 1 or 0.5");
  expect_doubt(called("T1 10MM FLAT ENDMILL", "10MM BULL NOSE R1"), "corner radius 0 and 1");
  expect_doubt(called("T1 D=10. CR=0. - FLAT END MILL", "CORNER R3"), "radius of 3");
  expect_doubt(called("T1 12MM CHAMFER MILL 90 DEG TIP 0.2", "CORNER R3"), "radius of 3");
  expect_doubt(called("T1 End Mill {6 mm}", "Ball Nose {3 mm}"), "different kinds");
  // One size, written in two ways.
  EXPECT_EQ(called("T1 D=10. CR=0.79 - BULLNOSE END MILL", "10MM BULL NOSE R1/32"),
            "10 corner 0.79 nose 0 tip 0 width 0");
  EXPECT_EQ(called("T1 D=10. CR=0. - FLAT END MILL", "10MM FLAT ENDMILL"),
            "10 corner 0 nose 0 tip 0 width 0");
  EXPECT_EQ(called("T1 D=10. CR=5. - BALL END MILL", "R5 BALL"),
            "10 corner 0 nose 0 tip 0 width 0");
}

TEST(ToolContradictions, AnglesWidthsAndTipsAreInDoubt) {
  expect_doubt(listed("T1 D=10. CR=0. TAPER=45DEG - CHAMFER MILL",
                      "T1 D=10. CR=0. TAPER=30DEG - CHAMFER MILL"),
               "two angles");
  expect_doubt(listed("T1 D=6. CR=0. TAPER=118DEG - DRILL", "T1 D=6. CR=0. TAPER=90DEG - DRILL"),
               "two angles");
  expect_doubt(called("T1 V-BIT 60 DEG D6", "V-BIT 90 DEG D6"), "two angles");
  expect_doubt(called("T1 T-SLOT 16 X 8", "T-SLOT 16 X 6"), "width 8 or 6");
  expect_doubt(called("T1 V-BIT 60 DEG D6 TIP 0.2", "V-BIT 60 DEG D6 TIP 0.5"), "tip 0.2 or 0.5");
  EXPECT_EQ(listed("T1 D=10. CR=0. TAPER=45DEG - CHAMFER MILL", "T1 10MM CHAMFER MILL 90 DEG"),
            "10 corner 0 nose 0 tip 0 width 0");
  EXPECT_EQ(called("T1 DRILL 8.5", "8.5MM DRILL 140 DEG"), "8.5 corner 0 nose 0 tip 0 width 0");
}

TEST(ToolContradictions, BladesAndNosesAreInDoubt) {
  expect_doubt(turned("T1 GROOVE 3MM", "GROOVE 4MM"), "width 3 mm or 4 mm");
  expect_doubt(turned("T1 VNMG 160404", "VNMG R0.8"), "nose radius 0.4 mm or 0.8");
  expect_doubt(turned("T1 CNMG 432", "CNMG 431"), "nose radius");
  EXPECT_EQ(turned("T1 CNMG 432", "CNMG 120408"), "0 corner 0 nose 0.7937 tip 0 width 0");
  EXPECT_EQ(turned("T1 GROOVING TOOL 3MM", "GROOVE 10MM WIDE"), "0 corner 0 nose 0 tip 0 width 3");
}

TEST(ToolContradictions, CornersOfABladeBesideItsWork) {
  for (const char* const words :
       {"FULL RADIUS GROOVE 4MM", "GROOVE 4MM FULL RADIUS", "GROOVE 4MM R2", "GROOVER 4MM FULL RAD",
        "GROOVE INSERT 4MM R2", "GROOVE 4MM RADIUS 2", "GROOVING TOOL 4MM FULL RADIUS"})
    EXPECT_EQ(turned("SHAFT", words), "0 corner 0 nose 2 tip 0 width 4") << words;
  EXPECT_EQ(turned("SHAFT", "GROOVE R1.5 W3"), "0 corner 0 nose 1.5 tip 0 width 3");
  EXPECT_EQ(turned("SHAFT", "CUTOFF 3MM R0.2"), "0 corner 0 nose 0.2 tip 0 width 3");
}

TEST(ToolContradictions, SizesWithoutAUnitAreInDoubt) {
  const char* const inches = "? gives the diameter 6 without a unit, beside a size in inches";
  expect_readings({
      {mm, "T1 T-SLOT CUTTER 6 X 1/8", inches},
      {mm, "T1 DOVETAIL D6 60DEG LOC 1/8", inches},
      {inch, "T1 T-SLOT CUTTER 4 X 1/8", "tslot 101.6, width 3.175"},
      {mm, "T1 T-SLOT CUTTER 1 X 1/8", "tslot 25.4, width 3.175"},
      {mm, "T1 SAW 6 X 1/8", "tslot 152.4, width 3.175"},
      {mm, "T1 V-BIT D1=0.2 D2=6 60DEG", "? can be read as a tip of 0.2 or as another size of 0.2"},
      {lathe_inch, "ROUND INSERT R3",
       "? gives the radius 3 of its round insert without a unit, in a program in inches"},
      {lathe_inch, "ROUND INSERT R.125", "turning, nose 3.175"},
  });
}

// "T0100" ends the offset of tool 1: what follows is about the next.
TEST(ToolContradictions, BehindTheEndOfAnOffsetTheNextToolIsNamed) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::lathe;
  const std::string first = "T0101 (OD CNMG 432)\nG0 X50. Z2.\nG1 Z-5. F.2\nX52.\n";
  for (const char* const end :
       {"T0100\n(FINISH VNMG 331)\nG0 T0303\n", "G28 U0. W0. T0100\n(FINISH VNMG 331)\nG0 T0303\n",
        "T0100\nN2\n(FINISH VNMG 331)\nG0 T0303\n"}) {
    const Program p = read_text(first + end + "G0 X40. Z1.\nG1 Z-3.\n", options);
    ASSERT_EQ(p.tools.size(), 2U) << listing(p);
    EXPECT_EQ(p.tools[1].insert, "VNMG") << end;
  }
  // Blocks without cuts between the call and the comment.
  const Program p = read_text(
      "T0303 M8\nG97 S500 M3\n(FINISH TURN VNMG 331)\nG0 X40. Z1.\nG1 Z-3. F.1\n", options);
  ASSERT_EQ(p.tools.size(), 1U) << listing(p);
  EXPECT_EQ(p.tools[0].insert, "VNMG");
}

TEST(ToolContradictions, ACommentBehindThePreselectedToolIsRead) {
  EXPECT_EQ(tool_of(std::string("T1 M6\nT2\n(D10 FLAT)\n") + kCut),
            "10 corner 0 nose 0 tip 0 width 0");
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::mill;
  const std::string cut = kCut;
  const Program p =
      read_text("T1 M6 (10MM ENDMILL)\n" + cut + "T2\n(D6 BALL)\nM6\n" + cut, options);
  ASSERT_EQ(p.tools.size(), 2U) << listing(p);
  EXPECT_EQ(p.tools[1].diameter, 6);
  EXPECT_EQ(p.tools[1].type, ToolType::ballmill);
}

}  // namespace
}  // namespace mrsim
