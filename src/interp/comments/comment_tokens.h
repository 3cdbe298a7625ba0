// A comment cut into words, numbers with their units, and signs, for those who look for tool data.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

struct CommentToken {
  enum class Kind : std::uint8_t { word, number, sign };
  Kind kind = Kind::sign;
  std::string_view text;  ///< as in the folded comment
  double value = 0;       ///< of a number, never negative
  double unit = 0;        ///< mm per unit where one stands behind the number, 0 = none does
  bool fraction = false;  ///< "1/4", "1-1/2"
  bool decimals = false;  ///< a point or a decimal comma was written
  bool angle = false;     ///< "90 DEG", "118°"
  bool glued = false;     ///< no blank before it
  bool dotted = false;    ///< a word that ends in a point: "IN.", "DIA."

  bool is(std::string_view what) const { return kind != Kind::number && text == what; }
  bool is_number() const { return kind == Kind::number; }
  /// ".1875": thousandths of an inch, as a rule.
  bool inch_style() const { return is_number() && text.starts_with('.') && text.size() > 3; }
};

/// Upper case; one '~' for each character outside of ASCII, but '"' for inch marks, '^' for a
/// degree sign, 'X' for a times sign and 'A' for the French preposition.
std::string fold_comment(std::string_view utf8);

/// The tokens of a folded comment, at most 200 of them. They refer to its text.
std::vector<CommentToken> comment_tokens(std::string_view folded);

}  // namespace mrsim
