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

TEST(ProgramEnd, EveryWordThatEndsAProgramCounts) {
  const std::string cut = "G0 Z5\nG1 Z-3 F200\nX5\n";
  EXPECT_EQ(end_told("%\nO1\n" + cut + "%\n", Dialect::fanuc), "");
  EXPECT_EQ(end_told(cut + "M99\n", Dialect::fanuc), "");
  EXPECT_EQ(end_told("%\n" + cut + "%\n", Dialect::ngc), "");
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

}  // namespace
}  // namespace mrsim
