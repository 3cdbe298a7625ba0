#include "interp/language/expression_lexer.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

// A comment that is not closed is not skipped: it gets its own error later.
void ExpressionLexer::skip_comments() {
  for (std::size_t end; at(p_) == '(' && (end = line_.find(')', p_)) != line_.npos;)
    p_ = std::min(line_.find_first_not_of(" \t\r", end + 1), line_.size());
}

bool ExpressionLexer::fail(const char* code, std::string text, std::size_t from, std::size_t to) {
  fault_ = {code, std::move(text), from, to > from ? to : from + 1};
  return false;
}

// Whether a name with "=" stands there: in "CALL O300 PX=3 LEN=20" LEN is not the operator LE.
bool ExpressionLexer::assigned_here() const {
  std::size_t end = p_;
  while (is_name(at(end))) ++end;
  while (at(end) == ' ' || at(end) == '\t') ++end;
  return at(end) == '=';
}

const OperatorRow* ExpressionLexer::operator_here(std::size_t& length) const {
  const char c = upper(at(p_));
  const OperatorRow* best = nullptr;
  if (is_letter(c) && !(rules_.plain_names && assigned_here())) {
    std::size_t end = p_;
    while (is_letter(at(end)) || at(end) == '_') ++end;
    for (const OperatorRow& row : rules_.operators) {
      const std::size_t n = row.name.size();
      if (row.name[0] != c || n > end - p_) continue;
      const bool whole = spelled(Spelling::names) || spelled(Spelling::plc);
      if (whole && (n != end - p_ || is_name(at(end)))) continue;
      bool same = true;
      for (std::size_t i = 1; i < n && same; ++i) same = upper(line_[p_ + i]) == row.name[i];
      if (same) best = &row;
    }
  } else if (!is_letter(c)) {
    for (const OperatorRow& row : rules_.operators) {
      if (row.name[0] != c || (row.name.size() == 2 && at(p_ + 1) != row.name[1])) continue;
      if (!best || row.name.size() > best->name.size()) best = &row;
    }
  }
  if (best) length = best->name.size();
  return best;
}

bool ExpressionLexer::number(Value& out) {
  const std::size_t from = p_;
  std::uint64_t mantissa = 0;
  std::size_t digits = 0, fraction = 0;
  bool point = false;
  for (;; ++p_) {
    const char c = at(p_);
    if (is_digit(c)) {
      if (++digits <= 15) mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
      if (point) ++fraction;
    } else if (c == '.' && !point) {
      point = true;
    } else if (!(rules_.glued_blanks && (c == ' ' || c == '\t'))) {
      break;
    }
  }
  while (p_ > from && (line_[p_ - 1] == ' ' || line_[p_ - 1] == '\t')) --p_;
  const bool exponent =
      spelled(Spelling::names) && upper(at(p_)) == 'E' && upper(at(p_ + 1)) == 'X';
  const bool foreign = upper(at(p_)) == 'E' && (is_digit(at(p_ + 1)) || at(p_ + 1) == '-');
  if (spelled(Spelling::hash) && foreign)
    return fail("number-malformed", "numbers of this control have no exponent: write them out",
                from, p_ + 2);
  if (digits > 0 && digits <= 15 && !exponent) {
    out = Value::of(static_cast<double>(mantissa) / kPowersOfTen[fraction]);
    return at(p_) != '.' || fail("number-malformed", "a second point in the number", from, p_ + 1);
  }
  std::string text;
  for (std::size_t i = from; i < p_; ++i)
    if (line_[i] != ' ' && line_[i] != '\t') text += line_[i];
  if (exponent) {
    text += 'e';
    p_ += 2;
    if (at(p_) == '-' || at(p_) == '+') text += line_[p_++];
    while (is_digit(at(p_))) text += line_[p_++];
  }
  const std::optional<double> value = parse_number(text, true);
  if (!value)
    return fail("number-malformed", fmt::format("\"{}\" is not a number", text.substr(0, 40)), from,
                p_);
  out = Value::of(*value);
  return true;
}

// Numbers to the bases 16 and 2: 'HFF' and 'B101'.
bool ExpressionLexer::radix(Value& out) {
  const std::size_t from = p_, end = line_.find('\'', p_ + 1);
  const int base = radix_base(at(p_ + 1));
  if (base == 0 || end == std::string_view::npos || end - from > 34 || end == from + 2)
    return fail("number-malformed", "expected 'H...' or 'B...'", from, from + 1);
  const std::optional<double> value = radix_number(line_.substr(from + 2, end - from - 2), base);
  if (!value) return fail("number-malformed", "expected 'H...' or 'B...'", from, end + 1);
  p_ = end + 1;
  out = Value::of(*value);
  return true;
}

bool ExpressionLexer::text(Value& out) {
  const std::size_t end = line_.find(at(p_), p_ + 1);
  if (end == std::string_view::npos)
    return fail("string-unterminated",
                fmt::format("the text that starts here is not closed with {}", at(p_)), p_, p_ + 1);
  out = Value::of_text(std::string(line_.substr(p_ + 1, end - p_ - 1)));
  p_ = end + 1;
  return true;
}

bool ExpressionLexer::bracketed_name(std::string_view line, std::size_t& p, std::string& name) {
  const std::size_t end = line.find('>', p);
  name.clear();
  if (end == std::string_view::npos)
    return fail("bracket", "the < here is not closed with >", p, p + 1);
  for (std::size_t i = p + 1; i < end; ++i)
    if (line[i] != ' ' && line[i] != '\t') name += line[i];
  p = end + 1;
  return !name.empty() || fail("expression", "the name between < and > is empty", end - 1, end);
}

}  // namespace mrsim
