// The text of an expression while it is read: how far it is read, blanks and comments, numbers and
// texts as they are written, operators, and the first fault. Private to src/interp.
#pragma once

#include "interp/language/rules.h"
#include "interp/language/value.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace mrsim {

class ExpressionLexer {
 public:
  /// The name inside #<...> without blanks, `p` on the "<" and then behind the ">". False: see
  /// fault().
  bool bracketed_name(std::string_view line, std::size_t& p, std::string& name);

  /// Why there is no value; only after a function that was false.
  const Fault& fault() const { return fault_; }
  const ExpressionRules& rules() const { return rules_; }

 protected:
  explicit ExpressionLexer(const ExpressionRules& rules) : rules_(rules) {}

  /// Each reads what stands at p_, which ends behind it. False: a fault.
  bool number(Value& out);
  bool radix(Value& out);
  bool text(Value& out);

  /// The operator at p_ and its length in bytes; null where there is none.
  const OperatorRow* operator_here(std::size_t& length) const;
  bool spelled(Spelling spelling) const { return rules_.spelling == spelling; }
  void skip_blanks() {
    const char* const text = line_.data();
    const std::size_t size = line_.size();
    std::size_t p = p_;
    while (p < size && (text[p] == ' ' || text[p] == '\t' || text[p] == '\r')) ++p;
    p_ = p;
    if (p < size && text[p] == '(' && rules_.comments) skip_comments();
  }
  /// Keeps the fault; always false. `from` and `to` are places in the line.
  bool fail(const char* code, std::string text, std::size_t from, std::size_t to);
  char at(std::size_t i) const { return i < line_.size() ? line_[i] : '\0'; }

  const ExpressionRules& rules_;
  std::string_view line_;
  std::size_t p_ = 0;
  Fault fault_;

 private:
  void skip_comments();
  bool assigned_here() const;
};

}  // namespace mrsim
