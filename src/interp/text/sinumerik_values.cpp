#include "interp/text/sinumerik_values.h"

#include "interp/text/characters.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::pair<std::string_view, Form> kForms[] = {
    {"AC", Form::ac},   {"IC", Form::ic},   {"DAC", Form::dac},
    {"DIC", Form::dic}, {"RAC", Form::rac}, {"RIC", Form::ric},
    {"DC", Form::ac},   {"ACP", Form::ac},  {"ACN", Form::ac}};

constexpr std::string_view kOperators[] = {"DIV", "MOD",  "AND",   "OR",
                                           "XOR", "B_OR", "B_AND", "B_XOR"};

}  // namespace

// Only T, and data that nothing reads, may have a text.
bool SinumerikValues::value(Block& block, Word& word) {
  skip_blanks();
  const std::size_t from = p_;
  if (!any_value(block, word)) return false;
  if (!word.string || word.address == letter('T') || word.address == Address::data) return true;
  fault(block, "expression", "a number is needed here, and this is a text or an axis (alarm 12150)",
        from, p_);
  return false;
}

// A number, AC(number) and its kin, "text", 'H1F'. Anything else is an expression.
bool SinumerikValues::any_value(Block& block, Word& word) {
  const std::size_t from = p_;
  const char c = at(p_);
  if (language_ && more_follows()) return expression(block, word, true);
  if (c == '"') {
    text_value(block, word);
    return !block.bad;
  }
  if (c == '\'') {
    if (radix(word)) return true;
    fault(block, "number-malformed", "expected 'H...' or 'B...'", from, p_);
    return false;
  }
  if (is_letter(c) || c == '_') return form_of_value(block, word);
  if (starts_number(c) &&
      (is_digit(at(p_ + 1)) || at(p_ + 1) == '.' || is_digit(c) || starts_number(at(p_ + 1)))) {
    std::size_t end = from + 1;
    while (is_digit(at(end)) || at(end) == '.') ++end;
    if ((at(end) == '+' || at(end) == '-') && is_digit(at(end - 1))) {
      p_ = end;
      unsupported(block, line_.substr(from, end - from + 1), "an expression", from);
      return false;
    }
    if (!number(block, word, true)) return false;
    const char after = at(p_);
    if (after == '*' || after == '/' || after == '(' || after == '<' || after == '>') {
      unsupported(block, line_.substr(from, p_ - from + 1), "an expression", from);
      return false;
    }
    return true;
  }
  if (c == '\0' || c == ';') {
    fault(block, "address-without-number", "no value after =", from > 0 ? from - 1 : 0, from);
    return false;
  }
  if (starts_number(c) && (at(p_ + 1) == '\0' || at(p_ + 1) == ';' || blank(at(p_ + 1))))
    return number(block, word, true);  // a lone sign or point
  p_ = from + 1;
  unsupported(block, line_.substr(from, 1), "an expression", from);
  return false;
}

// Whether more follows than a number, a text in quotes or AC(number).
bool SinumerikValues::more_follows() const {
  std::size_t i = p_;
  if (at(i) == '(' || at(i) == '$') return true;
  if (is_letter(at(i)) || at(i) == '_') {
    std::size_t end = i;
    while (is_name(at(end))) ++end;
    const std::string name = upper_case(line_.substr(i, std::min<std::size_t>(end - i, 33)));
    while (blank(at(end)) && end < line_.size()) ++end;
    for (const auto& [known, form] : kForms)
      if (known == name && at(end) == '(') return false;
    return true;
  }
  if (at(i) == '"') {
    i = line_.find('"', i + 1);
    if (i == std::string_view::npos) return false;
    ++i;
  } else if (at(i) == '\'') {
    i = line_.find('\'', i + 1);
    if (i == std::string_view::npos) return false;
    ++i;
  } else {
    const std::size_t signs = i;
    while (at(i) == '-' || at(i) == '+') ++i;
    if (i > signs && blank(at(i)) && i < line_.size()) return true;  // "- R1"
    if ((is_name(at(i)) && !is_digit(at(i))) || at(i) == '(' || at(i) == '$') return true;
    while (is_digit(at(i)) || at(i) == '.') ++i;
    if (i == signs) return false;
    if (upper(at(i)) == 'E' && upper(at(i + 1)) == 'X') {
      i += 2;
      while (is_digit(at(i)) || at(i) == '-' || at(i) == '+') ++i;
    }
    if ((at(i) == '-' || at(i) == '+') &&
        (is_name(at(i + 1)) || at(i + 1) == '(' || at(i + 1) == '$' || blank(at(i + 1))))
      return is_digit(at(i - 1)) || at(i - 1) == '.';
  }
  while (blank(at(i)) && i < line_.size()) ++i;
  std::size_t end = i;
  while (is_name(at(end))) ++end;
  const std::string word = upper_case(line_.substr(std::min(i, line_.size()), end - i));
  return at(i) == '*' || at(i) == '/' || at(i) == '<' || at(i) == '>' || at(i) == '+' ||
         at(i) == '-' || std::ranges::find(kOperators, word) != std::end(kOperators) ||
         (at(i) == '=' && at(i + 1) == '=');
}

bool SinumerikValues::form_of_value(Block& block, Word& word) {
  const std::size_t from = p_;
  while (is_name(at(p_))) ++p_;
  const std::string name = upper_case(line_.substr(from, std::min<std::size_t>(p_ - from, 33)));
  skip_blanks();
  const bool bracket = at(p_) == '(';
  for (const auto& [known, form] : kForms) {
    if (known != name || !bracket) continue;
    word.form = form;
    ++p_;
    skip_blanks();
    const std::size_t inner = p_;
    if (language_ && at(p_) != ')' && at(p_) != '\0' && at(p_) != ';') {
      if (!expression(block, word, true)) return false;
      skip_blanks();
      if (at(p_) == ')') {
        ++p_;
        return true;
      }
      fault(block, "bracket", "the ( here is not closed (alarm 12080)", inner - 1, inner);
      return false;
    }
    if (!starts_number(at(p_)) ||
        !(is_digit(at(p_ + 1)) || is_digit(at(p_)) || at(p_ + 1) == '.')) {
      const bool empty = at(p_) == ')';
      if (empty) ++p_;
      if (empty || at(p_) == '\0' || at(p_) == ';')
        fault(block, "address-without-number", fmt::format("no number in {}()", name), from, p_);
      else
        unsupported(block, line_.substr(inner, 1), "an expression", inner);
      return false;
    }
    if (!number(block, word, true)) return false;
    skip_blanks();
    if (at(p_) == ')') {
      ++p_;
      return true;
    }
    if (at(p_) == '\0' || at(p_) == ';')
      fault(block, "bracket", "the ( here is not closed (alarm 12080)", inner - 1, inner);
    else
      unsupported(block, line_.substr(inner, p_ - inner + 1), "an expression", inner);
    return false;
  }
  unsupported(block, line_.substr(from, p_ - from), "an expression", from);
  return false;
}

bool SinumerikValues::radix(Word& word) {
  const int base = radix_base(at(p_ + 1));
  const std::size_t end = line_.find('\'', p_ + 1);
  if (base == 0 || end == std::string_view::npos || end - p_ > 34 || end == p_ + 2) return false;
  const std::optional<double> value = radix_number(line_.substr(p_ + 2, end - p_ - 2), base);
  if (!value || *value > 1e9) return false;
  word.value = *value;
  p_ = end + 1;
  return true;
}

void SinumerikValues::text_value(Block& block, Word& word) {
  const std::size_t end = line_.find('"', p_ + 1);
  if (end == std::string_view::npos) {
    fault(block, "string-unterminated",
          "the text that starts here is not closed with \" (alarm 12080)", p_, p_ + 1);
    p_ = line_.size();
    return;
  }
  word.string = true;
  word.text = line_.substr(p_ + 1, end - p_ - 1);
  p_ = end + 1;
}

}  // namespace mrsim
