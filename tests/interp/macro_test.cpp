// Custom macros of FANUC: variables, loops and calls with arguments.
#include "interp/path_of.h"
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(Macro, WhileLoopsEqualTheWrittenOutProgram) {
  std::string plain = "G1 X0 Y0 F100\n";
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      plain += fmt::format("X{} Y{}\nZ-{}\nZ1\n", column * 10, row * 5 + 1, row + 1);
  const std::string loops =
      "G1 X0 Y0 F100\n#1=0\nWHILE[#1LT3]DO1\n#2=0\nWHILE[#2LE3]DO2\n"
      "X[#2*10] Y[#1*5+1]\nZ-[#1+1]\nZ1\n#2=#2+1\nEND2\n#1=#1+1\nEND1\nM30\n";
  EXPECT_EQ(run(Dialect::fanuc, loops), run(Dialect::fanuc, plain));
  const std::string jumps =
      "G1 X0 Y0 F100\n#1=0\nN10 #2=0\nN20 X[#2*10] Y[#1*5+1]\nZ-[#1+1]\nZ1\n#2=#2+1\n"
      "IF [#2 LT 4] GOTO 20\n#1=#1+1\nIF [#1 LT 3] GOTO 10\nM30\n";
  EXPECT_EQ(run(Dialect::fanuc, jumps), run(Dialect::fanuc, plain));
}

// One pocket by repeated calls, by a loop and by a macro with arguments.
TEST(Macro, CallsLoopsAndMacrosMakeTheSamePocket) {
  const std::string turn = "G1 X10\nG2 I-10\nG1 X20\nG2 I-20\nG1 X0\n";
  const std::string calls =
      "G1 X0 Y0 Z0 F100\nM98 P20003\nM30\nO3\nG91 G1 Z-1\nG90\n" + turn + "M99\n";
  const std::string old =
      "G1 X0 Y0 Z0 F100\nM98 P3 L2\nM30\nO3\nG91 G1 Z-1\nG90\n" + turn + "M99\n";
  const std::string loop =
      "G1 X0 Y0 Z0 F100\n#5=1\nWHILE [#5 LE 2] DO1\nG1 Z-#5\n" + turn + "#5=#5+1\nEND1\nM30\n";
  const std::string macro =
      "G1 X0 Y0 Z0 F100\nG65 P9010 A2 R20\nM30\nO9010\n#30=0\nWHILE [#30 LT #1] DO1\n#30=#30+1\n"
      "G1 Z-#30\nX[#18/2]\nG2 I-[#18/2]\nG1 X#18\nG2 I-#18\nG1 X0\nEND1\nM99\n";
  const std::string first = run(Dialect::fanuc, calls);
  EXPECT_EQ(run(Dialect::fanuc, old), first);
  EXPECT_EQ(run(Dialect::fanuc, loop), first);
  EXPECT_EQ(run(Dialect::fanuc, macro), first);
  EXPECT_EQ(read_text(macro, at_origin(Dialect::fanuc)).motions.size(), 12U);
}

TEST(Macro, EachCallHasItsArgumentsAndLocals) {
  EXPECT_EQ(run(Dialect::fanuc,
                "#1=50\nG1 F100 X1\nG65 P7 A1 B2 C3 I4 J5 K6 I7 J8 K9\nX#1\nM30\n"
                "O7\nX[#1*100+#2*10+#3] Y[#4*100+#5*10+#6] Z[#7*100+#8*10+#9]\nM99\n"),
            "1,0,0 123,456,789 50,456,789 ");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X1\nG65 P7 X5\nM30\nO7\nX#24 Y#25\nM99\n"), "1,0,0 5,0,0 ")
      << "a vacant word counts as not written";
  EXPECT_EQ(run(Dialect::fanuc,
                "G1 F100 X1\nG65 P7 X5\nM30\nO7\nX-#24 Y-#25 Z- #26\nX#24 Y[-#25+1]\nM99\n"),
            "1,0,0 -5,0,0 5,1,0 ");
  EXPECT_EQ(
      run(Dialect::fanuc, "G1 F100 X1\nG66 P7 Z2\nX2\nX3\nG67\nX4\nM30\nO7\nG1 Z-#26\nZ0\nM99\n"),
      "1,0,0 2,0,0 2,0,-2 2,0,0 3,0,0 3,0,-2 3,0,0 4,0,0 ");
  EXPECT_EQ(run(Dialect::fanuc,
                "G1 F100 X1\nG66.1 P7\nX2 Y3\nX4 Y5\nG67\nX6\nM30\nO7\nG1 X[#24*10] Y#25\nM99\n"),
            "1,0,0 20,3,0 40,5,0 6,5,0 ");
}

// The manual's example: G66 in G66; the last macro runs, a move in it calls the one before, and G67
// ends the last one alone.
TEST(Macro, ModalCallsRunInsideOneAnother) {
  const std::string macros = "M30\nO7\nG91 Y1\nG90\nM99\nO8\nZ6\nZ7\nM99\nO9\nZ[#26]\nM99\n";
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100\nG66 P7\nX10\nG66 P8\nX15\nG67\nG67\nX-25\n" + macros),
            "10,0,0 10,1,0 15,1,0 15,1,6 15,2,6 15,2,7 15,3,7 -25,3,7 ");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100\nG66 P7\nG66 P9 Z2\nG67\nX1\nG67\nX2\n" + macros),
            "1,0,0 1,1,0 2,1,0 ");
}

// A G66 of a macro itself holds for its moves; of the one before G65, no manual says.
TEST(Macro, AModalCallHoldsInTheMacroThatMadeIt) {
  const std::string macros = "M30\nO7\nZ-1\nZ0\nM99\nO8\nG66 P7\nX1\nG67\nX2\nM99\nO9\nX9\nM99\n";
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100\nG65 P8\nX3\n" + macros),
            "1,0,0 1,0,-1 1,0,0 2,0,0 3,0,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100\nG66 P7\nG65 P9\nG67\nX3\n" + macros),
            "9,0,0 3,0,0 not-supported");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100\nG66 P5\nX1\nG67\nX3\n" + macros + "O5\nG65 P7\nM99\n"),
            "1,0,0 1,0,-1 1,0,0 3,0,0 ")
      << "a macro in that of G66";
}

// Arguments are set once: the next run has what the last one left.
TEST(Macro, RunsOfOneCommandShareTheirVariables) {
  const std::string macro = "M30\nO7\n#1=#1+1\nX#1\nM99\n";
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100\nG65 P7 A2 L3\nG65 P7 A2\n" + macro),
            "3,0,0 4,0,0 5,0,0 3,0,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100\nG66 P7 A2\nY1\nY2\nG67\n" + macro),
            "0,1,0 3,1,0 3,2,0 4,2,0 ");
}

// More common variables of the 30i; those of Mitsubishi's begin at #400.
TEST(Macro, Fanuc30iAndMitsubishiHaveMoreCommonVariables) {
  EXPECT_EQ(run(Dialect::fanuc,
                "G1 F100\n#98000=1\n#98499=2\n#900000=3\n#907399=4\n#400=5\nM98 P2\n"
                "X#98000 Y#98499\nX#900000 Y#[907399]\nX#400\nM30\nO2\n#98499=#98499+7\nM99\n"),
            "1,9,0 3,4,0 5,4,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X1\nX#98001\n"), "1,0,0 variable-unset");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X1\nX#98500\n"), "1,0,0 variable-number");
}

TEST(Macro, M99ReturnsToABlockAndM97CallsOne) {
  EXPECT_EQ(run(Dialect::fanuc,
                "G1 F100 X1\nM98 P7\nX99\nN50 X2\nM97 P900 L2\nX3\nM30\nN900 G91 Y1\nG90\nM99\n"
                "O7\nX5\nM99 P50\n"),
            "1,0,0 5,0,0 2,0,0 2,1,0 2,2,0 3,2,0 ");
  for (const char* call : {"M98 H900 L2", "M98 Q900 L2"})
    EXPECT_EQ(run(Dialect::fanuc,
                  "G1 F100 X1\n" + std::string(call) + "\nX3\nM30\nN900 G91 Y1\nG90\nM99\n"),
              "1,0,0 1,1,0 1,2,0 3,2,0 ")
        << "a block of the same program (Mitsubishi)";
  EXPECT_EQ(run(Dialect::fanuc,
                "G1 F100 X1\nIF [1 EQ 1] THEN #1=4\nIF [1 EQ 2] THEN #1=5\n"
                "X#1\nG#3 X5\n"),
            "1,0,0 4,0,0 variable-unset");
}

TEST(Macro, FaultsAreToldWithTheirPlace) {
  const Program unset = read_text("G1 X1 F1\nX[#5+1]\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(unset.diagnostics.size(), 1U);
  EXPECT_EQ(unset.diagnostics[0].place.line, 2);
  EXPECT_EQ(unset.diagnostics[0].place.column, 3);
  EXPECT_NE(unset.diagnostics[0].text.find("--set '#5=1'"), std::string::npos);
  EXPECT_EQ(run(Dialect::fanuc, "G1 X1 F1\nGOTO 7\n"), "1,0,0 jump-target");
  EXPECT_EQ(run(Dialect::fanuc, "G1 X1 F1\nWHILE [1 EQ 1] DO1\nX2\n"), "1,0,0 structure");
  EXPECT_EQ(run(Dialect::fanuc, "G1 X1 F1\nX[1/0]\n"), "1,0,0 expression");
  const Program deep =
      read_text("G1 X1 F1\nM98 P7\nM30\nO7\n#100=0\nX[4/#100]\nM99\n", at_origin(Dialect::fanuc));
  ASSERT_EQ(deep.diagnostics.size(), 1U);
  EXPECT_NE(deep.diagnostics[0].text.find("(#100 = 0)"), std::string::npos);
  ASSERT_EQ(deep.diagnostics[0].called_from.size(), 1U);
  EXPECT_EQ(deep.diagnostics[0].called_from[0].line, 2);
}

TEST(Macro, VariablesMayBeSetFromOutside) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.variables = {{"#100", "2.5"}, {"#1", "4"}};
  EXPECT_EQ(path_of(read_text("G1 F1 X#100 Y#1\n", options)), "2.5,4,0 ");
  options.variables = {{"R1", "5"}};
  EXPECT_THROW(read_text("G1 X1 F1\n", options), Error);
  options = at_origin(Dialect::sinumerik);
  options.variables = {{"R1", "5"}, {"WIDTH", "7"}};
  EXPECT_EQ(path_of(read_text("G1 F1 X=R1 Y=WIDTH\n", options)), "5,7,0 ");
}

// Bar feeders: the program begins again for the next part, and nothing in it ends that.

// InterpOptions::trace_variables: the arguments of a call, too, at the line of the call.
TEST(Macro, AssignmentsAreToldOf) {
  class Assignments : public testing::CollectingSink {
   public:
    void assignment(const SourcePlace& place, const std::string& name,
                    const std::string& value) override {
      told += fmt::format("{}:{}={} ", place.line, name, value);
    }
    std::string told;
  };
  const auto told = [](Dialect dialect, const std::string& text) {
    const TempFolder scratch;
    InterpOptions options = at_origin(dialect);
    options.trace_variables = true;
    Assignments sink;
    interpret(scratch.write("p.nc", text), options, sink);
    return sink.told;
  };
  EXPECT_EQ(told(Dialect::fanuc, "#5=2\nG65 P7 A#5 X3.\nM30\nO7\n#2=#1+#24\nM99\n"),
            "1:#5=2 2:#1=2 2:#24=3 5:#2=5 ");
  EXPECT_EQ(told(Dialect::ngc, "o1 sub\n#3=[#1+1]\no1 endsub\no1 call [4]\nM2\n"),
            "4:#1=4 2:#3=5 ");
  EXPECT_EQ(told(Dialect::sinumerik,
                 "%_N_M_MPF\nSUB(5)\nM30\n%_N_SUB_SPF\nPROC SUB(REAL VA,INT VB=2)\nR1=VA\nRET\n"),
            "2:VA=5 2:VB=2 6:R1=5 ");
}

// The control reads a block skip there.
TEST(Macro, ADivisionWithoutBracketsIsToldOf) {
  const auto told = [](const char* text) {
    return codes(read_text(text, at_origin(Dialect::fanuc)), Severity::warning);
  };
  EXPECT_EQ(told("#1=10\nG1 X#1/2 F9\nM30\n"), "block-skip-inside");
  EXPECT_EQ(told("#1=10\nG1 X[#1/2] F9\nG0 Z#1 /2 M9\nZ50./2M9\nM30\n"), "");
}

// The holes were drilled, and the macro never ran.
TEST(Macro, ADrillingCycleUnderG66IsRefused) {
  const auto told = [](const std::string& text) {
    return codes(
        read_text(text + "M30\nO10\nG91 G1 Z1. F9\nG90\nM99\n", at_origin(Dialect::fanuc)));
  };
  EXPECT_EQ(told("G66 P10\nG81 X5. Z-1. R1. F9\nG67\nG80\n"), "not-supported");
  EXPECT_EQ(told("G66 P10\nG1 X5. F9\nG67\nG81 X5. Z-1. R1. F9\nG80\n"), "");
  EXPECT_EQ(told("G81 X5. Z-1. R1. F9\nG80\nG66 P10\nG1 X5. F9\nG67\n"), "");
}

// They were whole millimetres, beside X5000 in a block of its own as 5.
TEST(Macro, ArgumentsCountLeastIncrementsToo) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.least_increments = true;
  const auto path = [&](const std::string& call) {
    return path_text(
        read_text("#100=7\n" + call + "\nM30\nO7\nG1 X#24 Y#4 Z#1 F#9\nX#11\nM99\n", options));
  };
  EXPECT_EQ(path("G65 P7 X5000 I2000 A1000 H2 F100"), "l5,2,1 l2,2,1");
  EXPECT_EQ(path("G65 P7 X5. I#100 A[1+1] H2 F100"), "l5,7,2 l2,7,2");
  EXPECT_EQ(path("G20\nG65 P7 X5000 I0 A0 H2. F100"), "l12.7,0,0 l50.8,0,0");
}

TEST(Macro, CommentsMayStandBetweenOperands) {
  for (const char* const text :
       {"#1=[2+(NOTE)3]", "#1=2(A)+(B]) 3", "#1=(NOTE)5", "#1=SQRT(OF)[25]", "#1=5 (NOTE",
        "IF(A)[1 EQ 1(B)](C)THEN#1=5", "#2=0\nWHILE(A)[#2 EQ 0](B)DO1\n#1=5\n#2=1\nEND1"})
    EXPECT_EQ(run(Dialect::fanuc, fmt::format("G1 F9\n{}\nX#1\nM30\n", text)),
              std::string(text).ends_with("NOTE") ? "5,0,0 comment-unterminated" : "5,0,0 ")
        << text;
}

// 3 was given to #2.
TEST(Macro, ANumberOfAVariableThatIsNotWhole) {
  EXPECT_EQ(run(Dialect::fanuc, "#2=1\n#1.5=3\nG1 X#2 F9\nM30\n"), "1,0,0 variable-number");
  EXPECT_EQ(run(Dialect::fanuc, "#2=1\n#[3/2]=3\nG1 X#2 F9\nM30\n"), "1,0,0 variable-number");
  EXPECT_EQ(run(Dialect::ngc, "#2=1\n#1.5=3\nG1 X#2 F9\nM2\n"), "1,0,0 variable-number");
}

TEST(Macro, ArgumentsStandBehindTheCode) {
  const std::string macro = "\nM30\nO7\nG1 X#1 F9\nM99\n";
  EXPECT_EQ(run(Dialect::fanuc, "G65 P7 A1" + macro), "1,0,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "P7 G65 A1" + macro), "1,0,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "A1 G65 P7" + macro), "macro-arguments");
  EXPECT_EQ(run(Dialect::fanuc, "A1 G66 P7" + macro), "macro-arguments");
}

// G L N P were dropped: on the control they are arguments.
TEST(Macro, WordsUnderG66Point1ThatMayBeArguments) {
  for (const char* const word : {"G0", "L2", "P3", "N4"})
    EXPECT_EQ(
        run(Dialect::fanuc, fmt::format("G66.1 P7\nX5 {}\nG67\nM30\nO7\nG1 X#24 F9\nM99\n", word)),
        "not-supported")
        << word;
}

// G65 H02 P#101 Q#101 R1 adds on old controls. It called the program whose number #101 holds.
TEST(Macro, MacroAOfOldControlsIsNamed) {
  const std::string sub = "M30\nO8\nX#11\nM99\n";
  EXPECT_EQ(run(Dialect::fanuc, "#101=8\nG1 F100 X1\nG65 H02 P#101 Q#101 R1\n" + sub),
            "1,0,0 not-supported");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X1\nG65 P8 H5\n" + sub), "1,0,0 5,0,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X1\nG65 H5. P8\n" + sub), "1,0,0 5,0,0 ");
}

TEST(Macro, CallsThatBeginAtABlock) {
  const std::string sub = "\nX9\nM30\nO7\nX1\nN20 X2\nX3\nM99\nO8\nN30 X4\nM99\n";
  for (const char* const call : {"M98 P7 Q20", "M98 P7 H20", "#1=20\nM98 P7 Q#1"})
    EXPECT_EQ(run(Dialect::fanuc, "G1 F9\n" + std::string(call) + sub), "2,0,0 3,0,0 9,0,0 ")
        << call;
  EXPECT_EQ(run(Dialect::fanuc, "G1 F9\nM98 P7 Q30" + sub), "9,0,0 jump-target");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F9\nM98 P7 Q20 L2" + sub), "9,0,0 not-supported");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F9\nM98 P7 Q20\nX9\nM30\n"), "9,0,0 subprogram-missing");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F9\nM98 P7 Q20.5" + sub), "9,0,0 value-range");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F9\nM98 P7 Q-20" + sub), "9,0,0 value-range");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F9\nG43 H20 M98 P7" + sub), "1,0,0 2,0,0 3,0,0 9,0,0 ");
}

}  // namespace
}  // namespace mrsim
