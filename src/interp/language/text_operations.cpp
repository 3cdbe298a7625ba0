#include "interp/language/text_operations.h"

#include "core/text/text_io.h"
#include "interp/language/operations.h"
#include "interp/text/characters.h"

#include <optional>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kLongestText = 1000;
constexpr double kLongestPart = 1e9;

// The place of a character (INDEX, RINDEX), of the first of several (MINDEX), of a text (MATCH).
// -1: it is not there.
double index_of(const std::string& text, const std::string& sought, Function how) {
  std::size_t at = std::string::npos;
  if (how == Function::text_match) at = text.find(sought);
  if (how == Function::text_first_of) at = text.find_first_of(sought);
  if (how == Function::text_index && sought.size() == 1) at = text.find(sought);
  if (how == Function::text_rindex && sought.size() == 1) at = text.rfind(sought);
  return at == std::string::npos ? -1 : static_cast<double>(at);
}

}  // namespace

bool text_operator(Operator op, Value& left, const Value& right, std::string& why) {
  const auto as_text = [](const Value& value) {
    if (value.letter) return std::string(1, letter_of(value));
    return value.kind == Value::Kind::text ? value.text : value_text(value.number);
  };
  if (op == Operator::join) {
    left = Value::of_text(as_text(left) + as_text(right));
    if (left.text.size() > kLongestText) return fail(why, "the text grows too long");
    return true;
  }
  if (left.kind != right.kind && !left.letter && !right.letter)
    return fail(why, "a text and a number cannot be combined here");
  const int order = as_text(left).compare(as_text(right));
  switch (op) {
    case Operator::equal:
      left = Value::of(order == 0);
      return true;
    case Operator::unequal:
      left = Value::of(order != 0);
      return true;
    case Operator::less:
      left = Value::of(order < 0);
      return true;
    case Operator::less_equal:
      left = Value::of(order <= 0);
      return true;
    case Operator::greater:
      left = Value::of(order > 0);
      return true;
    case Operator::greater_equal:
      left = Value::of(order >= 0);
      return true;
    default:
      return fail(why, "texts can only be compared and joined with <<");
  }
}

bool text_function(Function function, std::span<const Value> arguments, Value& out,
                   std::string& why) {
  const std::string& text = arguments[0].text;
  const std::optional<double> number = parse_number(text, true);
  switch (function) {
    case Function::to_number:
      if (!number) return fail(why, fmt::format("\"{}\" is not a number", text.substr(0, 40)));
      out = Value::of(*number);
      return true;
    case Function::is_number:
      out = Value::of(number.has_value());
      return true;
    case Function::text_length:
      out = Value::of(static_cast<double>(text.size()));
      return true;
    case Function::upper_text:
      out = Value::of_text(upper_case(text));
      return true;
    case Function::lower_text: {
      std::string lower = text;
      for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
      out = Value::of_text(std::move(lower));
      return true;
    }
    case Function::text_index:
    case Function::text_rindex:
    case Function::text_first_of:
    case Function::text_match:
      out = Value::of(index_of(text, arguments[1].text, function));
      return true;
    case Function::join_text:
      if (arguments[1].kind != Value::Kind::text) return fail(why, "CONCAT joins texts");
      out = Value::of_text(text + arguments[1].text);
      return out.text.size() <= kLongestText || fail(why, "the text grows too long");
    case Function::as_text:
      out = Value::of_text(text);
      return true;
    case Function::part_of_text: {
      const double from = arguments[1].number,
                   count = arguments.size() > 2 ? arguments[2].number : kLongestPart;
      if (!(from >= 0) || !(count >= 0) || from > static_cast<double>(text.size()))
        return fail(why, "SUBSTR begins outside of the text");
      out = Value::of_text(
          text.substr(static_cast<std::size_t>(from),
                      static_cast<std::size_t>(std::min(count, static_cast<double>(text.size())))));
      return true;
    }
    default:
      return fail(why, "this function is not for texts");
  }
}

}  // namespace mrsim
