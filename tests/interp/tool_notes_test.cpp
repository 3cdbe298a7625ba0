// Which tool a comment is about, in whole programs.
#include "interp/support.h"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

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

const char* const kCut = "G0 X0 Y0 Z5\nG1 Z-1 F100\nX5\n";

TEST(ToolNotes, AboveTheCall) {
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

TEST(ToolNotes, FourDigitsAreStationAndOffsetOnLathes) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::lathe;
  const Program p = read_text(
      "(T0202 D=10 DRILL)\n(T0101 OD TURN CNMG 120408)\nT0101\nG0 X50. Z2.\nG1 Z-5. F.2\n"
      "T0202\nG0 X0 Z5.\nG1 Z-20. F.1\nT1212 (12. DRILL)\nG1 Z-30.\n",
      options);
  ASSERT_EQ(p.tools.size(), 3U) << listing(p);
  EXPECT_EQ(p.tools[0].insert, "CNMG");
  EXPECT_EQ(p.tools[1].type, ToolType::drill);
  EXPECT_EQ(p.tools[1].diameter, 10);
  EXPECT_EQ(p.tools[2].id, "12");
  EXPECT_EQ(p.tools[2].diameter, 12);
}

// "T4 D1 ; PARTING 3MM": beside the T word the work names the tool, on every lathe.
TEST(ToolNotes, WorkNamesTheToolOfALathe) {
  InterpOptions options;
  options.dialect = Dialect::sinumerik;
  options.machine = MachineKind::lathe;
  const Program p = read_text(
      "G18 G95\nT1 D1 ; PARTING 3MM\nG0 X50 Z-20\nG1 X-1 F0.1\nG0 X50\nT2 D1 ; THREAD\nG0 X30 Z2\n"
      "G33 Z-10 K2\nT=\"PLUNGE_CUTTER_2\" D1\nG0 X50 Z-5\nG1 X40 F0.1\n"
      "T=\"STECHER_4\" D1\nG0 X50\nG1 X40\nT=\"ROUGHING_T80_A\" D1\nG0 X50\nG1 X48\n",
      options);
  ASSERT_EQ(p.tools.size(), 5U) << listing(p);
  EXPECT_EQ(p.tools[0].type, ToolType::grooving);
  EXPECT_EQ(p.tools[0].width, 3);
  EXPECT_EQ(p.tools[1].type, ToolType::threading);
  EXPECT_EQ(p.tools[2].width, 2);
  EXPECT_EQ(p.tools[3].width, 4);
  EXPECT_EQ(p.tools[4].type, ToolType::turning);
}

// As SINUMERIK's lists call them; A and I are outside and inside.
TEST(ToolNotes, NamesInTheListsOfLathes) {
  const auto named = [](const std::string& name) {
    InterpOptions options;
    options.dialect = Dialect::sinumerik;
    options.machine = MachineKind::lathe;
    const Program p =
        read_text("G18 G95\nT=\"" + name + "\" D1\nG0 X50 Z2\nG1 Z-20 F0.1\nG1 X55\n", options);
    if (p.tools.size() != 1) return listing(p);
    const Tool& tool = p.tools[0];
    EXPECT_EQ(tool.nose_radius, name.ends_with("R08") ? 0.8 : name.ends_with("R0.4") ? 0.4 : 0);
    return fmt::format("{} tip {}, {:.3g} deg, width {}", static_cast<int>(tool.type), tool.tip,
                       degrees(tool.insert_angle), tool.width);
  };
  const auto turning = [](ToolType type, int tip, int corner, int width) {
    return fmt::format("{} tip {}, {} deg, width {}", static_cast<int>(type), tip, corner, width);
  };
  const std::string inside = turning(ToolType::boring, 0, 80, 0);
  EXPECT_EQ(named("ROUGHING_T80_A"), turning(ToolType::turning, 0, 80, 0));
  EXPECT_EQ(named("ROUGHING_T80 I"), inside);
  EXPECT_EQ(named("ROUGHING_T80_R08"), turning(ToolType::turning, 0, 80, 0));
  EXPECT_EQ(named("FINISHER_35 R0.4"), turning(ToolType::turning, 0, 35, 0));
  EXPECT_EQ(named("SCHRUPPER_80_I"), inside);
  EXPECT_EQ(named("ROUGHER_80"), turning(ToolType::turning, 0, 80, 0));  // no mill of 80 mm
  EXPECT_EQ(named("FINISHING_T35_A"), turning(ToolType::turning, 0, 35, 0));
  EXPECT_EQ(named("DREHMEISSEL_55_I"), turning(ToolType::boring, 0, 55, 0));
  EXPECT_EQ(named("PLUNGE_CUTTER_3_A"), turning(ToolType::grooving, 0, 35, 3));
  EXPECT_EQ(named("STECHER_3_I"), turning(ToolType::grooving, 2, 35, 3));
  EXPECT_EQ(named("GROOVER_3"), turning(ToolType::grooving, 0, 35, 3));
  EXPECT_EQ(named("ID_ROUGH"), turning(ToolType::boring, 0, 35, 0));
  EXPECT_EQ(named("OD_80_L"), turning(ToolType::turning, 0, 80, 0));
  EXPECT_EQ(named("ID_55_L"), turning(ToolType::boring, 0, 55, 0));
  const Program bare =
      read_text("G18 G95 DIAMON\nT=\"EINSTECHER\" D1\nG0 X50 Z-20\nG1 X40 F0.1\n", {});
  EXPECT_EQ(codes(bare, Severity::error), "tool-unknown");
  const Program said = read_text(
      "; T=\"ROUGHER_80\"\nG18 G95 DIAMON\nT=\"ROUGHER_80\" D1\nG0 X50 Z2\nG1 Z-20 F0.1\n", {});
  ASSERT_EQ(said.tools.size(), 1U) << listing(said);
  EXPECT_EQ(said.tools[0].type, ToolType::turning);
}

TEST(ToolNotes, WorkInsideTurnsThePointOutwards) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::lathe;
  const std::string cut = "G0 X30. Z2.\nG1 Z-5. F.1\n";
  const Program p = read_text("T0101 (ID GROOVE 3MM)\n" + cut + "T0202 (ID THREAD)\n" + cut +
                                  "T0303 (GROOVE 3MM)\n" + cut + "T0505 (FINISH BORE)\n" + cut,
                              options);
  ASSERT_EQ(p.tools.size(), 4U) << listing(p);
  EXPECT_EQ(p.tools[0].tip, 2);
  EXPECT_EQ(p.tools[1].tip, 6);
  EXPECT_EQ(p.tools[2].tip, 0);
  EXPECT_EQ(p.tools[3].type, ToolType::boring);
  EXPECT_EQ(codes(read_text("T0404 (FACE GROOVE 3MM)\n" + cut, options), Severity::error),
            "tool-unknown");
}

// A radius of inserts is the tool's, any other one the work's.
TEST(ToolNotes, NoseBesideTheWork) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::lathe;
  const std::pair<const char*, double> rows[] = {{"OD ROUGH R0.8", 0.8},
                                                 {"OD ROUGH R.8", 0.8},
                                                 {"FINISH OD NR 0.4", 0.4},
                                                 {"ROUGH TURN .031R", 0.7874},
                                                 {"OD TURN 1/32 R", 0.79375},
                                                 {"DESB. EXT. R0.8", 0.8},
                                                 {"TURNING R0.8", 0.8},
                                                 {"SCHLICHTEN AUSSEN R0.4", 0.4},
                                                 {"FINISH BORE R0.4", 0.4},
                                                 {"TURN R10", 0},
                                                 {"FINISH R5 FILLET", 0},
                                                 {"OD FACE FIN.015R", 0.381},
                                                 {"BORE R20", 0}};
  for (const auto& [comment, nose] : rows) {
    const std::string text = std::string("T0101 (") + comment + ")\nG0 X30. Z2.\nG1 Z-5. F.1\n";
    const Program p = read_text(text, options);
    ASSERT_EQ(p.tools.size(), 1U) << comment << listing(p);
    EXPECT_NEAR(p.tools[0].nose_radius, nose, 1e-9) << comment;
    const bool bores = std::string_view(comment).find("BORE") != std::string_view::npos;
    EXPECT_EQ(p.tools[0].type, bores ? ToolType::boring : ToolType::turning) << comment;
  }
  EXPECT_EQ(codes(read_text("G20\nT0101 (OD ROUGH R0.8)\nG0 X3. Z.2\nG1 Z-.5 F.01\n", options)), "")
      << "mm in a program in inches";
}

TEST(ToolNotes, BelowTheCall) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("T1 M6\n(6MM FLAT ENDMILL)\nT2\n" + cut + "T2 M6\n(10MM DRILL)\n" + cut),
            "1:6 2:10");
}

TEST(ToolNotes, SeveralCommentsOfOneTool) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("(TOOL NUMBER: 3)\n(TOOL TYPE: ENDMILL)\n(TOOL DIAMETER: 10.0)\n"
                      "(TOOL NUMBER: 4)\n(TOOL TYPE: BALLNOSE)\n(TOOL DIAMETER: 6.0)\nT3 M6\n" +
                      cut + "T4 M6\n" + cut),
            "3:10 4:6");
  EXPECT_EQ(
      diameters("(T1 D=6. CR=0. - ZMIN=-2. - FLAT END MILL)\nT1 M6\n(T1 DRILL HOLES)\n" + cut),
      "1:6");
  EXPECT_EQ(diameters("(T1 D=6. - FLAT END MILL)\n(T1 D=8. - FLAT END MILL)\nT1 M6\n" + cut),
            "1:0 tool-unknown");
}

TEST(ToolNotes, UnitsOfTheProgram) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("G20\n(T1 | 1/4 FLAT ENDMILL | H1)\nT1 M6\n" + cut), "1:6.35");
  EXPECT_EQ(diameters("G20\n(T1 | 6MM FLAT ENDMILL | H1)\nT1 M6\n" + cut), "1:6");
  EXPECT_EQ(
      diameters("G21\n(T239 | 10 FLAT ENDMILL | H239 | D239 | TOOL DIA. - 10.)\nT239 M6\n" + cut),
      "239:10");
}

TEST(ToolNotes, ByName) {
  EXPECT_EQ(diameters("T=\"ENDMILL_D10\"\nM6\nG90 G0 X0 Y0 Z5\nG1 Z-1 F100\n", Dialect::sinumerik),
            "ENDMILL_D10:10");
  EXPECT_EQ(diameters("T=\"CUTTER 10\"\nM6\nG90 G0 X0 Y0 Z5\nG1 Z-1 F100\n", Dialect::sinumerik),
            "CUTTER 10:10");
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

// T words of lathes with six and eight digits have half of them for the offset.
TEST(ToolNotes, StationsOfLathes) {
  const auto tools = [](const std::string& program) {
    InterpOptions options;
    options.dialect = Dialect::fanuc;
    options.machine = MachineKind::lathe;
    const Program p = read_text(program, options);
    std::string out;
    for (const Tool& tool : p.tools) out += fmt::format("{}:{:g} ", tool.id, tool.diameter);
    if (codes(p, Severity::note).find("tool-station") != std::string::npos) out += "tool-station";
    return out;
  };
  const std::string cut = "\nG0 X0 Z5\nG1 Z-1 F.1\n";
  EXPECT_EQ(tools("T0101 (DRILL 8MM)" + cut + "T1212 (DRILL 9MM)" + cut), "1:8 12:9 ");
  EXPECT_EQ(tools("T001001 (DRILL 8MM)" + cut + "T012012 (DRILL 9MM)" + cut), "1:8 12:9 ");
  EXPECT_EQ(tools("(T003003 DRILL 8MM)\nT003003" + cut), "3:8 ");
  EXPECT_EQ(tools("T00020002 (DRILL 8MM)" + cut), "2:8 ");
  EXPECT_EQ(tools("T0202.1 (DRILL 8MM)" + cut + "T0303.01 (DRILL 9MM)" + cut),
            "2:8 3:9 tool-station")
      << "Mazak: a suffix";
  EXPECT_EQ(codes(read_text("T0202.1 (DRILL 8MM)" + cut + "T0202.2" + cut,
                            at_origin(Dialect::fanuc, MachineKind::lathe))),
            "value-range");
  EXPECT_EQ(tools("T020202 (DRILL 8MM)" + cut), "2:8 ") << "Okuma: nose, tool and offset";
  EXPECT_EQ(tools("T002000 (DRILL 8MM)" + cut), "2:8 ");
  EXPECT_EQ(tools("T002012 (DRILL 8MM)" + cut), "2:8 tool-station") << "or something else";
}

// Mach has four digits for both on its lathes; tool 101 of LinuxCNC has to be given.
TEST(ToolNotes, StationsOfMach) {
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
TEST(ToolNotes, ATaperedMillWithoutFlutes) {
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
TEST(ToolNotes, AListOfNumberedTools) {
  const std::string cut = kCut;
  const std::string head =
      "(Tools used in this file: )\n(1 = End Mill {0.25\"})\n"
      "(2 = Ball Nose {0.125\"})\nG20\n";
  EXPECT_EQ(diameters(head + "T1 M6\n" + cut + "T2 M6\n" + cut), "1:6.35 2:3.175");
}

// A comment between the change and the first cut, if it names a tool and its size.
TEST(ToolNotes, AToolNamedBeforeItsFirstCut) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("M06 T01\nG0 X0 Y0 Z25. S1200 M3\n(12MM SLOT DRILL)\n" + cut), "1:12");
  EXPECT_EQ(diameters("M06 T01\nG0 X0 Y0 Z25.\n(DRILL 12MM HOLES)\n" + cut), "1:0 tool-unknown");
  EXPECT_EQ(diameters("T20 M6\nG31 Z-5. F100\nG0 Z5.\n(12MM SLOT DRILL)\nT2 M6\n" + cut), "2:12")
      << "a probe cuts nothing";
  EXPECT_EQ(diameters("T1 M6\n" + cut + "(12MM SLOT DRILL)\nT2 M6\n" + cut),
            "1:0 2:12 tool-unknown");
}

// pcb2gcode: the message between T and M6 is about that tool, whatever the one before is.
TEST(ToolNotes, AMessageBetweenTheCallAndTheChange) {
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
TEST(ToolNotes, AnotherToolWithoutAWordForIt) {
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
TEST(ToolNotes, ANumberDrillOrTheToolsNumber) {
  const std::string cut = kCut;
  EXPECT_EQ(diameters("G20\nT5 M6 (#7 DRILL)\n" + cut), "5:5.1054");
  EXPECT_EQ(diameters("G20\nT7 M6 (#7 DRILL)\n" + cut), "7:0 tool-unknown");
  EXPECT_EQ(diameters("G20\nT7 M6 (TOOL #7 .201 DRILL)\n" + cut), "7:5.1054");
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
TEST(ToolNotes, NoRegisterOfAnUnknownTool) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::mill;
  EXPECT_EQ(codes(read_text("T1 M6\nG0 X0 Y0 Z0\nG1 G41 D1 X9 F9\nY9\nG40 X0\nM30\n", options)),
            "tool-unknown");
}

// Words for the work above a T word name its tool, but not in a list above the first cut.
TEST(ToolNotes, WorkAboveTheTWordOfALathe) {
  const auto tools = [](const std::string& text) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    options.table.tools.clear();
    const Program p = read_text(text, options);
    std::string out = codes(p);
    for (const Tool& tool : p.tools) out += fmt::format(" {}", static_cast<int>(tool.type));
    return out;
  };
  const auto type = [](ToolType t) { return fmt::format(" {}", static_cast<int>(t)); };
  const std::string first = "G97 S500 M3\nT0101\nG0 X50. Z2.\nG1 Z-5. F.2\nX52.\nG0 Z9.\n";
  const std::string cut = "T0404\nG0 X50. Z2.\nG1 Z-5. F.2\nX52.\nM30\n";
  const std::string turned = type(ToolType::turning);
  EXPECT_EQ(tools(first + "N3 (CUT OFF 4MM)\n" + cut), turned + type(ToolType::grooving));
  EXPECT_EQ(tools(first + "(OD THREAD)\n" + cut), turned + type(ToolType::threading));
  EXPECT_EQ(tools(first + "(FINISH BORE)\n" + cut), turned + type(ToolType::boring));
  EXPECT_EQ(tools("(1. FACE)\n(2. CUT OFF)\n" + first + cut), turned + turned);
  EXPECT_EQ(tools(first + "(GROOVE)\n" + cut).substr(0, 12), "tool-unknown")
      << "no insert of 35 degrees cuts it";
}

}  // namespace
}  // namespace mrsim
