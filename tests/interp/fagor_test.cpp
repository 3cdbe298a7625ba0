// The language of the ISO family (Fagor 8055): parameters, and statements in brackets.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string fagor(const std::string& text) {
  return path_text(read_text(text, at_origin(Dialect::iso)));
}

TEST(FagorLanguage, ParametersStandWhereverNumbersDo) {
  EXPECT_EQ(fagor("(P1=5, P100=P1*2)\nG1 XP1 Y-P1 ZP100 F100\nX(P1+2) Y(SIN 30*P100)\nGP101 X1\n"),
            "l5,-5,10 l7,5,10 | variable-unset");
  EXPECT_EQ(fagor("N10 G1 X 10 F100\nG1 XP30 Y10\n"), "l10,0,0 | variable-number")
      << "there is no P30";
  EXPECT_EQ(fagor("(P1=1)\nG(P1) X5 F100\n(P2=3)\nGP2 X15 Y0 RP1\n"),
            "l5,0,0 | arc-radius-too-small");
}

TEST(FagorLanguage, LoopsEqualTheWrittenOutProgram) {
  std::string plain = "G1 X0 Y0 F100\n";
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      plain += fmt::format("X{} Y{}\nZ-{}\nZ1\n", column * 10, row * 5 + 1, row + 1);
  const std::string loops =
      "G1 X0 Y0 F100\n(P1=0)\nN10 (P2=0)\nN20 X(P2*10) Y(P1*5+1)\nZ-(P1+1)\nZ1\n(P2=P2+1)\n"
      "(IF P2 LT 4 GOTO N20)\n(P1=P1+1)\n(IF (P1 LT 3) GOTO N10)\nM30\n";
  EXPECT_EQ(fagor(loops), fagor(plain));
  const std::string parts =
      "G1 X0 Y0 F100\n(P1=0)\nN10 (P2=0)\nN20 X(P2*10) Y(P1*5+1)\nZ-(P1+1)\nZ1\n"
      "N30 (P2=P2+1)\n(RPT N20,N30) N3\nN40 (P1=P1+1)\n(IF P1 LT 3 GOTO N10)\nM30\n";
  EXPECT_EQ(fagor(parts), fagor(plain));
}

TEST(FagorLanguage, RepeatsOnceOrAsOftenAsSaid) {
  const std::string part = "G91 G1 F100\nN10 X1\nN20 Y2\n";
  EXPECT_EQ(fagor(part + "N30 (RPT N10,N20) N2 ; twice more\nX5\nM30\n"),
            "l1,0,0 l1,2,0 l2,2,0 l2,4,0 l3,4,0 l3,6,0 l8,6,0");
  EXPECT_EQ(fagor(part + "(RPT N10,N20)\nM30\n"), "l1,0,0 l1,2,0 l2,2,0 l2,4,0");
  EXPECT_EQ(fagor(part + "(RPT N20,N10)\nM30\n"), "l1,0,0 l1,2,0 | jump-target");
  EXPECT_EQ(fagor(part + "N10 X1\n(RPT N10,N20)\nM30\n"), "l1,0,0 l1,2,0 l2,2,0 | jump-target")
      << "two blocks N10: which one is meant nobody knows";
  EXPECT_EQ(fagor("G91 G1 F100\nN10 X1\nN20 (RPT N10,N20) N3\nM30\n").substr(0, 6), "l1,0,0");
}

TEST(FagorLanguage, PcallHasParametersOfItsOwn) {
  EXPECT_EQ(fagor("G1 F100 X1\n(P1=7)\n(PCALL 5, A2, P1=3, C(P1+1))\nZP1\n(CALL 6)\nZP1\nM30\n"
                  "(SUB 5)\nXP0 YP1 ZP2\n(P1=50)\n(RET)\n(SUB 6)\n(P1=9)\n(RET)\n"),
            "l1,0,0 l2,3,8 l2,3,7 l2,3,9")
      << "PCALL has parameters of its own, CALL those of its caller";
  EXPECT_EQ(
      fagor("G1 F100 X1\n(MCALL 4, B2)\nX2\nX3\n(MDOFF)\nX4\nM30\n(SUB 4)\nG91 ZP1\nG90\n(RET)\n"),
      "l1,0,0 l2,0,0 l2,0,2 l3,0,2 l3,0,4 l4,0,4");
  EXPECT_EQ(fagor("G1 F100 X1\n(CALL 8)\n"), "l1,0,0 | subprogram-missing");
  EXPECT_EQ(fagor("G1 F100 X1\n(CALL 8)\nM30\n(SUB 8)\n(CALL 8)\n(RET)\n"),
            "l1,0,0 | subprogram-depth");
  EXPECT_EQ(fagor("G1 F100 X1\n(SUB 8)\nX2\n(RET)\n"), "l1,0,0 | structure");
  EXPECT_EQ(fagor("G1 F100 X1\n(RET)\nX2\n"), "l1,0,0 | structure");
}

TEST(FagorLanguage, ConditionsChooseAnAction) {
  const auto of = [](const std::string& statement) {
    return fagor("(P1=2, P2=3)\n" + statement + "\nG1 F100 XP2\nM30\n(SUB 1)\n(P2=8)\n(RET)\n");
  };
  EXPECT_EQ(of("(IF P1 EQ 2 P2=4 ELSE P2=5)"), "l4,0,0");
  EXPECT_EQ(of("(IF P1 EQ 3 P2=4 ELSE P2=5)"), "l5,0,0");
  EXPECT_EQ(of("(IF P1*P2 GE 6 AND P1 NE P2 CALL 1)"), "l8,0,0");
  EXPECT_EQ(of("(IF NOT (P1 GT 1) OR P2 LT 3 CALL 1)"), "l3,0,0");
  EXPECT_EQ(of("(ERROR 5, \"NO STOCK\")"), " | program-alarm");
  EXPECT_EQ(of("(EXEC P5)"), " | not-supported");
}

TEST(FagorLanguage, FaultsHaveTheirPlaceAndValues) {
  const Program p = read_text("(P1=0)\nG1 F100 X1\nX(5/P1)\n", at_origin(Dialect::iso));
  ASSERT_EQ(codes(p), "expression");
  EXPECT_EQ(p.diagnostics.back().place.line, 3);
  EXPECT_NE(p.diagnostics.back().text.find("P1 = 0"), std::string::npos);
  const Program unset = read_text("G1 F100 X1\nXP1\nX3\n", at_origin(Dialect::iso));
  EXPECT_EQ(path_text(unset), "l1,0,0 l3,0,0 | variable-unset");
  EXPECT_NE(unset.diagnostics.back().text.find("--set P1=1"), std::string::npos);
  InterpOptions options = at_origin(Dialect::iso);
  options.variables = {{"P1", "6"}};
  EXPECT_EQ(path_text(read_text("G1 F100 XP1\n", options)), "l6,0,0");
  options.max_steps = 100;
  EXPECT_EQ(codes(read_text("G1 F100 X1\nN10 (GOTO N10)\n", options)), "program-endless");
}

// G87 and G88 are POCKET3 and POCKET4 between the same levels: J and K are half lengths, D lies
// between Z and the part.
TEST(Fagor, PocketsAreThoseOfTheirSizes) {
  const auto motions = [](const std::string& text, Dialect dialect) {
    return path_text(read_text("T1 D1 M6\nG0 X0 Y0 Z20\n" + text, at_origin(dialect)));
  };
  const auto iso = [&](const std::string& text) { return motions(text, Dialect::iso); };
  const auto sinumerik = [&](const std::string& text) { return motions(text, Dialect::sinumerik); };
  const std::string rectangle = "POCKET3(20,0,2,-5,40,30,,,,,2,,,,,1,11,4)\n";
  EXPECT_EQ(iso("F100\nG87 G98 X10 Y7 Z2 I-5 J20 K15 B2 C4 D2 H50 L.5 V20\nG91 X60\nG80\n"),
            sinumerik("F100\nX10 Y7\n" + rectangle + "G0 X70\n" + rectangle));
  EXPECT_EQ(iso("F100\nG91 G88 G99 X10 Y7 Z-18 I-7 J-12 B1.5 D2\n"),
            sinumerik("F100\nX10 Y7\nPOCKET4(2,0,2,-5,12,,,1.5,,,,,0,11)\n"));
  EXPECT_EQ(iso("F100\nG87 X10 Y7 Z2 I-5 J20 B2\n"), "r0,0,20 | value-missing");
  EXPECT_EQ(iso("F100\nG87 X10 Y7 Z2 I-5 J20 K4 B2\n"), "r0,0,20 r10,7,20 | value-range")
      << "the cutter has 10 mm";
  InterpOptions none = at_origin(Dialect::iso);
  none.table.tools.clear();
  const Program unknown = read_text("T3 D3 M6\nF100\nG88 Z2 I-5 J9 B1 D2\n", none);
  ASSERT_NE(listing(unknown).find("tool 3 cuts"), std::string::npos) << listing(unknown);
}

// The cycle in force at more places; its own block is the first of them.
TEST(Fagor, G60ToG65RepeatTheCycleAtTheirPlaces) {
  const auto holes = [](const std::string& places) {
    const std::string cycle = "F100\nG0 X0 Y0 Z20\nG81 G99 X10 Y20 Z2 I-8\n";
    const Program p = read_text("T1 D1 M6\n" + cycle + places + "\nG80\n", at_origin(Dialect::iso));
    std::string out;
    for (const Motion& m : p.motions)
      if (m.kind == MotionKind::line)
        out += fmt::format("{:.4g},{:.4g} ", m.end.x + 0.0, m.end.y + 0.0);
    return out + codes(p);
  };
  EXPECT_EQ(holes("G60 A30 X40 K3"), "10,20 27.32,30 44.64,40 ");
  EXPECT_EQ(holes("G60 X40 I20"), holes("G60 I20 K3"));
  EXPECT_EQ(holes("G60 X40 I15"), "10,20 value-range");
  EXPECT_EQ(holes("G62 X10 I5 Y8 D2"), "10,20 15,20 20,20 20,28 15,28 10,28 ");
  EXPECT_EQ(holes("G62 A90 X5 K2 J5 D2"), "10,20 10,25 5,25 5,20 ");
  EXPECT_EQ(holes("G63 X10 Y0 K4"), "10,20 20,10 30,20 20,30 ");
  EXPECT_EQ(holes("G63 X10 Y0 I90 C2"), "10,20 20,30 30,20 20,10 ");
  EXPECT_EQ(holes("G64 X0 Y-10 B180 I90 C0 F200"), "10,20 0,10 10,0 ");
  EXPECT_EQ(holes("G64 X0 Y-10 B-90 K2"), "10,20 20,10 ");
  EXPECT_EQ(holes("G60 X40 K3 P2"), "10,20 not-supported");
  EXPECT_EQ(holes("G80\nG60 X40 K3"), "10,20 not-supported") << "no cycle is in force";
}

// Values of the control's tables are no comments.
TEST(FagorLanguage, TablesThatAreSetAreErrors) {
  EXPECT_EQ(fagor("G1 F100 X5\n(ORGX54=5)\n"), "l5,0,0 | not-supported");
  EXPECT_EQ(fagor("G1 F100 X5\n(TOR1=4.98)\n"), "l5,0,0 | not-supported");
  EXPECT_EQ(fagor("(TOL=0.01)\n(ORG = CORNER)\nG1 F100 X5\n"), "l5,0,0");
}

// 8060 to 8070: what changes no path is read over, what does is an error by name.
TEST(FagorLanguage, InstructionsOfThe8070ThatMoveSomethingAreErrors) {
  EXPECT_EQ(
      fagor(
          "F100\nN10 #HSC ON [CONTERROR 0.01]\nG1 X5\n#MSG[\"HELLO\"]\n#HSC OFF\n#RTCP OFF\nX9\n"),
      "l5,0,0 l9,0,0");
  EXPECT_EQ(fagor("#CS ON [1][MODE 1, 0,0,0, 0,45,0]\n"), " | not-supported");
}

// They were comments: the program ran on.
TEST(FagorLanguage, AJumpMayGoToAComputedBlock) {
  const std::string blocks = "N10 G1 X1 F9\nN20 G1 X2 F9\nM30\n";
  EXPECT_EQ(fagor("(P1=2)\n(GOTO N(P1*10))\n" + blocks), "l2,0,0");
  EXPECT_EQ(fagor("(P1=20)\n(GOTO NP1)\n" + blocks), "l2,0,0");
  EXPECT_EQ(fagor("(P1=10)\nG91\nN10 G1 X1 F9\nN20 Y1\n(RPT NP1,N(P1+10)) N1\nM30\n"),
            "l1,0,0 l1,1,0 l2,1,0 l2,2,0");
  EXPECT_EQ(fagor("(GOTO NEXT SIDE)\n" + blocks), "l1,0,0 l2,0,0") << "a comment";
}

}  // namespace
}  // namespace mrsim
