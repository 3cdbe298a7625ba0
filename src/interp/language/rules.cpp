#include "interp/language/rules.h"

namespace mrsim {
namespace {

using O = Operator;
using F = Function;

// LinuxCNC: ** binds before * / MOD, these before + -, these before comparisons, these before AND
// OR XOR. Operators of one level are evaluated from the left.
constexpr OperatorRow kLinuxcnc[] = {
    {"**", O::power, 5},         {"*", O::multiply, 4}, {"/", O::divide, 4},
    {"MOD", O::remainder_up, 4}, {"+", O::add, 3},      {"-", O::subtract, 3},
    {"EQ", O::equal, 2},         {"NE", O::unequal, 2}, {"GT", O::greater, 2},
    {"GE", O::greater_equal, 2}, {"LT", O::less, 2},    {"LE", O::less_equal, 2},
    {"AND", O::both, 1},         {"OR", O::either, 1},  {"XOR", O::one_of, 1},
};

constexpr FunctionRow kLinuxcncFunctions[] = {
    {"ABS", F::absolute},     {"ACOS", F::arc_cosine}, {"ASIN", F::arc_sine},
    {"ATAN", F::arc_tangent}, {"COS", F::cosine},      {"EXISTS", F::exists},
    {"EXP", F::exponential},  {"FIX", F::floor},       {"FUP", F::ceiling},
    {"LN", F::logarithm},     {"ROUND", F::round},     {"SIN", F::sine},
    {"SQRT", F::square_root}, {"TAN", F::tangent},
};

// FANUC: * / AND MOD bind before + - OR XOR, and these before comparisons.
constexpr OperatorRow kFanucOperators[] = {
    {"*", O::multiply, 3},    {"/", O::divide, 3},      {"AND", O::bits_and, 3},
    {"MOD", O::remainder, 3}, {"+", O::add, 2},         {"-", O::subtract, 2},
    {"OR", O::bits_or, 2},    {"XOR", O::bits_xor, 2},  {"EQ", O::equal, 1},
    {"NE", O::unequal, 1},    {"GT", O::greater, 1},    {"GE", O::greater_equal, 1},
    {"LT", O::less, 1},       {"LE", O::less_equal, 1},
};

constexpr FunctionRow kFanucFunctions[] = {
    {"SIN", F::sine},          {"COS", F::cosine},      {"TAN", F::tangent},
    {"ASIN", F::arc_sine},     {"ACOS", F::arc_cosine}, {"ATAN", F::arc_tangent, 1, 2},
    {"SQRT", F::square_root},  {"SQR", F::square_root}, {"ABS", F::absolute},
    {"BIN", F::from_decimal},  {"BCD", F::to_decimal},  {"ROUND", F::round},
    {"RND", F::round},         {"FIX", F::truncate},    {"FUP", F::away},
    {"LN", F::logarithm},      {"EXP", F::exponential}, {"POW", F::power, 2, 2},
    {"ADP", F::tool_decimals},
};

// SINUMERIK, from the closest binding on: the colon of frames, NOT and B_NOT (operands), * / DIV
// MOD,
// + -, B_AND, B_XOR, B_OR, AND, XOR, OR, <<, comparisons.
constexpr OperatorRow kSinumerikOperators[] = {
    {":", O::chain, 12},       {"*", O::multiply, 10},
    {"/", O::divide, 10},      {"DIV", O::divide_whole, 10},
    {"MOD", O::remainder, 10}, {"+", O::add, 9},
    {"-", O::subtract, 9},     {"B_AND", O::bits_and, 8},
    {"B_XOR", O::bits_xor, 7}, {"B_OR", O::bits_or, 6},
    {"AND", O::both, 5},       {"XOR", O::one_of, 4},
    {"OR", O::either, 3},      {"<<", O::join, 2},
    {"==", O::equal, 1},       {"<>", O::unequal, 1},
    {"<=", O::less_equal, 1},  {">=", O::greater_equal, 1},
    {"<", O::less, 1},         {">", O::greater, 1},
};

constexpr FunctionRow kSinumerikFunctions[] = {
    {"SIN", F::sine},
    {"COS", F::cosine},
    {"TAN", F::tangent},
    {"ASIN", F::arc_sine},
    {"ACOS", F::arc_cosine},
    {"ATAN2", F::arc_tangent, 2, 2},
    {"SQRT", F::square_root},
    {"POT", F::square},
    {"ABS", F::absolute},
    {"TRUNC", F::truncate},
    {"ROUND", F::round},
    {"ROUNDUP", F::ceiling},
    {"QU", F::itself},
    {"LN", F::logarithm},
    {"EXP", F::exponential},
    {"MINVAL", F::smallest, 2, 2},
    {"MAXVAL", F::largest, 2, 2},
    {"BOUND", F::bound, 3, 3},
    {"NUMBER", F::to_number},
    {"ISNUMBER", F::is_number},
    {"ISVAR", F::exists},
    {"STRLEN", F::text_length},
    {"TOUPPER", F::upper_text},
    {"TOLOWER", F::lower_text},
    {"INDEX", F::text_index, 2, 2},
    {"RINDEX", F::text_rindex, 2, 2},
    {"MINDEX", F::text_first_of, 2, 2},
    {"MATCH", F::text_match, 2, 2},
    {"SUBSTR", F::part_of_text, 2, 3},
    {"AXSTRING", F::as_text},
    {"AXNAME", F::upper_text},
    {"CTRANS", F::frame_trans, 2, 16},
    {"CROT", F::frame_rot, 2, 16},
    {"CSCALE", F::frame_scale, 2, 16},
    {"CMIRROR", F::frame_mirror, 1, 8},
    {"INVFRAME", F::frame_inverse},
};

// Fagor 8055, from the closest binding on: NOT, functions and signs (operands), EXP MOD, * /, + -,
// comparisons, AND XOR, OR.
constexpr OperatorRow kFagor[] = {
    {"EXP", O::power, 6},        {"MOD", O::remainder, 6}, {"*", O::multiply, 5},
    {"/", O::divide, 5},         {"+", O::add, 4},         {"-", O::subtract, 4},
    {"EQ", O::equal, 3},         {"NE", O::unequal, 3},    {"GT", O::greater, 3},
    {"GE", O::greater_equal, 3}, {"LT", O::less, 3},       {"LE", O::less_equal, 3},
    {"AND", O::bits_and, 2},     {"XOR", O::bits_xor, 2},  {"OR", O::bits_or, 1},
};

constexpr FunctionRow kFagorFunctions[] = {
    {"SIN", F::sine},           {"COS", F::cosine},      {"TAN", F::tangent},
    {"ASIN", F::arc_sine},      {"ACOS", F::arc_cosine}, {"ATAN", F::arc_tangent},
    {"ARG", F::argument, 2, 2}, {"ABS", F::absolute},    {"LOG", F::logarithm_ten},
    {"SQRT", F::square_root},   {"ROUND", F::round},     {"FIX", F::truncate},
    {"FUP", F::next_whole},     {"BCD", F::to_decimal},  {"BIN", F::from_decimal},
};

// CODESYS, from the closest binding on: NOT and functions (operands), MOD, * /, + -, comparisons,
// AND, XOR, OR.
constexpr OperatorRow kCodesysOperators[] = {
    {"MOD", O::remainder, 14}, {"*", O::multiply, 13},
    {"/", O::divide, 13},      {"+", O::add, 12},
    {"-", O::subtract, 12},    {"=", O::equal, 10},
    {"<>", O::unequal, 10},    {">", O::greater, 10},
    {"<", O::less, 10},        {">=", O::greater_equal, 10},
    {"<=", O::less_equal, 10}, {"AND", O::both, 6},
    {"XOR", O::one_of, 5},     {"OR", O::either, 4},
};

constexpr FunctionRow kCodesysFunctions[] = {
    {"SIN", F::sine},          {"COS", F::cosine},
    {"TAN", F::tangent},       {"ASIN", F::arc_sine},
    {"ACOS", F::arc_cosine},   {"ATAN", F::arc_tangent},
    {"ABS", F::absolute},      {"SQRT", F::square_root},
    {"LN", F::logarithm},      {"LOG", F::logarithm_ten},
    {"EXP", F::exponential},   {"EXPT", F::power, 2, 2},
    {"TRUNC", F::truncate},    {"MIN", F::smallest, 2, 2},
    {"MAX", F::largest, 2, 2}, {"CONCAT", F::join_text, 2, 2},
};

}  // namespace

const ExpressionRules& linuxcnc_rules() {
  static const ExpressionRules kRules = [] {
    ExpressionRules rules;
    rules.operators = kLinuxcnc;
    rules.functions = kLinuxcncFunctions;
    rules.named_hash = true;
    rules.equal_within = 1e-4;
    return rules;
  }();
  return kRules;
}

const ExpressionRules& fanuc_rules() {
  static const ExpressionRules kRules = [] {
    ExpressionRules rules;
    rules.operators = kFanucOperators;
    rules.functions = kFanucFunctions;
    rules.abbreviated = rules.vacant_is_zero = rules.plain_names = rules.comments = true;
    rules.full_turn = rules.arc_sine_full = rules.compares_once = true;
    rules.zero_divide_alarm = " (alarm 112)";
    rules.range_alarm = " (alarm 119)";
    return rules;
  }();
  return kRules;
}

const ExpressionRules& sinumerik_rules() {
  static const ExpressionRules kRules = [] {
    ExpressionRules rules;
    rules.open = '(';
    rules.close = ')';
    rules.operators = kSinumerikOperators;
    rules.functions = kSinumerikFunctions;
    rules.spelling = Spelling::names;
    rules.glued_blanks = false;
    rules.compares_once = true;
    rules.equal_relative = 1e-12;
    rules.zero_divide_alarm = rules.range_alarm = " (alarm 14051)";
    return rules;
  }();
  return kRules;
}

const ExpressionRules& fagor_rules() {
  static const ExpressionRules kRules = [] {
    ExpressionRules rules;
    rules.open = '(';
    rules.close = ')';
    rules.operators = kFagor;
    rules.functions = kFagorFunctions;
    rules.spelling = Spelling::parameter;
    rules.glued_blanks = false;
    rules.bare_functions = true;
    return rules;
  }();
  return kRules;
}

const ExpressionRules& codesys_rules() {
  static const ExpressionRules kRules = [] {
    ExpressionRules rules;
    rules.open = '{';
    rules.close = '}';
    rules.operators = kCodesysOperators;
    rules.functions = kCodesysFunctions;
    rules.spelling = Spelling::plc;
    rules.glued_blanks = false;
    rules.bare_functions = rules.radians = true;
    return rules;
  }();
  return kRules;
}

}  // namespace mrsim
