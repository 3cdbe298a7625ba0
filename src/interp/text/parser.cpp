#include "interp/text/parser.h"

#include "core/text_io.h"
#include "interp/text/characters.h"
#include "interp/text/codes.h"
#include "interp/text/line_scan.h"

#include <array>
#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Exact: a mantissa below 2^53 divided by a power of ten up to 10^22 is correctly rounded.
constexpr std::array<double, 16> kPowersOfTen = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
constexpr std::size_t kLongestBlock = 512;  // characters, SINUMERIK
constexpr std::size_t kMostWords = 4096;    // words of a block

}  // namespace

Parser::Parser(Dialect dialect, Reporter& reporter)
    : dialect_(dialect),
      reporter_(reporter),
      glued_blanks_(dialect == Dialect::fanuc || dialect == Dialect::ngc) {}

void Parser::skip_blanks() {
  while (p_ < line_.size() && blank(line_[p_])) ++p_;
}

void Parser::fault(Block& block, const char* code, const std::string& text, std::size_t from,
                   std::size_t to) {
  block.bad = true;
  reporter_.add(Severity::error, code, text, static_cast<int>(from), static_cast<int>(to - from));
}

// " (alarm 004)" on a control that numbers this fault.
std::string Parser::alarm(const char* fanuc, const char* sinumerik) const {
  const char* number = dialect_ == Dialect::fanuc       ? fanuc
                       : dialect_ == Dialect::sinumerik ? sinumerik
                                                        : nullptr;
  return number ? fmt::format(" (alarm {})", number) : std::string();
}

void Parser::unsupported(Block& block, std::string_view word, std::string_view what,
                         std::size_t from) {
  fault(block, "not-supported",
        fmt::format("{} is {}, which is not supported yet; the block is not read",
                    to_utf8(word.substr(0, 40)), what),
        from, from + word.size());
  // The rest belongs to the unread construct.
  const bool comment = dialect_ == Dialect::sinumerik;
  while (p_ < line_.size() && line_[p_] != ';' && (comment || line_[p_] != '(')) ++p_;
}

void Parser::push(Block& block, Word& word, std::size_t from) {
  word.column = static_cast<int>(from);
  word.length = static_cast<int>(p_ - from);
  if (block.words.size() > kMostWords) return;
  if (block.words.size() == kMostWords)
    fault(block, "block-too-long", fmt::format("more than {} words in a block", kMostWords), from,
          p_);
  block.words.push_back(word);
}

bool Parser::next(Block& block, std::size_t& position) {
  block.words.clear();
  block.comments.clear();
  block.argument = block.function_name = block.name = block.contour = {};
  block.skip_level = -1;
  block.modal_call = false;
  block.statement = Block::kNoStatement;
  block.bad = block.has_number = block.no_hole = false;
  line_ = block.line;
  p_ = position;
  if (p_ == 0 && dialect_ == Dialect::sinumerik && line_.size() > kLongestBlock)
    fault(block, "block-too-long",
          fmt::format("{} characters, and a block has at most {}", line_.size(), kLongestBlock),
          kLongestBlock, line_.size());
  skip_blanks();
  const bool any = p_ < line_.size();
  while (p_ < line_.size() && step(block) == Step::more) {
  }
  position = p_;
  return any;
}

Parser::Step Parser::step(Block& block) {
  const char c = line_[p_];
  if (is_letter(c) || c == '_') {
    if (dialect_ == Dialect::sinumerik) {
      sinumerik_word(block);
      return block.statement == Block::kNoStatement ? Step::more : Step::end_of_block;
    }
    if (upper(c) == 'N' && dialect_ == Dialect::codesys && is_digit(at(p_ + 1)) &&
        (block.has_number || !block.words.empty())) {
      reporter_.add(Severity::warning, "blocks-on-one-line",
                    "a second N word on the line: a new block is taken to start here",
                    static_cast<int>(p_), 1);
      return Step::end_of_block;
    }
    letter_word(block);
    return block.statement == Block::kNoStatement ? Step::more : Step::end_of_block;
  }
  if (dialect_ == Dialect::ngc && c == '$' && grbl_command(block)) return Step::more;
  if (dialect_ == Dialect::ngc && (c == '@' || c == '^' || c == '$')) {
    letter_word(block);
    return Step::more;
  }
  if (blank(c)) {
    ++p_;
  } else if ((c == '*' || c == '$') && is_end_sign()) {
    Word sign;
    sign.column = static_cast<int>(p_++);
    sign.length = 1;
    reporter_.once(Severity::note, "block-end-sign",
                   fmt::format("{} at the end of a line prints the end of a block: left out", c),
                   sign, "block-end-sign");
  } else if (c == ';' && ends_block()) {
    ++p_;
    return Step::end_of_block;
  } else if (c == ';') {
    read_comment(block, '\0');
  } else if (c == '(' && dialect_ == Dialect::iso && statement(block, p_)) {
    return block.statement == Block::kNoStatement ? Step::more : Step::end_of_block;
  } else if (c == '(' && dialect_ != Dialect::sinumerik) {
    read_comment(block, ')');
  } else if (starts_number(c)) {
    bare_number(block);
  } else if (c == '#' && fagor_instruction(block)) {
    return Step::more;
  } else if (language_ && c == (dialect_ == Dialect::sinumerik ? '$' : '#')) {
    assignment(block, p_);
  } else if (!skip_rest(block) && (!block.words.empty() || !head_of_block(block))) {
    strange_character(block);
  }
  return Step::more;
}

// Listings print the end of a block as "*" or "$".
bool Parser::is_end_sign() const {
  return (dialect_ == Dialect::fanuc || dialect_ == Dialect::iso) && p_ > 0 &&
         line_.find_first_not_of(" \t\r", p_ + 1) == line_.npos;
}

// FANUC ends blocks with ";". Behind one that is not the last there is another block, if the line
// ends with ";" too ("G1X1;Y2;"); else a comment.
bool Parser::ends_block() const {
  if (dialect_ != Dialect::fanuc) return false;
  const std::size_t last = line_.find_last_not_of(" \t\r");
  return line_[last] == ';';
}

// "[BILLET X100 Y80 Z15" of Denford: for a simulation, no word of the control.
bool Parser::is_directive() const {
  if (line_[p_] != '[' || (dialect_ != Dialect::fanuc && dialect_ != Dialect::iso)) return false;
  const std::string head = upper_case(line_.substr(p_ + 1, 8));
  return head.starts_with("BILLET") || head == "EDGEMOVE" || head.starts_with("TOOLDEF");
}

// What stands only before the words: "%", "/2", ":1234".
bool Parser::head_of_block(Block& block) {
  const std::size_t from = p_;
  const char c = line_[p_];
  Word word;
  if (c == '%') {
    word.address = Address::function;
    word.code = Code::header;
    word.text = line_.substr(p_);
    p_ = line_.size();
    push(block, word, from);
  } else if (is_remark(line_, p_)) {
    block.comments.push_back(line_.substr(p_ + 1, line_.rfind(']') - p_ - 1));
    p_ = line_.size();
  } else if (is_directive()) {
    p_ = line_.size();
    word.column = static_cast<int>(from);
    word.length = 1;
    reporter_.once(Severity::note, "simulator-line",
                   "[BILLET, [EDGEMOVE and [TOOLDEF are for Denford's simulation: left out; "
                   "--stock and --tool say the same here",
                   word, "simulator-line");
  } else if (c == '/' && block.skip_level < 0) {
    ++p_;
    block.skip_level = is_digit(at(p_)) ? at(p_++) - '0' : 0;
    if ((skip_ >> block.skip_level & 1U) != 0) p_ = line_.size();
  } else if (c == ':' && is_digit(at(p_ + 1))) {
    const bool program = dialect_ != Dialect::sinumerik && names_program(line_, p_);
    ++p_;
    word.address = letter('O');
    if (number(block, word, false) && program) push(block, word, from);
  } else if (c == '$' && dialect_ == Dialect::fanuc && p_ + 2 < line_.size() &&
             line_.find_last_not_of(" \t\r") == line_.rfind('%')) {
    p_ = line_.size();  // Okuma: $NAME.MIN%
  } else if (c == '$' && dialect_ == Dialect::fanuc &&
             upper_case(line_.substr(p_ + 1, 8)).find("G84") != line_.npos) {
    p_ = line_.size();  // "$ G84 XB=40 DB=2": more of the line before, see skip_conditions()
  } else {
    return false;
  }
  return true;
}

// "G0 Z50. /2M9" of FANUC: what stands behind the sign is left out where its level is.
bool Parser::skip_rest(const Block& block) {
  if (line_[p_] != '/' || dialect_ != Dialect::fanuc || block.words.empty()) return false;
  std::size_t end = p_ + 1;
  const int level = is_digit(at(end)) ? at(end++) - '0' : 0;
  while (blank(at(end)) && end < line_.size()) ++end;
  if (!is_letter(at(end))) return false;
  p_ = (skip_ >> level & 1U) != 0 ? line_.size() : end;
  return true;
}

void Parser::read_comment(Block& block, char close) {
  const std::size_t from = p_ + 1;
  if (close == '\0') {
    doubt_comment(block);
    block.comments.push_back(line_.substr(from));
    p_ = line_.size();
    return;
  }
  const std::size_t end = line_.find(close, from);
  if (end == std::string_view::npos) {
    fault(block, "comment-unterminated", "the comment that starts here is not closed with )", p_,
          p_ + 1);
    p_ = line_.size();
    return;
  }
  const std::string_view text = line_.substr(from, end - from);
  block.comments.push_back(text);
  p_ = end + 1;
  const std::size_t outer = line_.find(')', p_);
  if (text.find('(') == text.npos || outer == line_.npos || line_.find('(', p_) < outer) return;
  p_ = outer;  // words of an outer comment are no blocks
  strange_character(block);
}

void Parser::bare_number(Block& block) {
  const std::size_t from = p_;
  while (p_ < line_.size() && (starts_number(line_[p_]))) ++p_;
  const std::string text(line_.substr(from, std::min<std::size_t>(p_ - from, 40)));
  fault(
      block, "number-without-address",
      fmt::format("{} has no address; missing axis letter before {}?{}", text, text, alarm("004")),
      from, p_);
}

// A number of at most 15 digits that ends where its digits do, as nearly all are. False, and p_
// where it was, for any other.
bool Parser::plain_number(Word& word, bool exponent) {
  const char *const begin = line_.data() + p_, *const end = line_.data() + line_.size();
  const char* p = begin;
  const bool negative = p < end && *p == '-';
  if (p < end && (*p == '-' || *p == '+')) ++p;
  std::uint64_t mantissa = 0;
  const auto read_digits = [&] {
    const char* const first = p;
    for (; p < end && is_digit(*p); ++p)
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    return static_cast<std::size_t>(p - first);
  };
  std::size_t digits = read_digits(), fraction = 0;
  const bool point = p < end && *p == '.';
  if (point) {
    ++p;
    fraction = read_digits();
    digits += fraction;
  }
  if (digits == 0 || digits > 15) return false;
  if (glued_blanks_)
    while (p < end && blank(*p)) ++p;
  if (p < end && (starts_number(*p) || (exponent && upper(*p) == 'E'))) return false;
  while (glued_blanks_ && blank(p[-1])) --p;
  const double value = static_cast<double>(mantissa) / kPowersOfTen[fraction];
  if (value > kLargestNumber) return false;
  word.value = negative ? -value : value;
  word.point = point;
  p_ += static_cast<std::size_t>(p - begin);
  return true;
}

// The number at p_. Requires: starts_number(at(p_)) or the fault is reported.
bool Parser::number(Block& block, Word& word, bool exponent) {
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

void Parser::letter_word(Block& block) {
  const std::size_t from = p_;
  const char c = upper(line_[p_]);
  const bool early =
      (c == 'O' && dialect_ == Dialect::ngc) || (c == 'G' && dialect_ == Dialect::codesys);
  if (early && statement(block, from)) return;
  if (block.words.empty() && assigns_name()) return assignment(block, from);
  if (zero_as_letter(block)) return;
  ++p_;
  if (dialect_ != Dialect::codesys) skip_blanks();
  const bool fadal = c == 'R' && at(p_) == '0' && (at(p_ + 1) == '+' || at(p_ + 1) == '-');
  if (fadal && dialect_ == Dialect::fanuc) ++p_;  // "R0+.1": the level of a cycle is a parameter
  const char n = at(p_);
  if (starts_number(n)) {
    Word word;
    word.address = letter(c);
    const std::size_t digits = p_;
    const bool plain = plain_number(word, false), whole = dialect_ == Dialect::codesys;
    if (plain ? whole && operator_follows() : expression_follows(p_)) {
      p_ = digits;
      if (expression(block, word, whole)) push(block, word, from);
      return;
    }
    if (!plain && !number(block, word, false)) return;
    if (c == 'S' && at(p_) == '=' && spindle_speed(block, word)) return push(block, word, from);
    if (glued_blanks_) check_inner_blanks(digits);
    if (c == 'N') {
      block.has_number = true;
      return;
    }
    push(block, word, from);
    if (c == 'G' && word.value == 84 && !block.contour.empty()) return skip_conditions(block);
    if (c == 'M' && has_message(word)) p_ = std::min(line_.find(';', p_), line_.size());
    return;
  }
  if (n == '=' && dialect_ == Dialect::fanuc && language_) {  // "X=VC1*2" of Okuma
    Word word;
    word.address = letter(c);
    ++p_;
    if (expression(block, word, true)) push(block, word, from);
    return;
  }
  if (language_ && !(c == 'O' && is_letter(n)) && expression_follows(p_)) {
    Word word;
    word.address = letter(c);
    if (expression(block, word, dialect_ == Dialect::codesys)) push(block, word, from);
    return;
  }
  if (n == '!' && c == 'L' && dialect_ == Dialect::codesys) return jump_label();
  if (n == '#' || n == '[' || n == '$') return strange_character(block);
  p_ = from;
  if (statement(block, from) || block_name(block) || contour_name(block)) return;
  if (dialect_ == Dialect::codesys && (is_letter(n) || n == '_')) return codesys_name(block);
  if (macro_word(block) || okuma_word(block) || okuma_pattern(block) || skips_switch(block) ||
      okuma_program(block))
    return;
  unknown_word(block, from);
}

}  // namespace mrsim
