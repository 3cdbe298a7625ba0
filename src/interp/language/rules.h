// The arithmetic of each control as tables: operators with their precedence, functions with their
// arguments. No logic.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace mrsim {

enum class Operator : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  divide_whole,  ///< SINUMERIK DIV
  remainder,     ///< sign of the dividend
  remainder_up,  ///< LinuxCNC MOD: never negative
  power,
  equal,
  unequal,
  less,
  less_equal,
  greater,
  greater_equal,
  bits_and,
  bits_or,
  bits_xor,
  both,  ///< truth values
  either,
  one_of,
  join,   ///< SINUMERIK <<, CODESYS CONCAT
  chain,  ///< SINUMERIK : of frames
};

enum class Function : std::uint8_t {
  sine,
  cosine,
  tangent,
  arc_sine,
  arc_cosine,
  arc_tangent,
  itself,  ///< SINUMERIK: QU of M=QU(8) says when M is output
  absolute,
  square_root,
  square,
  exponential,
  logarithm,
  logarithm_ten,
  power,
  argument,  ///< Fagor ARG(x,y): the angle of the point, 0 to 360
  round,
  floor,         ///< LinuxCNC FIX
  ceiling,       ///< LinuxCNC FUP
  truncate,      ///< towards 0
  away,          ///< away from 0
  next_whole,    ///< Fagor FUP, which its manual explains for numbers above 0
  from_decimal,  ///< BIN: binary-coded decimal to number
  to_decimal,    ///< BCD
  exists,        ///< LinuxCNC EXISTS[#<name>], SINUMERIK ISVAR("NAME")
  smallest,
  largest,
  bound,
  to_number,
  is_number,
  text_length,
  upper_text,
  lower_text,
  text_index,
  text_rindex,
  text_first_of,
  text_match,
  part_of_text,
  as_text,
  frame_trans,
  frame_rot,
  frame_scale,
  frame_mirror,
  frame_inverse,
  tool_decimals,  ///< FANUC ADP: gives the value unchanged
  join_text,      ///< CODESYS CONCAT
};

/// How variables are written.
enum class Spelling : std::uint8_t {
  hash,       ///< #1
  names,      ///< R1, NAME, $NAME
  parameter,  ///< P1
  plc,        ///< $NAME$ of the controller, #NAME of the program
};

struct OperatorRow {
  std::string_view name;
  Operator op;
  int level;  ///< a higher level binds more closely
};

struct FunctionRow {
  std::string_view name;
  Function function;
  int least = 1, most = 1;  ///< arguments
};

/// The arithmetic of one control.
struct ExpressionRules {
  char open = '[', close = ']';
  std::span<const OperatorRow> operators;
  std::span<const FunctionRow> functions;
  Spelling spelling = Spelling::hash;
  bool named_hash = false;      ///< #<name>
  bool glued_blanks = true;     ///< blanks mean nothing, even inside a number
  bool comments = false;        ///< ( ) is a comment, between operands as well
  bool abbreviated = false;     ///< two letters of a function's name are enough
  bool vacant_is_zero = false;  ///< a vacant operand counts as 0
  bool bare_functions = false;  ///< SIN 30 without brackets
  bool plain_names = false;     ///< VC1, DIA: variables of Okuma
  bool radians = false;         ///< angles of functions; else degrees
  bool full_turn = false;       ///< the arc tangent of two arguments is 0 to 360
  bool arc_sine_full = false;   ///< ASIN is 270 to 90, written as 0 to 360
  bool compares_once = false;   ///< two comparisons without brackets are a fault
  double equal_within = 0;      ///< absolute tolerance of = and its opposite
  double equal_relative = 0;    ///< relative tolerance of =, too
  std::string_view zero_divide_alarm, range_alarm;
};

/// The rules of each control.
const ExpressionRules& linuxcnc_rules();
const ExpressionRules& fanuc_rules();
const ExpressionRules& sinumerik_rules();
const ExpressionRules& fagor_rules();
const ExpressionRules& codesys_rules();

}  // namespace mrsim
