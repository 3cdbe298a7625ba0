// Computes the expressions of NC programs straight from the text of the line: `#1+2`, `SIN[30]`,
// `R1*(R2-1)`. One evaluator for all controls; what differs is in ExpressionRules.
// Guarantees: the nesting of brackets is bounded; a fault has its place; nothing is printed.
// Does not know where variables live (VariableReader) or what the value is for.
#pragma once

#include "interp/language/operands.h"

#include <cstddef>
#include <string_view>

namespace mrsim {

class Evaluator final : public Operands {
 public:
  Evaluator(const ExpressionRules& rules, VariableReader& variables) : Operands(rules, variables) {}

  /// The longest expression at `p`; moves `p` behind it. False: see fault().
  bool expression(std::string_view line, std::size_t& p, Value& out);
  /// One operand at `p` ("#1", "-[2+3]", "SIN[30]"), as it stands behind an address.
  bool operand(std::string_view line, std::size_t& p, Value& out);
  /// As operand(); the value must be a number that is not vacant.
  bool number_operand(std::string_view line, std::size_t& p, double& out);
  /// As expression(); the value must be a number that is not vacant.
  bool number_expression(std::string_view line, std::size_t& p, double& out);
  /// The number of a variable behind its #, which must be whole.
  bool variable_number(std::string_view line, std::size_t& p, double& out);

 private:
  bool expression_within(Value& out) override { return binary(0, out); }
  bool binary(int least_level, Value& out);
  bool combine(const OperatorRow& row, std::size_t from, Value& left, Value& right);
  void start(std::string_view line, std::size_t p);
  bool finish(std::size_t& p, bool ok);
  bool take_number(Value& value, std::size_t from, std::size_t& p, double& out);

  std::size_t started_at_ = 0;
};

}  // namespace mrsim
