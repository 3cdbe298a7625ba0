// The same T number called again, with another tool in its comment.
#include "core/words/tool_types.h"
#include "interp/support.h"

#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// "1 endmill 10, 1 (line 9) ballmill 6 | 1 1 1 (line 9)": the tools, and those of the cuts.
std::string tools(const std::string& text, InterpOptions options = {},
                  MachineKind machine = MachineKind::mill) {
  options.dialect = Dialect::fanuc;
  options.machine = machine;
  const Program p = read_text(text, options);
  std::string out;
  for (const Tool& tool : p.tools)
    out += fmt::format("{}{} {} {:g}", out.empty() ? "" : ", ", tool.id, tool_type_name(tool.type),
                       is_turning(tool.type) ? tool.nose_radius : tool.diameter);
  out += " |";
  for (const Motion& m : p.motions)
    if (m.kind == MotionKind::line && m.end.z == m.start.z)
      out += " " + p.tools[static_cast<std::size_t>(m.tool)].id + ";";
  return out + (codes(p).empty() ? "" : " " + codes(p));
}

std::string turned(const std::string& text) { return tools(text, {}, MachineKind::lathe); }

const std::string kFirst = std::string("T1 M6 (10MM FLAT ENDMILL)\n") + kCut;  // lines 1 to 4
const std::string kBall = "1 endmill 10, 1 (line 6) ballmill 6 | 1; 1 (line 6);";

TEST(CalledAgain, WithAnotherToolInItsCommentItIsAnother) {
  const std::string cut = kCut;
  EXPECT_EQ(tools(kFirst + "M0\nT1 M6 (6MM BALL ENDMILL)\n" + cut), kBall);
  EXPECT_EQ(tools(kFirst + "(6MM BALL ENDMILL)\nT1 M6\n" + cut), kBall);
  EXPECT_EQ(tools(kFirst + "M5\nT1 M6\n(6MM BALL ENDMILL)\n" + cut), kBall);
  EXPECT_EQ(tools(kFirst + "M5\nT1 M6\n(T1 D=6. CR=3. - BALL END MILL)\n" + cut), kBall);
  EXPECT_EQ(tools(kFirst + "(T1 6MM BALL ENDMILL)\nT1 M6\n" + cut), kBall);
  EXPECT_EQ(tools(kFirst + "M5\nT1 M6\nG54\nG0 X0 Y0\n(6MM BALL ENDMILL)\n" + cut), kBall);
  EXPECT_EQ(
      tools("(TOOL/MILL,3.175,0,0,0)\nM6T102\n" + cut + "(TOOL/MILL,6.35,0,0,0)\nM6T102\n" + cut),
      "102 endmill 3.175, 102 (line 7) endmill 6.35 | 102; 102 (line 7);");
  EXPECT_EQ(tools(kFirst + "M5\nT1 M6\n(TOOL TYPE: BALL MILL)\n(TOOL DIAMETER: 6.0)\n" + cut),
            kBall);
}

TEST(CalledAgain, KindsThatAreSizesToo) {
  EXPECT_EQ(tools(std::string("T1 M6\n(End Mill {6 mm})\n") + kCut + "T1 M6\n(Ball Nose {3 mm})\n" +
                  kCut),
            "1 endmill 6, 1 (line 6) ballmill 3 | 1; 1 (line 6);");
}

TEST(CalledAgain, TheCommentOfTheFirstBringsItBack) {
  const std::string cut = kCut;
  const std::string both = kFirst + "M5\nT1 M6 (6MM BALL ENDMILL)\n" + cut;
  EXPECT_EQ(tools(both + "T1 M6 (10MM FLAT ENDMILL)\n" + cut),
            "1 endmill 10, 1 (line 6) ballmill 6 | 1; 1 (line 6); 1;");
  EXPECT_EQ(tools(both + "T1 M6\n" + cut),
            "1 endmill 10, 1 (line 6) ballmill 6 | 1; 1 (line 6); 1 (line 6);");
}

TEST(CalledAgain, AnotherOperationIsTheSameTool) {
  const std::string cut = kCut;
  for (const char* const work :
       {"FINISH", "ROUGH", "POCKET 20MM", "10MM FLAT ENDMILL", "T1 10. FLAT ENDMILL", "CONTOUR 2",
        "FLAT ENDMILL", "10MM ENDMILL - FINISH", "BALL FINISH", "CHAMFER EDGES"})
    EXPECT_EQ(tools(fmt::format("{}M5\nT1 M6 ({})\n{}", kFirst, work, cut)), "1 endmill 10 | 1; 1;")
        << work;
  // A header that agrees with the calls.
  EXPECT_EQ(tools("(T1 D=10. CR=0. - ZMIN=-1. - FLAT END MILL)\n" + kFirst +
                  "T1 M6 (T1 D=10. CR=0. - FLAT END MILL)\n" + cut),
            "1 endmill 10 | 1; 1;");
  // 3/8 inch, rounded.
  EXPECT_EQ(tools("G21\nT1 M6 (9.525MM FLAT ENDMILL)\n" + cut + "T1 M6 (3/8 FLAT ENDMILL)\n" + cut),
            "1 endmill 9.525 | 1; 1;");
}

TEST(CalledAgain, AKindWithoutASizeIsTold) {
  EXPECT_EQ(tools(kFirst + "M5\nT1 M6 (CENTER DRILL)\n" + kCut),
            "1 endmill 10 | 1; 1; tool-contradicts");
}

TEST(CalledAgain, WithoutACallItIsAnError) {
  EXPECT_EQ(tools(kFirst + "(T1 - 8MM BALL ENDMILL)\nX9\n"), "1 endmill 10 | 1; 1; tool-unknown");
  EXPECT_EQ(tools(kFirst + "(T1 - 10MM FLAT ENDMILL)\nX9\n"), "1 endmill 10 | 1; 1;");
}

TEST(CalledAgain, AToolThatIsGivenCutsEverywhere) {
  InterpOptions options;
  Tool tool;
  tool.id = "1";
  tool.diameter = 4;
  options.table.tools.push_back(tool);
  const std::string text = kFirst + "M5\nT1 M6 (6MM BALL ENDMILL)\n" + kCut;
  EXPECT_EQ(tools(text, options), "1 endmill 4 | 1; 1; tool-contradicts");
  tool.id = "1 (line 6)";
  options.table.tools.push_back(tool);
  EXPECT_EQ(tools(text, options), "1 endmill 4, 1 (line 6) endmill 4 | 1; 1 (line 6);");
}

TEST(CalledAgain, ALatheAsksWhereTheWordsMayBeTheWork) {
  const std::string turn = "G0 X20 Z1\nG1 Z-5 F.1\nX22\nG0 X50 Z50\n";
  const std::string first = "T0101 (OD CNMG 120408)\n" + turn;
  EXPECT_EQ(turned(first + "T0101 (VNMG 160404)\n" + turn),
            "1 turning 0.8, 1 (line 6) turning 0.4 | 1; 1 (line 6);");
  EXPECT_EQ(turned(first + "T0101 (GROOVING TOOL 3MM)\n" + turn),
            "1 turning 0.8, 1 (line 6) grooving 0 | 1; 1 (line 6);");
  EXPECT_NE(turned(first + "T0101 (GROOVE 3MM)\n" + turn).find("tool-unknown"), std::string::npos);
  EXPECT_EQ(turned(first + "T0101 (FINISH OD)\n" + turn), "1 turning 0.8 | 1; 1;");
}

}  // namespace
}  // namespace mrsim
