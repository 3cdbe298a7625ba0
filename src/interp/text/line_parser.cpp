#include "interp/text/line_parser.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace mrsim {

void LineParser::skip_blanks() {
  while (p_ < line_.size() && blank(line_[p_])) ++p_;
}

void LineParser::fault(Block& block, const char* code, const std::string& text, std::size_t from,
                       std::size_t to) {
  block.bad = true;
  reporter_.add(Severity::error, code, text, static_cast<int>(from), static_cast<int>(to - from));
}

// On Fagor's controls N at the end of a block repeats a place; FANUC lets N stand anywhere.
void LineParser::block_number(Block& block, std::size_t from) {
  const std::size_t end = p_;
  skip_blanks();
  const bool again = block.has_number && (dialect_ != Dialect::iso || is_letter(at(p_)));
  p_ = end;
  block.has_number = true;
  if (!again) return;
  const std::string text =
      "N a second time in the block: is the end of a line lost here?" + alarm(nullptr, "12010");
  if (dialect_ == Dialect::sinumerik || dialect_ == Dialect::ngc)
    return fault(block, "address-twice", text, from, p_);
  if (block.words.empty()) return;
  reporter_.add(Severity::warning, "address-twice", text + " Its words are read as one block",
                static_cast<int>(from), static_cast<int>(p_ - from));
}

// The number of the alarm, " (alarm 004)", on a control that has one for this fault.
std::string LineParser::alarm(const char* fanuc, const char* sinumerik) const {
  const char* number = dialect_ == Dialect::fanuc       ? fanuc
                       : dialect_ == Dialect::sinumerik ? sinumerik
                                                        : nullptr;
  return number ? fmt::format(" (alarm {})", number) : std::string();
}

void LineParser::unsupported(Block& block, std::string_view word, std::string_view what,
                             std::size_t from) {
  fault(block, "not-supported",
        fmt::format("{} is {}, which is not supported yet; the block is not read",
                    to_utf8(word.substr(0, 40)), what),
        from, from + word.size());
  // What follows belongs to the word that is not supported.
  const bool comment = dialect_ == Dialect::sinumerik;
  while (p_ < line_.size() && line_[p_] != ';' && (comment || line_[p_] != '(')) ++p_;
}

void LineParser::push(Block& block, Word& word, std::size_t from) {
  word.column = static_cast<int>(from);
  word.length = static_cast<int>(p_ - from);
  if (block.words.size() > kMostWords) return;
  if (block.words.size() == kMostWords)
    fault(block, "block-too-long", fmt::format("more than {} words in a block", kMostWords), from,
          p_);
  block.words.push_back(word);
}

const char* LineParser::read_digits(const char* p, const char* end, Word& word) {
  const bool negative = p < end && *p == '-';
  if (negative || (p < end && *p == '+')) ++p;
  std::uint64_t mantissa = 0;
  const auto digits = [&] {
    const char* const first = p;
    for (; p < end; ++p) {
      const auto digit = static_cast<unsigned>(*p) - '0';
      if (digit > 9) break;
      mantissa = mantissa * 10 + digit;
    }
    return static_cast<std::size_t>(p - first);
  };
  std::size_t count = digits(), fraction = 0;
  word.point = p < end && *p == '.';
  if (word.point) {
    ++p;
    fraction = digits();
    count += fraction;
  }
  if (count == 0 || count > 15) return nullptr;
  const double whole = static_cast<double>(mantissa);
  const double value = fraction == 0 ? whole : whole / kPowersOfTen[fraction];
  if (value > kLargestNumber) return nullptr;
  word.value = negative ? -value : value;
  return p;
}

// Reads a number without an exponent. For any other: false, and p_ stays where it was.
bool LineParser::plain_number(Word& word, bool exponent) {
  const char *const begin = line_.data() + p_, *const end = line_.data() + line_.size();
  const char* const p = read_digits(begin, end, word);
  if (p == nullptr) return false;
  const char* behind = p;
  if (glued_blanks_)
    while (behind < end && blank(*behind)) ++behind;
  if (behind < end && (starts_number(*behind) || (exponent && upper(*behind) == 'E'))) return false;
  p_ += static_cast<std::size_t>(p - begin);
  return true;
}

// The number at p_. Requires: starts_number(at(p_)) or the fault is reported.
bool LineParser::number(Block& block, Word& word, bool exponent) {
  if (plain_number(word, exponent)) return true;
  const std::size_t from = p_;
  bool negative = false;
  if (at(p_) == '+' || at(p_) == '-') negative = line_[p_++] == '-';
  std::uint64_t mantissa = 0;
  int digits = 0, fraction = -1;
  for (;; ++p_) {
    const char c = at(p_);
    if (is_digit(c)) {
      if (mantissa != 0 || c != '0') ++digits;
      if (digits <= 15) mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
      if (fraction >= 0) ++fraction;
    } else if (c == '.' && fraction < 0) {
      fraction = 0;
    } else if (!(glued_blanks_ && blank(c) && p_ < line_.size())) {
      break;
    }
  }
  while (glued_blanks_ && p_ > from && blank(line_[p_ - 1])) --p_;
  const bool any = p_ > from && (is_digit(line_[p_ - 1]) || p_ - from > 1);
  const char follows = at(p_);
  const bool odd =
      follows == '.' || follows == '+' || follows == '-' || (exponent && upper(follows) == 'E');
  if (!any || digits > 15 || fraction > 15 || odd) return number_slow(block, word, from, exponent);
  const double value = fraction > 0 ? static_cast<double>(mantissa) /
                                          kPowersOfTen[static_cast<std::size_t>(fraction)]
                                    : static_cast<double>(mantissa);
  word.value = negative ? -value : value;
  word.point = fraction >= 0;
  if (value <= kLargestNumber && (fraction != 0 || p_ - from > 1 + (negative ? 1U : 0U)))
    return true;
  return number_slow(block, word, from, exponent);
}

bool LineParser::number_slow(Block& block, Word& word, std::size_t from, bool exponent) {
  p_ = from;
  std::string text;
  while (p_ < line_.size() && (starts_number(line_[p_]) || (glued_blanks_ && blank(line_[p_])))) {
    if (!blank(line_[p_])) text += line_[p_];
    ++p_;
  }
  if (exponent && upper(at(p_)) == 'E' && upper(at(p_ + 1)) == 'X') {
    text += 'e';
    p_ += 2;
    while (p_ < line_.size() && (is_digit(line_[p_]) || line_[p_] == '-' || line_[p_] == '+'))
      text += line_[p_++];
  }
  word.point = text.find('.') != std::string::npos;
  const std::optional<double> value = parse_number(text, exponent);
  if (value && *value <= kLargestNumber && *value >= -kLargestNumber) {
    word.value = *value;
    return true;
  }
  const std::string shown = text.substr(0, 40);
  const bool zero = from > 1 && upper(line_[from - 1]) == 'O' && is_digit(line_[from - 2]);
  const bool is_one = text.find('.') == text.rfind('.') &&
                      text.find_last_of("+-") + 1 <= 1;  // no sign but the first
  if (is_one && text.size() > 9 && text.find_first_of("0123456789") != std::string::npos)
    fault(block, "number-too-large", fmt::format("{} is too large (limit 1e9)", shown), from, p_);
  else
    fault(block, "number-malformed",
          fmt::format(
              "\"{}\" is not a number{}{}", shown,
              alarm(text.rfind('-') + 1 > 1 || text.rfind('+') + 1 > 1 ? "006" : "007", "12080"),
              zero ? ": does a letter O before it stand for the digit 0?" : ""),
          from, p_);
  return false;
}

// A statement ends the block of words: it is read and carried out by the language.
bool LineParser::statement(Block& block, std::size_t from) {
  if (!language_ || !language_->starts_statement(line_, from)) return false;
  if (!block.words.empty()) {
    fault(block, "statement-not-alone", "a statement stands alone in its block", from, from + 1);
    p_ = line_.size();
  } else {
    block.statement = p_ = from;
  }
  return true;
}

void LineParser::assignment(Block& block, std::size_t from) {
  p_ = from;
  if (language_->assignment(line_, p_)) return;
  block.bad = true;
  p_ = line_.size();
}

// Gives the word its value. False: it has none, because it is vacant or failed.
bool LineParser::expression(Block& block, Word& word, bool whole) {
  const LanguageReader::Answer answer = language_->value(line_, p_, word, whole);
  word.point = true;  // only written numbers count least increments
  if (answer == LanguageReader::Answer::failed) {
    block.bad = true;
    p_ = line_.size();
  }
  return answer == LanguageReader::Answer::value;
}

// Whether a variable, a bracket or a function stands behind an address, with or without signs.
bool LineParser::expression_follows(std::size_t from) const {
  if (!language_) return false;
  while (at(from) == '-' || at(from) == '+' || (blank(at(from)) && from < line_.size())) ++from;
  const char c = at(from);
  if (dialect_ == Dialect::codesys) {  // a name needs a blank before it: "X abs{-2}"
    const bool apart = from > 0 && !is_letter(line_[from - 1]);
    return c == '$' || c == '#' || c == '{' || c == '\'' ||
           (apart && is_letter(c) && language_->starts_function(line_, from));
  }
  if (dialect_ == Dialect::iso) return c == '(' || (upper(c) == 'P' && is_digit(at(from + 1)));
  return c == '#' || c == '[' || (is_letter(c) && language_->starts_function(line_, from));
}

// Whether an operator stands behind the number at p_, so that CODESYS reads an expression.
bool LineParser::operator_follows() const {
  std::size_t from = p_;
  while (from < line_.size() && blank(line_[from])) ++from;
  std::size_t end = from;
  while (is_letter(at(end))) ++end;
  if (end == from)
    return at(from) != '\0' && std::string_view("*/+-=<>").find(at(from)) != line_.npos;
  const std::string name = upper_case(line_.substr(from, std::min<std::size_t>(end - from, 4)));
  return name == "MOD" || name == "AND" || name == "OR" || name == "XOR";
}

}  // namespace mrsim
