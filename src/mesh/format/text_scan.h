// A scanner for the text formats: words, numbers and lines, with the line number for messages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mrsim::detail {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

class TextScan {
 public:
  explicit TextScan(std::string_view text) : text_(text) {}

  /// Next word across line ends; empty at the end of the text.
  std::string_view word();
  /// Next word of the present line; empty at its end.
  std::string_view word_in_line();
  /// Goes to the beginning of the next line; false at the end of the text.
  bool next_line();
  /// What is left of the present line, without its end.
  std::string_view rest_of_line();
  std::size_t line() const { return line_; }
  std::size_t position() const { return at_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// The text without the byte order mark of UTF-8 that some editors put before it.
std::string_view without_mark(std::string_view text);

/// The finite float that `word` spells ("1e-3" allowed); nothing otherwise.
std::optional<float> to_float(std::string_view word);
/// The whole number that `word` spells; nothing otherwise.
std::optional<std::int64_t> to_integer(std::string_view word);

/// Appends the shortest text that reads back to the same float.
void append_number(std::string& out, float value);
void append_number(std::string& out, std::int64_t value);

/// ASCII letters only; other bytes are compared as they are.
bool equals_ignoring_case(std::string_view a, std::string_view b);

}  // namespace mrsim::detail
