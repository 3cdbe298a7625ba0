// Expressions of each control against results from the manuals and from arithmetic by hand.
#include "core/numbers/exponential.h"
#include "interp/language/evaluator.h"
#include "interp/language/variables.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

struct ExpressionCase {
  const char* text;
  double value;
};

/// "fault" at the column (1-based) where it is, else the value.
struct Outcome {
  bool ok;
  Value value;
  Fault fault;
  std::size_t end;
};

Outcome evaluate(const ExpressionRules& rules, Variables& variables, const std::string& text) {
  Evaluator evaluator(rules, variables);
  Outcome out{};
  std::size_t p = 0;
  out.ok = evaluator.expression(text, p, out.value);
  out.end = p;
  if (!out.ok) out.fault = evaluator.fault();
  return out;
}

void expect_all(const ExpressionRules& rules, Variables& variables,
                std::span<const ExpressionCase> cases) {
  for (const ExpressionCase& one : cases) {
    SCOPED_TRACE(one.text);
    const Outcome got = evaluate(rules, variables, one.text);
    ASSERT_TRUE(got.ok) << got.fault.text;
    EXPECT_EQ(got.end, std::string(one.text).size());
    EXPECT_TRUE(got.value.is_number());
    EXPECT_NEAR(got.value.number, one.value, 1e-14 * std::max(1.0, std::abs(one.value)));
  }
}

Variables linuxcnc_variables() {
  Variables v(VariableForm::linuxcnc);
  std::string why;
  v.assign(1, Value::of(2), why);
  v.assign(2, Value::of(5), why);
  v.assign(5, Value::of(-1.5), why);
  v.assign(100, Value::of(30), why);
  v.assign("a", {}, Value::of(7), why);
  v.assign("_globalname", {}, Value::of(8), why);
  return v;
}

TEST(Expression, LinuxCncExpressionsHaveTheirValues) {
  // clang-format off
  constexpr ExpressionCase kCases[] = {
      {"1", 1}, {"1.5", 1.5}, {".5", 0.5}, {"5.", 5}, {"-3", -3}, {"+3", 3}, {"--5", 5},
      {"-+5", -5}, {"1 2.3 4", 12.34}, {"1000000", 1e6}, {"0.000001", 1e-6},
      {"1+2", 3}, {"1-2", -1}, {"2*3", 6}, {"7/2", 3.5}, {"1+2*3", 7}, {"[1+2]*3", 9},
      {"10-4-3", 3}, {"16/4/2", 2}, {"2*3/4", 1.5}, {"1-2+3", 2}, {"2+3-4*5/2", -5},
      {"2**3", 8}, {"2**3**2", 64}, {"2*3**2", 18}, {"-2**2", 4}, {"4**0.5", 2}, {"2**-1", 0.5},
      {"0**0", 1}, {"0**2", 0}, {"[-2]**3", -8}, {"10**3", 1000},
      {"7 mod 3", 1}, {"-7 mod 3", 2}, {"7 mod -3", 1}, {"7.5MOD2", 1.5}, {"2*7mod4", 2},
      {"1 EQ 1", 1}, {"1 EQ 1.00005", 1}, {"1 EQ 1.001", 0}, {"1 NE 2", 1}, {"1 NE 1.00005", 0},
      {"1 LT 2", 1}, {"2LT2", 0}, {"2 LE 2", 1}, {"3 GT 2", 1}, {"2 GT 2", 0}, {"2 GE 2", 1},
      {"1 ge 2", 0}, {"5 le 0.01", 0}, {"1+1 EQ 2", 1}, {"2*2 GT 3+0", 1},
      {"1 AND 1", 1}, {"1 AND 0", 0}, {"2 AND 3", 1}, {"0 OR 0", 0}, {"0 OR 5", 1},
      {"1 XOR 1", 0}, {"1 XOR 0", 1}, {"0 xor 0", 0}, {"1 LT 2 AND 3 LT 4", 1},
      {"1 OR 0 AND 0", 0}, {"1 GT 2 OR 2 GT 1", 1},
      {"abs[-2.5]", 2.5}, {"ABS[3]", 3}, {"acos[0.5]", 60}, {"ACOS[-1]", 180}, {"acos[1]", 0},
      {"ASIN[0.5]", 30}, {"asin[-0.5]", -30}, {"ASIN[1]", 90}, {"atan[1]/[1]", 45},
      {"ATAN[1]/[-1]", 135}, {"atan[-1]/[-1]", -135}, {"ATAN[0]/[-1]", 180}, {"atan[2]/[0]", 90},
      {"cos[60]", 0.5}, {"COS[0]", 1}, {"cos[90]", 0}, {"cos[180]", -1}, {"sin[30]", 0.5},
      {"SIN[90]", 1}, {"sin[-90]", -1}, {"sin[180]", 0}, {"tan[45]", 1}, {"TAN[-45]", -1},
      {"exp[0]", 1}, {"EXP[1]", 2.718281828459045}, {"ln[1]", 0}, {"LN[10]", 2.302585092994046},
      {"ln[exp[2]]", 2}, {"fix[2.8]", 2}, {"FIX[-2.8]", -3}, {"fup[2.8]", 3}, {"FUP[-2.8]", -2},
      {"fix[3]", 3}, {"round[2.5]", 3}, {"ROUND[-2.5]", -3}, {"round[2.4]", 2}, {"round[-0.4]", 0},
      {"sqrt[3]", 1.7320508075688772}, {"SQRT[12.0]", 3.4641016151377544}, {"sqrt[0]", 0},
      {"2*sin[30]+1", 2}, {"-sin[30]", -0.5}, {"-[2+3]", -5}, {"+[2]", 2}, {"[[2]]", 2},
      {"1 + [2 * 3 - 4 ** [6 / 3]]", -9},
      {"#1", 2}, {"#2+1", 6}, {"-#1", -2}, {"##1", 5}, {"#[1+1]", 5}, {"#[#1*1]", 5}, {"#5", -1.5},
      {"#1**#1", 4}, {"#<a>", 7}, {"#< A >", 7}, {"#<_globalname>", 8}, {"#<_GLOBAL NAME>*2", 16},
      {"EXISTS[#1]", 1}, {"exists[#99999]", 0}, {"EXISTS[#<a>]", 1}, {"EXISTS[#<b>]", 0},
      {"#100/2", 15}, {"#31", 0}, {"[#1 EQ 2] AND [#2 NE 2]", 1}, {"#sqrt[4]", 5},
  };
  // clang-format on
  Variables variables = linuxcnc_variables();
  expect_all(linuxcnc_rules(), variables, kCases);
}

TEST(Expression, FanucExpressionsHaveTheirValues) {
  // clang-format off
  constexpr ExpressionCase kCases[] = {
      {"1", 1}, {"#1", 2}, {"-#1", -2}, {"#1+#2", 7}, {"#1*#2", 10}, {"#2/#1", 2.5}, {"#1-#2", -3},
      {"#1+#2*3", 17}, {"[#1+#2]*3", 21}, {"#[#1]", 5}, {"#[#1-1]", 2}, {"##1", 5},
      {"12 AND 10", 8}, {"12 OR 10", 14}, {"12XOR10", 6}, {"1 + 12 AND 10", 9}, {"1 OR 2*2", 5},
      {"7 MOD 3", 1}, {"-7 MOD 3", -1}, {"#2MOD#1", 1},
      {"SIN[30]", 0.5}, {"COS[60]", 0.5}, {"TAN[45]", 1}, {"SIN[#100]", 0.5}, {"COS[180]", -1},
      {"ASIN[0.5]", 30}, {"ASIN[-0.5]", 330}, {"ASIN[-1]", 270}, {"ACOS[0.5]", 60},
      {"ACOS[-0.5]", 120}, {"ATAN[1]/[1]", 45}, {"ATAN[-1]/[-1]", 225}, {"ATAN[1]/[-1]", 135},
      {"ATAN[-1]/[1]", 315}, {"ATAN[1,-1]", 135}, {"ATAN[1]", 45}, {"ATAN[-1]", -45},
      {"ATAN[0]/[-1]", 180}, {"SQRT[16]", 4}, {"SQR[16]", 4}, {"SQRT[#1*#1+#2*#2]", std::sqrt(29.0)},
      {"ABS[-3.2]", 3.2}, {"ROUND[1.5]", 2}, {"ROUND[-1.5]", -2}, {"ROUND[1.4]", 1}, {"RND[2.5]", 3},
      {"FIX[1.2]", 1}, {"FIX[-1.2]", -1}, {"FUP[1.2]", 2}, {"FUP[-1.2]", -2}, {"FUP[2]", 2},
      {"LN[1]", 0}, {"EXP[0]", 1}, {"EXP[LN[7]]", 7}, {"POW[2,10]", 1024}, {"POW[9,0.5]", 3},
      {"BIN[18]", 12}, {"BCD[12]", 18}, {"BCD[1234]", 4660}, {"BIN[4660]", 1234},
      {"SI[30]", 0.5}, {"CO[60]", 0.5}, {"RO[1.6]", 2}, {"FU[1.1]", 2}, {"AB[-1]", 1},
      {"1 EQ 1", 1}, {"1 NE 1", 0}, {"2 GT 1", 1}, {"2 GE 2", 1}, {"1 LT 2", 1}, {"3 LE 2", 0},
      {"#1 EQ 2", 1}, {"#1EQ#0", 0}, {"#1NE#0", 1}, {"#0 EQ #0", 1}, {"#33 EQ #0", 1},
      {"#33 NE #0", 0}, {"#130 EQ #0", 1}, {"#33 EQ 0", 0}, {"#33 NE 0", 1}, {"#33 + 1", 1},
      {"#33*5", 0}, {"#33 GE 0", 1}, {"[#1 GT 1] AND [#2 GT 1]", 1}, {"[#1 GT 5]OR[#2 GT 1]", 1},
      {"SIN[30]*2", 1}, {"-SIN[30]", -0.5}, {"2*-3", -6}, {"10-2-3", 5}, {"100/10/5", 2},
      {"[[2+3]*[4-1]]", 15}, {"1 . 5 + 1", 2.5}, {"#100*#101", 120}, {"#101AND6", 4},
      {"#500", 12.5}, {"#500/ #101", 3.125}, {"ABS[#3]", 3}, {"-ABS[#3]", -3}, {"FIX[#500]", 12},
  };
  // clang-format on
  Variables variables(VariableForm::fanuc);
  std::string why;
  variables.enter_level();
  for (const auto& [number, value] :
       {std::pair{1, 2.0}, {2, 5.0}, {3, -3.0}, {100, 30.0}, {101, 4.0}, {500, 12.5}})
    ASSERT_TRUE(variables.assign(number, Value::of(value), why)) << why;
  expect_all(fanuc_rules(), variables, kCases);
}

Variables sinumerik_variables() {
  Variables v(VariableForm::sinumerik);
  std::string why;
  for (const auto& [number, value] : {std::pair{1, 10.0}, {2, 3.0}, {3, 0.5}, {10, 30.0}})
    v.assign(number, Value::of(value), why);
  v.define("WIDTH", VariableType::real, {}, false, why);
  v.assign("width", {}, Value::of(12.5), why);
  v.define("COUNT", VariableType::integer, {}, false, why);
  v.assign("COUNT", {}, Value::of(2.6), why);
  v.define("FIELD", VariableType::real, {2, 3, 0}, false, why);
  const Value at[] = {Value::of(1), Value::of(2)};
  v.assign("FIELD", at, Value::of(42), why);
  v.define("NAME", VariableType::text, {}, false, why);
  v.assign("NAME", {}, Value::of_text("POCKET"), why);
  v.define("FLAG", VariableType::boolean, {}, false, why);
  v.assign("FLAG", {}, Value::of(17), why);
  return v;
}

TEST(Expression, SinumerikExpressionsHaveTheirValues) {
  // clang-format off
  constexpr ExpressionCase kCases[] = {
      {"1", 1}, {"R1", 10}, {"r2", 3}, {"R[1]", 10}, {"R[R2-2]", 10}, {"-R1", -10}, {"R1+R2", 13},
      {"R1-R2", 7}, {"R1*R2", 30}, {"R1/4", 2.5}, {"3/4", 0.75}, {"7/4", 1.75}, {"R1+R2*2", 16},
      {"(R1+R2)*2", 26}, {"10-4-3", 3}, {"7 DIV 4.1", 1}, {"3 DIV 4", 0}, {"7 DIV 4", 1},
      {"-7 DIV 2", -3}, {"3 MOD 4", 3}, {"7 MOD 4", 3}, {"-7 MOD 4", -3}, {"2*7 MOD 4", 2},
      {"SIN(30)", 0.5}, {"COS(60)", 0.5}, {"TAN(45)", 1}, {"ASIN(0.5)", 30}, {"ACOS(0.5)", 60},
      {"ATAN2(30.5,80.1)", 20.8455}, {"ATAN2(30,-80)", 159.444}, {"ATAN2(1,1)", 45},
      {"SQRT(16)", 4}, {"POT(-3)", 9}, {"ABS(-2.5)", 2.5}, {"TRUNC(2.9)", 2}, {"TRUNC(-2.9)", -2},
      {"ROUND(2.5)", 3}, {"ROUND(-2.4)", -2}, {"ROUNDUP(3.1)", 4}, {"ROUNDUP(3.6)", 4},
      {"ROUNDUP(-3.1)", -3}, {"ROUNDUP(-3.6)", -3}, {"LN(1)", 0}, {"EXP(0)", 1}, {"EXP(LN(5))", 5},
      {"MINVAL(3,5)", 3}, {"MAXVAL(3,5)", 5}, {"BOUND(0,10,12)", 10}, {"BOUND(0,10,-2)", 0},
      {"BOUND(0,10,5)", 5}, {"1EX3", 1000}, {"1.5EX-2", 0.015}, {"'HFF'", 255}, {"'B1001'", 9},
      {"1==1", 1}, {"1<>1", 0}, {"1<2", 1}, {"2>1", 1}, {"2>=2", 1}, {"2<=1", 0}, {"R1==10", 1},
      {"0.1+0.2==0.3", 1}, {"1==1.0000001", 0}, {"NOT 1", 0}, {"NOT 0", 1}, {"NOT(1==2)", 1},
      {"(R1>0) AND (R2<5)", 1}, {"(R1>0) AND (R2>5)", 0}, {"(R1<0) OR (R2<5)", 1},
      {"(1==1) XOR (2==2)", 0}, {"TRUE AND FALSE", 0}, {"TRUE", 1}, {"false", 0},
      {"NOT TRUE OR TRUE", 1}, {"12 B_AND 10", 8}, {"12 B_OR 10", 14}, {"12 B_XOR 10", 6},
      {"B_NOT 5", -6}, {"1 B_OR 2 B_AND 2", 3}, {"1+1 B_AND 3", 2}, {"0 OR 1 AND 0", 0},
      {"1 XOR 1 AND 0", 1}, {"1 OR 0 XOR 1", 1},
      {"WIDTH", 12.5}, {"width*2", 25}, {"COUNT", 3}, {"FIELD[1,2]", 42}, {"FIELD[COUNT-2,R2-1]", 42},
      {"FIELD[0,0]", 0}, {"FLAG", 1}, {"R1*SIN(R10)", 5}, {"-SIN(30)", -0.5}, {"R3*-2", -1},
      {"SQRT(POT(3)+POT(4))", 5}, {"2*(3+(4-1))", 12}, {"R1 + R2", 13}, {"R1/R2*R2", 10},
      {"NAME==\"POCKET\"", 1}, {"NAME<>\"SLOT\"", 1}, {"STRLEN(NAME)", 6}, {"NUMBER(\"1.5\")", 1.5},
      {"ISNUMBER(\"1.5\")", 1}, {"ISNUMBER(\"A\")", 0}, {"INDEX(NAME,\"K\")", 3},
      {"INDEX(NAME,\"Z\")", -1}, {"RINDEX(\"ABCB\",\"B\")", 3}, {"MINDEX(\"X12.5\",\".1\")", 1},
      {"MATCH(\"ABCD\",\"CD\")", 2}, {"MATCH(\"ABCD\",\"DC\")", -1}, {"\"A\"<\"B\"", 1}, {"SUBSTR(NAME,2,2)==\"CK\"", 1},
      {"TOLOWER(NAME)==\"pocket\"", 1}, {"\"A\"<<1==\"A1\"", 1}, {"\"A\"<<R3<<\"B\"==\"A0.5B\"", 1},
  };
  // clang-format on
  Variables variables = sinumerik_variables();
  for (const ExpressionCase& one : kCases) {
    SCOPED_TRACE(one.text);
    const Outcome got = evaluate(sinumerik_rules(), variables, one.text);
    ASSERT_TRUE(got.ok) << got.fault.text;
    EXPECT_EQ(got.end, std::string(one.text).size());
    // The manual prints ATAN2 with four decimals.
    EXPECT_NEAR(got.value.number, one.value,
                std::string(one.text).find("ATAN2(30") == 0 ? 5e-4 : 1e-12);
  }
}

// The examples of the 8055's programming manual, and what follows from its table of priorities.
TEST(Expression, FagorExpressionsHaveTheirValues) {
  // clang-format off
  constexpr ExpressionCase kCases[] = {
      {"3 + 4", 7}, {"5 - 2", 3}, {"-(2 * 3)", -6}, {"2 * 3", 6}, {"9 / 2", 4.5}, {"7 MOD 4", 3},
      {"2 EXP 3", 8}, {"SIN 30", 0.5}, {"COS 30", 0.8660254037844386}, {"TAN 30", 0.5773502691896257},
      {"ASIN 1", 90}, {"ACOS 1", 0}, {"ATAN 1", 45}, {"ARG(-1,-2)", 243.43494882292202},
      {"ABS -8", 8}, {"LOG 100", 2}, {"SQRT 16", 4}, {"ROUND 5.83", 6}, {"FIX 5.423", 5},
      {"FUP 7", 7}, {"FUP 5.423", 6}, {"BCD 234", 564}, {"BIN 564", 234},
      {"P1", 5}, {"-P1", -5}, {"P1+P2", 8}, {"p100*2", 60}, {"P1*(P2-1)", 10}, {"P1-P2-1", 1},
      {"2+3*4", 14}, {"2*3 EXP 2", 18}, {"7 MOD 4*2", 6}, {"-2 EXP 2", 4}, {"2 EXP 3 EXP 2", 64},
      {"SIN 30*2", 1}, {"SIN(30)*2", 1}, {"SIN P100", 0.5}, {"SQRT(P1*P1+12*12)", 13},
      {"ABS(-3)+1", 4}, {"FIX -5.4", -5}, {"ROUND -2.5", -3}, {"ATAN -1", -45}, {"ARG(1,0)", 0},
      {"ARG(0,1)", 90}, {"ARG(1,-1)", 315}, {"LOG 0.001", -3}, {"LOG 1000", 3},
      {"P1 EQ 5", 1}, {"P1 NE 5", 0}, {"P1 GT P2", 1}, {"P1 LT P2", 0}, {"P1 GE 5", 1},
      {"P1 LE 4", 0}, {"P1 EQ 5 AND P2 EQ 3", 1}, {"P1 EQ 5 AND P2 EQ 4", 0},
      {"P1 EQ 4 OR P2 EQ 3", 1}, {"P1 EQ 5 XOR P2 EQ 3", 0}, {"NOT (P1 EQ 5)", 0},
      {"NOT (P1 EQ 4) AND P2 LT 4", 1}, {"1 OR 0 AND 0", 1}, {"12 AND 10", 8}, {"12 OR 3", 15},
      {"P1+1 EQ 2*P2", 1}, {"((2))", 2}, {"1.5+.5", 2},
  };
  // clang-format on
  Variables variables(VariableForm::fagor);
  std::string why;
  for (const auto& [number, value] : {std::pair{1, 5.0}, {2, 3.0}, {100, 30.0}})
    ASSERT_TRUE(variables.assign(number, Value::of(value), why)) << why;
  expect_all(fagor_rules(), variables, kCases);
}

// Angles are in radians, as everywhere in IEC 61131.
TEST(Expression, CodesysExpressionsHaveTheirValues) {
  // clang-format off
  constexpr ExpressionCase kCases[] = {
      {"1", 1}, {"1 + 2 * 3", 7}, {"{1 + 2} * 3", 9}, {"10 - 4 - 3", 3}, {"16 / 4 / 2", 2},
      {"2 * 7 MOD 4", 6}, {"7 MOD 4", 3}, {"-7 MOD 4", -3}, {"7.5 MOD 2", 1.5}, {"-{2 + 3}", -5},
      {"$a$", 3}, {"$A$ * 2", 6}, {"#r", 25}, {"#R*2", 50}, {"-#R*2", -50}, {"#R/$a$*3", 25},
      {"$app.fb.x$ + 1", 8}, {"sin{0}", 0}, {"sin 0", 0}, {"sin{pi / 2}", 1}, {"cos{pi}", -1},
      {"cos 0", 1}, {"tan{pi / 4}", 1}, {"asin{1}", 1.5707963267948966},
      {"acos{-1}", 3.141592653589793}, {"atan{1}", 0.7853981633974483}, {"atan -1", -0.7853981633974483},
      {"abs{-2}", 2}, {"abs -2", 2}, {"sqrt 16", 4}, {"sqrt{2 * 8} + 1", 5}, {"ln{1}", 0},
      {"log 100", 2}, {"exp 0", 1}, {"exp{1}", 2.718281828459045}, {"expt{2, 10}", 1024},
      {"expt{2, #R - 24}", 2}, {"trunc{2.9}", 2}, {"trunc -2.9", -2}, {"min{3, 5}", 3},
      {"max{3, 5}", 5}, {"pi", 3.141592653589793}, {"TRUE", 1}, {"false", 0},
      {"1 = 1", 1}, {"1 = 2", 0}, {"1 <> 2", 1}, {"1 < 2", 1}, {"2 > 3", 0}, {"2 >= 2", 1},
      {"3 <= 2", 0}, {"1 + 1 = 2", 1}, {"1 < 2 AND 2 < 3", 1}, {"1 < 2 AND 3 < 2", 0},
      {"1 > 2 OR 2 > 1", 1}, {"TRUE XOR TRUE", 0}, {"TRUE OR TRUE XOR TRUE", 1},
      {"TRUE XOR FALSE AND FALSE", 1}, {"NOT TRUE", 0}, {"NOT {1 = 2}", 1}, {"NOT FALSE AND TRUE", 1},
      {"'a' = 'a'", 1}, {"'a' <> 'b'", 1}, {"concat{'a', 'b'} = 'ab'", 1},
      {"concat{'prefix_', concat{#s, '_suffix'}} = 'prefix_x_suffix'", 1}, {"2.5 * -2", -5},
  };
  // clang-format on
  Variables variables(VariableForm::codesys);
  std::string why;
  ASSERT_TRUE(variables.assign("$a$", {}, Value::of(3), why)) << why;
  ASSERT_TRUE(variables.assign("$app.fb.x$", {}, Value::of(7), why)) << why;
  ASSERT_TRUE(variables.define("#R", VariableType::real, {}, false, why)) << why;
  ASSERT_TRUE(variables.assign("#r", {}, Value::of(25), why)) << why;
  ASSERT_TRUE(variables.define("#S", VariableType::text, {}, false, why)) << why;
  ASSERT_TRUE(variables.assign("#s", {}, Value::of_text("x"), why)) << why;
  expect_all(codesys_rules(), variables, kCases);
}

TEST(Expression, FaultsHaveTheirPlace) {
  struct Row {
    const char* text;
    const char* code;
    std::size_t from;
    const char* says;
  };
  const auto check = [](const ExpressionRules& rules, Variables& variables, const Row& row) {
    SCOPED_TRACE(row.text);
    const Outcome got = evaluate(rules, variables, row.text);
    ASSERT_FALSE(got.ok);
    EXPECT_STREQ(got.fault.code, row.code) << got.fault.text;
    EXPECT_EQ(got.fault.from, row.from) << got.fault.text;
    EXPECT_NE(got.fault.text.find(row.says), std::string::npos) << got.fault.text;
  };
  Variables linuxcnc = linuxcnc_variables();
  for (const Row& row : {Row{"1/0", "expression", 1, "division by 0"},
                         {"#1/[#2-5]", "expression", 2, "(#1 = 2, #2 = 5)"},
                         {"[1+2", "bracket", 0, "not closed with ]"},
                         {"SQRT[-1]", "expression", 0, "square root of -1"},
                         {"ASIN[2]", "expression", 0, "-1 to 1"},
                         {"LN[0]", "expression", 0, "logarithm"},
                         {"[-1]**0.5", "expression", 4, "fraction"},
                         {"EXISTS[1]", "expression", 7, "# expected"},
                         {"EXISTS[#1+#2]", "bracket", 9, "] expected"},
                         {"EXISTS[#<foo]", "bracket", 8, "not closed with >"},
                         {"#<b>", "variable-unset", 0, "never set"},
                         {"#99999", "variable-number", 0, "1 to 5601"},
                         {"#[1.5]", "variable-number", 0, "whole number"},
                         {"FOO[1]", "function-unknown", 0, "FOO is no function"},
                         {"ATAN[1]", "function-arguments", 0, "ATAN[y]/[x]"},
                         {"SIN 30", "expression", 0, "SIN[...]"},
                         {"1+", "expression", 2, "ends too early"},
                         {"1.2.3", "number-malformed", 0, "second point"}})
    check(linuxcnc_rules(), linuxcnc, row);
  Variables fanuc(VariableForm::fanuc);
  for (const Row& row : {Row{"#1+1", "variable-unset", 0, "--set '#1=1'"},
                         {"#500", "variable-unset", 0, "--set '#500=1'"},
                         {"#50", "variable-number", 0, "#33"},
                         {"5/0", "expression", 1, "alarm 112"},
                         {"[1 EQ 1 OR 2 EQ 2]", "expression", 13, "brackets"},
                         {"[1 GT 0 AND 2 LT 3]", "expression", 14, "brackets"}})
    check(fanuc_rules(), fanuc, row);
  Variables sinumerik = sinumerik_variables();
  for (const Row& row : {Row{"R7", "variable-unset", 0, "--set R7=1"},
                         {"LENGTH*2", "variable-unset", 0, "alarm 12550"},
                         {"FIELD[2,0]", "variable-unset", 0, "index 1"},
                         {"R1>0 AND R2<3", "expression", 11, "brackets"},
                         {"NAME+1", "expression", 0, "cannot be combined"},
                         {"SIN 30", "expression", 0, "SIN(...)"},
                         {"R1/(R2-3)", "expression", 2, "R1 = 10, R2 = 3"}})
    check(sinumerik_rules(), sinumerik, row);
  Variables fagor(VariableForm::fagor);
  for (const Row& row : {Row{"P7", "variable-unset", 0, "--set P7=1"},
                         {"P50", "variable-number", 0, "P100-P299"},
                         {"FUP -1.5", "expression", 0, "not known"},
                         {"NOT 2", "expression", 0, "conditions"},
                         {"ARG 1", "function-arguments", 0, "2 arguments"},
                         {"1/0", "expression", 1, "division by 0"}})
    check(fagor_rules(), fagor, row);
  Variables codesys(VariableForm::codesys);
  for (const Row& row : {Row{"$x$", "variable-unset", 0, "--set '$x$=1'"},
                         {"#x", "variable-unset", 0, "LET it"},
                         {"$x", "expression", 0, "closed with $"},
                         {"{1+2", "bracket", 0, "closed with }"},
                         {"foo{1}", "function-unknown", 0, "FOO"},
                         {"1/{2-2}", "expression", 1, "division by 0"}})
    check(codesys_rules(), codesys, row);
}

TEST(Expression, NestingIsBounded) {
  Variables variables(VariableForm::linuxcnc);
  for (const std::string unit : {"[", "-", "#", "SIN["}) {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += unit;
    EXPECT_STREQ(evaluate(linuxcnc_rules(), variables, text + "1").fault.code, "expression-deep");
  }
}

// Closed forms: exact where the manual is, and within two units of the last place of libm.
TEST(Exponential, AgreesWithLibm) {
  for (double x = -700; x < 700; x += 0.37)
    EXPECT_NEAR(exponential(x) / std::exp(x), 1, 4e-15) << x;
  for (double x = 1e-300; x < 1e300; x *= 3.7)
    EXPECT_NEAR(natural_logarithm(x), std::log(x), 1e-15 * std::max(1.0, std::abs(std::log(x))))
        << x;
  EXPECT_EQ(power(2, 10), 1024);
  EXPECT_EQ(power(10, -2), 0.01);
  EXPECT_EQ(power(-3, 3), -27);
  EXPECT_NEAR(power(2, 0.5), std::sqrt(2.0), 1e-15);
  EXPECT_EQ(exponential(1000), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace mrsim
