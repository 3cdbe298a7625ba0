#include "interp/text/strange_text.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"
#include "interp/text/line_scan.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Characters within which a partner is looked for: each character of a long line may ask.
constexpr std::size_t kNearby = 1000;

// The minus signs and dashes of typesetting.
bool is_dash(std::string_view text) {
  return text.starts_with("\xE2\x88\x92") || text.starts_with("\xE2\x80\x93") ||
         text.starts_with("\xE2\x80\x94");
}

// Whether a statement or an assignment stands there, and not only comments and N words.
bool says_something(std::string_view head) {
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (head[i] == '(')
      i = std::min(head.find(')', i), head.size());
    else if (head[i] == '#' || (is_letter(head[i]) && upper(head[i]) != 'N'))
      return true;
  }
  return false;
}

}  // namespace

// FANUC's ";" ends a block, and many programmers write a comment behind it. Where words follow,
// either may be meant. Z4 behind a tool is its number of flutes.
void StrangeText::doubt_comment(const Block& block) {
  const auto is_tool = [](const Word& word) { return word.address == letter('T'); };
  if (dialect_ != Dialect::fanuc || (block.words.empty() && !says_something(line_.substr(0, p_))) ||
      std::any_of(block.words.begin(), block.words.end(), is_tool) ||
      !looks_like_block(line_.substr(p_ + 1)) ||
      line_.find_first_of("GXYZgxyz", p_ + 1) == std::string_view::npos)
    return;
  Word sign;
  sign.column = static_cast<int>(p_);
  sign.length = static_cast<int>(line_.size() - p_);
  reporter_.once(
      Severity::warning, "block-end-sign",
      "what stands behind ; is read as a comment: a block there needs a line of its own, "
      "or a ; at the end of the line",
      sign, "comment-as-block");
}

// "GO X5" and "MO3" have the letter O where a zero is meant.
bool StrangeText::zero_as_letter(Block& block) {
  const char c = upper(at(p_));
  if ((c != 'G' && c != 'M') || upper(at(p_ + 1)) != 'O') return false;
  const std::size_t next = p_ + 2;
  const bool axis = is_letter(at(next)) && starts_number(at(next + 1));
  if (is_name(at(next)) && !is_digit(at(next)) && !axis) return false;
  const std::size_t from = p_;
  p_ = next;
  while (is_digit(at(p_))) ++p_;
  fault(block, "address-without-number",
        fmt::format("{}: a letter O stands where the digit 0 is meant",
                    line_.substr(from, p_ - from)),
        from, p_);
  return true;
}

// Reports what is a word elsewhere: a variable, an expression, a name. False: nothing of the kind.
bool StrangeText::word_of_others(Block& block) {
  const std::size_t from = p_;
  const char c = line_[p_];
  const auto tell = [&](std::string_view text, const char* what) {
    unsupported(block, text, what, from);
    return true;
  };
  if (c == '$') {
    while (p_ < line_.size() && (is_name(line_[p_]) || line_[p_] == '$')) ++p_;
    return tell(line_.substr(from, p_ - from), "a variable");
  }
  if (c == '#' && dialect_ != Dialect::sinumerik) {
    ++p_;
    while (is_digit(at(p_))) ++p_;
    return tell(line_.substr(from, p_ - from), "a variable");
  }
  if (c == '[') return tell("[", "an expression without its address, such as X[#1+2]");
  if (c == '<') {
    const std::size_t close = line_.substr(from, kNearby).find('>');
    if (close == line_.npos) return false;
    p_ = from + close + 1;
    return tell(line_.substr(from, std::min<std::size_t>(p_ - from, 40)), "the name of a program");
  }
  return c == ',' && is_letter(at(p_ + 1)) && tell(line_.substr(from, 2), "a corner word");
}

void StrangeText::character(Block& block) {
  if (word_of_others(block)) return;
  const std::size_t from = p_;
  const char c = line_[p_];
  const auto byte = static_cast<unsigned char>(c);
  if (c == '(' && dialect_ == Dialect::sinumerik) {
    p_ = std::min(line_.find(')', p_), line_.size() - 1) + 1;
    return fault(block, "character", "( has no meaning here; a comment begins with ;", from, p_);
  }
  ++p_;
  if (byte == 0) return fault(block, "character", "a NUL byte: is this a text file?", from, p_);
  if (byte >= 0x80) {
    const bool dash = is_dash(line_.substr(from));
    while (p_ < line_.size() && static_cast<unsigned char>(line_[p_]) >= 0x80) ++p_;
    return fault(block, "character",
                 fmt::format("a character outside of ASCII, allowed only in comments{}",
                             dash ? ": a minus is written -" : ""),
                 from, p_);
  }
  if (byte < 0x20 || byte == 0x7F)
    return fault(block, "character", fmt::format("control character 0x{:02X}", byte), from, p_);
  if (c == ',' && from > 0 && is_digit(line_[from - 1]) && is_digit(at(p_))) {
    while (is_digit(at(p_))) ++p_;
    return fault(block, "character", ", has no meaning here: a decimal point is written .", from,
                 p_);
  }
  const std::string_view before = line_.substr(0, from);
  const bool nested =
      c == ')' &&
      before.substr(before.size() - std::min(kNearby, before.size())).find('(') != before.npos;
  fault(block, "character",
        fmt::format("{} has no meaning here{}", c,
                    nested ? ": a comment ends at its first ), one in another too" : ""),
        from, p_);
}

// FANUC reads "G1 95" as G195; whoever wrote it meant something else. A sign may stand apart.
void StrangeText::check_inner_blanks(std::size_t from) {
  std::string_view token = line_.substr(from, p_ - from);
  token = token.substr(0, token.find_last_not_of(" \t") + 1);  // blanks behind it end the number
  const std::size_t blank = token.find_first_of(" \t", token.find_first_of("0123456789."));
  if (blank == std::string_view::npos) return;
  reporter_.add(
      Severity::warning, "blank-in-number",
      fmt::format("blanks mean nothing to this control: \"{}\" is one number; missing axis "
                  "letter?",
                  token.substr(0, 40)),
      static_cast<int>(from), static_cast<int>(token.size()));
}

void StrangeText::word(Block& block, std::size_t from) {
  p_ = from + 1;  // also behind "@" and "^", which are no names
  while (is_name(at(p_)) || at(p_) == '=' || at(p_) == '.') ++p_;
  const std::string_view token = line_.substr(from, p_ - from);
  const bool assigned = token.find('=') != std::string_view::npos;
  if (assigned || token.size() > 2)
    return fault(block, "word-unknown",
                 fmt::format("{} is not a word of this control{}", to_utf8(token.substr(0, 40)),
                             assigned ? " (is it a SINUMERIK program? --dialect sinumerik)" : ""),
                 from, p_);
  const bool zero = upper(line_[from]) == 'O' && from > 0 && is_digit(line_[from - 1]);
  fault(block, "address-without-number",
        fmt::format("no number after {}{}{}", upper(line_[from]), alarm("005"),
                    zero ? ": is the digit 0 meant?" : ""),
        from, p_);
}

}  // namespace mrsim
