// Computes the expressions of NC programs straight from the text of the line: `#1+2`, `SIN[30]`,
// `R1*(R2-1)`. One evaluator for all controls; what differs is in ExpressionRules.
// Guarantees: the nesting of brackets is bounded; a fault has its place; nothing is printed.
// Does not: know where variables live (VariableReader) or what the value is for.
#pragma once

#include "interp/language/rules.h"
#include "interp/language/value.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// Answers what an expression asks for. False: `why` has a sentence for the user.
class VariableReader {
 public:
  virtual ~VariableReader() = default;
  /// #number or R number. A vacant value is an answer.
  virtual bool numbered(double number, Value& out, std::string& why) = 0;
  /// #<name>, a SINUMERIK name or $ name with its indices. The name as written.
  virtual bool named(std::string_view name, std::span<const Value> indices, Value& out,
                     std::string& why) = 0;
  /// EXISTS[#...]
  virtual bool exists(double number) = 0;
  virtual bool exists(std::string_view name) = 0;
};

class Evaluator {
 public:
  Evaluator(const ExpressionRules& rules, VariableReader& variables)
      : rules_(rules), variables_(variables) {}

  /// The longest expression at `p`; moves `p` behind it. False: see fault().
  bool expression(std::string_view line, std::size_t& p, Value& out);
  /// One operand at `p` ("#1", "-[2+3]", "SIN[30]"), as it stands behind an address.
  bool operand(std::string_view line, std::size_t& p, Value& out);
  /// As operand(), and a number that is not vacant.
  bool number_operand(std::string_view line, std::size_t& p, double& out);
  bool number_expression(std::string_view line, std::size_t& p, double& out);
  /// The number of a variable behind its #: a whole one.
  bool variable_number(std::string_view line, std::size_t& p, double& out);
  /// The name inside #<...> without blanks, `p` on the "<".
  bool bracketed_name(std::string_view line, std::size_t& p, std::string& name);

  /// What ROUND rounds to: 1, or the control's least increment inside of an NC word.
  void set_round_step(double step) { round_step_ = step; }
  const Fault& fault() const { return fault_; }
  const ExpressionRules& rules() const { return rules_; }
  /// " (#1 = 2, #3 = 0)" for the variables read since the expression began; empty if none.
  std::string values_read() const;

  static constexpr int kDeepest = 64;  ///< brackets inside one another
  static constexpr double kLargestValue = 1e300;

 private:
  static constexpr const char* kNotWhole = "the number of a variable is a whole number";
  static constexpr double kNearWhole = 1e-4;  // of the number of a variable

  struct Seen {
    std::size_t from, to;
    double number;
    bool plain;
  };

  bool binary(int least_level, Value& out);
  bool unary(Value& out);
  bool bracketed(Value& out);
  bool number(Value& out);
  bool radix(Value& out);
  bool text(Value& out);
  bool plc_variable(Value& out);
  bool parameter_variable(Value& out);
  bool negation(std::size_t from, bool bits, Value& out);
  bool bare_call(const FunctionRow& row, std::size_t from, Value& out);
  bool hash_variable(Value& out);
  bool word(Value& out);
  bool plain_variable(std::size_t from, Value& out);
  bool name_variable(std::size_t from, std::string_view name, Value& out);
  bool call(const FunctionRow& row, std::size_t from, Value& out);
  bool frame_call(const FunctionRow& row, std::size_t from, Value& out);
  bool exists_call(std::size_t from, Value& out);
  bool is_variable(const Value& name, std::size_t from, Value& out);
  bool arguments(std::vector<Value>& values, std::size_t most);
  bool combine(const OperatorRow& row, std::size_t from, Value& left, Value& right);
  bool usable(Value& value, std::size_t from);
  bool spelled(Spelling spelling) const { return rules_.spelling == spelling; }
  bool assigned_here() const;
  const OperatorRow* operator_here(std::size_t& length) const;
  const FunctionRow* function_named(std::string_view name) const;
  void seen(std::size_t from, const Value& value);
  void skip_blanks();
  void skip_comments();
  bool fail(const char* code, std::string text, std::size_t from, std::size_t to);
  bool start(std::string_view line, std::size_t p);
  bool finish(std::size_t& p, bool ok);
  char at(std::size_t i) const { return i < line_.size() ? line_[i] : '\0'; }

  const ExpressionRules& rules_;
  VariableReader& variables_;
  std::string_view line_;
  std::size_t p_ = 0;
  int depth_ = 0;
  double round_step_ = 1;
  Fault fault_;
  std::array<Seen, 6> seen_{};
  std::size_t seen_count_ = 0;
  std::size_t started_at_ = 0;
};

}  // namespace mrsim
