// Several programs in one file: which of them is the main program, and which are never run.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

const InterpOptions kArchive = at_origin(Dialect::fanuc);

std::string notes_of(const std::string& text) {
  return codes(read_text(text, kArchive), Severity::note);
}

TEST(SeveralPrograms, ProgramsThatNothingCallsAreToldOf) {
  const auto told = [](const std::string& text) {
    for (const Diagnostic& d : read_text(text, kArchive).diagnostics)
      if (d.code == "program-not-run") return d.text;
    return std::string();
  };
  const std::string two = "O1\nG1 X1. F1\nM98 P2\nM30\nO0002\nX2.\nM99\n";
  EXPECT_EQ(told(two), "");
  EXPECT_EQ(told(two + "O1003\nX9.\nM30\n"),
            "the program ends here: O1003 in line 8 is not called, and not run");
  EXPECT_EQ(told(two + "%\n%\nO1003\nX9.\nM30\n%\nO4\nM99\n"),
            "the program ends here: O1003 in line 10 (and 1 more) is not called, and not run");
  EXPECT_EQ(notes_of("O1\nG1 X1. F1\nM99\nO2\nM99\n"), "program-loops program-not-run");
  const std::string before = "%\nO1000\nG1 X2. F1\nM99\n%\n\n%\n";
  for (const char* call : {"M98 P1000 L1", "M98 P11000", "G65 P1000"}) {
    const std::string text = before + "O0001 (MAIN)\nG1 X1. F1\n" + call + "\nM30\n%\n";
    EXPECT_EQ(path_text(read_text(text, kArchive)), "l1,0,0 l2,0,0") << call;
    EXPECT_EQ(notes_of(text), "program-start");
  }
  const std::string nameless = "%\nG1 X1. F1\nM98 P1000\nM30\nO1000\nG1 X2. F1\nM99\n";
  EXPECT_EQ(path_text(read_text(nameless + "O2\nG1 X9. F1\nM98 P1000\nM30\n%\n", kArchive)),
            "l1,0,0 l2,0,0")
      << "a main program without a name comes first";
  EXPECT_EQ(notes_of(before + "O1\nM98 P1001\nM30\nO1001\nM99\n"), "program-loops program-not-run");
  EXPECT_EQ(notes_of("O1\nG1 X1. F1\nG65 P2\nM30\nO2\nM99\n"), "");
  const Program okuma =
      read_text("OSUB (HOLE)\nG1 X2 F1\nRTS\nO1000\nX1\nCALL OSUB\nX3\nM2\n", kArchive, "part.min");
  EXPECT_EQ(path_text(okuma), "r1,0,0 l2,0,0 l3,0,0");
  EXPECT_NE(codes(okuma, Severity::note).find("program-start"), std::string::npos);
}

// Archives hold their files in any order.
TEST(SeveralPrograms, AMainProgramBehindItsSubprogramsIsFound) {
  const auto run = [](const std::string& text) {
    return read_text(text, at_origin(Dialect::sinumerik));
  };
  const std::string sub = "%_N_UP_SPF\n;$PATH=/_N_SPF_DIR\nG1 X5 F9\nM17\n";
  const std::string main = "%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\nG1 X1 F9\nUP\nM30\n";
  EXPECT_EQ(path_text(run(sub + main)), "l1,0,0 l5,0,0");
  EXPECT_EQ(codes(run(sub + main), Severity::note), "program-start");
  EXPECT_EQ(codes(run(main + sub), Severity::note), "");
  EXPECT_EQ(path_text(run("\n" + sub + "%_N_UP2_SPF\nX7\nM17\n" + main)), "l1,0,0 l5,0,0");
  EXPECT_EQ(path_text(run(sub)), "l5,0,0") << "a subprogram alone is run";
  EXPECT_EQ(path_text(run(main + sub + "%_N_NEXT_MPF\nX9\nM30\n")), "l1,0,0 l5,0,0");
  EXPECT_EQ(codes(run(main + sub + "%_N_NEXT_MPF\nX9\nM30\n"), Severity::note), "program-not-run");
  EXPECT_EQ(path_text(run("; ORDER 4711\n;\n" + sub + main)), "l1,0,0 l5,0,0")
      << "comments may stand before the first header";
}

TEST(SeveralPrograms, AMainProgramThatAnotherOneCallsIsASubprogram) {
  const auto run = [](const std::string& text) {
    return read_text(text, at_origin(Dialect::sinumerik));
  };
  const std::string hole = "%_N_HOLE_MPF\nT1 M6\nG1 X5 F9\nM17\n";
  const std::string between = "%_N_AIR_SPF\nHOLE\nM30\n";
  for (const char* call : {"HOLE", "N20 HOLE P1", "CALL \"HOLE\"", "n20 hole ; once"}) {
    const std::string text =
        hole + between + "%_N_PART_MPF\nG1 X1 F9\n" + std::string(call) + "\nM30\n";
    EXPECT_EQ(path_text(run(text)), "l1,0,0 l5,0,0") << call;
    EXPECT_EQ(codes(run(text), Severity::note), "program-start tool-inferred") << call;
  }
  for (const char* other : {"HOLE=1", "HOLES", "MSG(\"HOLE\")", "HOLE:"})
    EXPECT_EQ(path_text(run(hole + "%_N_PART_MPF\nDEF INT HOLE\nG1 X1 F9\n" + std::string(other) +
                            "\nM30\n")),
              "l5,0,0")
        << other;
  EXPECT_EQ(path_text(run("%_N_ONE_MPF\nG1 X5 F9\nM30\n%_N_TWO_MPF\nG1 X1 F9\nONE\nM30\n")),
            "l5,0,0")
      << "the first one is a main program by its M30";
  for (const std::string word : {"A", "T5"})
    EXPECT_EQ(path_text(run("%_N_" + word + "_MPF\nG1 X5 F9\nM17\n%_N_TWO_MPF\nG1 X1 F9\n" + word +
                            "\nM30\n")),
              "l5,0,0")
        << "a word of the block, and no call";
}

}  // namespace
}  // namespace mrsim
