// What programs for lathes say of their tools in comments.
#include "interp/support.h"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

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

// "OD ROUGHER", "60 DEG THREADER": what the tool does names it, as "OD ROUGHING TOOL" does.
TEST(ToolNotes, DoersNameTheToolOfALathe) {
  InterpOptions options;
  options.dialect = Dialect::iso;
  options.machine = MachineKind::lathe;
  const Program p = read_text(
      "G21 G99\nT0101 (OD ROUGHER)\nG0 X50. Z2.\nG1 Z-9. F.2\nX52.\nG0 Z2.\n"
      "T0202 (60 DEG THREADER)\nG0 X50. Z2.\nG32 Z-8. F1.5\nG0 X52.\nM30\n",
      options);
  ASSERT_EQ(p.tools.size(), 2U) << listing(p);
  EXPECT_EQ(p.tools[0].type, ToolType::turning);
  EXPECT_EQ(p.tools[1].type, ToolType::threading);
}

// As SINUMERIK's lists call them; A and I are outside and inside.
TEST(ToolNotes, NamesInTheListsOfLathesTellTheTool) {
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

// Neither is the usual sharp insert.
TEST(ToolNotes, RoundToolsAndStopsAreNoInserts) {
  const auto told = [](const std::string& comment) {
    InterpOptions options;
    options.dialect = Dialect::fanuc;
    options.machine = MachineKind::lathe;
    return codes(read_text("T0101 (" + comment + ")\nG0 X30. Z2.\nG1 X28. F.1\nZ-5.\n", options),
                 Severity::note);
  };
  const auto has = [&](const std::string& comment, const std::string& code) {
    return told(comment).find(code) != std::string::npos;
  };
  for (const char* round : {"R5 BUTTON", "ROUND 8MM", "FULL RADIUS R2", "RDMT 10"})
    EXPECT_TRUE(has(round, "tool-unknown")) << round << ": " << told(round);
  for (const char* stop : {"TURRET STOP", "FEED STOCK", "PULL BAR", "STEADY REST"})
    EXPECT_TRUE(has(stop, "tool-touches")) << stop << ": " << told(stop);
  EXPECT_TRUE(has("FINISH PROFILE", "tool-inferred"));
}

// A radius of inserts is the tool's, any other one the work's.
TEST(ToolNotes, ARadiusOfInsertsBesideTheWorkIsTheNose) {
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

// T words of lathes with six and eight digits have half of them for the offset.
TEST(ToolNotes, HalfOfALathesStationIsItsOffset) {
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

// A comment that names its tool by the number, in a list above the program: what its words say of
// the work counts, too.
TEST(ToolNotes, WorkInAListNamesTheTurretToolOfItsNumber) {
  const auto tool = [](const std::string& comment) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    options.table.tools.clear();
    const Program p = read_text(comment + "\nT0505\nG0 X30. Z2.\nG1 Z-5. F.2\n", options);
    return p.tools.empty() ? Tool{} : p.tools[0];
  };
  EXPECT_EQ(tool("(T0505 ID FINISH)").type, ToolType::boring);
  EXPECT_EQ(tool("(T5 ROUGH BORE)").type, ToolType::boring);
  EXPECT_EQ(tool("(TOOL 5 - INSIDE FINISH)").type, ToolType::boring);
  EXPECT_EQ(tool("(T0505 OD FINISH R0.8)").nose_radius, 0.8);
  EXPECT_EQ(tool("(T0505 OD FINISH)").type, ToolType::turning);
  EXPECT_EQ(tool("(T0404 ID FINISH)").type, ToolType::turning);
}

// No insert for the outside leaves its cut towards the axis.
TEST(ToolNotes, ACutTowardsTheAxisNeedsDataOfItsBar) {
  const auto told = [](const std::string& work) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    options.table.tools.clear();
    return codes(read_text("G97 S500 M3\nT0505\nG0 X30. Z2.\n" + work, options));
  };
  for (const char* bores :
       {"G1 Z-20. F.2\nX28.\nG0 Z2.\n", "G1 Z-20. F.2\nG0 U-1.\nZ2.\n", "G1 Z-20. F.2\nG0 X29. Z2.",
        "G1 X26. Z-20. F.2\nZ-30.\nX24.\nG0 Z2.\n", "G90 X32. Z-20. F.2\n",
        "G0 X20.\nG71 U1. R.5\nG71 P1 Q2 U-.4 W.1 F.2\nN1 G0 X40.\nG1 Z-10. F.1\nN2 X20.\n"})
    EXPECT_EQ(told(bores), "tool-unknown") << bores;
  for (const char* turns :
       {"G1 Z-20. F.2\nX32.\nG0 Z2.\n", "G1 Z-20. F.2\nG0 X32.\nX28. Z2.\n",
        "G0 Z0\nG1 X-1.6 F.2\nG0 Z2.\n", "G1 Z0 F.2\nX-1.6\nG0 Z2.\n", "G1 Z-5. F.2\nG0 Z2.\n",
        "G1 X0 Z-5. F.2\nX-1.6\nG0 Z2.\n", "G1 Z-20. F.2\nX35. Z-30.\nG0 X40.\nZ2.\nX26.\n"})
    EXPECT_EQ(told(turns), "") << turns;
}

// Nor does it plunge and go straight back.
TEST(ToolNotes, APlungeAndBackNeedsDataOfItsBlade) {
  const auto told = [](const std::string& work) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    options.table.tools.clear();
    return codes(read_text("G97 S500 M3\nT0505\nG0 X52. Z2.\n" + work, options), Severity::error);
  };
  for (const char* plunges :
       {"Z-20.\nG1 X40. F.1\nG0 X52.\n", "Z-20.\nG1 X40. F.1\nX52.\n",
        "Z-40.\nG1 X-1. F.1\nG0 X60.\n", "Z-20.\nG1 X46. F.1\nG0 X47.\nG1 X40.\nG0 X52.\n",
        "Z-20.\nG75 R.5\nG75 X30. Z-28. P2000 Q2500 F.1\n", "X20.\nZ-20.\nG1 X30. F.1\nG0 X20.\n"})
    EXPECT_EQ(told(plunges), "tool-unknown") << plunges;
  for (const char* turns :
       {"Z0\nG1 X-1.6 F.2\nG0 X52.\n", "X40.\nG1 Z-20. F.2\nX46.\nG0 X52.\n",
        "Z-20.\nG1 X40. F.1\nG0 Z-19.\nX52.\n", "X46.\nG1 Z-20. F.2\nX42.\nX52.\n",
        "Z-20.\nG1 X50.5 F.1\nZ-30.\nG0 X52.\n"})
    EXPECT_EQ(told(turns), "") << turns;
}

// Words for the work above a T word name its tool, but not in a list above the first cut.
TEST(ToolNotes, WorkAboveTheTWordNamesItsToolOnALathe) {
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
  for (const char* before :
       {"TURN FOR THREAD M36", "TURN THREAD DIA", "THREAD RELIEF", "GEWINDE VORDREHEN"})
    EXPECT_EQ(tools(first + "(" + before + ")\n" + cut), turned + turned) << before;
  EXPECT_EQ(tools(first + "(FINISH BORE)\n" + cut), turned + type(ToolType::boring));
  EXPECT_EQ(tools("(1. FACE)\n(2. CUT OFF)\n" + first + cut), turned + turned);
  EXPECT_EQ(tools(first + "(GROOVE)\n" + cut).substr(0, 12), "tool-unknown")
      << "no insert of 35 degrees cuts it";
  const std::string modes = "%\nO1(CNC)\nG98 G18\nG50 S6000\n";  // of Fusion
  EXPECT_EQ(tools(modes + "\n(GROOVE4)\n" + cut).substr(0, 12), "tool-unknown");
  EXPECT_EQ(tools(modes + "(THREAD1)\n" + cut), type(ToolType::threading));
  EXPECT_EQ(tools(modes + "(FACE)\n(THREAD)\n" + cut), turned) << "a list";
  for (const char* title : {"THREAD", "BORE 25 H7 BUSH", "HOLD ON BORE", "2ND OP AFTER BORING"})
    EXPECT_EQ(tools(modes + "(" + title + ")\n" + cut), turned) << title;
}

// The nose in a line of its own was no nose: the insert was sharp.
TEST(ToolNotes, NoseAndCornerOfAnInsertMayStandInLinesOfTheirOwn) {
  const auto insert = [](const std::string& lines) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    options.table.tools.clear();
    const Program p = read_text(lines + "T0101\nG0 X50. Z2.\nG1 Z-5. F.2\nX52.\nM30\n", options);
    const std::string errors = codes(p, Severity::error);
    return p.tools.empty() || !errors.empty()
               ? errors
               : fmt::format("{:g} {:g}", p.tools[0].nose_radius, degrees(p.tools[0].insert_angle));
  };
  EXPECT_EQ(insert("(T0101 TURNING TOOL)\n(TIP ANGLE: 55)\n(TIP RADIUS: 0.4)\n"), "0.4 55");
  EXPECT_EQ(insert("(TOOL 1: CNMG 120408)\n(ANGLE: 93)\n"), "0.8 80");
  EXPECT_EQ(insert("(TOOL 1: CNMG 120408)\n(ANGLE: 55)\n"), "tool-unknown");
  EXPECT_EQ(insert("(TOOL 1: OD 80 DEG)\n(ANGLE: 35)\n"), "tool-unknown");
  for (const char* const work : {"R2", "RADIUS 5", "FINISH R3", "NR. 3", "R0.4", "3 DEG TAPER",
                                 "60 DEG", "ANGLE 30", "BALL", "BALL R10", "DIA 50.", "D50."})
    EXPECT_EQ(insert(fmt::format("(T0101 CNMG 120408)\n({})\n", work)), "0.8 80") << work;
  const std::string blade = insert("(T0101 GROOVE 3MM R0.2)\n");
  EXPECT_EQ(blade.substr(0, 4), "0.2 ");
  for (const char* const work : {"R2", "DIA 50.", "D50.", "ROUGH D40.", "BALL R10"})
    EXPECT_EQ(insert(fmt::format("(T0101 GROOVE 3MM R0.2)\n({})\n", work)), blade) << work;
  EXPECT_EQ(insert("(T0101 CNMG 120408)\n(TIP RADIUS: 0.4)\n"), "tool-unknown");
}

// "(T0606 CCMT 3-2-MP3)" is for the outside, unless what it cuts is a bore.
TEST(ToolNotes, InsertAloneInABoreIsUnknown) {
  const auto turned = [](const std::string& notes, const std::string& cut) {
    InterpOptions options;
    options.dialect = Dialect::fanuc;
    options.machine = MachineKind::lathe;
    return read_text("O1867\n" + notes + "G21 G99\nT0606\nG96 S200 M3\nG0 X37 Z2\nG1 Z0.1 F0.2\n" +
                         cut + "G0 Z2\nX150 Z200\nM30\n",
                     options);
  };
  const std::string bore = "X33 Z-3\nZ-30\nG0 X30\n";
  EXPECT_EQ(codes(turned("(T0606 CCMT 3-2-MP3)\n", bore), Severity::error), "tool-unknown");
  for (const char* bar :
       {"(T0606 CCMT 3-2-MP3)\n(T0606 - ID BORE)\n", "(T0606 - CCMT 3-2-MP3 BORING BAR)\n"}) {
    const Program p = turned(bar, bore);
    EXPECT_EQ(codes(p, Severity::error), "") << listing(p);
    EXPECT_EQ(p.tools.at(0).type, ToolType::boring) << bar;
  }
  EXPECT_EQ(turned("(T0606 CNMG 432)\n(T0606 FACE AND ID CHAMFER)\n", "Z-3\n").tools.at(0).type,
            ToolType::turning);
  for (const char* cut : {"Z0\nX-1\nG0 Z2\nX30\nG1 Z-20\nG0 X38\n", "Z-0.5\nG0 X30\n"})
    EXPECT_EQ(codes(turned("(T0606 CNMG 432 OD TURN)\n", cut), Severity::error), "") << cut;
}

// The tool came to the face with the feed, which was taken for a cut that a bar leaves.
TEST(ToolNotes, FacesWithoutDataAreNotBored) {
  const auto errors = [](const std::string& cut) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    options.table.tools.clear();
    return codes(
        read_text("T0101\nG97 S500 M3\nG0 X42. Z2.\nG1 F.2\n" + cut + "G0 X100. Z150.\nM30\n",
                  options),
        Severity::error);
  };
  for (const char* const face :
       {"Z0\nX-1.\nG0 X38. Z2.\n", "Z0\nX-1.\nG0 X38.\nZ2.\n", "Z0\nX18.\nG0 Z2.\n",
        "Z0.5\nX18.\nG0 X38. Z2.\nG1 Z0\nX18.\nG0 Z2.\n"})
    EXPECT_EQ(errors(face), "") << face;
  const std::string from_chuck = "G0 Z82.\nG1 Z80.\nX-1.\nG0 X38. Z82.\nG1 Z30.\nX42.\n";
  EXPECT_EQ(errors(from_chuck), "");
  for (const char* const bore :
       {"Z-30.\nX40.\nG0 Z2.\n", "Z0\nX36. Z-3.\nZ-30.\nG0 X34.\nZ2.\n",
        "G0 Z82.\nG1 Z60.\nX40.\nG0 Z82.\n", "G0 X18.\nG1 Z-30.\nX0\nG0 X17.\nZ2.\n",
        "G0 X18.\nG1 Z-30.\nX0\nX2. Z-29.\nG0 Z5.\n"})
    EXPECT_EQ(errors(bore), "tool-unknown") << bore;
}

// Faces by hand go back where they came from, pass below pass, as a blade that plunges does; so do
// those of G72 without R.
TEST(ToolNotes, FacesCutStepByStepAreNotPlunged) {
  const auto errors = [](const std::string& cut) {
    InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
    options.table.tools.clear();
    return codes(
        read_text("T0101\nG97 S500 M3\nG0 X62. Z2.\n" + cut + "G0 X100. Z150.\nM30\n", options),
        Severity::error);
  };
  const auto passes = [](const std::vector<double>& depths, double to) {
    std::string text;
    for (const double depth : depths)
      text += fmt::format("G0 Z{}\nG1 X{:.1f} F.2\nG0 X62.\n", -depth, to);
    return text;
  };
  EXPECT_EQ(errors(passes({1}, -1) + passes({2, 4, 6.5, 9}, 30)), "");
  EXPECT_EQ(errors("G0 Z0\nG1 X-1. F.2\nG0 Z1.\nX62.\n" + passes({2, 4}, 30)), "");
  EXPECT_EQ(errors(passes({0.5, 3, 5}, 30) + passes({6}, 40)), "") << "to a boss that widens";
  const std::string contour = "N1 G0 Z-16.\nG1 X40.\nZ-6.\nX30. Z0\nN2 X-1.\n";
  EXPECT_EQ(errors("G72 P1 Q2 D2. U.2 W.1 F.2\n" + contour), "") << "Haas's, without R";
  EXPECT_EQ(errors("G72 W1.5\nG72 P1 Q2 U.2 W.1 F.2\n" + contour), "");
  EXPECT_EQ(errors("G0 Z1.\nG72 W3.\nG72 P1 Q2 U.2 W.1 F.2\n" + contour), "");
  for (const std::string& groove :
       {passes({2}, 50), passes({0.5, 6}, 30), passes({0.5, 2}, 30) + passes({3}, 20),
        passes({1, 2}, 30) + "T0202\n" + passes({4}, 30)})
    EXPECT_EQ(errors(groove), "tool-unknown") << groove;
}

}  // namespace
}  // namespace mrsim
