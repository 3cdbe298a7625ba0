// The language of CODESYS SoftMotion: variables, expressions, calls with arguments, G20 G36 G37.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string codesys(const std::string& text,
                    const InterpOptions& options = at_origin(Dialect::codesys)) {
  return path_text(read_text(text, options));
}

// The example of the CODESYS documentation, with values for its variables.
TEST(CodesysLanguage, TheExampleOfTheDocumentationMovesAsItsPlainBlocks) {
  InterpOptions options = at_origin(Dialect::codesys);
  options.variables = {{"$g_x$", "10"}, {"$g_y$", "5"}};
  const std::string called =
      "N0 G01 X$g_x$ Y0 F50 E30 E-30\nN10 G01 X0 Y$g_y$\nN20 CNC2{25}\nN30 G90 G01 X0 Y-200\n"
      "SUBPROGRAM CNC2{#RADIUS : LREAL}\nN010 G91\n"
      "N020 G02 X#RADIUS*2 Y0 R#RADIUS Z2.5 F100 E-100 E100\n"
      "N030 G02 X-#RADIUS*2 Y0 R#RADIUS Z7.5\nEND_SUBPROGRAM\n";
  const std::string plain =
      "N0 G01 X10 Y0 F50 E30 E-30\nN10 G01 X0 Y5\nG91\nN020 G02 X50 Y0 R25 Z2.5 F100\n"
      "N030 G02 X-50 Y0 R25 Z7.5\nN30 G90 G01 X0 Y-200\n";
  EXPECT_EQ(codesys(called, options), codesys(plain));
  EXPECT_EQ(codesys(plain), "l10,0,0 l0,5,0 a50,5,2.5 a0,5,10 l0,-200,10");
}

TEST(CodesysLanguage, SubprogramsMayStandInFilesOfTheirOwn) {
  const TempFolder scratch;
  scratch.write("step.cnc",
                "SUBPROGRAM Step{#A : LREAL, #ON : BOOL}\nN1 G1 X#A Z#ON\nN2 RETURN\n"
                "N3 X99\nEND_SUBPROGRAM\n");
  const std::string main = scratch.write("main.cnc",
                                         "N1 G1 F100 X1\nN2 Step{2 + 3, TRUE}\n"
                                         "N3 DYNCALL{concat{'st', 'ep'}, 8, 2 < 1}\n");
  EXPECT_EQ(path_text(read_program(main, at_origin(Dialect::codesys))), "l1,0,0 l5,0,1 l8,0,0");
}

TEST(CodesysLanguage, JumpsAndCountersEqualTheWrittenOutProgram) {
  std::string plain = "N10 G91\n";
  for (int i = 0; i < 10; ++i) plain += "G01 X10 Y10 F100\n";
  EXPECT_EQ(codesys("N00 G36 D10 (set counter to 10)\nN10 G91\nN20 G01 X10 Y10 F100\n"
                    "N30 G37 D-1 (decrement)\nN40 G20 L20 (jump, if counter != 0)\n"),
            codesys(plain));
  EXPECT_EQ(codesys("N0 G91\nN1000 G36 O$g_i$ D10\nN1010 G01 X10 Y10 F100\nN1030 G37 O$g_i$ D-1\n"
                    "N1040 G20 L1010 K$g_i$\n"),
            codesys(plain));
  EXPECT_EQ(codesys("LET #I : LREAL\nN0 G91\nN5 G01 X10 Y10 F100\nN6 G37 O#I D1\n"
                    "N7 G20 L5 K#I < 10\n"),
            codesys(plain));
}

TEST(CodesysLanguage, JumpsGoDownToLabels) {
  // Comments may stand between the words.
  EXPECT_EQ(codesys("N1 G36 (a) O (b) $n$ (c) D2 (d)\nN2 G91 G1 X1 F100\nN3 G37 (e) O$n$ D-1\n"
                    "N4 G20 (f) L2 (g) K$n$ (h)\nN5 Y1\n"),
            "l1,0,0 l2,0,0 l2,1,0");
  EXPECT_EQ(codesys("N1 G1 X1 F100\nN2 G20 L?4\nN3 X2\nN4 X3 L!14\nN5 X4 L!4\nN6 X5\n"),
            "l1,0,0 l4,0,0 l5,0,0");
  EXPECT_EQ(codesys("N1 G1 X1 F100 L!4\nN2 G20 L?4\nN3 X2\n"), "l1,0,0 | jump-target");
  EXPECT_EQ(codesys("N1 G1 X1 F100\nN2 G20 L?4\nN3 X2\nN5 X4 (there) L!4\nN6 X5\n"),
            "l1,0,0 l4,0,0 l5,0,0");
  EXPECT_EQ(codesys("N1 G1 X1 F100\nN2 G20 L7\nN3 X2\n"), "l1,0,0 | jump-target");
}

TEST(CodesysLanguage, ExpressionsAreWordsValues) {
  EXPECT_EQ(codesys("N1 G1 F100 X2 + 3 * 4 Y{2 + 3} * 4 Z7 MOD 4\n"), "l14,20,3");
  EXPECT_EQ(codesys("N1 G1 F100 X abs{-2} Y abs -3 Z pi - pi\n"), "l2,3,0");
  EXPECT_EQ(codesys("N1 G1 F100 X10*sin{pi/2} Y10*cos{pi}\n"), "l10,-10,0");
  EXPECT_EQ(codesys("N1 G1 F100 X{1 < 2} Y{1 = 2} Z NOT {1 = 2 XOR 2 = 2}\n"), "l1,0,0");
  EXPECT_EQ(codesys("N1 G1 F100 X expt{2, 10} Y sqrt 16 Z log 1000\n"), "l1024,4,3");
  EXPECT_EQ(codesys("N1 G1 F100 X5 E100 E-100\nN2 X6 F50 E30 E-30\n"), "l5,0,0 l6,0,0");
}

TEST(CodesysLanguage, FaultsHaveTheirPlaceAndValues) {
  const Program p =
      read_text("N1 G36 O$a$ D0\nN2 G1 F100 X1\nN3 X5/$a$\n", at_origin(Dialect::codesys));
  ASSERT_EQ(codes(p), "expression");
  EXPECT_EQ(p.diagnostics.back().place.line, 3);
  EXPECT_NE(p.diagnostics.back().text.find("$a$ = 0"), std::string::npos);
  EXPECT_EQ(codesys("N1 G1 F100 X1\nN2 X$never$\nN3 X2\n"), "l1,0,0 l2,0,0 | variable-unset");
  EXPECT_EQ(codesys("N1 G1 F100 X1\nN2 X#never\nN3 X2\n"), "l1,0,0 l2,0,0 | variable-unset");
  const std::string sub = "SUBPROGRAM Part{#A : LREAL, #S : STRING}\nN1 X#A\nEND_SUBPROGRAM\n";
  EXPECT_EQ(codesys("N1 G1 F100 X1\nN2 Part{2}\nN3 X9\n" + sub), "l1,0,0 | call-arguments");
  EXPECT_EQ(codesys("N1 G1 F100 X1\nN2 Part{2, 3}\nN3 X9\n" + sub), "l1,0,0 | call-arguments");
  EXPECT_EQ(codesys("N1 G1 F100 X1\nN2 Part{2, 'a'}\nN3 X9\n" + sub), "l1,0,0 l2,0,0 l9,0,0");
  EXPECT_EQ(codesys("N1 G1 F100 X1\nN2 Part{2, 'a'} X4\nN3 X9\n" + sub), "l1,0,0 | statement");
  EXPECT_EQ(codesys("N1 G1 F100 X1\nN2 Part{}\nSUBPROGRAM Part{}\nN1 Part{}\nEND_SUBPROGRAM\n"),
            "l1,0,0 | subprogram-depth");
  InterpOptions options = at_origin(Dialect::codesys);
  options.max_steps = 100;
  EXPECT_EQ(codes(read_text("N1 G1 F100 X1\nN2 G20 L2\n", options)), "program-endless");
}

TEST(CodesysLanguage, LocalVariablesBeginWithAValue) {
  EXPECT_EQ(codesys("LET #A : LREAL := 10\nLET #B : LREAL := #A + sqrt{16} (* 14 *)\n"
                    "LET #C : BOOL := #A > 3\nN1 G1 X#B Y#A Z#C F100\nN2 X sqrt{16}\n"),
            "l14,10,1 l4,10,1");
  EXPECT_EQ(codesys("LET #A : LREAL := 'x'\n"), " | variable-unset");
  for (const char* other : {"LET #A=10\n", "LET #A : LREAL\nN1 #A=10\n"}) {
    const Program p = read_text(other, at_origin(Dialect::codesys));
    ASSERT_FALSE(p.diagnostics.empty());
    EXPECT_NE(p.diagnostics[0].text.find(other[4] == '#' && other[6] == '=' ? ":=" : "G36 O#A"),
              std::string::npos)
        << p.diagnostics[0].text;
  }
}

TEST(CodesysLanguage, NoAxisMovesUnsaid) {
  EXPECT_EQ(codesys("N1 G1 F100 X1 A5\n"), " | not-supported");
  EXPECT_EQ(codesys("N1 G1 F100 X1 C0\n"), "l1,0,0");
  EXPECT_EQ(codesys("N1 G1 F100 X1 P5 Q1\nN2 X2 P6\n"),
            "l1,0,0 l2,0,0 | auxiliary-axis auxiliary-axis");
  EXPECT_EQ(codesys("N1 G1 F100 X1 W0\n"), "l1,0,0");
}

TEST(CodesysLanguage, ATextIsNoPlace) {
  EXPECT_EQ(codesys("LET #S : STRING := 'abc'\nN1 G1 F100 X1\nN2 X#S Y5\n"), "l1,0,0 | expression");
}

TEST(CodesysLanguage, WordsThatShapeTheSpeedAreTold) {
  const Program p =
      read_text("N1 G1 F100 X1 E30 E-30 S1 FF2000\nN2 X2 EF5\n", at_origin(Dialect::codesys));
  const auto told = std::count_if(p.diagnostics.begin(), p.diagnostics.end(),
                                  [](const Diagnostic& d) { return d.code == "dynamics-unread"; });
  EXPECT_EQ(told, 3);
}

TEST(CodesysLanguage, BracesStandRightBehindAWordOrAName) {
  EXPECT_EQ(codesys("N1G1X{2*3}Y{4}F100\nG1X{1}\n"), "l6,4,0 l1,4,0") << "no blank between words";
  const std::string sub = "{3}\nN2 M30\nSUBPROGRAM ";
  const std::string body = "{#A : LREAL}\nN10 G1 X#A F100\nEND_SUBPROGRAM\n";
  for (const std::string name : {"SQ", "CNC2", "G1X2Y"})
    EXPECT_EQ(codesys("N1 " + name + sub + name + body), "l3,0,0") << name;
}

}  // namespace
}  // namespace mrsim
