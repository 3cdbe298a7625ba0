#include "interp/language/expression.h"

#include "core/text/text_io.h"
#include "interp/language/operations.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

void Evaluator::skip_blanks() {
  const char* const text = line_.data();
  const std::size_t size = line_.size();
  std::size_t p = p_;
  while (p < size && (text[p] == ' ' || text[p] == '\t' || text[p] == '\r')) ++p;
  p_ = p;
  if (p < size && text[p] == '(' && rules_.comments) skip_comments();
}

// A comment that is not closed stays for its own error.
void Evaluator::skip_comments() {
  for (std::size_t end; at(p_) == '(' && (end = line_.find(')', p_)) != line_.npos;)
    p_ = std::min(line_.find_first_not_of(" \t\r", end + 1), line_.size());
}

bool Evaluator::fail(const char* code, std::string text, std::size_t from, std::size_t to) {
  fault_ = {code, std::move(text), from, to > from ? to : from + 1};
  return false;
}

bool Evaluator::start(std::string_view line, std::size_t p) {
  line_ = line;
  p_ = started_at_ = p;
  depth_ = 0;
  seen_count_ = 0;
  return true;
}

bool Evaluator::finish(std::size_t& p, bool ok) {
  p = p_;
  if (!ok && fault_.code[0] != '\0') fault_.text += values_read();
  return ok;
}

bool Evaluator::expression(std::string_view line, std::size_t& p, Value& out) {
  start(line, p);
  bool ok = binary(0, out);
  if (ok && out.never_set) ok = usable(out, started_at_);
  return finish(p, ok);
}

// A sign in front of a vacant variable belongs to the address: "X-#1" counts as not written.
bool Evaluator::operand(std::string_view line, std::size_t& p, Value& out) {
  start(line, p);
  skip_blanks();
  const std::size_t behind = at(p_) == '-' ? line.find_first_not_of(" \t", p_ + 1) : line.npos;
  const bool negative = rules_.vacant_is_zero && behind != line.npos && line[behind] == '#';
  if (negative) p_ = behind;
  bool ok = unary(out);
  if (negative) out.number = -out.number;
  if (ok && out.never_set) ok = usable(out, started_at_);
  return finish(p, ok);
}

bool Evaluator::number_operand(std::string_view line, std::size_t& p, double& out) {
  Value value;
  const std::size_t from = p;
  if (!operand(line, p, value)) return false;
  if (!usable(value, from)) return finish(p, false);
  if (!value.is_number()) return fail("expression", "a number is needed here", from, p);
  out = value.number;
  return true;
}

bool Evaluator::variable_number(std::string_view line, std::size_t& p, double& out) {
  const std::size_t from = p;
  if (!number_operand(line, p, out)) return false;
  const double whole = nearest_whole(out);
  if (std::abs(out - whole) > kNearWhole) return fail("variable-number", kNotWhole, from, p);
  out = whole;
  return true;
}

bool Evaluator::number_expression(std::string_view line, std::size_t& p, double& out) {
  Value value;
  const std::size_t from = p;
  if (!expression(line, p, value)) return false;
  if (!usable(value, from)) return finish(p, false);
  if (!value.is_number()) return fail("expression", "a number is needed here", from, p);
  out = value.number;
  return true;
}

std::string Evaluator::values_read() const {
  std::string text;
  for (std::size_t i = 0; i < seen_count_; ++i) {
    const Seen& one = seen_[i];
    text += text.empty() ? " (" : ", ";
    text += to_utf8(line_.substr(one.from, std::min<std::size_t>(one.to - one.from, 40)));
    text += one.plain ? fmt::format(" = {}", value_text(one.number)) : std::string(" is vacant");
  }
  return text.empty() ? text : text + ")";
}

void Evaluator::seen(std::size_t from, const Value& value) {
  if (seen_count_ == seen_.size() || value.never_set || value.kind == Value::Kind::text ||
      value.kind == Value::Kind::frame)
    return;
  seen_[seen_count_++] = {from, p_, value.number, value.is_number()};
}

// Makes a number of a vacant operand, where the control counts it as 0.
bool Evaluator::usable(Value& value, std::size_t from) {
  if (value.kind == Value::Kind::faulty) return fail("", {}, from, p_);
  if (value.kind != Value::Kind::vacant) return true;
  if (value.never_set) return fail("variable-unset", value.text, from, p_);
  if (!rules_.vacant_is_zero) return fail("variable-unset", "the variable holds nothing", from, p_);
  value = Value::of(0);
  return true;
}

// "CALL O300 PX=3 LEN=20": LEN is no LE.
bool Evaluator::assigned_here() const {
  std::size_t end = p_;
  while (is_name(at(end))) ++end;
  while (at(end) == ' ' || at(end) == '\t') ++end;
  return at(end) == '=';
}

const OperatorRow* Evaluator::operator_here(std::size_t& length) const {
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

// Operands joined by operators of at least this level, equal levels from the left.
bool Evaluator::binary(int least_level, Value& out) {
  const std::size_t from = p_;
  if (!unary(out)) return false;
  bool compared = false;
  for (;;) {
    const std::size_t end = p_;
    skip_blanks();
    std::size_t length = 0;
    const OperatorRow* row = operator_here(length);
    if (!row || row->level < least_level) {
      p_ = end;
      return true;
    }
    const std::size_t place = p_;
    const bool comparison = row->op >= Operator::equal && row->op <= Operator::greater_equal;
    if (comparison && compared && spelled(Spelling::names))
      return fail("expression",
                  "two comparisons in a row: comparisons bind least, so write brackets about each",
                  place, place + length);
    compared = comparison;
    p_ += length;
    Value right;
    if (!binary(row->level + 1, right)) return false;
    if (out.kind != Value::Kind::number || right.kind != Value::Kind::number) {
      if (!combine(*row, from, out, right)) return false;
      continue;
    }
    std::string why;
    if (!apply_operator(rules_, row->op, out, right, why))
      return fail("expression", std::move(why), place, p_);
    if (!(std::abs(out.number) <= kLargestValue))
      return fail("number-too-large", "the result is too large", place, p_);
    out.letter = false;
  }
}

// An operator with an operand that is no number: comparisons with #0 ask whether one is vacant.
bool Evaluator::combine(const OperatorRow& row, std::size_t from, Value& left, Value& right) {
  using Kind = Value::Kind;
  const bool asks = (left.kind == Kind::vacant && !left.never_set) ||
                    (right.kind == Kind::vacant && !right.never_set);
  if (asks && (row.op == Operator::equal || row.op == Operator::unequal) &&
      left.kind != Kind::faulty && right.kind != Kind::faulty) {
    const bool same = left.kind == Kind::vacant && right.kind == Kind::vacant;
    left = Value::of(same == (row.op == Operator::equal));
    return true;
  }
  if (!usable(left, from) || !usable(right, from)) return false;
  std::string why;
  if (!apply_operator(rules_, row.op, left, right, why))
    return fail("expression", std::move(why), from, p_);
  return true;
}

bool Evaluator::unary(Value& out) {
  skip_blanks();
  const char c = at(p_);
  if (is_digit(c) || c == '.') return number(out);
  if (c == '#' && spelled(Spelling::hash)) return hash_variable(out);
  if ((c == '#' || c == '$') && spelled(Spelling::plc)) return plc_variable(out);
  if (upper(c) == 'P' && is_digit(at(p_ + 1)) && spelled(Spelling::parameter))
    return parameter_variable(out);
  if (c == rules_.open) return bracketed(out);
  if (c == '-' || c == '+') {
    const std::size_t from = p_++;
    if (++depth_ > kDeepest) return fail("expression-deep", "too many signs", from, p_);
    if (!unary(out)) return false;
    --depth_;
    if (!usable(out, from)) return false;
    if (!out.is_number()) return fail("expression", "a sign needs a number", from, p_);
    if (c == '-') out.number = -out.number;
    out.letter = false;
    return true;
  }
  if (is_letter(c)) return word(out);
  if ((c == '_' || c == '$' || c == '"') && spelled(Spelling::names))
    return c == '"' ? text(out) : word(out);
  if (c == '\'' && spelled(Spelling::names)) return radix(out);
  if (c == '\'' && spelled(Spelling::plc)) return text(out);
  if (p_ >= line_.size()) return fail("expression", "the expression ends too early", p_, p_ + 1);
  return fail("expression", fmt::format("a number, a variable or {} is expected here", rules_.open),
              p_, p_ + 1);
}

bool Evaluator::bracketed(Value& out) {
  const std::size_t from = p_++;
  if (++depth_ > kDeepest)
    return fail("expression-deep",
                fmt::format("more than {} brackets inside one another", kDeepest), from, p_);
  if (!binary(0, out)) return false;
  --depth_;
  skip_blanks();
  if (at(p_) != rules_.close)
    return fail("bracket",
                fmt::format("the {} here is not closed with {}", rules_.open, rules_.close), from,
                from + 1);
  ++p_;
  return true;
}

// VC1 and V1 of Okuma, whose digits end them, and local names.
bool Evaluator::plain_variable(std::size_t from, Value& out) {
  p_ = from;
  while (is_letter(at(p_))) ++p_;
  const std::string letters = upper_case(line_.substr(from, std::min<std::size_t>(p_ - from, 3)));
  const bool common = letters == "V" || letters == "VC";
  while (is_digit(at(p_)) || (!common && is_letter(at(p_)))) ++p_;
  const std::string_view name = line_.substr(from, p_ - from);
  if (at(p_) == '[')
    return fail("variable-unset", fmt::format("the system variable {} is not answered here", name),
                from, p_);
  std::string why;
  if (!variables_.named(name, {}, out, why))
    return fail("variable-unset", std::move(why), from, p_);
  if (out.kind == Value::Kind::faulty) return fail("", {}, from, p_);
  seen(from, out);
  return true;
}

}  // namespace mrsim
