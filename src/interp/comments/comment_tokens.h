// Cuts a comment into words, numbers with their units, and signs. The sources that look for data of
// tools in comments read these tokens.
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
  double unit = 0;        ///< mm per unit if one stands behind the number, else 0
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

/// The comment in upper case. Each character outside of ASCII becomes one '~', except that inch
/// marks become '"', a degree sign '^', a times sign 'X' and the French preposition 'A'.
std::string fold_comment(std::string_view utf8);

/// The tokens of a folded comment, at most 200 of them. They refer to its text.
std::vector<CommentToken> comment_tokens(std::string_view folded);

}  // namespace mrsim
