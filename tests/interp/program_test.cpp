// Whole programs: recognition, tools from comments, subprograms, flow, the seeds, the JSON lines.
#include "interp/comments/tool_comment.h"
#include "interp/recognise/recognise.h"
#include "interp/show/path_picture.h"
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string data(const std::string& name) { return std::string(MRSIM_DATA_DIR) + "/" + name; }

TEST(Recognise, DialectsAreRecognised) {
  struct Row {
    const char* name;
    const char* text;
    Dialect dialect;
  };
  const Row rows[] = {
      {"a.MPF", "G1 X1 Y1", Dialect::sinumerik},
      {"a.spf", "G1 X1 Y1", Dialect::sinumerik},
      {"a.nc", "N10 G2 X5 Y5 CR=5", Dialect::sinumerik},
      {"a.nc", "TRANS X5\nG1 X1 Y1", Dialect::sinumerik},
      {"a.nc", "G1 X1 Y1 ; cut", Dialect::sinumerik},
      {"a.nc", "G2 X1 Y1 I=AC(3) J0", Dialect::sinumerik},
      {"a.nc", "%\nO0001\nG1 X1 Y1\n%", Dialect::fanuc},
      {"a.nc", "O0001;\nG90G80G40G49;\nG0G90G54X0Y0;", Dialect::fanuc},
      {"a.nc", ":1234\nG1 X1 Y1", Dialect::fanuc},
      {"a.nc", "G1 X1 Y1\nM98 P2 L50\nM30", Dialect::fanuc},
      {"a.nc", "%\nO1001\n(T1 D=6. CR=0. - FLAT END MILL)\nG90 G94\nG1 X1 Y1", Dialect::fanuc},
      {"a.nc", "N110 G1 X50 Y17 F250\nN120 G2 X21 Y34 i-20 j0\nN130 G1 X10 Y53", Dialect::iso},
      {"a.nc", "N120 G3 X21 Y30 R-13", Dialect::iso},
      {"a.nc", "N10 G0 X10 Y5 (start)\nN20 G2 X5 R5\nM30", Dialect::iso},
      {"a.nc", "N10 G98 G2 X5 Y5 I3 J3 F10", Dialect::codesys},
      {"a.nc", "N10 G99 G3 X5 Y5 I3 J3 F10", Dialect::codesys},
      {"a.nc", "N10 G1 X100 Y100 F100 N20 G2 X200 Y100 R50", Dialect::codesys},
      {"a.nc", "N10 G1 X100 Y100 F100\nN15 G99\nN20 G2 X200 Y100 I50 J0", Dialect::codesys},
      {"a.nc", "N10 G1 X100 Y100\nN20 G2 I50 J0 T180", Dialect::codesys},
      {"a.nc",
       ";@MKR|TOOL|number=1|type=Flat End|diameter=3\n;pass 1\nG21\nG90\nT1 M6\nG1 X1 Y1 ; cut",
       Dialect::ngc},
      {"a.nc", "O1;\nG1X1F1;X2Y5;", Dialect::fanuc},
      {"a.nc", "SUBPROGRAM Part\nG1 X1 Y1\nEND_SUBPROGRAM", Dialect::codesys},
  };
  const TempFolder scratch;
  for (const Row& row : rows) {
    SCOPED_TRACE(row.text);
    const Recognition r = recognise(scratch.write(row.name, row.text), {});
    EXPECT_EQ(r.dialect, row.dialect) << r.dialect_reason;
    EXPECT_FALSE(r.dialect_reason.empty());
    EXPECT_FALSE(r.empty);
  }
}

TEST(Recognise, MachinesAreRecognised) {
  struct Row {
    const char* text;
    MachineKind machine;
  };
  constexpr auto mill = MachineKind::mill, lathe = MachineKind::lathe,
                 unclear = MachineKind::automatic;
  const Row rows[] = {{"G1 X1 Y1", mill},
                      {"G96 S100\nG1 X1 Z1", lathe},
                      {"LIMS=3000\nG1 X1 Z1", lathe},
                      {"DIAMON\nG1 X1 Z1", lathe},
                      {"G18\nG1 X1 Z1", lathe},
                      {"T1 ; turning tool\nG1 X1 Z1", unclear},
                      {"G1 X1 Z1", unclear},
                      {"G96 S100\nG1 X1 Y1", unclear},
                      {"TRANS X1 Y1\nG96 S100\nG1 X1", lathe},
                      {"G18\nG1 X1 Y1", mill}};
  const TempFolder scratch;
  for (const Row& row : rows) {
    SCOPED_TRACE(row.text);
    const std::string path = scratch.write("a.MPF", row.text);
    EXPECT_EQ(recognise(path, {}).machine, row.machine);
    if (row.machine != unclear) continue;
    try {
      read_program(path, {});
      FAIL();
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), "machine-unclear");
      EXPECT_EQ(e.kind(), Error::Kind::usage);
    }
  }
}

TEST(Recognise, FanucLathesAreRecognised) {
  const std::pair<const char*, MachineKind> rows[] = {
      {"O1\nG0 X20 Z2\nG1 U-2 W-5 F.1", MachineKind::lathe},
      {"O1\nG92 X18 Z-20 F1.5", MachineKind::lathe},
      {"O1\nG76 P011060 Q100 R50", MachineKind::lathe},
      {"O1\nG0 X20 Y2\nG1 W-5 F.1", MachineKind::mill},
      {"O1\nG92 X0 Z0\nG1 X5 F1", MachineKind::automatic},
      {"O1\nG50 S2000\nG0 X50. Z2.\nG90 X40. Z-10. F.2\nX35.\nX30.", MachineKind::lathe},
      {"O1\nT0101\nG0 X50. Z2.\nG90 X40. Z-10. F.2\nX35.", MachineKind::lathe},
      {"O1\nT1200\nG0 X50. Z2.\nG90 X40. Z-10. F.2\nX35.", MachineKind::lathe},
      {"O1\nT0101 M6\nG0 X50. Z2.\nG90 X40. Z-10. F.2", MachineKind::automatic},
      {"O1\nT0101\nM06\nG0 X50. Z2.\nG90 X40. Z-10. F.2", MachineKind::automatic},
      {"O1\nT1234\nG0 X50. Z2.\nG90 X40. Z-10. F.2", MachineKind::automatic},
      {"O1\nT101\nG0 X50. Z2.\nG90 X40. Z-10. F.2", MachineKind::automatic},
      {"O1\n(T1 CNMG432)\nT101\nG0 X50. Z2.\nG90 X40. Z-10. F.2", MachineKind::lathe},
      {"O1\nG96 S200 M3\nG0 X50. Z2.\nG112\nG1 X40. Y5. F.2\nG113", MachineKind::lathe},
      {"O1\nT0101 (END MILL D10)\nG0 X50. Z2.\nG90 G1 X40. Z-10. F.2", MachineKind::automatic},
      {"O1\nT0101\nG50 S2000\nG0 X50. Y2.\nG90 X40. Z-10. F.2", MachineKind::mill},
      {"O1\nT1 M6\nG90 G54 G0 X50. Z2.\nG1 Z-3. F100\nG90 X40. Z-10.", MachineKind::automatic}};
  const TempFolder scratch;
  for (const auto& [text, machine] : rows)
    EXPECT_EQ(recognise(scratch.write("a.nc", text), {}).machine, machine) << text;
}

TEST(ToolComment, ToolsAreReadInManyTongues) {
  struct Row {
    const char* text;
    ToolType type;
    double diameter, corner;
    const char* id;
  };
  const Row rows[] = {
      {" Steblasto frezalo \xC3\x98"
       "5",
       ToolType::endmill, 5, 0, ""},
      {" Steblasto frezalo \xD8"
       "5",
       ToolType::endmill, 5, 0, ""},
      {" Steblasto frezalo \xF8"
       "5",
       ToolType::endmill, 5, 0, ""},
      {" Steblasto frezalo \xE2\x8C\x80 5", ToolType::endmill, 5, 0, ""},
      {"END MILL D5", ToolType::endmill, 5, 0, ""},
      {"end mill dia. 12.5", ToolType::endmill, 12.5, 0, ""},
      {"T1 D=6. CR=0. - ZMIN=-2. - FLAT END MILL", ToolType::endmill, 6, 0, "1"},
      {"T12 D=10. CR=2. - ZMIN=-2. - BULLNOSE END MILL", ToolType::bullmill, 10, 2, "12"},
      {"T2 D=8. CR=4. - BALL END MILL", ToolType::ballmill, 8, 4, "2"},
      {"@MKR|TOOL|number=3|type=Flat End|diameter=3.175", ToolType::endmill, 3.175, 0, "3"},
      {"Schaftfr\xC3\xA4ser \xC3\x98 20", ToolType::endmill, 20, 0, ""},
      {"8 mm drill", ToolType::drill, 8, 0, ""},
      {"end mill", ToolType::endmill, 0, 0, ""},
      {" No\xC5\xBE za fino obdelavo", ToolType::turning, 0, 0, ""},
      {" No\xBE za fino obdelavo", ToolType::turning, 0, 0, ""},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.text);
    const ToolHint hint = read_tool_comment(row.text);
    ASSERT_TRUE(hint.type.has_value());
    EXPECT_EQ(*hint.type, row.type);
    EXPECT_EQ(hint.diameter, row.diameter);
    EXPECT_EQ(hint.corner_radius, row.corner);
    EXPECT_EQ(hint.id, row.id);
  }
  EXPECT_FALSE(read_tool_comment("finish the pocket"));
}

TEST(Tools, AToolIsUnknownOnlyWhenItCuts) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  const Program p = read_text("T7 M6\nG0 X1 Y1\nT1 M6 (END MILL D5)\nG1 X5 F1\n", options);
  EXPECT_EQ(codes(p), "") << listing(p);
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_EQ(p.tools[0].id, "1");
  const Program bad = read_text("T7 M6\nG0 X1 Y1 Z1\nG1 X5 F1\nX6\n", options);
  ASSERT_EQ(codes(bad), "tool-unknown");
  EXPECT_EQ(bad.diagnostics[0].place.line, 1);
  EXPECT_EQ(bad.diagnostics[0].place.column, 1);
  options.require_tools = false;
  EXPECT_EQ(codes(read_text("G1 X5 Y1 F1\n", options), Severity::error), "");
}

TEST(Tools, ChangeAtM6OrWithoutItAtT) {
  InterpOptions options;
  options.dialect = Dialect::fanuc;
  const char* head = "(T1 D=6. - FLAT END MILL)\n(T2 D=8. - BALL END MILL)\n";
  const auto ids = [&](const std::string& text) {
    const Program p = read_text(head + text, options);
    std::string out;
    for (const Motion& m : p.motions)
      out += m.tool < 0 ? std::string("-") : p.tools[static_cast<std::size_t>(m.tool)].id;
    return out;
  };
  EXPECT_EQ(ids("T1 M6\nG1 X1 Y1 F1\nT2\nX2\nM6\nX3\n"), "112");
  EXPECT_EQ(ids("T1\nG1 X1 Y1 F1\nT2\nX2\n"), "12");
}

TEST(Subprograms, FanucCallsSubprogramsOfItsOwnFile) {
  const char* spellings[] = {"M98 P2 L3", "M98P30002", "M98 P0002 L3", "M98 P00030002"};
  for (const char* call : spellings) {
    SCOPED_TRACE(call);
    const Program p =
        read_text(std::string("O1\nG91 G1 X1 F1\n") + call + "\nM30\nO2\nX1\nX1\nM99\n",
                  at_origin(Dialect::fanuc));
    ASSERT_EQ(codes(p), "") << listing(p);
    ASSERT_EQ(p.motions.size(), 7U);
    EXPECT_EQ(p.motions.back().end.x, 7);
    const std::string json = motion_json(p, p.motions.back());
    EXPECT_NE(json.find("\"called_from\":[["), std::string::npos) << json;
    EXPECT_NE(json.find(",3]]"), std::string::npos) << json;
  }
}

TEST(Subprograms, SubprogramsAreFoundBesideTheProgram) {
  const TempFolder scratch;
  scratch.write("POCKET.SPF", "G91 G1 X1\nM17\n");
  scratch.write("L12.SPF", "G91 G1 Y1\nRET\n");
  scratch.write("O0007.nc", "G91 G1 X1\nM99\n");
  scratch.write("Slot.cnc", "SUBPROGRAM Slot\nN10 G91 G1 X1\nN20 RETURN\nEND_SUBPROGRAM\n");
  const std::string s =
      scratch.write("main.MPF", "G1 X1 F1\nPOCKET\npocket P2\nL12\nCALL \"POCKET\"\nM30\n");
  const Program p = read_program(s, at_origin(Dialect::sinumerik));
  ASSERT_EQ(codes(p), "") << listing(p);
  EXPECT_EQ(p.motions.size(), 6U);
  EXPECT_EQ(p.files.size(), 3U);
  const Program f =
      read_program(scratch.write("f.nc", "G1 X1 F1\nM98 P7\nM30\n"), at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(f), "") << listing(f);
  EXPECT_EQ(f.motions.size(), 2U);
  const Program c = read_program(scratch.write("c.cnc", "N10 G1 X1 F1\nN20 Slot{}\n"),
                                 at_origin(Dialect::codesys));
  EXPECT_EQ(codes(c), "") << listing(c);
  EXPECT_EQ(c.motions.size(), 2U);
}

// A file that was put together of two, each with its own O2: a control has one of them.
TEST(Subprograms, OneThatStandsTwiceIsToldOf) {
  EXPECT_EQ(path_text(read_text("G1 X1 F1\nM98 P2 L2\nM30\nO2\nX5\nM99\nO2\nX7\nM99\n",
                                at_origin(Dialect::fanuc))),
            "l1,0,0 l5,0,0 | subprogram-twice");
  EXPECT_EQ(codes(read_text("G1 X1 F1\nSUBX\nSUBX\nM30\n%_N_SUBX_SPF\nX5\nM17\n"
                            "%_N_SUBX_SPF\nX7\nM17\n",
                            at_origin(Dialect::sinumerik))),
            "subprogram-twice");
  EXPECT_EQ(codes(read_text("O100 sub\nG1 X#1 F1\nO100 endsub\nO100 call [5]\nM2\n",
                            at_origin(Dialect::ngc))),
            "");
  EXPECT_EQ(path_text(read_text("O1 sub\nG1 X5 F1\nO1 endsub\nO1 sub\nG1 X7 F1\nO1 endsub\n"
                                "O1 call\nO1 call\nM2\n",
                                at_origin(Dialect::ngc))),
            "l5,0,0 | subprogram-twice");
  EXPECT_EQ(path_text(read_text("(CALL 3)\nM30\n(SUB 3)\nG1 X5 F1\n(RET)\n(SUB 3)\nX7\n(RET)\n",
                                at_origin(Dialect::iso))),
            "l5,0,0 | subprogram-twice");
}

TEST(Subprograms, MissingAndEndlessSubprogramsAreErrors) {
  EXPECT_EQ(codes(read_text("G1 X1 F1\nM98 P99\n", at_origin(Dialect::fanuc))),
            "subprogram-missing");
  EXPECT_EQ(codes(read_text("G1 X1 F1\nNOWHERE\n", at_origin(Dialect::sinumerik))),
            "subprogram-missing");
  const Program p =
      read_text("O1\nG1 X1 F1\nM98 P2\nM30\nO2\nM98 P2\nM99\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p), "subprogram-depth");
  EXPECT_EQ(p.diagnostics[0].called_from.size(), 10U);
  InterpOptions options = at_origin(Dialect::fanuc);
  options.max_blocks = 1000;
  EXPECT_EQ(codes(read_text("O1\nG1 X1 F1\nM98 P2 L9999\nM30\nO2\nG0 X1\nM99\n", options)),
            "program-endless");
  // Passes of a cycle count in a loop: each line of this one makes 2 000 pecks.
  options.max_blocks = 100'000;
  options.max_steps = 50'000;
  EXPECT_EQ(
      codes(read_text("O1\nG0 Z2\nWHILE[1EQ1]DO1\nG83 Z-20 R1 Q0.01 F1\nEND1\nM30\n", options)),
      "program-endless");
  const Program loop = read_text("G1 X1 F1\nM99\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(loop, Severity::note), "program-loops");
}

TEST(Flow, SkippedBlocksLabelsAndEndsAreObeyed) {
  InterpOptions options = at_origin(Dialect::sinumerik);
  EXPECT_EQ(read_text("G1 X1 F1\n/X2\n/3 X3\nM30\nX4\n", options).motions.size(), 3U);
  options.block_skip = 1;
  EXPECT_EQ(read_text("G1 X1 F1\n/X2\n/3 X3\nM30\nX4\n", options).motions.size(), 2U);
  options.block_skip = 8;
  EXPECT_EQ(read_text("G1 X1 F1\n/X2\n/3 X3\n", options).motions.size(), 2U);
  EXPECT_EQ(
      codes(read_text("N10 START: G1 X1 F1\nMSG(\"x; y\") ; z\nSTOPRE\nG4 F2\nG64 X2\n", options)),
      "");
}

TEST(Flow, OnlyTheTextBetweenPercentSignsCounts) {
  const Program p =
      read_text("this is no program\n%\nO1;\nG1X1F1;X2;\nG 1 X 3\nM30\n%\nrubbish here\n",
                at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p), "") << listing(p);
  EXPECT_EQ(p.motions.size(), 3U);
}

TEST(Flow, TextBeforeTheTapeMarkMayHoldWords) {
  const Program p = read_text("some text G1 X5 (M30)\n%\nO1\nG0 X1\nG1 X2 F1\nM30\n%\nG1 X9\n",
                              at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p), "") << listing(p);
  EXPECT_EQ(p.motions.size(), 2U);
  EXPECT_EQ(read_text("N1 G1 X5 F1\nM30\n%\nrubbish\n", at_origin(Dialect::fanuc)).motions.size(),
            1U);
}

TEST(Flow, WorkpieceStatesTheStock) {
  const Program p = read_text("WORKPIECE(,\"\",,\"BOX\",112,0,-20,-80,-5,-6,100,60)\nG1 X1 F1\n",
                              at_origin(Dialect::sinumerik));
  ASSERT_TRUE(p.workpiece.has_value());
  expect_near(p.workpiece->box.lo, {-5, -6, -20});
  expect_near(p.workpiece->box.hi, {100, 60, 0});
  const Program c = read_text("WORKPIECE(,\"\",,\"CYLINDER\",64,0,-100,-80,50)\nG1 X1 F.1\n",
                              at_origin(Dialect::sinumerik, MachineKind::lathe));
  ASSERT_TRUE(c.workpiece.has_value());
  EXPECT_EQ(c.workpiece->kind, StockShape::Kind::cylinder);
  EXPECT_EQ(c.workpiece->outer_radius, 25);
  for (const char* type : {"N_CORNER\",0,0,-20,-80,6,50", "FILE\",,,,,,,\"part.stl\""}) {
    const Program n = read_text(fmt::format("WORKPIECE(,\"\",,\"{})\nG1 X1 F1\n", type),
                                at_origin(Dialect::sinumerik));
    EXPECT_EQ(codes(n, Severity::note), "simulator-line") << type;
    EXPECT_FALSE(n.workpiece.has_value());
  }
}

TEST(Primer, TheMillingPrimerIsReadAsDrawn) {
  const Program p = read_program(data("PRIMER_2F.MPF"), {});
  ASSERT_EQ(codes(p), "") << listing(p);
  EXPECT_EQ(p.dialect, Dialect::sinumerik);
  EXPECT_EQ(p.machine, MachineKind::mill);
  ASSERT_EQ(p.motions.size(), 7U);
  EXPECT_EQ(motion_json(p, p.motions[2]),
            "{\"line\":7,\"column\":5,\"kind\":\"arc\",\"start\":[12.5,-30,8],\"end\":[42.5,-30,8],"
            "\"center\":[27.5,-30,8],\"axis\":[0,0,1],\"radius\":15,\"sweep\":180,\"rise\":0,"
            "\"tool\":\"4\",\"feed\":200,\"feed_unit\":\"mm/min\",\"spindle\":3200}");
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_EQ(p.tools[0].diameter, 5);
}

TEST(Primer, TheTurningPrimerIsReadAsDrawn) {
  const Program p = read_program(data("PRIMER_2S.MPF"), {});
  ASSERT_EQ(codes(p), "") << listing(p);
  EXPECT_EQ(p.machine, MachineKind::lathe);
  ASSERT_EQ(p.motions.size(), 8U);
  EXPECT_EQ(motion_json(p, p.motions[3]),
            "{\"line\":8,\"column\":5,\"kind\":\"arc\",\"start\":[10,0,50],\"end\":[15,0,45],"
            "\"center\":[10,0,45],\"axis\":[0,1,0],\"radius\":5,\"sweep\":90,\"rise\":0,"
            "\"tool\":\"2\",\"feed\":0.1,\"feed_unit\":\"mm/rev\",\"surface_speed\":220}");
  ASSERT_EQ(p.tools.size(), 1U);
  EXPECT_EQ(p.tools[0].type, ToolType::turning);
  EXPECT_NEAR(degrees(p.tools[0].insert_angle), 35, 1e-12);
  EXPECT_NEAR(degrees(p.tools[0].lead_angle), 93, 1e-12);
  EXPECT_EQ(p.tools[0].edge_length, 16);
  EXPECT_EQ(p.tools[0].nose_radius, 0);
}

TEST(Diagnostics, BeyondAHundredOfAKindAreCounted) {
  TempFolder folder;
  const std::string path =
      folder.write("flood.nc", "/" + std::string(999999, '!') + "\nG1 X1 F100\n");
  const Program p = read_program(path, at_origin(Dialect::iso));
  ASSERT_EQ(p.diagnostics.size(), 101U);
  EXPECT_EQ(p.diagnostics[99].place.column, 101);
  EXPECT_EQ(p.diagnostics[100].text, "... and 999899 more of these");
  EXPECT_EQ(p.diagnostics[100].code, p.diagnostics[99].code);
  EXPECT_EQ(p.diagnostics[100].severity, Severity::error);
}

TEST(Pictures, ArcsStayArcs) {
  const Program p = read_program(data("PRIMER_2F.MPF"), {});
  const std::string svg = path_svg(p);
  EXPECT_NE(svg.find("A15 15 0 0 0"), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos);
  const std::string ply = path_ply(p);
  EXPECT_EQ(ply.find("ply\n"), 0U);
}

TEST(Text, NumbersAreShort) {
  EXPECT_EQ(number_text(42.50000000000001), "42.5");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(-1e-12), "0");
  EXPECT_EQ(number_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(number_text(123456.7890123), "123456.789012");
}

// A link may lead to a file of the folder or of --path, to no other.
TEST(Subprograms, ALinkDoesNotLeadOutOfTheFolder) {
  const TempFolder job, elsewhere;
  const std::string main = job.write("main.nc", "O1\nM98 P2\nG1 X30 F1\nM30\n");
  const std::string far = elsewhere.write("far.nc", "G1 X20 F1\nM99\n");
  const std::filesystem::path link = std::filesystem::path(main).parent_path() / "O0002.nc";
  InterpOptions options = at_origin(Dialect::fanuc);
  std::filesystem::create_symlink(far, link);
  try {
    read_program(main, options);
    FAIL() << "a file of another folder was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "subprogram-outside");
    EXPECT_NE(std::string(error.what()).find("O0002.nc is a link to"), std::string::npos);
  }
  options.search_path = {std::filesystem::path(far).parent_path().string()};
  EXPECT_EQ(path_text(read_program(main, options)), "l20,0,0 l30,0,0");
  options.search_path.clear();
  std::filesystem::remove(link);
  job.write("near.txt", "G1 X10 F1\nM99\n");
  std::filesystem::create_symlink("near.txt", link);
  EXPECT_EQ(path_text(read_program(main, options)), "l10,0,0 l30,0,0");
}

}  // namespace
}  // namespace mrsim
