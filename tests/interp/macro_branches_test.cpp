// Custom macros of FANUC: branches, jumps and their conditions.
#include "interp/path_of.h"
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

// Branches of several lines (30i-B): nothing stands behind their THEN.
TEST(MacroBranches, BranchesOfSeveralLinesChooseOneWay) {
  const auto path = [](const std::string& text) { return run(Dialect::fanuc, text + "M30\n"); };
  const std::string ladder =
      "N5 IF[#1 EQ 1]THEN (ONE)\nG1 X1 F9\nN6 ELSEIF [#1 EQ 2] THEN\nG1 X2 F9\n#1=1\nELSE\n"
      "G1 X3 F9\nENDIF\nY1\n";
  EXPECT_EQ(path("#1=1\n" + ladder), "1,0,0 1,1,0 ");
  EXPECT_EQ(path("#1=2\n" + ladder), "2,0,0 2,1,0 ");
  EXPECT_EQ(path("#1=7\n" + ladder), "3,0,0 3,1,0 ");
  EXPECT_EQ(path("#1=0\nWHILE[#1 LT 3]DO1\n#1=#1+1\nIF[#1 EQ 2]THEN\nIF[#1 GT 1]THEN\nG1 Y#1 F9\n"
                 "ENDIF\nELSE\nG1 X#1 F9\nENDIF\nEND1\n"),
            "1,0,0 1,2,0 3,2,0 ");
  EXPECT_EQ(path("#1=3\nIF[#1 EQ 1]THEN\nG1 X1 F9\nENDIF\nIF[#1 EQ 3]THEN #2=5.\nG1 X#2 F9\n"),
            "5,0,0 ");
  const auto told = [](const std::string& text) {
    return codes(read_text(text, at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(told("#1=3\nIF[#1 EQ 1]THEN\nG1 X1 F9\nM30\n"), "structure");
  EXPECT_EQ(told("G1 X1 F9\nELSE\nX2\nENDIF\nM30\n"), "structure");
  for (const char* const holds : {"1 EQ 1", "1 EQ 2"})
    EXPECT_EQ(told(fmt::format("#1=0\nIF[{}]THEN #1=5. ELSE #1=6.\nG1 X9 F9\nM30\n", holds)),
              "not-supported")
        << "no ELSE was read behind a condition that is false";
  EXPECT_EQ(told("#1=0\nIF[1 EQ 1]THEN #1=5. (OR ELSE 6)\nG1 X#1 F9\nM30\n"), "");
}

// The jump of an IF that is false passed over all of these, up to ENDIF.
TEST(MacroBranches, BlocksOfBranchesThatAreNotWhole) {
  const auto read = [](const std::string& condition, const std::string& rest) {
    return read_text(
        "#1=0\nG1 F9\nIF[" + condition + "]THEN\nG1 X1 F9\n" + rest + "\nG1 X99\nM30\n",
        at_origin(Dialect::fanuc));
  };
  for (const char* const rest :
       {"ELSEIF[#1EQ0]THEN G1 X2\nENDIF", "ELSEIF[#1EQ0]\nG1 X2\nENDIF",
        "ELSEIF[#1EQ0]GOTO 20\nN20 G1 X2\nENDIF", "(C) ELSEIF\nG1 X2\nENDIF",
        "ELSIF[#1EQ0]THEN\nG1 X2\nENDIF", "N3 ELSEG1X2\nENDIF", "ELSE IF[#1EQ0]THEN\nENDIF",
        "ELSE G1 X2\nENDIF", "ENDIF G1 X3", "ENDIF #1=7", "N9 (C) ENDIF (C) #1=7",
        "ELSE\nX2\nELSE\nX3\nENDIF", "ELSE\nX2\nELSEIF[#1EQ0]THEN\nX3\nENDIF"})
    for (const char* const condition : {"#1EQ1", "#1EQ0"}) {
      const Program p = read(condition, rest);
      EXPECT_EQ(codes(p), "structure") << rest;
      EXPECT_TRUE(p.motions.empty()) << rest;
    }
  for (const char* const rest : {"(OTHER) ELSE\nX2\nENDIF", "N5(A) N6 (B)ELSE (C)\nX2\n (D) ENDIF",
                                 "ELSEIF (C) [#1EQ0] (C) THEN (C)\nX2\n(C)ELSE\nX3\nENDIF"}) {
    EXPECT_EQ(path_text(read("#1EQ1", rest)), "l2,0,0 l99,0,0") << rest;
    EXPECT_EQ(path_text(read("#1EQ0", rest)), "l1,0,0 l99,0,0") << rest;
  }
  for (const char* const begin : {"(TEST) IF[#1EQ1]THEN", "N1 (A) IF (B) [#1EQ1] (C) THEN (D)"})
    EXPECT_EQ(run(Dialect::fanuc, fmt::format("#1=0\n{}\nG1 X1 F9\nENDIF\nG1 X9 F9\nM30\n", begin)),
              "9,0,0 ");
}

// All of it ran, or none.
TEST(MacroBranches, PartsOfBranchesThatBlockSkipLeavesOut) {
  const auto told = [](const std::string& text, unsigned levels) {
    InterpOptions options = at_origin(Dialect::fanuc);
    options.block_skip = levels;
    return codes(read_text(text, options));
  };
  for (const char* const condition : {"1EQ1", "1EQ2"}) {
    const std::string head = fmt::format("IF[{}]THEN\nG1 X1 F9\n", condition);
    EXPECT_EQ(told(head + "/ELSE\nG1 X2 F9\nENDIF\nG1 X9 F9\nM30\n", 1), "structure");
    EXPECT_EQ(told(head + "N1 (A) /2 ELSE\nG1 X2 F9\nENDIF\nG1 X9 F9\nM30\n", 4), "structure");
    EXPECT_EQ(told("/3" + head + "ENDIF\nG1 X9 F9\nM30\n", 8), "structure");
    EXPECT_EQ(told(head + "/ELSE\nG1 X2 F9\nENDIF\nG1 X9 F9\nM30\n", 0), "");
  }
  EXPECT_EQ(told("/IF[1EQ1]THEN\n/G1 X2 F9\n/ENDIF\nG1 X9 F9\nM30\n", 1), "");
}

// Nothing of the line ran but its IF, and the program went on behind it.
TEST(MacroBranches, BranchesWithinALineNeedASemicolonAtItsEnd) {
  const std::string line = "IF[1EQ1]THEN; G1 X1 F9; ELSE; G1 X2 F9; ENDIF; G1 X3 F9";
  const auto read = [&](const char* end) {
    return read_text(line + end + "\nG1 X99 F9\nM30\n", at_origin(Dialect::fanuc));
  };
  EXPECT_EQ(codes(read("")), "structure");
  EXPECT_EQ(path_text(read(";")), "l1,0,0 l3,0,0 l99,0,0");
}

// Behind ";" in a line that none ends a comment begins: its N20 was jumped to.
TEST(MacroBranches, AJumpPassesNumbersInComments) {
  const auto path = [](const char* line) {
    return path_text(read_text(std::string("GOTO 20\n") + line + "\nN20 G1 X99 F9\nM30\n",
                               at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(path("G1 X5 F9 ; N20 G1 X7"), "l99,0,0");
  EXPECT_EQ(path("G1 X5 F9 (; N20 G1 X7);"), "l99,0,0");
  EXPECT_EQ(path("G1 X5 F9; N20 G1 X7 F9;"), "l7,0,0 l99,0,0");
}

// Controls give an alarm.
TEST(MacroBranches, ConditionsStandInBrackets) {
  for (const char* const text : {"IF #1 EQ 2 GOTO 5", "IF#1EQ2THEN#1=3", "WHILE #1 EQ 2 DO1\nEND1"})
    EXPECT_EQ(run(Dialect::fanuc, fmt::format("#1=2\n{}\nN5 G1 X1 F9\nM30\n", text)), "bracket")
        << text;
  for (const char* const text : {"o1 if 1\no1 endif", "o1 while 0\no1 endwhile",
                                 "o1 repeat 2\no1 endrepeat", "o1 do\no1 while 0"})
    EXPECT_EQ(run(Dialect::ngc, fmt::format("{}\nG1 X1 F9\nM2\n", text)), "bracket") << text;
}

// The branch passed over the ELSE, which no control sees there.
TEST(MacroBranches, PartsOfBranchesAndLoopsBehindWordsAreErrors) {
  const auto told = [](const std::string& text) {
    return codes(read_text("#1=2\n" + text + "\nM30\n", at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(told("IF[#1 EQ 1]THEN\nG1 X1 F9 ELSE\nX2\nENDIF"), "structure");
  EXPECT_EQ(told("IF[#1 EQ 1]THEN\nG1 X1 F9\n#2=1 ENDIF\nX2\nENDIF"), "structure");
  EXPECT_EQ(told("WHILE[#1 EQ 1]DO1\nG1 X1 F9 END1\nX2\nEND1"), "structure");
  EXPECT_EQ(told("IF[#1 EQ 1]THEN\nG1 X1 F9 (ELSE)\nENDIF\nX2 F9 G1"), "");
}

// Haas: N50 [#1 LT 10] M99 P10 goes on at a block where the condition holds.
TEST(MacroBranches, AConditionBeforeM99DecidesOnHaas) {
  const std::string sub = "M30\nO7\n[#1 GT 2] M99\nX[#1*10]\nM99\n";
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X1\nG65 P7 A2\nG65 P7 A3\nX4\n" + sub),
            "1,0,0 20,0,0 4,0,0 ");
  EXPECT_EQ(run(Dialect::fanuc,
                "#1=0\nN10 #1=#1+1\nG1 F100 X#1\nN50 [#1 LT 3] (AGAIN) M99 P10\nY9\nM30\n"),
            "1,0,0 2,0,0 3,0,0 3,9,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X1\nM98 P7\nM30\nO7\nX[1+1] M99\nX9\nM99\n"),
            "1,0,0 2,0,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "#1=0\n[#1 LT 3] M98 P7\nM30\n"), "not-supported");
}

// Words behind a GOTO are lost, whether it is taken or not.
TEST(MacroBranches, WordsBehindAJumpAreToldOf) {
  const auto told = [](const std::string& line) {
    return path_text(read_text("#1=0 #100=10\nG1 X1 F9\n" + line + "\nX2\nN10 X3\nM30\n",
                               at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(told("IF[#1EQ5]GOTO10 X9."), "l1,0,0 l2,0,0 l3,0,0 | word-without-effect");
  EXPECT_EQ(told("GOTO 10 Y9."), "l1,0,0 l3,0,0 | word-without-effect");
  EXPECT_EQ(told("IF[#1EQ5]GOTO N10 Y9."), "l1,0,0 l2,0,0 l3,0,0 | word-without-effect");
  EXPECT_EQ(told("IF[#1EQ5]GOTO#9 Y9."), "l1,0,0 l2,0,0 l3,0,0 | word-without-effect");
  EXPECT_EQ(told("GOTO[[#1+5]*2] Y9."), "l1,0,0 l3,0,0 | word-without-effect");
  EXPECT_EQ(told("GOTO#[#1+100] Y9."), "l1,0,0 l3,0,0 | word-without-effect");
  EXPECT_EQ(told("IF[#1EQ0]GOTO 10 (NEXT) ;"), "l1,0,0 l3,0,0");
  EXPECT_EQ(told("IF[#1EQ0]GOTO N10 (NEXT)"), "l1,0,0 l3,0,0");
  EXPECT_EQ(told("IF [#1EQ0]GOTON10"), "l1,0,0 l3,0,0");
  EXPECT_EQ(told("IF [#1EQ5]GOTON10 (NEXT)"), "l1,0,0 l2,0,0 l3,0,0");
  EXPECT_EQ(told("goton10 Y9."), "l1,0,0 l3,0,0 | word-without-effect");
  EXPECT_EQ(told("IF[#1EQ0] N10 Y9."), "l1,0,0 l3,0,0 | word-without-effect") << "Okuma";
  EXPECT_EQ(told("IF[#1EQ0] N10 (NEXT)"), "l1,0,0 l3,0,0");
  EXPECT_EQ(told("GOTO#100 (NEXT)"), "l1,0,0 l3,0,0");
  EXPECT_EQ(told("GOTO [#1 + 10] ;"), "l1,0,0 l3,0,0");
  EXPECT_EQ(told("IF[#1EQ5]GOTO[10+#1]"), "l1,0,0 l2,0,0 l3,0,0");
}

}  // namespace
}  // namespace mrsim
