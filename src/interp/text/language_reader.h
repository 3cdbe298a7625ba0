// What the parser asks a control's language for: values of expressions, assignments, and where a
// statement (IF, GOTO, O100 call ...) begins. The parser itself knows only words and numbers.
#pragma once

#include "interp/text/block.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mrsim {

class LanguageReader {
 public:
  enum class Answer : std::uint8_t {
    value,
    vacant,  ///< FANUC: the word counts as not written
    failed,  ///< no value; a fault was reported
  };
  virtual ~LanguageReader() = default;

  /// The value at `p` for `word`: one operand behind an address, or with `whole` an expression.
  /// Moves `p` behind it.
  virtual Answer value(std::string_view line, std::size_t& p, Word& word, bool whole) = 0;
  /// Carries out the assignment at `p` ("#1=2", "R1=R2*3", "WIDTH[2]=5") and moves `p` behind it.
  /// False: reported.
  virtual bool assignment(std::string_view line, std::size_t& p) = 0;
  /// Whether a statement begins at `p`.
  virtual bool starts_statement(std::string_view line, std::size_t p) = 0;
  /// Whether a function of expressions begins at `p` ("SIN[").
  virtual bool starts_function(std::string_view line, std::size_t p) const = 0;
  /// Whether a name is a variable that has been defined.
  virtual bool is_variable(std::string_view name) = 0;
};

}  // namespace mrsim
