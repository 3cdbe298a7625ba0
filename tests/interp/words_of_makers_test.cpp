// Words that one maker's posts write: FZ of SINUMERIK, M25 of Centroid, and words of Brother and of
// other lathes that are refused by name.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(WordsOfMakers, FeedPerToothIsAFeed) {
  const Program p =
      read_text("G1 G95 FZ=0.1 X10\nX20\nG94 F100 X30\n", at_origin(Dialect::sinumerik));
  ASSERT_EQ(path_text(p), "l10,0,0 l20,0,0 l30,0,0");
  EXPECT_EQ(codes(p, Severity::note), "feed-per-tooth");
  EXPECT_EQ(p.motions[1].feed, 0.1);
  EXPECT_EQ(p.motions[1].feed_unit, FeedUnit::mm_per_rev);
  EXPECT_EQ(p.motions[2].feed_unit, FeedUnit::mm_per_min);
  EXPECT_EQ(codes(read_text("G1 FZ=0 X10 F100\n", at_origin(Dialect::sinumerik))), "feed-range");
}

// Centroid's posts begin with M25 G49: behind M25 the tool is up, whatever Z was before.
TEST(WordsOfMakers, M25OfCentroidTakesZToItsReferencePoint) {
  const std::string program =
      "M25 G49\nG0 X5\nG43 H1 Z2\nG1 Z-1 F100\nX10\nM25\nX50 Y50\nG0 Z2\nG1 X60\n";
  const Program p = read_text(program, at_origin(Dialect::fanuc));
  std::string assumed;
  for (const Motion& m : p.motions) assumed += m.assumed_start ? '?' : '.';
  EXPECT_EQ(assumed, "??..??.") << path_text(p);
  const Program other = read_text("G49\nG1 X5 F100\nM25\nX10\n", at_origin(Dialect::fanuc));
  EXPECT_FALSE(other.motions.back().assumed_start) << "a cut goes on: M25 was something else";
}

// Hurco's posts write M25 alone, before tools change.
TEST(WordsOfMakers, M25LeavesZUnknownUntilItIsGiven) {
  const Program p = read_text("G0 X5\nZ-1\nG1 X9 F100\nM25\nG0 X50 Y50\nZ2\nG1 X60\nZ-1\n",
                              at_origin(Dialect::fanuc));
  std::string assumed;
  for (const Motion& m : p.motions) assumed += m.assumed_start ? '?' : '.';
  EXPECT_EQ(assumed, "...??..") << path_text(p);
  EXPECT_EQ(codes(p, Severity::note), "reference-point");
  const Program lathe =
      read_text("G0 X5.\nM25\nX9.\n", at_origin(Dialect::fanuc, MachineKind::lathe));
  EXPECT_FALSE(lathe.motions.back().assumed_start);
}

// The changer takes Z up, so that a rapid aside behind M6 does not run at the depth of the last
// cut.
TEST(WordsOfMakers, M6OfAToolChangerTakesZUp) {
  const auto assumed = [](const std::string& behind, Dialect dialect) {
    const Program p = read_text("G0 Z-1\nG1 X9 F100\nT2 M6\n" + behind, at_origin(dialect));
    std::string out;
    for (const Motion& m : p.motions) out += m.assumed_start ? '?' : '.';
    return out;
  };
  EXPECT_EQ(assumed("G0 X50 Y50\nZ2\nG1 X60\nZ-1\n", Dialect::fanuc), "..??..");
  EXPECT_EQ(assumed("G1 X50 F100\nG0 X60\n", Dialect::fanuc), "....") << "it goes on at Z-1";
  EXPECT_EQ(assumed("G1 Z-2 F100\n", Dialect::fanuc), "...");
  EXPECT_EQ(assumed("G0 X50 Y50\nZ2\n", Dialect::ngc), "....") << "changed by hand";
}

// OSP: G116 T changes the tool, G71 Z is the level that cycles return to under M53, M54 returns to
// R.
TEST(WordsOfMakers, OkumaChangesToolsAndReturnsFromHoles) {
  InterpOptions options = at_origin(Dialect::fanuc);
  const Program p = read_text(
      "G15 H1\nG116 T3\nG0 X0 Y0 Z9\nG71 Z50\nG81 X1 Z-5 R2 F100 M53\nX3\nX4 M54\nG80\n", options);
  EXPECT_EQ(path_text(p),
            "r0,0,9 r1,0,9 r1,0,2 l1,0,-5 r1,0,50 r3,0,50 r3,0,2 l3,0,-5 r3,0,50 r4,0,50 r4,0,2 "
            "l4,0,-5 r4,0,2");
  ASSERT_FALSE(p.tools.empty());
  EXPECT_EQ(p.tools.back().id, "3");
  EXPECT_EQ(codes(p, Severity::note).find("m-unknown"), std::string::npos);
  EXPECT_EQ(codes(read_text("G116\nG1 X1 F9\n", options), Severity::note), "work-offset-unset")
      << "of Haas: a work offset";
  EXPECT_EQ(path_text(read_text("G71\nG1 Z50 F9\n", options)), "l0,0,50");
}
// PathPilot's and Mach's posts begin so; what G15, G50 and G69 end does not exist in LinuxCNC.
TEST(WordsOfMakers, SafeStartsOfMachAndPathPilotAreRead) {
  const auto run = [](const std::string& text) {
    return path_text(read_text(text, at_origin(Dialect::ngc)));
  };
  EXPECT_EQ(run("G90 G54 G64 G50 G17 G40 G80 G94 G91.1 G49\nG15 G69\nG1 X5 F100\nM2\n"), "l5,0,0");
  EXPECT_EQ(run("G16\nG1 X5 F100\nM2\n"), "l5,0,0 | g-unknown");
  for (const char* on : {"G51 X2", "G68 R30", "G12 I5"}) {
    const Program p = read_text(on + std::string("\nM2\n"), at_origin(Dialect::ngc));
    EXPECT_NE(codes(p, Severity::note).find("word-of-mach"), std::string::npos) << on;
  }
}

// What senders write between the lines: $H homes, settings do nothing, $J= moves.
TEST(WordsOfMakers, SettingsOfGrblAreReadOverAndItsJogsRefused) {
  const auto run = [](const std::string& text) { return read_text(text, at_origin(Dialect::ngc)); };
  const Program p = run("$X\n$32=0\n$$ (all)\n?\nG1 X5 F100\n$H\nG0 X0 Y0 Z5\nG1 X6 F100\nM2\n");
  EXPECT_EQ(codes(p), "") << listing(p);
  EXPECT_EQ(codes(p, Severity::note), "reference-point");
  ASSERT_EQ(p.motions.size(), 3U);
  EXPECT_TRUE(p.motions[1].assumed_start);
  EXPECT_EQ(codes(run("$J=G91 X10 F500\nM2\n")), "not-supported");
  EXPECT_EQ(codes(run("$1 M3 S500\nG1 X5 F100\nM2\n")), "");
  InterpOptions options;
  options.machine = MachineKind::mill;
  EXPECT_EQ(static_cast<int>(read_text("$H\nG90\nG0 X0 Y0\nG1 X5 F9\n", options).dialect),
            static_cast<int>(Dialect::ngc));
}

// G5.3 P of Hurco sets how smooth surfaces get; LinuxCNC's stands behind G5.2.
TEST(WordsOfMakers, G5OfHurcoSetsTheSurfaceQuality) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.dialect = Dialect::automatic;
  EXPECT_EQ(
      path_text(read_text("%\nG70 G90 G40\nG53 G0 Z0.\nG5.3 P50\nG1 X2. F40.\nM2\n", options)),
      "l50.8,0,0");
}

// G41.1 of FANUC turns a knife along the path: no compensation. What ends it, and polygon turning,
// stands in the heads of programs.
TEST(WordsOfMakers, NormalDirectionControlIsNoCompensation) {
  const InterpOptions mill = at_origin(Dialect::fanuc);
  EXPECT_EQ(codes(read_text("G40.1\nG41.1\nG1 X5. F100\n", mill)), "not-supported");
  EXPECT_EQ(path_text(read_text("G40 G40.1 G50.2\nG1 X5. F100\n", mill)), "l5,0,0");
  EXPECT_EQ(codes(read_text("G96 S100 P1 M3\nG1 X5. F.2\n",
                            at_origin(Dialect::fanuc, MachineKind::lathe))),
            "");
}

// One offset under three names: set by one, it is in force under the others.
TEST(WordsOfMakers, OffsetsOfHaasHaveSeveralNames) {
  const auto end = [](const std::string& text, const std::string& table = "") {
    InterpOptions options = at_origin(Dialect::fanuc);
    if (!table.empty()) options.table.work = {{table, {7, 0, 0}}};
    return path_text(read_text(text + "\nG1 X1 F100\n", options));
  };
  for (const char* select : {"G54.1 P3", "G154 P3", "G54 P3"}) {
    EXPECT_EQ(end("G10 L20 P3 X10\n" + std::string(select)), "l11,0,0") << select;
    for (const char* table : {"G54.1 P3", "G54.1P3", "G154 P3"})
      EXPECT_EQ(end(select, table), "l8,0,0") << select << " of " << table;
  }
  EXPECT_EQ(end("G10 L20 P1 X10\nG110"), "l11,0,0");
  EXPECT_EQ(end("G129", "G154 P20"), "l8,0,0");
  EXPECT_EQ(end("G10 L20 P3 X10\nG154 P3", "G54.1 P3"), "l11,0,0") << "G10 replaces the table's";
}

// Fusion's post for Grbl writes no T word; the one tool of its comments is in the spindle.
TEST(WordsOfMakers, AToolNamedInACommentAloneIsInTheSpindle) {
  const auto diameter = [](const std::string& head, const std::string& given = "") {
    InterpOptions options;
    options.machine = MachineKind::mill;
    options.dialect = Dialect::ngc;
    options.start = Vec3{};
    if (!given.empty()) {
      Tool tool;
      tool.diameter = 8;
      tool.id = given == "any" ? "" : given;
      options.table.tools.push_back(tool);
    }
    const Program p = read_text(head + "G21\nM3 S1000\nG1 X5 F100\n", options);
    return codes(p) + (p.tools.empty() ? "" : fmt::format("{:g}", p.tools[0].diameter));
  };
  const std::string one = "(T1 D=3.175 CR=0 - ZMIN=-1 - flat end mill)\n";
  EXPECT_EQ(diameter(one), "3.175");
  EXPECT_EQ(diameter(one, "any"), "8") << "--tool endmill:d=8";
  EXPECT_EQ(diameter(one, "1"), "8") << "--tool 1=endmill:d=8";
  EXPECT_EQ(diameter(one + "(T2 D=6 CR=0 - flat end mill)\n"), "tool-unknown") << "which of two?";
  EXPECT_EQ(diameter("(6mm end mill)\n"), "6") << "a tool with its size and unit";
  EXPECT_EQ(diameter("(drill 6mm)\n"), "tool-unknown") << "it may be the work";
}

TEST(WordsOfMakers, AWordOfBrotherIsRefusedByName) {
  const Program p = read_text("G1 X1 F100\nG100 X1 Y2 Z3\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(codes(p), "not-supported");
  EXPECT_NE(p.diagnostics.back().text.find("Brother"), std::string::npos);
}

// The tool changes at the top, so that the rapid to the place begins there: Z is known from it on.
// FANUC's G23 to G26 have no axes: these ran as moves of G1.
TEST(WordsOfMakers, PocketsOfGskAreRefused) {
  for (const char* pocket : {"G22 X10 Y10 R2 Z-5 I20 L5 F100", "G23 X10 Y10 Z-5 R2 I20",
                             "G25 X10 Y10 Z-5 I20 J5", "G26 X10 Y10"}) {
    const Program p =
        read_text(std::string("G1 X5 F100\n") + pocket + "\n", at_origin(Dialect::fanuc));
    EXPECT_EQ(path_text(p), "l5,0,0 | not-supported") << pocket;
  }
  const Program limits =
      read_text("G1 X5 F100\nG22 X100 Y100 Z50 I-10 J-10 K-50\nG23\nG25\nG26 P1 Q2 R3\nG1 X9\n",
                at_origin(Dialect::fanuc));
  EXPECT_EQ(path_text(limits).substr(0, 13), "l5,0,0 l9,0,0");
}

TEST(WordsOfMakers, G100OfBrotherChangesTheTool) {
  const Program p = read_text("T2 M6\nG1 X1 F100\nG100 T1 X10 Y20 Z50 G43 H0 L2 S8000 M3\nX5\n",
                              at_origin(Dialect::fanuc));
  EXPECT_EQ(path_text(p), "l1,0,0 r10,20,50 l5,20,50");
  ASSERT_EQ(p.motions.size(), 3U);
  EXPECT_TRUE(p.motions[1].assumed_start);
  EXPECT_EQ(p.tools[static_cast<std::size_t>(p.motions[2].tool)].id, "1");
}

TEST(WordsOfMakers, LinesForDenfordsSimulationAreReadOver) {
  const Program p = read_text("[BILLET X100 Y80 Z15\n[TOOLDEF T1 D8\nO1\nG1 X1 F100\n",
                              at_origin(Dialect::fanuc));
  EXPECT_EQ(path_text(p), "l1,0,0");
  EXPECT_EQ(codes(p, Severity::note), "simulator-line");
}

// The next tool is set up by hand: G92 Z0 is said where it touches the part, not where T1 was.
TEST(WordsOfMakers, G92BehindAToolChangedByHandIsATouchOff) {
  const std::string one = "G21 G90\nG0 Z20\n", two = "G92 Z0\nG0 Z5\nG1 Z-1 F9\n";
  for (const char* pause : {"M0\n", "M6 T2\n", "M5\nM0\nM6 T2\n"}) {
    const Program p = read_text(one + pause + two, at_origin(Dialect::iso));
    EXPECT_EQ(p.motions.back().end.z, -1) << pause;
    EXPECT_NE(codes(p, Severity::note).find("touch-off"), std::string::npos) << pause;
  }
  EXPECT_EQ(read_text(one + "M6 T2\n" + two, at_origin(Dialect::fanuc)).motions.back().end.z, -1);
  EXPECT_EQ(read_text(one + "M0\nG0 Z10\n" + two, at_origin(Dialect::iso)).motions.back().end.z, 9);
}

// FANUC 0i: M98 <NAME>. One error, not five.
TEST(WordsOfMakers, NamesOfProgramsAreOneError) {
  const Program p = read_text("G1 X1 F100\nM98 <SUB/A.NC>\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(codes(p), "not-supported");
  EXPECT_NE(p.diagnostics.back().text.find("<SUB/A.NC>"), std::string::npos);
}

TEST(WordsOfMakers, LookAheadMayHaveATolerance) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::iso, Dialect::ngc})
    EXPECT_EQ(path_text(read_text("G90 G64 P0.01 Q0.02\nG1 X1 F100\n", at_origin(dialect))),
              "l1,0,0");
}

// PowerMill and NX write a line for each value.
TEST(WordsOfMakers, ACornerRadiusMayStandInALineOfItsOwn) {
  InterpOptions options;
  options.machine = MachineKind::mill;
  options.start = Vec3{};
  const auto tool = [&](const std::string& lines) {
    const Program p = read_text("%\nO1\n" + lines + "T1 M6\nG1 X5 F100\nM30\n", options);
    const Tool t = p.tools.empty() ? Tool() : p.tools[0];
    return fmt::format("{} {:g} {:g}", static_cast<int>(t.type), t.diameter, t.corner_radius);
  };
  const std::string head = "(TOOL NAME: EM10)\n(TOOL DIAMETER: 10.0)\n";
  EXPECT_EQ(tool(head + "(TIP RADIUS: 1.5)\n"),
            fmt::format("{} 10 1.5", static_cast<int>(ToolType::bullmill)));
  EXPECT_EQ(tool(head + "(CORNER RADIUS = 0.0)\n"),
            fmt::format("{} 10 0", static_cast<int>(ToolType::endmill)));
  EXPECT_EQ(tool("(T1 12. EM 0.5R)\n"),
            fmt::format("{} 12 0.5", static_cast<int>(ToolType::bullmill)));
  EXPECT_EQ(tool(head + "(CORNER RADIUS 3 OF THE PART)\n"),
            fmt::format("{} 10 0", static_cast<int>(ToolType::endmill)));
}

// "T1 = 6mm", and the T of an insert's code.
TEST(WordsOfMakers, NumbersBesideAToolsNumberAreItsSizes) {
  const auto tool = [](const std::string& comment, bool lathe) {
    InterpOptions options;
    options.machine = lathe ? MachineKind::lathe : MachineKind::mill;
    options.dialect = Dialect::fanuc;
    options.start = Vec3{};
    const Program p = read_text(
        "(" + comment + ")\nT" + (lathe ? "0303" : "3 M6") + "\nG1 X5 F100\nM30\n", options);
    if (p.tools.empty()) return codes(p);
    return codes(p) + fmt::format("{:g} {:g}", p.tools[0].diameter, p.tools[0].nose_radius);
  };
  EXPECT_EQ(tool("T3 = 6mm Endmill", false), "6 0");
  EXPECT_EQ(tool("T3 = 6. ENDMILL", false), "6 0");
  EXPECT_EQ(tool("TOOL 3 - ROUGH BORING BAR CCMT 09T304", true), "0 0.4");
  EXPECT_EQ(tool("T3 CCMT 09T308", true), "0 0.8");
}

// LinuxCNC: M61 says which tool is in the spindle. It was passed over.
TEST(WordsOfMakers, M61TellsTheToolInTheSpindle) {
  InterpOptions options = at_origin(Dialect::ngc);
  options.table.tools[0].id = "1";
  options.table.tools.push_back(options.table.tools[0]);
  options.table.tools[1].id = "3";
  const Program p = read_text("T1 M6\nG1 X1 F100\nM61 Q3\nX2\n", options);
  EXPECT_EQ(path_text(p), "l1,0,0 l2,0,0");
  ASSERT_EQ(p.motions.size(), 2U);
  EXPECT_EQ(p.tools[static_cast<std::size_t>(p.motions[1].tool)].id, "3");
  EXPECT_EQ(path_text(read_text("M61\n", options)), " | value-missing");
}

// On a lathe the comment beside the T word names what its tool does.
TEST(WordsOfMakers, ACommentTellsWhatATurretToolDoes) {
  const auto tool = [](const std::string& comment) {
    const Program p = read_text("T0303 (" + comment + ")\nG1 X5 Z1 F.1\n", [] {
      InterpOptions options = at_origin(Dialect::fanuc, MachineKind::lathe);
      options.table.tools.clear();
      return options;
    }());
    if (p.tools.empty() || !codes(p).empty()) return codes(p);
    const Tool& t = p.tools[0];
    return fmt::format("{} {:g} {:g}", static_cast<int>(t.type), t.width, t.nose_radius);
  };
  const auto kind = [](ToolType type, const char* rest) {
    return fmt::format("{} {}", static_cast<int>(type), rest);
  };
  EXPECT_EQ(tool("GROOVE 3MM"), kind(ToolType::grooving, "3 0"));
  EXPECT_EQ(tool("OD GROOVE 2.5MM"), kind(ToolType::grooving, "2.5 0"));
  EXPECT_EQ(tool("PART OFF 3.0 MM"), kind(ToolType::grooving, "3 0"));
  EXPECT_EQ(tool("OD THREAD"), kind(ToolType::threading, "0 0"));
  EXPECT_EQ(tool("GROOVE AT Z-20"), "tool-unknown") << "no width";
  EXPECT_EQ(tool("CNMG 12 04 08"), kind(ToolType::turning, "0 0.8"));
}

// Without T words and numbers: Estlcam, bCNC. Two of them ask for --tool.
TEST(WordsOfMakers, OneToolWithoutANumberIsInTheSpindle) {
  InterpOptions options;
  options.machine = MachineKind::mill;
  options.dialect = Dialect::ngc;
  options.start = Vec3{};
  const auto tool = [&](const std::string& head) {
    const Program p = read_text(head + "G21\nG1 X5 F100\n", options);
    return codes(p) + (p.tools.empty() ? "" : fmt::format("{:g}", p.tools[0].diameter));
  };
  EXPECT_EQ(tool("(Required tools:)\n(Endmill 3mm)\nG90\n(No. 1: Pocket 1)\n"), "3");
  EXPECT_EQ(tool("(Required tools:)\n(Endmill 3mm)\nG90\n(No. 1 Engraving 1)\n"), "3");
  EXPECT_EQ(tool("(Required tools:)\n(V-Bit 60 deg)\nG90\n(No. 1 Engraving 1)\n"), "0");
  EXPECT_EQ(tool("(tool 3.175mm)\n"), "3.175");
  EXPECT_EQ(tool("(Cutter: Ballnose diameter 6 mm)\n"), "6");
  EXPECT_EQ(tool("(Required tools:)\n(Endmill 3mm)\n(Endmill 6mm)\n"), "tool-unknown");
  EXPECT_EQ(tool("(pocket 30mm)\n"), "tool-unknown");
}

TEST(WordsOfMakers, MirrorOfHaasAboutAnotherPlaceIsRefusedByName) {
  const Program p = read_text("G1 X1 F100\nG101 X3\nX5\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(codes(p), "not-supported");
  EXPECT_NE(p.diagnostics.back().text.find("mirror"), std::string::npos);
}

TEST(WordsOfMakers, RBesideG61AndBesideG64WithM19IsRefused) {
  const auto of = [](const std::string& text) {
    return codes(read_text("G1 X1 F100\n" + text + "\n", at_origin(Dialect::ngc)));
  };
  EXPECT_EQ(of("G61 R0.5"), "word-unexpected");
  EXPECT_EQ(of("G64 M19 R90"), "word-unexpected");
  EXPECT_EQ(of("G64 P0.1 R0.5\nM19\nG61"), "");
}

// Cycles of other controls are refused with their names.
TEST(WordsOfMakers, CyclesOfOtherLathesAreRefusedByName) {
  const auto why = [](const std::string& line) {
    const Program p = read_text("G0 X40. Z5.\n" + line + "\nG1 X30. F.1\n",
                                at_origin(Dialect::fanuc, MachineKind::lathe));
    for (const Diagnostic& d : p.diagnostics)
      if (d.severity == Severity::error) return d.text;
    return std::string();
  };
  EXPECT_NE(why("G271 P1 Q2 U.5").find("write G71"), std::string::npos);
  EXPECT_NE(why("G290 X30. Z-10.").find("write G90"), std::string::npos);
  EXPECT_NE(why("G77 I0 J15. L4 R8.").find("flats"), std::string::npos);
  EXPECT_NE(why("G247 X30.").find("SINUMERIK"), std::string::npos);
}

}  // namespace
}  // namespace mrsim
