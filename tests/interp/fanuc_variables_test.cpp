// Variables that a FANUC control answers from its tables: offsets, modal codes, positions.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(FanucVariables, AreAnsweredFromTables) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.table.offsets = {{"H2", 0, 0.5, 80}, {"D2", 4, 0.25, 0}};
  options.variables = {{"#2001", "7"}};
  const auto x = [&](const std::string& text, const char* variable) {
    const Program p = read_text("G1 F100 X1\n" + text + "\nX" + variable + " Y1\n", options);
    return codes(p) + fmt::format("{:g}", p.motions.back().end.x);
  };
  EXPECT_EQ(x("", "#2001"), "7") << "given from outside";
  EXPECT_EQ(x("", "#2002"), "variable-number1");
  EXPECT_EQ(x("#2001=9", "#2001"), "variable-number7");
  EXPECT_EQ(x("", "#11002"), "80");
  EXPECT_EQ(x("", "#10002"), "0.5");
  EXPECT_EQ(x("", "#13002"), "4");
  EXPECT_EQ(x("", "#11003"), "variable-number1");
  EXPECT_EQ(x("G43 H2", "#4111"), "2");
  EXPECT_EQ(x("G43 H2", "#4008"), "43");
  EXPECT_EQ(x("G99", "#4010"), "99");
  EXPECT_EQ(x("T7 M6", "#4120"), "7");
  EXPECT_EQ(x("G10 L2 P0 X3.", "#5201"), "6") << "the external offset counts for X too";
  EXPECT_EQ(x("G10 L20 P2 X3.", "#7021"), "3");
  EXPECT_EQ(x("#14041=4", "#7041"), "4");
  EXPECT_EQ(x("", "#5021"), "variable-number1") << "where the machine's zero is, is not known";
  EXPECT_EQ(x("G28 X2.", "#5041"), "variable-number2");
  EXPECT_EQ(x("Z7", "#5043"), "7");
  EXPECT_EQ(x("G43 H2 Z7", "#5003"), "7");
  EXPECT_EQ(x("G43 H2 Z7", "#5043"), "variable-number1") << "with the length, or without?";
  EXPECT_EQ(x("G43 H2 Z7", "#5041"), "1");
  EXPECT_EQ(codes(read_text("G41 D2 G1 F100 X9\nY9\nX#5041\nG40 X0\n", options)),
            "variable-number");
}

// The second axis of a lathe is Z; its groups of G codes are others than those of mills.
TEST(FanucVariables, OfLathesCountTheirAxesAndGroups) {
  const auto z = [](const std::string& text, const char* variable) {
    const Program p = read_text("G1 F.1 X30. Z-5.\n" + text + "\nZ" + variable + "\n",
                                at_origin(Dialect::fanuc, MachineKind::lathe));
    return codes(p) + fmt::format("{:g}", p.motions.back().end.z);
  };
  EXPECT_EQ(z("", "[#5002-1.]"), "-6");
  EXPECT_EQ(z("", "#5001"), "30");
  EXPECT_EQ(z("G96 S100", "#4002"), "96");
  EXPECT_EQ(z("G98", "#4005"), "98");
  EXPECT_EQ(z("G10 L2 P2 X8. Z3.", "#5242"), "3");
  EXPECT_EQ(z("G10 L2 P2 X8. Z3.", "#5241"), "8");
  EXPECT_EQ(z("T0303", "#4120"), "303");
}

// What was asked for and meets nothing is a note, once each.
TEST(Macro, OptionsThatMeetNothingAreTold) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.variables = {{"#100", "2.5"}, {"#1", "4"}, {"#2", "1"}, {"#501", "1"}, {"#5221", "0"}};
  const std::string text = "G1 F1 X#100\n#2=3\nG65 P2 A5\n/2 Y#2\nM30\nO2\n#3=#1\nX#3 /3 Y1\nM99\n";
  const auto told = [&] {
    std::string out;
    for (const Diagnostic& d : read_text(text, options).diagnostics)
      if (d.code.ends_with("-unused")) out += d.code + ": " + d.text + "\n";
    return out;
  };
  EXPECT_EQ(told(),
            "set-unused: --set does nothing to this program for #1 (never read), #2 (set before "
            "it is read), #501 (never read)\n");
  options.variables.clear();
  options.block_skip = 0b1100;
  EXPECT_EQ(told(), "");
  options.block_skip = 0b10011;
  EXPECT_EQ(told(),
            "block-skip-unused: --block-skip 0,1,4 does nothing: no block that was read has that "
            "level\n");
  options.block_skip = 0;
  options.comp = CompRadius::wear;
  EXPECT_EQ(told(),
            "comp-unused: --comp does nothing: the program has no G41 or G42 that counts\n");
  options = at_origin(Dialect::sinumerik);
  options.variables = {{"R1", "5"}, {"WIDTH", "7"}, {"LEN", "1"}};
  const Program local = read_text("DEF REAL WIDTH\nWIDTH=1\nG1 F1 X=R1 Y=WIDTH\n", options);
  ASSERT_EQ(local.diagnostics.size(), 1U);
  EXPECT_EQ(local.diagnostics[0].text,
            "--set does nothing to this program for WIDTH (never read), LEN (never read)");
}

// What the machine does with them moves nothing.
TEST(FanucVariables, CountersAndOutputsKeepWhatIsSet) {
  const auto path = [](const std::string& text) {
    return path_text(read_text(text + "M30\n", at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(path("#3901=#3901+1\nG1 X#3901 F100\n"), "l1,0,0");
  EXPECT_EQ(path("#1100=1\n#1132=5\n#3001=0\nG1 X#1132 Y#3001 F100\n"), "l5,0,0");
  EXPECT_EQ(path("G1 X#1000 F100\n"), " | variable-number");
  EXPECT_EQ(path("IF[#3902 GT 5] GOTO 9\nN9 G1 X1. F100\n").substr(0, 18), " | variable-number");
}

// Loops that make a tool longer cut deeper on the machine, and cut all at one depth here.
TEST(FanucRegisters, ALengthMustNotChangeBetweenCuts) {
  const auto run_lengths = [](const std::string& first, const std::string& second,
                              const std::string& h = "H1") {
    const auto cut = [](const std::string& number) {
      return "G43 " + number + " G0 Z9.\nG1 Z0 F9.\nG0 Z9.\n";
    };
    return codes(read_text(first + cut("H1") + second + cut(h), at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(run_lengths("G10 L11 P1 R0\n", "G10 L11 P1 R-1.\n"), "not-supported");
  EXPECT_EQ(run_lengths("", "G91 G10 L11 P1 R-1.\nG90\n"), "not-supported");
  EXPECT_EQ(run_lengths("G10 L10 P1 R0\nG10 L10 P1 R80.\n", "G10 L10 P1 R80.\n"), "");
  EXPECT_EQ(run_lengths("G10 L10 P1 R90.\n", "G10 L10 P2 R80.\n"), "");
  EXPECT_EQ(run_lengths("", "G10 L11 P1 R-1.\n"), "not-supported") << "the first wear counts";
  EXPECT_EQ(run_lengths("#10001=0\n", "#10001=#10001-1\n"), "not-supported");
  EXPECT_EQ(run_lengths("#11001=80\n", "#11001=80\n"), "");
  EXPECT_EQ(run_lengths("", "#11001=80\n"), "not-supported");
  EXPECT_EQ(run_lengths("G10 P1 R80.\n", "G10 P1 R79.\n"), "not-supported") << "memory A";
}

TEST(FanucRegisters, AnOffsetOfALatheMustNotChangeBetweenCuts) {
  const auto told = [](const std::string& set, const std::string& second = "T0101") {
    const std::string cut = "\nG0 X20. Z1.\nG1 Z-5. F.1\nG0 X30.\nZ1.\n";
    return codes(read_text("G10 P1 X0 Z0\nT0101" + cut + set + second + cut,
                           at_origin(Dialect::fanuc, MachineKind::lathe)));
  };
  EXPECT_EQ(told("G10 P1 U-0.5\n"), "not-supported");
  EXPECT_EQ(told("G10 P1 X-0.5\n"), "not-supported");
  EXPECT_EQ(told("G10 P1 X0 Z0\n"), "");
  EXPECT_EQ(told("G10 P2 U-0.5\n"), "");
  EXPECT_EQ(told("G10 P2 U-0.5\n", "T0202"), "");
  EXPECT_EQ(told("G10 P10001 X-180.\n"), "not-supported");
}

TEST(FanucRegisters, TheAxisOfAnOffsetThatChangesIsTold) {
  const auto told = [](const std::string& set) {
    const std::string cut = "T0101\nG0 X20. Z1.\nG1 Z-5. F.1\nG0 X30.\nZ1.\n";
    for (const Diagnostic& d :
         read_text(cut + set + cut, at_origin(Dialect::fanuc, MachineKind::lathe)).diagnostics)
      if (d.code == "not-supported") return d.text;
    return std::string();
  };
  EXPECT_NE(told("G10 P1 U-2.\n").find("into X, or shift the zero by G52 X"), std::string::npos);
  EXPECT_NE(told("G10 P1 W-2.\n").find("into Z, or shift the zero by G52 Z"), std::string::npos);
}

// Another tool's length, and one that no cut follows, change nothing.
TEST(FanucRegisters, ALengthMayChangeBehindAnotherTool) {
  const auto told = [](const std::string& text) {
    return codes(read_text(text, at_origin(Dialect::fanuc)));
  };
  const std::string first = "G10 L10 P1 R80.\nG10 L10 P2 R90.\nT1 M6\nG43 H1\nG1 Z0 F9.\nG0 Z9.\n";
  EXPECT_EQ(told(first + "G10 L10 P2 R91.\nT2 M6\nG43 H2\nG1 Z0\nG0 Z9.\n"), "");
  EXPECT_EQ(told(first + "G91 G10 L11 P2 R0.1\nG90 T2 M6\nG43 H2\nG1 Z0\nG0 Z9.\n"), "");
  EXPECT_EQ(told(first + "T2 M6\nG43 H2\nG1 Z0\nG0 Z9.\nG10 L10 P1 R81.\nM30\n"), "");
  EXPECT_EQ(told(first + "G10 L10 P1 R81.\nG10 L10 P1 R80.\nG43 H1\nG1 Z0\nG0 Z9.\n"), "");
  const std::string changed = first + "G10 L10 P1 R81.\nT2 M6\nG43 H2\nG1 Z0\nG0 Z9.\n";
  EXPECT_EQ(told(changed + "T1 M6\nG43 H1\nG1 Z0\n"), "not-supported");
  EXPECT_EQ(told(first + "G49\nT2 M6\nG10 L10 P1 R120.\nG43 H1\nG1 Z0\n"), "") << "one H for both";
}

// Two lengths of one tool that the program tells differ on the machine.
TEST(FanucRegisters, TwoLengthsOfOneToolAreAnError) {
  const auto told = [](const std::string& set, const std::string& second = "") {
    const std::string cut = "\nG1 Z0 F9.\nG0 Z9.\n";
    return codes(read_text(set + "T1 M6\nG43 H1" + cut + second + "G43 H2" + cut,
                           at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(told("G10 L10 P1 R100.\nG10 L10 P2 R98.\n"), "not-supported");
  EXPECT_EQ(told("G10 L10 P1 R100.\n", "G10 L10 P2 R98.\n"), "not-supported");
  EXPECT_EQ(told("G10 L10 P1 R100.\nG10 L10 P2 R100.\n"), "");
  EXPECT_EQ(told("G10 L10 P1 R100.\nG10 L11 P1 R-1.\nG10 L10 P2 R100.\n"), "not-supported");
  EXPECT_EQ(told("G10 L10 P1 R100.\n"), "") << "the other one is unknown";
  EXPECT_EQ(told("G10 L10 P1 R100.\nG10 L10 P2 R98.\n", "T2 M6\n"), "");
}

// On the machine the two are as far apart as the tool is long.
TEST(FanucRegisters, CutsMustNotBeWithAndWithoutTheLength) {
  const auto told = [](const std::string& second, bool listed = false) {
    InterpOptions options = at_origin(Dialect::fanuc);
    if (listed) options.table.offsets.push_back({"H1", 0, 0, 20});
    return codes(read_text("T1 M6\nG43 H1 G0 Z5.\nG1 Z-1. F9.\nX9.\nG0 Z50.\n" + second, options));
  };
  EXPECT_EQ(told("G49\nG0 Z5.\nG1 Z-2.\n"), "not-supported");
  EXPECT_EQ(told("G44 H1\nG0 Z5.\nG1 Z-2.\n"), "not-supported");
  EXPECT_EQ(told("G43 H0\nG0 Z5.\nG1 Z-2.\n"), "not-supported");
  EXPECT_EQ(told("G49\nG43 H1 Z5.\nG1 Z-2.\n"), "");
  EXPECT_EQ(told("G49 G1 X5.\nG1 Z80.\n"), "") << "at the height where it is, and out";
  EXPECT_EQ(told("G49\nG91 G1 Z-51.\n"), "") << "in steps";
  EXPECT_EQ(told("G49 G0 Z80.\nG1 X50.\nG43 H1 G0 Z5.\nG1 Z-2.\n"), "") << "a way above";
  EXPECT_EQ(told("G49 G1 Z80.\nX50.\nG43 H1 Z5.\nZ-2.\n"), "") << "ways by feed";
  EXPECT_EQ(told("G49\nT2 M6\nG0 Z5.\nG1 Z-2.\n"), "") << "another tool";
  EXPECT_EQ(told("G49\nG0 Z5.\nG1 Z-2.\n", true), "") << "the table tells it";
}

// #4012 is group 12: the work offset on Haas and Mitsubishi, G66 and G67 on FANUC, which no program
// reads.
TEST(Macro, Group12IsTheWorkOffset) {
  const std::string text = "G55\n#33=#4012\nG54 G1 X#33 F9\nX#4012\nM30\n";
  EXPECT_EQ(path_text(read_text(text, at_origin(Dialect::fanuc))), "l55,0,0 l54,0,0 | modal-group");
  InterpOptions given = at_origin(Dialect::fanuc);
  given.variables = {{"#4012", "67"}};
  EXPECT_EQ(path_text(read_text(text, given)), "l67,0,0");
}

TEST(Macro, ABlankBehindTheSlashMeansNothing) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.block_skip = 0b100;
  EXPECT_EQ(path_text(read_text("/ 2 G1 X1 F9\n/ 3 G1 X2 F9\nN5 / 2 X3\n/ X4\nM30\n", options)),
            "l2,0,0 l4,0,0");
}

// The blocks behind it ran.
TEST(FanucRegisters, AnAlarmEndsTheProgram) {
  const Program p =
      read_text("G1 X1 F9\n#3000=1(NO TOOL)\nX2\nX#5\nM30\n", at_origin(Dialect::fanuc));
  EXPECT_EQ(path_text(p), "l1,0,0 | program-alarm");
}

}  // namespace
}  // namespace mrsim
