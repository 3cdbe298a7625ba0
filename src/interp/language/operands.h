// The operands of expressions: numbers, texts, variables, functions, brackets, and the signs before
// them. Evaluator joins them by operators. Private to src/interp.
#pragma once

#include "interp/language/expression_lexer.h"
#include "interp/language/values_read.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// Gives the values of the variables in an expression. False: `why` has a sentence for the user.
class VariableReader {
 public:
  virtual ~VariableReader() = default;
  /// #number or an R parameter. The value may be vacant.
  virtual bool numbered(double number, Value& out, std::string& why) = 0;
  /// #<name>, a SINUMERIK name or $ name with its indices. The name as written.
  virtual bool named(std::string_view name, std::span<const Value> indices, Value& out,
                     std::string& why) = 0;
  /// EXISTS[#...]: whether the variable has a value.
  virtual bool exists(double number) = 0;
  virtual bool exists(std::string_view name) = 0;
};

class Operands : public ExpressionLexer {
 public:
  virtual ~Operands() = default;

  /// What ROUND rounds to: 1, or the control's least increment inside of an NC word.
  void set_round_step(double step) { round_step_ = step; }
  /// " (#1 = 2, #3 = 0)" for the variables read since the expression began; empty if none.
  std::string values_read() const { return read_.text(line_); }

  static constexpr int kDeepest = 64;  ///< brackets inside one another
  static constexpr double kLargestValue = 1e300;

 protected:
  static constexpr const char* kNotWhole = "the number of a variable is a whole number";
  static constexpr double kNearWhole =
      1e-4;  // how far the number of a variable may be from a whole one

  Operands(const ExpressionRules& rules, VariableReader& variables)
      : ExpressionLexer(rules), variables_(variables) {}

  /// The expression at p_ inside of brackets, an index or an argument. False: a fault.
  virtual bool expression_within(Value& out) = 0;
  /// The operand at p_ with its signs. False: a fault.
  bool unary(Value& out);
  /// Makes a number of a vacant value where the control counts it as 0. False: a fault, from `from`
  /// to p_.
  bool usable(Value& value, std::size_t from) {
    return value.is_number() || number_of_vacant(value, from);
  }

  int depth_ = 0;  ///< how many brackets, signs and functions are open at p_
  ValuesRead read_;

 private:
  bool number_of_vacant(Value& value, std::size_t from);
  bool bracketed(Value& out);
  bool close(std::size_t from);
  bool plc_variable(Value& out);
  bool parameter_variable(Value& out);
  bool negation(std::size_t from, bool bits, Value& out);
  bool bare_call(const FunctionRow& row, std::size_t from, Value& out);
  bool hash_variable(Value& out);
  bool word(Value& out);
  bool plain_variable(std::size_t from, Value& out);
  bool name_variable(std::size_t from, std::string_view name, Value& out);
  bool answered(std::size_t from, const Value& value);
  bool call(const FunctionRow& row, std::size_t from, Value& out);
  bool frame_call(const FunctionRow& row, std::size_t from, Value& out);
  bool exists_call(std::size_t from, Value& out);
  bool is_variable(const Value& name, std::size_t from, Value& out);
  bool arguments(std::vector<Value>& values, std::size_t most);
  const FunctionRow* function_named(std::string_view name) const;

  VariableReader& variables_;
  double round_step_ = 1;
};

}  // namespace mrsim
