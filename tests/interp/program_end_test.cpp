// Where the text of a program ends without a word that ends it.
#include "interp/support.h"

#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

/// "w8" for a warning program-end-missing in line 8, "n8" for a note.
std::string end_told(const std::string& text, Dialect dialect) {
  const TempFolder scratch;
  std::string out;
  for (const Diagnostic& d :
       read_program(scratch.write("program.nc", text), at_origin(dialect)).diagnostics)
    if (d.code == "program-end-missing")
      out += fmt::format("{}{}", d.severity == Severity::note ? 'n' : 'w', d.place.line);
  return out;
}

TEST(ProgramEnd, AFileThatEndsInACutIsAWarning) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::iso, Dialect::ngc, Dialect::sinumerik}) {
    EXPECT_EQ(end_told("G0 Z5\nG1 Z-3 F200\nX5", dialect), "w3");
    EXPECT_EQ(end_told("G0 Z5\nG1 Z-3 F200\nX5\n\n\n", dialect), "w3") << "the last block";
    EXPECT_EQ(end_told("G0 Z5\nG1 Z-3 F200\nX5\nG0 Z5\n", dialect), "n4") << "it has left the part";
    EXPECT_EQ(end_told("G0 Z5\nG1 Z-3 F200\nX5\nZ5\nM5\n", dialect), "n5") << "by a line up";
    EXPECT_EQ(end_told("G0 Z5\nG1 Z-3 F200\nX5\nM30\n", dialect), "");
    EXPECT_EQ(end_told("F200\n", dialect), "") << "nothing moves";
  }
  EXPECT_EQ(end_told("%\nO1\nG1 Z-3 F200\nX5\n", Dialect::fanuc), "w4");
  EXPECT_EQ(end_told("G1 X5 F1\n", Dialect::codesys), "") << "its programs have no such word";
}

// Programs of Grbl retract by machine coordinates, and those of routers have no rapids.
TEST(ProgramEnd, AToolThatHasLeftThePartIsInNoCut) {
  const std::string cut = "G21 G90\nG0 Z5\nX1 Y1\nG1 Z-3 F200\nX5\n";
  EXPECT_EQ(end_told(cut + "G53 G0 Z0\n", Dialect::ngc), "n6");
  EXPECT_EQ(end_told(cut + "G28\n", Dialect::fanuc), "n6");
  EXPECT_EQ(end_told(cut + "G1 Z5\nX0 Y0\n", Dialect::ngc), "n7") << "at clearance height";
  EXPECT_EQ(end_told(cut + "G1 X9 Z5\n", Dialect::ngc), "n6") << "a slanted lift";
  EXPECT_EQ(end_told("F9\nG1 Z5\nX1\nZ-1\nX5\nZ5\nX0\n", Dialect::ngc), "n7") << "no rapid";
  EXPECT_EQ(end_told(cut + "G1 X9 Z-1\n", Dialect::ngc), "w6");
  EXPECT_EQ(end_told(cut + "G53 G0 Z0\nG0 Z5\nX9\nG1 Z-1\nX3\n", Dialect::ngc), "w10");
  EXPECT_EQ(end_told("F9\nG0 X1 Y1\nG1 X9\nY9\n", Dialect::ngc), "w4") << "all at one height";
}

TEST(ProgramEnd, ALathesToolLeavesInX) {
  const auto turned = [](const std::string& text) {
    const TempFolder scratch;
    const Program p = read_program(scratch.write("program.nc", "G18 G99\nG0 X52. Z2.\nG1 " + text),
                                   at_origin(Dialect::fanuc, MachineKind::lathe));
    for (const Diagnostic& d : p.diagnostics)
      if (d.code == "program-end-missing") return d.severity == Severity::note ? 'n' : 'w';
    return '-';
  };
  EXPECT_EQ(turned("X48. F.2\nZ-20.\nX52.\n"), 'n');
  EXPECT_EQ(turned("X48. F.2\nZ-20.\nX54. Z-21.\n"), 'n');
  EXPECT_EQ(turned("X48. F.2\nZ-20.\nX50.\n"), 'w') << "a shoulder";
  EXPECT_EQ(turned("Z0 F.2\nX-1.6\n"), 'w');
  EXPECT_EQ(turned("X56. F.2\nZ-20.\nX52.\n"), 'n') << "in a bore";
}

TEST(ProgramEnd, EveryWordThatEndsAProgramCounts) {
  const std::string cut = "G0 Z5\nG1 Z-3 F200\nX5\n";
  EXPECT_EQ(end_told("%\nO1\n" + cut + "%\n", Dialect::fanuc), "");
  EXPECT_EQ(end_told(cut + "M99\n", Dialect::fanuc), "");
  EXPECT_EQ(end_told("%\n" + cut + "%\n", Dialect::ngc), "");
  for (const Dialect dialect : {Dialect::fanuc, Dialect::iso, Dialect::ngc})
    EXPECT_EQ(mill(cut + "M30 %\r\n", dialect), "r0,0,5 l0,0,-3 l5,0,-3");
  EXPECT_EQ(end_told(cut + "M2\n", Dialect::ngc), "");
  EXPECT_EQ(end_told(cut + "M02\n", Dialect::iso), "");
  EXPECT_EQ(end_told(cut + "M17\n", Dialect::sinumerik), "");
  EXPECT_EQ(end_told(cut + "RET\n", Dialect::sinumerik), "");
}

TEST(ProgramEnd, ItIsToldOnce) {
  EXPECT_EQ(end_told("F1\nG1 X1\nX2 Y\n", Dialect::iso), "") << "the error comes first";
  EXPECT_EQ(end_told("O1 sub\nG1 X5\nO1 endsub\nF9\nO1 call\n", Dialect::ngc), "w5")
      << "LinuxCNC's error alone";
  EXPECT_EQ(end_told("G1 X1 F1\nM98 P7\nG1 X3\nM30\nO7\nG1 X2\n", Dialect::fanuc), "w6")
      << "the subprogram's alone";
}

TEST(ProgramEnd, AProgramOfAnArchiveEndsAtTheNextHeader) {
  const auto told = [](const std::string& text) {
    const Program p = read_text(text, at_origin(Dialect::sinumerik));
    std::string out = path_text(p);
    for (const Diagnostic& d : p.diagnostics) out += fmt::format("\n{}: {}", d.place.line, d.text);
    return out;
  };
  const std::string main = "%_N_A_MPF\nG1 X1 F9\nUP\nX2\n";
  EXPECT_EQ(told(main + "%_N_UP_SPF\nX5\n%_N_B_MPF\nX9\nM30\n"),
            "l1,0,0 l5,0,0 l2,0,0 | program-end-missing program-end-missing\n"
            "7: the program before B has no M17: it is taken to end here\n"
            "5: the program before UP has no M30: it is taken to end here\n"
            "5: the program ends here: B in line 7 is not called, and not run");
  EXPECT_EQ(told("%_N_A_MPF\nG1 X1 F9\n%_N_B_MPF\nX9\nM30\n"),
            "l1,0,0 | program-end-missing\n"
            "3: the program before B has no M30: it is taken to end here\n"
            "3: the program ends here: B in line 3 is not called, and not run");
  EXPECT_EQ(told(main + "M30\n%_N_UP_SPF\nX5\nRET\n%_N_V_SPF\nM17\n"), "l1,0,0 l5,0,0 l2,0,0");
}

}  // namespace
}  // namespace mrsim
