#include "interp/language/evaluator.h"

#include "interp/language/operations.h"

#include <cmath>
#include <string>
#include <utility>

namespace mrsim {

void Evaluator::start(std::string_view line, std::size_t p) {
  line_ = line;
  p_ = started_at_ = p;
  depth_ = 0;
  read_.clear();
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

// A sign before a vacant variable belongs to the address, so that "X-#1" counts as not written.
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

// Takes the value that stands from `from` to p. False: it is no number, or was never set.
bool Evaluator::take_number(Value& value, std::size_t from, std::size_t& p, double& out) {
  if (!usable(value, from)) return finish(p, false);
  if (!value.is_number()) return fail("expression", "a number is needed here", from, p);
  out = value.number;
  return true;
}

bool Evaluator::number_operand(std::string_view line, std::size_t& p, double& out) {
  Value value;
  const std::size_t from = p;
  return operand(line, p, value) && take_number(value, from, p, out);
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
  return expression(line, p, value) && take_number(value, from, p, out);
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
    if (comparison && compared && rules_.compares_once)
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

// Applies an operator where an operand is no number. Comparisons with #0 ask whether one is vacant.
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

}  // namespace mrsim
