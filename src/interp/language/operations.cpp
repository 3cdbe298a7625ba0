#include "interp/language/operations.h"

#include "core/numbers/exponential.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "interp/language/text_operations.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLargestAngle = 1e9, kLargestRadians = 1e7;
constexpr double kLargestBits = 9007199254740992.0;  // 2^53

bool equal(const ExpressionRules& rules, double a, double b) {
  const double gap = std::abs(a - b);
  return gap <= rules.equal_within ||
         gap <= rules.equal_relative * std::max(std::abs(a), std::abs(b));
}

bool bit_operator(Operator op, double& a, double b, std::string& why) {
  if (std::abs(a) > kLargestBits || std::abs(b) > kLargestBits)
    return fail(why, "too large for an operation on bits");
  const auto x = static_cast<std::int64_t>(nearest_whole(a));
  const auto y = static_cast<std::int64_t>(nearest_whole(b));
  a = static_cast<double>(op == Operator::bits_and  ? x & y
                          : op == Operator::bits_or ? x | y
                                                    : x ^ y);
  return true;
}

bool divide(const ExpressionRules& rules, Operator op, double& a, double b, std::string& why) {
  if (b == 0) return fail(why, fmt::format("division by 0{}", rules.zero_divide_alarm));
  switch (op) {
    case Operator::divide:
      a /= b;
      break;
    case Operator::divide_whole:
      a = std::trunc(a / b);
      break;
    default:
      a = std::fmod(a, b);
      if (op == Operator::remainder_up && a < 0) a += std::abs(b);
  }
  return true;
}

bool raise(double& a, double b, std::string& why) {
  if (a < 0 && b != std::floor(b))
    return fail(why, "a negative number has no power with a fraction as exponent");
  if (a == 0 && b < 0) return fail(why, "0 has no negative power");
  a = a == 0 ? (b == 0 ? 1.0 : 0.0) : power(a, b);
  return true;
}

bool number_operator(const ExpressionRules& rules, Operator op, double& a, double b,
                     std::string& why) {
  switch (op) {
    case Operator::add:
      a += b;
      return true;
    case Operator::subtract:
      a -= b;
      return true;
    case Operator::multiply:
      a *= b;
      return true;
    case Operator::equal:
      a = equal(rules, a, b);
      return true;
    case Operator::unequal:
      a = !equal(rules, a, b);
      return true;
    case Operator::less:
      a = a < b;
      return true;
    case Operator::less_equal:
      a = a <= b;
      return true;
    case Operator::greater:
      a = a > b;
      return true;
    case Operator::greater_equal:
      a = a >= b;
      return true;
    case Operator::both:
      a = a != 0 && b != 0;
      return true;
    case Operator::either:
      a = a != 0 || b != 0;
      return true;
    case Operator::one_of:
      a = (a != 0) != (b != 0);
      return true;
    case Operator::bits_and:
    case Operator::bits_or:
    case Operator::bits_xor:
      return bit_operator(op, a, b, why);
    case Operator::power:
      return raise(a, b, why);
    case Operator::join:
    case Operator::chain:
      return fail(why, "this operator is not for numbers");
    default:
      return divide(rules, op, a, b, why);
  }
}

bool trigonometric(const ExpressionRules& rules, Function function, double x, double& out,
                   std::string& why) {
  const double limit = rules.radians ? kLargestRadians : kLargestAngle;
  if (std::abs(x) > limit) return fail(why, "the angle is above a million turns");
  const SinCos sc = rules.radians ? sincos(x) : sincos_deg(x);
  if (function == Function::sine) {
    out = sc.sin;
  } else if (function == Function::cosine) {
    out = sc.cos;
  } else {
    if (sc.cos == 0)
      return fail(why, fmt::format("TAN of {:g} degrees is infinite{}", x, rules.range_alarm));
    out = sc.sin / sc.cos;
  }
  return true;
}

// The angle in the unit of the control's functions.
double angle_of(const ExpressionRules& rules, double radians) {
  return rules.radians ? radians : degrees(radians);
}

// The logarithm to the base 10, exact for powers of ten.
double logarithm_ten(double x) {
  const double log = natural_logarithm(x) / natural_logarithm(10), whole = nearest_whole(log);
  constexpr double kNearWhole = 1e-12;  // more than the rounding of the quotient of logarithms
  return std::abs(log - whole) < kNearWhole && power(10, std::abs(whole)) == (whole < 0 ? 1 / x : x)
             ? whole
             : log;
}

bool arc_function(const ExpressionRules& rules, Function function, double x, double& out,
                  std::string& why) {
  if (x < -1 || x > 1)
    return fail(
        why, fmt::format("{} of {:g}: the argument is -1 to 1{}",
                         function == Function::arc_sine ? "ASIN" : "ACOS", x, rules.range_alarm));
  const double other = std::sqrt((1 - x) * (1 + x));
  out = angle_of(rules,
                 function == Function::arc_sine ? mrsim::atan2(x, other) : mrsim::atan2(other, x));
  if (function == Function::arc_sine && rules.arc_sine_full && out < 0) out += 360;
  return true;
}

// Converts between a number and binary-coded decimal, in which each digit has four bits.
bool coded_decimal(bool decode, double x, double& out, std::string& why) {
  const double limit = decode ? 4294967295.0 : 99999999.0;
  if (x < 0 || x > limit || x != std::floor(x))
    return fail(why, fmt::format("{:g} is out of the range of BCD and BIN", x));
  auto rest = static_cast<std::uint64_t>(x);
  const std::uint64_t from = decode ? 16 : 10, to = decode ? 10 : 16;
  std::uint64_t place = 1, sum = 0;
  for (; rest != 0; rest /= from, place *= to) {
    if (rest % from > 9) return fail(why, "a digit of the binary-coded number is above 9");
    sum += place * (rest % from);
  }
  out = static_cast<double>(sum);
  return true;
}

// Functions that drop the decimals of x.
bool to_whole(Function function, double x, double& out, std::string& why) {
  switch (function) {
    case Function::floor:
      out = std::floor(x);
      return true;
    case Function::ceiling:
      out = std::ceil(x);
      return true;
    case Function::truncate:
      out = std::trunc(x);
      return true;
    case Function::away:
      out = x < 0 ? std::floor(x) : std::ceil(x);
      return true;
    default:  // FUP
      if (x < 0 && x != std::trunc(x))
        return fail(why, fmt::format("FUP of {:g}: its result below 0 is not known", x));
      out = std::ceil(x);
      return true;
  }
}

bool one_number(const ExpressionRules& rules, Function function, double x, double round_step,
                double& out, std::string& why) {
  switch (function) {
    case Function::sine:
    case Function::cosine:
    case Function::tangent:
      return trigonometric(rules, function, x, out, why);
    case Function::arc_sine:
    case Function::arc_cosine:
      return arc_function(rules, function, x, out, why);
    case Function::arc_tangent:
      out = angle_of(rules, mrsim::atan2(x, 1));
      return true;
    case Function::itself:
      out = x;
      return true;
    case Function::absolute:
      out = std::abs(x);
      return true;
    case Function::square_root:
      if (x < 0) return fail(why, fmt::format("the square root of {:g}{}", x, rules.range_alarm));
      out = std::sqrt(x);
      return true;
    case Function::square:
      out = x * x;
      return true;
    case Function::exponential:
      out = exponential(x);
      return true;
    case Function::logarithm:
    case Function::logarithm_ten:
      if (x <= 0) return fail(why, fmt::format("the logarithm of {:g}{}", x, rules.range_alarm));
      out = function == Function::logarithm ? natural_logarithm(x) : logarithm_ten(x);
      return true;
    case Function::round:
      out = round_step == 1 ? nearest_whole(x) : nearest_whole(x / round_step) * round_step;
      return true;
    case Function::floor:
    case Function::ceiling:
    case Function::truncate:
    case Function::away:
    case Function::next_whole:
      return to_whole(function, x, out, why);
    case Function::from_decimal:
    case Function::to_decimal:
      return coded_decimal(function == Function::from_decimal, x, out, why);
    case Function::tool_decimals:
      out = x;
      return true;
    default:
      return fail(why, "this function is not for numbers");
  }
}

bool several_numbers(const ExpressionRules& rules, Function function,
                     std::span<const Value> arguments, double& out, std::string& why) {
  const double a = arguments[0].number, b = arguments[1].number;
  switch (function) {
    case Function::arc_tangent:
      out = degrees(mrsim::atan2(a, b));
      if (rules.full_turn && out < 0) out += 360;
      return true;
    case Function::argument:
      out = degrees(mrsim::atan2(b, a));
      if (out < 0) out += 360;
      return true;
    case Function::power:
      out = a;
      return raise(out, b, why);
    case Function::smallest:
      out = std::min(a, b);
      return true;
    case Function::largest:
      out = std::max(a, b);
      return true;
    case Function::bound:  // BOUND(lowest, highest, value)
      out = std::min(std::max(arguments[2].number, a), b);
      return true;
    default:
      return fail(why, "this function is not for numbers");
  }
}

}  // namespace

double nearest_whole(double x) {
  const double whole = std::trunc(x);
  return std::abs(x - whole) >= 0.5 ? whole + (x < 0 ? -1 : 1) : whole;
}

std::string value_text(double value) { return fmt::format("{:.10g}", value); }

std::string value_shown(const Value& value) {
  switch (value.kind) {
    case Value::Kind::number:
      return value_text(value.number);
    case Value::Kind::text:
      return fmt::format("\"{}\"", to_utf8(value.text));
    case Value::Kind::frame:
      return "a frame";
    default:
      return "vacant";
  }
}

bool apply_operator(const ExpressionRules& rules, Operator op, Value& left, const Value& right,
                    std::string& why) {
  using Kind = Value::Kind;
  if (left.kind == Kind::number && right.kind == Kind::number && op != Operator::join)
    return number_operator(rules, op, left.number, right.number, why);
  if (op == Operator::chain && left.kind == Kind::frame && right.kind == Kind::frame) {
    left = Value::of_frame(compose(*left.frame, *right.frame));
    return true;
  }
  if (left.kind == Kind::frame || right.kind == Kind::frame)
    return fail(why, "frames can only be chained with :");
  return text_operator(op, left, right, why);
}

bool apply_function(const ExpressionRules& rules, Function function,
                    std::span<const Value> arguments, double round_step, Value& out,
                    std::string& why) {
  if (arguments[0].kind == Value::Kind::text) return text_function(function, arguments, out, why);
  if (function == Function::frame_inverse) {
    if (arguments[0].kind != Value::Kind::frame) return fail(why, "a frame is needed here");
    out = Value::of_frame(inverse(*arguments[0].frame));
    return true;
  }
  for (const Value& argument : arguments)
    if (argument.kind != Value::Kind::number) return fail(why, "a number is needed here");
  double result = 0;
  const bool one = arguments.size() == 1;
  if (!(one ? one_number(rules, function, arguments[0].number, round_step, result, why)
            : several_numbers(rules, function, arguments, result, why)))
    return false;
  out = Value::of(result);
  return true;
}

}  // namespace mrsim
