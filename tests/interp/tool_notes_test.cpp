// Which tool a comment is about, in whole programs.
#include "interp/support.h"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// "1:6 2:10": tools and diameters of the cuts, in the order of their first use.
std::string diameters(const std::string& text, Dialect dialect = Dialect::fanuc) {
  InterpOptions options;
  options.dialect = dialect;
  options.machine = MachineKind::mill;
  const Program p = read_text(text, options);
  std::string out;
  for (const Tool& tool : p.tools)
    out += fmt::format("{}{}:{:g}", out.empty() ? "" : " ", tool.id, tool.diameter);
  const std::string errors = codes(p, Severity::error);
  return errors.empty() ? out : out + " " + errors;
}

TEST(ToolNotes, TheCommentAboveTheCallNamesTheTool) {
  const std::string cut = kCut;
  // FreeCAD: the operation's comment, modes, then the call.
  EXPECT_EQ(diameters("(begin operation: TC: 5mm Endmill)\n(machine units: mm/min)\n"
                      "(TC: 5mm Endmill)\n(Begin toolchange)\nM5\nG90\nM6 T1\nG43 H1\n" +
                      cut + "(TC: 3mm Drill)\nM5\nT2 M6\n" + cut),
            "1:5 2:3");
  // The nearest group of comments counts.
  EXPECT_EQ(diameters("(3MM ENDMILL)\nG90\n(TC: 5mm Endmill)\nT1 M6\n" + cut), "1:5");
  // In a program without T words.
  EXPECT_EQ(diameters("G21\n(3.175mm endmill)\n" + cut, Dialect::ngc), ":3.175");
  EXPECT_EQ(diameters("G21\n; 1/8 flat end mill\n" + cut, Dialect::ngc), ":3.175");
  EXPECT_EQ(diameters("G21\n(drill 6mm)\n" + cut, Dialect::ngc), " tool-unknown");
  EXPECT_EQ(diameters("G21\n(6mm endmill)\n" + cut + "(3mm endmill)\n" + cut, Dialect::ngc),
            ":6 tool-unknown");
  // Two in one group contradict each other.
  EXPECT_EQ(diameters("(3MM ENDMILL)\n(TC: 5mm Endmill)\nT1 M6\n" + cut), "1:0 tool-unknown");
  // A comment is not about the tool after the next cut.
  EXPECT_EQ(
      diameters("T1 M6 (6MM ENDMILL)\nG0 X0 Y0 Z5\n(8MM ENDMILL)\nG1 Z-1 F100\nT2 M6\n" + cut),
      "1:6 2:0 tool-unknown");
}

TEST(ToolNotes, TheCommentBelowTheCallNamesTheTool) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("T1 M6\n(6MM FLAT ENDMILL)\nT2\n" + cut + "T2 M6\n(10MM DRILL)\n" + cut),
            "1:6 2:10");
}

TEST(ToolNotes, CommentsOfOneToolAreReadTogether) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("(TOOL NUMBER: 3)\n(TOOL TYPE: ENDMILL)\n(TOOL DIAMETER: 10.0)\n"
                      "(TOOL NUMBER: 4)\n(TOOL TYPE: BALLNOSE)\n(TOOL DIAMETER: 6.0)\nT3 M6\n" +
                      cut + "T4 M6\n" + cut),
            "3:10 4:6");
  EXPECT_EQ(
      diameters("(T1 D=6. CR=0. - ZMIN=-2. - FLAT END MILL)\nT1 M6\n(T1 DRILL HOLES)\n" + cut),
      "1:6");
  EXPECT_EQ(diameters("T1 M6 (6MM ENDMILL)\n(T2 NEXT: 8MM DRILL)\n" + cut + "T2 M6\n" + cut),
            "1:6 2:8");
  EXPECT_EQ(diameters("(T1 D=6. - FLAT END MILL)\n(T1 D=8. - FLAT END MILL)\nT1 M6\n" + cut),
            "1:0 tool-unknown");
}

// Posts leave out signs that controls do not read in comments.
TEST(ToolNotes, NamesThatHaveLostTheirSlash) {
  const std::string head = "(T1 D=3.175 CR=0. - ZMIN=-1. - FLAT END MILL)\nT1 M6\n", cut = kCut;
  EXPECT_EQ(diameters(head + "(18 FLAT ENDMILL)\n" + cut), "1:3.175");
  EXPECT_EQ(diameters(head + "(14 FLAT ENDMILL)\n" + cut), "1:0 tool-unknown");
  EXPECT_EQ(diameters("G20\n(112 FACE MILL)\n(D=1.5)\nT1 M6\n" + cut), "1:38.1");
}

// WorkNC and others end with the number.
TEST(ToolNotes, ANumberMayStandBehindWhatItNumbers) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("(TOOL NAME: BALL MILL D8)\n(TOOL NUMBER: 5)\n(TOOL NAME: END MILL D10)\n"
                      "(TOOL NUMBER: 6)\nT5 M6\n" +
                      cut + "T6 M6\n" + cut),
            "5:8 6:10");
  EXPECT_EQ(diameters("(10MM ENDMILL)\n(TOOL 5)\nT5 M6\n" + cut), "5:10");
  // A comment about the work, then a list that begins with the numbers.
  EXPECT_EQ(diameters("(ROUGH WITH 10MM ENDMILL)\n(TOOL 5)\n(8MM DRILL)\nT5 M6\n" + cut), "5:8");
  EXPECT_EQ(diameters("(ROUGH WITH 10MM ENDMILL)\n(T5 8MM DRILL)\n(T6 HAIMER)\nT5 M6\n" + cut +
                      "T6 M6\n" + cut),
            "5:8 6:0 tool-unknown");
}

// T6 of an alloy is no tool.
TEST(ToolNotes, TheTemperOfAnAlloyIsNoTool) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("(10MM ENDMILL)\n(MATERIAL 6061-T6)\nT1 M6\n" + cut), "1:10");
  EXPECT_EQ(diameters("(MATERIAL 7075 T6)\n(10MM ENDMILL)\nT1 M6\n" + cut + "T6 M6\n" + cut),
            "1:10 6:0 tool-unknown");
  EXPECT_EQ(diameters("(10MM ENDMILL FOR 6061-T6)\nT1 M6\n" + cut), "1:10");
}

TEST(ToolNotes, KeysWithValuesAreReadLineByLine) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("(TOOL: 5)\n(TYPE: BALL)\n(DIAMETER: 8.0)\n(OPERATION: CONTOUR)\n(TOOL: 6)\n"
                      "(TYPE: ENDMILL)\n(DIAMETER: 10.0)\nT5 M6\n" +
                      cut + "T6 M6\n" + cut),
            "5:8 6:10");
  EXPECT_EQ(diameters("(DIAMETER: 50.0)\nT5 M6\n" + cut), "5:0 tool-unknown") << "of the work";
  EXPECT_EQ(diameters("(DIAMETER: 50.0)\nG0\n(TOOL 5)\n(ENDMILL D8)\nT5 M6\n" + cut), "5:8");
}

// A list of NX: each line is about the tool whose name it gives.
TEST(ToolNotes, EachLineOfAListIsAboutTheToolItNames) {
  const std::string cut = "G90 G0 X0 Y0 Z5\nG1 Z-1 F100\n";
  const std::string list = "; MILL_D20R2 (D20 R2)\n; MILL_D20 (D20)\n; DRILL_D8\n";
  EXPECT_EQ(diameters(list + "T=\"MILL_D20R2\" M6\n" + cut + "T=\"DRILL_D8\" M6\n" + cut,
                      Dialect::sinumerik),
            "MILL_D20R2:20 DRILL_D8:8");
}

// What the comment leaves open the name may tell.
TEST(ToolNotes, TheNameMayGiveTheSizeAndTheCommentTheKind) {
  const std::string call = " ALL HOLES\nT=\"DRILL_8\" M6\nG90 G0 X0 Y0 Z5\nG1 Z-1 F100\n";
  EXPECT_EQ(diameters("; TWIST DRILL FOR" + call, Dialect::sinumerik), "DRILL_8:8");
  EXPECT_EQ(diameters("; END MILL FOR" + call, Dialect::sinumerik), "DRILL_8:0 tool-unknown");
}

TEST(ToolNotes, SizesHaveTheUnitOfTheProgram) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("G20\n(T1 | 1/4 FLAT ENDMILL | H1)\nT1 M6\n" + cut), "1:6.35");
  EXPECT_EQ(diameters("G20\n(T1 | 6MM FLAT ENDMILL | H1)\nT1 M6\n" + cut), "1:6");
  EXPECT_EQ(
      diameters("G21\n(T239 | 10 FLAT ENDMILL | H239 | D239 | TOOL DIA. - 10.)\nT239 M6\n" + cut),
      "239:10");
}

TEST(ToolNotes, TheNameOfAToolMayTellItsSize) {
  EXPECT_EQ(diameters("T=\"ENDMILL_D10\"\nM6\nG90 G0 X0 Y0 Z5\nG1 Z-1 F100\n", Dialect::sinumerik),
            "ENDMILL_D10:10");
  EXPECT_EQ(diameters("T=\"CUTTER 10\"\nM6\nG90 G0 X0 Y0 Z5\nG1 Z-1 F100\n", Dialect::sinumerik),
            "CUTTER 10:10");
  const auto corner = [](const char* name) {
    InterpOptions options;
    options.dialect = Dialect::sinumerik;
    options.machine = MachineKind::mill;
    const Program p =
        read_text(fmt::format("T=\"{}\"\nM6\nG90 G0 X0 Y0 Z5\nG1 Z-1 F100\n", name), options);
    return p.tools.empty() ? -1 : p.tools[0].corner_radius;
  };
  EXPECT_EQ(corner("MILL_D12_R0_5"), 0.5) << "names have no points";
  EXPECT_EQ(corner("MILL_D12_R05"), 0) << "an error: R5 or R0.5";
}

TEST(ToolNotes, TipsThatAreNotToldAreSaidToBeSharp) {
  const auto note = [](const std::string& comment) {
    const Program p = read_text("G21\n(" + comment + ")\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\n", [] {
      InterpOptions options;
      options.dialect = Dialect::fanuc;
      options.machine = MachineKind::mill;
      return options;
    }());
    for (const Diagnostic& d : p.diagnostics)
      if (d.code == "tool-inferred") return d.text;
    return std::string();
  };
  const std::string sharp = "its tip taken to be sharp";
  EXPECT_NE(note("T7 D=12. CR=0. TAPER=45DEG - ZMIN=-1. - CHAMFER MILL").find(sharp),
            std::string::npos);
  EXPECT_EQ(note("T7 CHAMFER MILL D12 90 DEG TIP D2").find(sharp), std::string::npos);
  EXPECT_EQ(note("T7 60V 1/2\"").find(sharp), std::string::npos);
}

// Mach has four digits for both on its lathes; tool 101 of LinuxCNC has to be given.
TEST(ToolNotes, FourDigitsOfMachAreToolAndOffset) {
  InterpOptions options;
  options.dialect = Dialect::ngc;
  options.machine = MachineKind::lathe;
  const std::string program = "(T0202 DRILL 8MM)\nT0202\nG0 X0 Z5\nG1 Z-1 F100\nM2\n";
  const auto id = [&](const std::string& text) {
    const Program p = read_text(text, options);
    return p.tools.empty() ? listing(p)
                           : fmt::format("{} {:g}", p.tools[0].id, p.tools[0].diameter);
  };
  EXPECT_EQ(id(program), "2 8");
  EXPECT_NE(codes(read_text(program, options), Severity::note).find("tool-station"),
            std::string::npos);
  EXPECT_EQ(id("T2 M6 (DRILL 8MM)\nG0 X0 Z5\nG1 Z-1 F100\nM2\n"), "2 8");
  Tool drill;
  drill.id = "202", drill.type = ToolType::drill, drill.diameter = 9;
  options.table.tools.push_back(drill);
  EXPECT_EQ(id(program), "202 9");
}

// Of a thread mill a comment gives the cylinder alone: a warning says so.
TEST(ToolNotes, AThreadMillIsACylinderWithAWarning) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::mill;
  const std::string cut = kCut;
  const Program p = read_text("(T3 D=8. CR=0. PITCH=1.25 - THREAD MILL)\nT3 M6\n" + cut, options);
  EXPECT_EQ(codes(p), "tool-inferred");
  EXPECT_NE(listing(p).find("its thread as a plain cylinder"), std::string::npos);
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_EQ(p.tools[0].diameter, 8);
  EXPECT_EQ(codes(read_text("T1 M6 (8MM ENDMILL)\n" + cut, options)), "");
}

// Fusion's D of a tapered ball mill lies within the ball; how long the taper is stands nowhere: the
// run takes it to be as long as it cuts.
TEST(ToolNotes, ATaperedMillNeedsNoFlutes) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::mill;
  const Program p = read_text(
      "(T12 D=1.872 CR=1. TAPER=3.8deg - tapered mill)\nT12 M6\n" + std::string(kCut), options);
  EXPECT_EQ(codes(p), "");
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_EQ(p.tools[0].type, ToolType::taper);
  EXPECT_EQ(p.tools[0].diameter, 1.872);
  EXPECT_EQ(p.tools[0].flute_length, 0);
}

// Vectric lists tools by their numbers.
TEST(ToolNotes, AListOfNumberedToolsIsRead) {
  const std::string cut = kCut;
  const std::string head =
      "(Tools used in this file: )\n(1 = End Mill {0.25\"})\n"
      "(2 = Ball Nose {0.125\"})\nG20\n";
  EXPECT_EQ(diameters(head + "T1 M6\n" + cut + "T2 M6\n" + cut), "1:6.35 2:3.175");
}

// A comment between the change and the first cut, if it names a tool and its size.
TEST(ToolNotes, ACommentBeforeTheFirstCutNamesTheTool) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("M06 T01\nG0 X0 Y0 Z25. S1200 M3\n(12MM SLOT DRILL)\n" + cut), "1:12");
  EXPECT_EQ(diameters("M06 T01\nG0 X0 Y0 Z25.\n(DRILL 12MM HOLES)\n" + cut), "1:0 tool-unknown");
  EXPECT_EQ(diameters("T20 M6\nG31 Z-5. F100\nG0 Z5.\n(12MM SLOT DRILL)\nT2 M6\n" + cut), "2:12")
      << "a probe cuts nothing";
  EXPECT_EQ(diameters("T1 M6\n" + cut + "(12MM SLOT DRILL)\nT2 M6\n" + cut),
            "1:0 2:12 tool-unknown");
}

// pcb2gcode: the message between T and M6 is about that tool, whatever the one before is.
TEST(ToolNotes, AMessageBetweenCallAndChangeNamesTheTool) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("T0\nM5 (Spindle stop.)\n(MSG, Change tool bit to mill diameter 0.15000mm)\n"
                      "M6\n" +
                          cut + "T1\nM5\n(MSG, Change tool bit to drill size 0.8mm)\nM6\n" + cut,
                      Dialect::ngc),
            "0:0.15 1:0.8");
  // The next tool made ready: the operation is that of the tool in the spindle.
  EXPECT_EQ(diameters("T1 M6 (8MM ENDMILL)\nT2\n(ROUGH WITH 10MM ENDMILL)\n" + cut + "M6\n" + cut),
            "1:8 2:0 tool-unknown");
}

// Without T words comments may change the tool, too.
TEST(ToolNotes, WithoutTWordsCommentsMayChangeTheTool) {
  const std::string cut = "G1 X5 Y0 Z0 F100\nX9\nY5\n";
  EXPECT_EQ(diameters("(Tool diameter: 2.0)\n" + cut + "(Tool diameter: 2.0)\n" + cut), ":2");
  EXPECT_EQ(diameters("(Tool diameter: 2.0)\n" + cut + "(Tool diameter: 5.0)\n" + cut),
            ":2 tool-unknown");
}

// The error gives words for --tool that fit the kind.
TEST(ToolNotes, RefusalsNameTheKind) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::mill;
  const auto told = [&](const std::string& comment) {
    return listing(read_text("(" + comment + ")\nT1 M6\n" + kCut, options));
  };
  EXPECT_NE(told("T1 DOVETAIL D=14 60 DEG").find("give its profile"), std::string::npos);
  EXPECT_NE(told("T1 V-BIT 6 MM").find("--tool 1=chamfer:d=6,tip_angle=60"), std::string::npos);
}

// A size below 1 in a program that names no unit may be inches: the run asks.
TEST(ToolNotes, SmallSizesNeedAUnit) {
  const std::string head = "(TOOL 3 .250 BALL EM)\n", change = "T3 M6\n";
  EXPECT_EQ(diameters(head + change + kCut), "3:0 tool-unknown");
  EXPECT_EQ(diameters(head + "G20\n" + change + kCut), "3:6.35");
  EXPECT_EQ(diameters(head + "G21\n" + change + kCut), "3:0 tool-unknown")
      << "thousandths in a program in mm";
  EXPECT_EQ(diameters("(TOOL 3 0.25 BALL EM)\nG21\n" + change + kCut), "3:0.25");
  EXPECT_EQ(diameters("(T3 0.5MM ENDMILL)\n" + change + kCut), "3:0.5");
}

// "#7 DRILL" beside T7 may number the tool.
TEST(ToolNotes, TheToolsOwnNumberNamesNoNumberDrill) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("G20\nT5 M6 (#7 DRILL)\n" + cut), "5:5.1054");
  EXPECT_EQ(diameters("G20\nT7 M6 (#7 DRILL)\n" + cut), "7:0 tool-unknown");
  EXPECT_EQ(diameters("G20\nT7 M6 (TOOL #7 .201 DRILL)\n" + cut), "7:5.1054");
  EXPECT_EQ(diameters("G20\n(T7 #7 DRILL)\n(T7 .201 DRILL)\nT7 M6\n" + cut), "7:5.1054");
}

// An angle that the kind implies stays when another comment tells the diameter, and is noted.
TEST(ToolNotes, AnAssumedAngleIsNoted) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::mill;
  const Program p = read_text(
      "(TOOL NUMBER: 3)\n(TOOL TYPE: SPOT DRILL)\n(TOOL DIAMETER: 10)\nT3 M6\n" + std::string(kCut),
      options);
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_NEAR(p.tools[0].tip_angle, 1.5707963, 1e-6);
  EXPECT_NE(listing(p).find("taken to have 90 degrees"), std::string::npos) << listing(p);
}

// A register of a tool that is not known is no second fault.
TEST(ToolNotes, ARegisterOfAnUnknownToolIsNoSecondFault) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::mill;
  EXPECT_EQ(codes(read_text("T1 M6\nG0 X0 Y0 Z0\nG1 G41 D1 X9 F9\nY9\nG40 X0\nM30\n", options)),
            "tool-unknown");
}

// Where T makes a tool ready and M6 brings it.
TEST(ToolNotes, M6BringsTheToolThatWaits) {
  const auto tools = [](const std::string& text) {
    InterpOptions options = at_origin(Dialect::fanuc);
    options.table.tools.clear();
    for (const char* id : {"1", "2", "3"}) {
      Tool tool;
      tool.id = id;
      tool.diameter = 10;
      options.table.tools.push_back(tool);
    }
    const Program p = read_text(text, options);
    std::string out;
    for (const Motion& motion : p.motions)
      out += motion.tool < 0 ? "- " : p.tools[static_cast<std::size_t>(motion.tool)].id + " ";
    return out + codes(p);
  };
  const std::string cut = "G1 X5. F100\n", back = "X0\n";
  EXPECT_EQ(tools("T1\nM6 T2\n" + cut + "M6 T3\n" + back + "M6\n" + cut), "1 2 3 tool-order");
  EXPECT_EQ(tools("M6 T1\n" + cut + "T2\nM6 T2\n" + back), "1 2 ");
  EXPECT_EQ(tools("T1 M6\nT2\n" + cut + "T3 M6\n" + back), "1 3 ") << "the call of T2 is left over";
  EXPECT_EQ(tools("T1 M6 T2\n" + cut + "T2 M6 T3\n" + back), "1 2 ");
  EXPECT_EQ(tools("M6\nT2\n" + cut + "M6\nT1\n" + back), "- 2 tool-unknown");
  EXPECT_EQ(tools("T2\n" + cut), "2 ");
}

// NX writes a tool in several comments, above the call or below it.
TEST(ToolNotes, NxWritesAToolInSeveralComments) {
  const auto tool = [](const std::string& before, const std::string& behind,
                       const std::string& kind = "Milling Tool-5 Parameters") {
    InterpOptions options = at_origin(Dialect::sinumerik);
    options.table.tools.clear();
    const std::string comments = ";TOOL NAME : MILL_D10\n;DESCRIPTION : " + kind +
                                 "\n;TOOL DIAMETER : 10.00\n;CORNER RADIUS : 1.00\n";
    const std::string call = ";First Tool\nSUPA G0 Z500 D0\nT=\"MILL_D10\"\nM6\n";
    const Program p = read_text(
        (before.empty() ? "" : comments) + call + (behind.empty() ? "" : comments) + "G1 X5 F100\n",
        options);
    return p.tools.empty() ? Tool{} : p.tools[0];
  };
  for (const Tool& told : {tool("above", ""), tool("", "below")}) {
    EXPECT_EQ(told.type, ToolType::bullmill);
    EXPECT_EQ(told.diameter, 10);
    EXPECT_EQ(told.corner_radius, 1);
  }
  EXPECT_EQ(tool("", "").type, ToolType::endmill) << "by its name";
  InterpOptions options = at_origin(Dialect::fanuc);
  options.table.tools.clear();
  const Program ball = read_text(
      "(TOOL NAME: MILL_D10)\n(DESCRIPTION: Milling Tool-Ball Mill)\nT1 M6\nG1 X5. F100\n",
      options);
  ASSERT_EQ(ball.tools.size(), 1U);
  EXPECT_EQ(ball.tools[0].type, ToolType::ballmill);
}

// A tool with its number, and lines below that tell its kind and its corner.
TEST(ToolNotes, LinesBelowTheToolsNumberTellItsKind) {
  const auto tool = [](const std::string& comments) {
    InterpOptions options = at_origin(Dialect::fanuc);
    options.table.tools.clear();
    const Program p = read_text(comments + "\nT1 M6\nG1 X5. F100\n", options);
    if (p.tools.empty()) return std::string("none");
    return fmt::format("{} {:g} {:g}", static_cast<int>(p.tools[0].type), p.tools[0].diameter,
                       p.tools[0].corner_radius);
  };
  const auto is = [](ToolType type, double d, double r) {
    return fmt::format("{} {:g} {:g}", static_cast<int>(type), d, r);
  };
  EXPECT_EQ(tool("(T1 6MM)\n(BALL NOSE)"), is(ToolType::ballmill, 6, 0));
  EXPECT_EQ(tool("(T1 6MM)\n(SPOT DRILL)"), is(ToolType::drill, 6, 0));
  EXPECT_EQ(tool("(TOOL 1: EM 6MM)\n(R: 0.5)"), is(ToolType::bullmill, 6, 0.5));
  EXPECT_EQ(tool("(TOOL NO.: 1)\n(TOOL NAME: EM 10)\n(CR=0.5)"), is(ToolType::bullmill, 10, 0.5));
  EXPECT_EQ(tool("(T1 ENDMILL)\n(DIA: 10.)\n(CORNER R 0.5)"), is(ToolType::bullmill, 10, 0.5));
  EXPECT_EQ(tool("(T1 6MM ENDMILL)\n(RADIUS 20)"), is(ToolType::endmill, 6, 0)) << "of the work";
  for (const char* work : {"CHAMFER", "DRILL1", "TALADRO1"})
    EXPECT_EQ(tool(fmt::format("(T1 6MM ENDMILL)\n({})", work)), is(ToolType::endmill, 6, 0));
  EXPECT_EQ(tool("(T1: SHANK D12)\n(CUTTER D10 R1)"), is(ToolType::endmill, 0, 0)) << "asks";
}

}  // namespace
}  // namespace mrsim
