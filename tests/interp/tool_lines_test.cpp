// What lines of their own say of a tool above or below them: its kind, sizes and angles; and lines
// that are about the work.
#include "core/numbers/units.h"
#include "interp/support.h"

#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// The type, the diameter and the angles of the first tool; or the doubt.
std::string first_tool(const std::string& text, Dialect dialect = Dialect::fanuc) {
  InterpOptions options;
  options.dialect = dialect;
  options.machine = MachineKind::mill;
  const Program p = read_text(text, options);
  for (const Diagnostic& d : p.diagnostics)
    if (d.code == "tool-unknown") return d.text;
  if (p.tools.empty()) return "none";
  const Tool& t = p.tools[0];
  return fmt::format("{} {:g} tip {:g} taper {:g}", static_cast<int>(t.type), t.diameter,
                     degrees(t.tip_angle), degrees(t.taper_angle));
}

std::string tool_like(ToolType type, double diameter, double tip, double taper) {
  return fmt::format("{} {:g} tip {:g} taper {:g}", static_cast<int>(type), diameter, tip, taper);
}

// T1, whose comment has a line below it.
std::string below(const char* tool, const char* line) {
  return first_tool(fmt::format("(T1 {})\n({})\nT1 M6\n{}", tool, line, kCut));
}

// A line with an angle alone was ignored: the tool was upright, a drill had 118 degrees.
TEST(ToolLines, AnAngleMayStandInALineOfItsOwn) {
  const std::string cut = kCut, call = "T1 M6\n" + cut;
  using enum ToolType;
  EXPECT_EQ(first_tool("(T1 DRILL D8)\n(TIP ANGLE: 140)\n" + call), tool_like(drill, 8, 140, 0));
  EXPECT_EQ(first_tool("(TIP ANGLE: 140)\n(8MM DRILL)\n" + call), tool_like(drill, 8, 140, 0));
  EXPECT_EQ(first_tool("(T1 V-BIT D6)\n(ANGLE: 60)\n" + call), tool_like(chamfer, 6, 60, 0));
  EXPECT_EQ(first_tool("(TAPER MILL)\n(DIAMETER: 6.)\n(TAPER ANGLE: 5.)\n" + call),
            tool_like(taper, 6, 0, 5));
  EXPECT_EQ(first_tool("(T1 EM 6MM)\n(TAPER ANGLE: 0)\n" + call), tool_like(endmill, 6, 0, 0));
  EXPECT_NE(first_tool("(EM 6MM)\n(TAPER: 2)\n" + call).find("tapered mill"), std::string::npos);
  EXPECT_NE(first_tool("T1 M6 (EM 6MM)\n(TAPER: 2)\n" + cut).find("tapered mill"),
            std::string::npos);
  EXPECT_NE(first_tool("G21\n(6mm endmill)\n(TAPER: 2)\n" + cut, Dialect::ngc).find("tapered"),
            std::string::npos);
  EXPECT_EQ(first_tool("(T1 EM 6MM)\n(HELIX ANGLE: 30)\n" + call), tool_like(endmill, 6, 0, 0));
}

// Of a tool whose kind the list leaves open, the comment at the call tells it.
TEST(ToolLines, TheCommentAtTheCallTellsAnOpenKind) {
  const std::string cut = kCut, head = "(T1 D6.)\nG90\n";
  using enum ToolType;
  EXPECT_EQ(first_tool(head + "(DRILL 118)\nT1 M6\n" + cut), tool_like(drill, 6, 118, 0));
  EXPECT_EQ(first_tool(head + "T1 M6 (DRILL 118)\n" + cut), tool_like(drill, 6, 118, 0));
  EXPECT_EQ(first_tool(head + "T1 M6\n(DRILL 118)\n" + cut), tool_like(drill, 6, 118, 0));
  EXPECT_EQ(first_tool(head + "(BALL MILL)\nT1 M6\n" + cut), tool_like(ballmill, 6, 0, 0));
  EXPECT_NE(first_tool(head + "(BALL MILL D8)\nT1 M6\n" + cut).find("diameter 6 or 8"),
            std::string::npos);
  EXPECT_NE(first_tool("(T1 6MM EM)\nG90\n(BALL MILL 6MM)\nT1 M6\n" + cut).find("different"),
            std::string::npos);
  EXPECT_EQ(first_tool("(T1 6MM EM)\nG90\n(DRILL 4 HOLES)\nT1 M6\n" + cut),
            tool_like(endmill, 6, 0, 0));
  EXPECT_EQ(first_tool("(T1 SPOT 90 DIA 12)\nT1 M6\n" + cut), tool_like(drill, 12, 90, 0));
}

TEST(ToolLines, SizesMayStandInALineOfTheirOwn) {
  const std::string cut = kCut, call = "T1 M6\n" + cut;
  const std::string bull = tool_like(ToolType::bullmill, 10, 0, 0);
  for (const char* const line : {"D10. R1.", "D=10. R=1.", "DIA: 10. CORNER RADIUS: 1.",
                                 "DIAM 10 R 1", "TOOL DIA. 10.0, R 1.0"}) {
    const std::string lines = fmt::format("(BULL NOSE MILL)\n({})\n", line);
    EXPECT_EQ(first_tool(lines + call), bull) << line;
    EXPECT_EQ(first_tool("T1 M6\n" + lines + cut), bull) << line;
  }
  EXPECT_NE(first_tool("(BULL NOSE MILL)\n(D1 R1)\n" + call).find("no diameter"),
            std::string::npos);
  for (const char* const line : {"CR0.5", "0.5 CORNER RADIUS", "TIP RADIUS 0.5", "CORNER RAD .5",
                                 "NOSE RADIUS 0.5", "RE 0.5", "R=.5"})
    EXPECT_EQ(below("10MM ENDMILL", line), bull) << line;
  for (const char* const line : {"R0.5", "0.5R", "RADIUS 0.5", "WITH 1MM RADIUS"})
    EXPECT_NE(below("10MM ENDMILL", line).find("made for a radius"), std::string::npos) << line;
  EXPECT_EQ(below("8MM BALL MILL", "R4"), tool_like(ToolType::ballmill, 8, 0, 0));
  EXPECT_NE(below("10MM ENDMILL", "R5").find("made for a radius"), std::string::npos);
  EXPECT_EQ(below("10MM ENDMILL", "D10"), tool_like(ToolType::endmill, 10, 0, 0));
  EXPECT_EQ(below("10MM ENDMILL", "FLUTE LENGTH 20"), tool_like(ToolType::endmill, 10, 0, 0));
  EXPECT_NE(below("10MM ENDMILL", "BALL END").find("different"), std::string::npos);
  EXPECT_NE(below("10MM ENDMILL", "BALL").find("different"), std::string::npos);
  EXPECT_EQ(below("D10.", "BALL"), tool_like(ToolType::ballmill, 10, 0, 0));
  EXPECT_EQ(below("10MM ENDMILL", "BULL R1"), bull);
  for (const char* const line : {"TAPERED", "3 DEG TAPER", "TAPER 3 DEG"})
    EXPECT_NE(below("10MM ENDMILL", line).find("tapered mill"), std::string::npos) << line;
  EXPECT_NE(below("10MM ENDMILL", "45 DEG").find("45 degrees"), std::string::npos);
  EXPECT_EQ(below("SPOT DRILL D10", "120 DEG"), tool_like(ToolType::drill, 10, 120, 0));
  EXPECT_EQ(below("T-SLOT D20", "WIDTH: 3"), tool_like(ToolType::tslot, 20, 0, 0));
  const Program v = read_text("G21\n(T1 V-BIT 60 DEG D12)\n(TIP DIA 0.2)\n" + call, [] {
    InterpOptions options;
    options.dialect = Dialect::fanuc;
    options.machine = MachineKind::mill;
    return options;
  }());
  ASSERT_EQ(v.tools.size(), 1U);
  EXPECT_EQ(v.tools[0].tip_diameter, 0.2) << "it was sharp";
}

// Below a tool's comment, what the work is like: it was read as the tool's.
TEST(ToolLines, LinesAboutTheWorkAreDoubted) {
  const auto asks = [&](const char* tool, const char* line, const char* about) {
    EXPECT_NE(below(tool, line).find(about), std::string::npos) << tool << ", " << line;
  };
  using enum ToolType;
  for (const char* const line : {"FINISH R3", "ROUGHING R2.5", "CENTER R5", "FOUR R3", "RIGHT R1",
                                 "NR. 3", "NR 2", "RE 1", "RAYON 2", "CORNER 1.", "TOOL RADIUS 3"})
    asks("10MM ENDMILL", line, "made for a radius");
  asks("CHAMFER MILL D10 90 DEG", "FINISH R3", "made for a radius");
  // At the change to a tool that the list describes they are about the work.
  for (const char* const line : {"FINISH R3", "R3", "NR. 3", "45 DEG", "ANGLE 30", "3 DEG TAPER"})
    EXPECT_EQ(first_tool(fmt::format("(T1 10MM ENDMILL)\nG90\nT1 M6\n({})\n{}", line, kCut)),
              tool_like(endmill, 10, 0, 0))
        << line;
  EXPECT_EQ(below("10MM ENDMILL", "TOOL RADIUS 5"), tool_like(endmill, 10, 0, 0));
  EXPECT_EQ(below("10MM ENDMILL", "TOOL RADIUS: 5."), tool_like(endmill, 10, 0, 0));
  EXPECT_EQ(below("10MM ENDMILL", "TOOL RADIUS: 1."), tool_like(bullmill, 10, 0, 0));
  EXPECT_EQ(below("10MM ENDMILL", "RC 45"), tool_like(endmill, 10, 0, 0));
  EXPECT_EQ(below("10MM BULL NOSE R1", "FINISH R3"), tool_like(bullmill, 10, 0, 0));
  asks("10MM BULL NOSE R1", "RADIUS: 3", "corner radius 1 or 3");
  EXPECT_EQ(below("10MM BULL NOSE R1", "CORNER RADIUS: 1.0"), tool_like(bullmill, 10, 0, 0));
  for (const char* const line : {"R3", "R0.5", "FINISH R3", "RADIUS 2"}) {
    EXPECT_EQ(below("DRILL 8.5MM", line), tool_like(drill, 8.5, 0, 0)) << line;
    EXPECT_EQ(below("REAMER 8MM", line), tool_like(endmill, 8, 0, 0)) << line;
  }
  for (const char* const line : {"45 DEG", "3 DEG TAPER", "TAPER 3 DEG", "ANGLE 30", "90 DEG"})
    asks("DRILL 8.5MM", line, "such a slope");
  EXPECT_EQ(below("DRILL 8.5MM", "140 DEG"), tool_like(drill, 8.5, 140, 0));
  for (const char* const line :
       {"SPOT DRILL HOLES", "CENTER DRILL", "CHAMFER MILL EDGE", "DOVETAIL 60 DEG"})
    asks("DRILL 8.5MM", line, "kind");
  asks("10MM ENDMILL", "BALL NOSE FINISHING", "different kinds");
  asks("SPOT DRILL D10 90 DEG", "TAPER 3 DEG", "two angles");
  asks("CHAMFER MILL D10 90 DEG", "TAPER 3 DEG", "two angles");
}

// A plain end mill may rough a slot or go along an edge of any form; the cutter of that form has
// its own name or size.
TEST(ToolLines, ShapesBelowAPlainEndMillAreThoseOfTheWork) {
  using enum ToolType;
  for (const char* const work : {"DOVETAIL SLOT", "ROUGH DOVETAIL", "ROUGH T-SLOT",
                                 "ROUND OVER EDGES", "FINISH T SLOT SIDES"}) {
    EXPECT_EQ(below("10MM ENDMILL", work), tool_like(endmill, 10, 0, 0)) << work;
    EXPECT_EQ(first_tool(fmt::format("({})\n(10MM ENDMILL)\nT1 M6\n{}", work, kCut)),
              tool_like(endmill, 10, 0, 0))
        << work;
  }
  for (const char* const tool : {"DOVETAIL CUTTER", "T-SLOT CUTTER", "ROUND OVER BIT",
                                 "DOVETAIL 60 DEG", "T-SLOT MILL", "WOODRUFF", "DOVETAIL", "T-SLOT",
                                 "KEYSEAT", "CORNER ROUND", "CORNER ROUNDING", "ROUND OVER"})
    EXPECT_NE(below("10MM ENDMILL", tool).find("different kinds"), std::string::npos) << tool;
}

// The comment of the block of the change, or right behind it, names the tool.
TEST(ToolLines, AFormAtTheChangeContradictsAPlainEndMill) {
  const std::string cut = kCut, fusion = "(T1 D=10. CR=0. - ZMIN=-5. - FLAT END MILL)\n";
  for (const char* const form :
       {"DOVETAIL", "KEYSEAT", "T-SLOT", "ROUGH DOVETAIL", "DOVETAIL CUTTER"}) {
    for (const std::string& head : {std::string("(T1 10MM END MILL)\n"), fusion}) {
      const std::string beside = fmt::format("{}T1 M6 ({})\n{}", head, form, cut);
      const std::string behind = fmt::format("{}T1 M6\n({})\n{}", head, form, cut);
      EXPECT_NE(first_tool(beside).find("different kinds"), std::string::npos) << beside;
      EXPECT_NE(first_tool(behind).find("different kinds"), std::string::npos) << behind;
    }
  }
}

// Such a size is that of a corner rounding cutter or of the head of a T-slot cutter.
TEST(ToolLines, SizesOfAFormBesideAPlainEndMillAreDoubted) {
  const std::string call = std::string("T1 M6\n") + kCut;
  for (const char* const lines :
       {"(CORNER ROUNDING)\n(10MM END MILL)\n(CR 3)\n", "(CORNER ROUNDING)\n(10MM END MILL R3)\n",
        "(T-SLOT)\n(T1 D25 END MILL W8)\n", "(T-SLOT)\n(T1 D25 END MILL)\n(WIDTH 8)\n",
        "(ROUND OVER EDGES)\n(10MM END MILL)\n(CR 3)\n", "(ROUND OVER EDGES)\n(10MM END MILL R3)\n",
        "(T1 10MM END MILL R3)\n(ROUND OVER EDGES)\n", "(ROUGH T-SLOT)\n(T1 D25 END MILL W8)\n",
        "(T1 D25 END MILL W8)\n(ROUGH T-SLOT)\n"})
    EXPECT_NE(first_tool(lines + call).find("the comment"), std::string::npos) << lines;
}

// "MILL D25" may be any mill: the name of a form says which, and asks for what it lacks.
TEST(ToolLines, AFormBelowAMillOfNoKindIsItsKind) {
  const std::string cut = kCut, call = "T1 M6\n" + cut;
  for (const std::string& text :
       {"(T1 MILL D25)\nT1 M6 (T-SLOT CUTTER)\n" + cut, "(T1 MILL D25)\n(T-SLOT)\n" + call,
        "(T1 MILL D25)\nT1 M6 (DOVETAIL CUTTER)\n" + cut, "(MILL D10)\n(DOVETAIL)\n" + call,
        "(T-SLOT)\n(MILL D10)\n" + call, "(T1 MILL D25)\nT1 M6\n(T-SLOT)\n" + cut})
    EXPECT_NE(first_tool(text).find("the comment"), std::string::npos) << text;
}

TEST(ToolLines, WhatIsTakenToBeTheWorkIsTold) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  const Program p =
      read_text(std::string("(T1 10MM ENDMILL)\n(ROUGH T-SLOT)\nT1 M6\n") + kCut, options);
  std::string told;
  for (const Diagnostic& d : p.diagnostics)
    if (d.code == "tool-inferred") told = d.text;
  EXPECT_NE(told.find("\"ROUGH T-SLOT\" taken to be the work"), std::string::npos) << told;
}

// Diameters of holes and pockets beside the tool that makes them.
TEST(ToolLines, SizesOfTheWorkAreNotThoseOfTheTool) {
  const std::string call = std::string("T1 M6\n") + kCut;
  const std::string mill = tool_like(ToolType::endmill, 10, 0, 0);
  for (const char* line :
       {"T1 D30 POCKET", "T1 BORE D30", "T1 KREISTASCHE D30", "T1 BORE 30MM", "T1 DIA 30 BORE"}) {
    EXPECT_EQ(first_tool(fmt::format("(T1 10MM ENDMILL)\n({})\n", line) + call), mill) << line;
    EXPECT_EQ(first_tool(fmt::format("({})\n(T1 10MM ENDMILL)\n", line) + call), mill) << line;
  }
  for (const char* line : {"T1 D12 GUEHRING", "T1 D=30 POCKET", "T1 TAPPING D8"})
    EXPECT_NE(first_tool(fmt::format("(T1 10MM ENDMILL)\n({})\n", line) + call).find("read as"),
              std::string::npos)
        << line;
}

// When a tool is replaced says not which is at hand, unless nothing else does.
TEST(ToolLines, UpkeepIsOfNoOtherTool) {
  const std::string call = std::string("T1 M6\n") + kCut;
  const std::string line = "(REPLACE 10MM ENDMILL EVERY 20 PARTS)\n";
  const std::string mill = tool_like(ToolType::endmill, 12, 0, 0);
  EXPECT_EQ(first_tool("(T1 12MM ENDMILL)\n" + line + call), mill);
  EXPECT_EQ(first_tool(line + "(T1 12MM ENDMILL)\n" + call), mill);
  EXPECT_EQ(first_tool(line + call), tool_like(ToolType::endmill, 10, 0, 0));
  const std::string own = "(T1 10MM ENDMILL - CHECK IF WORN)\n";
  EXPECT_EQ(first_tool(own + call), tool_like(ToolType::endmill, 10, 0, 0));
  EXPECT_NE(first_tool(own + "(T1 12MM ENDMILL)\n" + call).find("read as"), std::string::npos);
}

// What F-Engrave writes of its V-bit.
TEST(ToolLines, SettingsOfFEngraveTellItsBit) {
  const auto settings = [](const char* cut, const char* bit) {
    return fmt::format(
        "(fengrave_set cut_type    {} )\n(fengrave_set bit_shape   {} )\n"
        "(fengrave_set v_bit_angle 60 )\n(fengrave_set v_bit_dia   12.0 )\nG21\n{}",
        cut, bit, kCut);
  };
  EXPECT_EQ(first_tool(settings("v-carve", "VBIT"), Dialect::ngc),
            tool_like(ToolType::chamfer, 12, 60, 0));
  EXPECT_NE(first_tool(settings("engrave", "VBIT"), Dialect::ngc).find("F-Engrave"),
            std::string::npos);
  EXPECT_NE(first_tool(settings("v-carve", "BALL"), Dialect::ngc).find("F-Engrave"),
            std::string::npos);
}

// Beside a change they tell of the tool before or after it.
TEST(ToolLines, LinesAboutAnotherToolAreNotThisOnes) {
  const std::string cut = kCut;
  const std::string mill = tool_like(ToolType::endmill, 10, 0, 0);
  for (const char* line : {"NEXT TOOL - 6MM DRILL", "NEXT: 6MM DRILL", "LAST TOOL WAS 6MM DRILL",
                           "NAECHSTES WERKZEUG BOHRER D6"}) {
    const std::string other = fmt::format("({})\n", line);
    EXPECT_TRUE(first_tool("T1 M6\n" + other + cut).find("there are no data") != std::string::npos)
        << line;
    EXPECT_EQ(first_tool("T1 M6 (10MM ENDMILL)\n" + other + cut), mill) << line;
  }
  EXPECT_EQ(first_tool("(LAST TOOL WAS 6MM DRILL)\nT1 M6 (10MM ENDMILL)\n" + cut), mill);
  for (const char* end : {"END OF 6MM DRILL", "DONE WITH 6MM DRILL", "FINISHED WITH 6MM DRILL",
                          "ENDE BOHRER 6MM", "FIN DU FORET 6MM"})
    EXPECT_EQ(first_tool("(" + std::string(end) + ")\n(10MM ENDMILL)\nT1 M6\n" + cut), mill) << end;
  EXPECT_EQ(first_tool("(NEXT TOOL IS A 10MM ENDMILL)\nT1 M6\n" + cut), mill);
}

}  // namespace
}  // namespace mrsim
