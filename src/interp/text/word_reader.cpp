#include "interp/text/word_reader.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"
#include "interp/text/codes.h"
#include "interp/text/line_scan.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace mrsim {

bool WordReader::read(Block& block) {
  skip_blanks();
  const bool any = p_ < line_.size();
  do plain_words(block);
  while (p_ < line_.size() && step(block) == Step::more);
  return any;
}

// Reads words such as "X10. Y-2.5": a letter and a number that ends at a blank, a letter or the end
// of the line, as nearly all words are. Stops at any other word, which step() reads.
void WordReader::plain_words(Block& block) {
  if (dialect_ == Dialect::sinumerik || dialect_ == Dialect::codesys) return;
  const char *const begin = line_.data(), *const end = begin + line_.size();
  for (const char* p = begin + p_; p < end && block.words.size() < kMostWords;) {
    const char c = upper(*p);
    if (!is_letter(c) || c == 'M' || c == 'O' || c == 'V') return;
    if (c == 'G' && !block.contour.empty()) return;
    if (c == 'N' && block.has_number) return;
    Word word;
    const char* const number_end = read_digits(p + 1, end, word);
    if (number_end == nullptr) return;
    if (number_end < end && upper(*number_end) == 'E') return;  // perhaps an exponent
    const char* next = number_end;
    while (next < end && blank(*next)) ++next;
    if (next < end && !is_letter(*next)) return;
    if (c == 'N') {
      block.has_number = true;
    } else {
      word.address = letter(c);
      word.column = static_cast<int>(p - begin);
      word.length = static_cast<int>(number_end - p);
      block.words.push_back(word);
    }
    p = next;
    p_ = static_cast<std::size_t>(p - begin);
  }
}

// A statement takes the rest of its block.
WordReader::Step WordReader::letter_step(Block& block) {
  if (dialect_ == Dialect::sinumerik) {
    sinumerik_.read(block);
  } else if (upper(line_[p_]) == 'N' && dialect_ == Dialect::codesys && is_digit(at(p_ + 1)) &&
             (block.has_number || !block.words.empty())) {
    reporter_.add(Severity::warning, "blocks-on-one-line",
                  "a second N word on the line: a new block is taken to start here",
                  static_cast<int>(p_), 1);
    return Step::end_of_block;
  } else {
    letter_word(block);
  }
  return block.statement == Block::kNoStatement ? Step::more : Step::end_of_block;
}

void WordReader::end_sign() {
  Word sign;
  sign.column = static_cast<int>(p_);
  sign.length = 1;
  reporter_.once(
      Severity::note, "block-end-sign",
      fmt::format("{} at the end of a line prints the end of a block: left out", line_[p_]), sign,
      "block-end-sign");
  ++p_;
}

WordReader::Step WordReader::step(Block& block) {
  const char c = line_[p_];
  if (is_letter(c) || c == '_') return letter_step(block);
  if (dialect_ == Dialect::ngc && (c == '$' || c == '?') && special_.grbl_command(block))
    return Step::more;
  if (dialect_ == Dialect::ngc && (c == '@' || c == '^' || c == '$')) {
    letter_word(block);
    return Step::more;
  }
  if (blank(c)) {
    ++p_;
  } else if (c == '/' && at(p_ + 1) == '/') {
    slashes(block);
  } else if ((c == '*' || c == '$') && is_end_sign()) {
    end_sign();
  } else if (c == '%' && ends_tape(block)) {
    p_ = line_.size();
  } else if (c == ';' && ends_block()) {
    ++p_;
    return Step::end_of_block;
  } else if (c == ';') {
    read_comment(block, '\0');
  } else if (((c == '(' && dialect_ == Dialect::iso) || (c == '[' && dialect_ == Dialect::fanuc)) &&
             statement(block, p_)) {
    return block.statement == Block::kNoStatement ? Step::more : Step::end_of_block;
  } else if (c == '(' && dialect_ != Dialect::sinumerik) {
    read_comment(block, ')');
  } else if (starts_number(c)) {
    bare_number(block);
  } else if (c == '#' && special_.fagor_instruction(block)) {
    return Step::more;
  } else if (language_ && c == (dialect_ == Dialect::sinumerik ? '$' : '#')) {
    assignment(block, p_);
  } else if (!skip_rest(block) && (!block.words.empty() || !head_of_block(block)) &&
             !okuma_.program_in_brackets(block) && !(c == ',' && special_.corner_word(block))) {
    strange_.character(block);
  }
  return Step::more;
}

// "//" begins a comment in the software of some routers. No control writes block skip twice.
void WordReader::slashes(Block& block) {
  Word sign;
  sign.column = static_cast<int>(p_);
  sign.length = 2;
  block.comments.push_back(line_.substr(p_ + 2));
  p_ = line_.size();
  reporter_.once(Severity::note, "slash-comment", "what stands behind // is read as a comment",
                 sign, "slash-comment");
}

// Listings print the end of a block as "*" or "$".
bool WordReader::is_end_sign() const {
  return (dialect_ == Dialect::fanuc || dialect_ == Dialect::iso) && p_ > 0 &&
         line_.find_first_not_of(" \t\r", p_ + 1) == line_.npos;
}

// "M30%": the line break before the last character of the tape is missing.
bool WordReader::ends_tape(const Block& block) const {
  return line_.find_first_not_of(" \t\r", p_ + 1) == line_.npos &&
         std::any_of(block.words.begin(), block.words.end(), [](const Word& word) {
           return word.address == letter('M') &&
                  (word.value == 2 || word.value == 30 || word.value == 99);
         });
}

// FANUC ends blocks with ";". What follows is another block if the line ends with ";" as well
// ("G1X1;Y2;"), else a comment.
bool WordReader::ends_block() const {
  if (dialect_ != Dialect::fanuc) return false;
  const std::size_t last = line_.find_last_not_of(" \t\r");
  return line_[last] == ';';
}

// "[BILLET X100 Y80 Z15" of Denford is for a simulation, and no word of the control.
bool WordReader::is_directive() const {
  if (line_[p_] != '[' || (dialect_ != Dialect::fanuc && dialect_ != Dialect::iso)) return false;
  const std::string head = upper_case(line_.substr(p_ + 1, 8));
  return head.starts_with("BILLET") || head == "EDGEMOVE" || head.starts_with("TOOLDEF") ||
         head == "STEP";
}

// The place behind "!L10" or "!2L10" of Mitsubishi's lathes with several paths, or 0.
std::size_t WordReader::end_of_wait() const {
  if (dialect_ != Dialect::fanuc || at(p_) != '!') return 0;
  std::size_t end = p_ + 1;
  while (at(end) == '!' || is_digit(at(end)) || (blank(at(end)) && end < line_.size())) ++end;
  if (upper(at(end)) != 'L' || !is_digit(at(end + 1))) return 0;
  for (++end; is_digit(at(end));) ++end;
  return end;
}

// Reads what may only stand before the words: "%", "/2", ":1234".
bool WordReader::head_of_block(Block& block) {
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
                   "[BILLET, [EDGEMOVE, [TOOLDEF and [STEP are for Denford's simulation: left out; "
                   "--stock and --tool say the same here",
                   word, "simulator-line");
  } else if (c == '/' && block.skip_level < 0) {
    ++p_;
    std::size_t level = p_;
    while (blank(at(level)) && level < line_.size()) ++level;
    if (is_digit(at(level))) p_ = level;
    block.skip_level = is_digit(at(p_)) ? at(p_++) - '0' : 0;
    if (skips_level(skip_, block.skip_level)) p_ = line_.size();
  } else if (const std::size_t end = end_of_wait(); end > 0) {
    word.column = static_cast<int>(from);
    word.length = static_cast<int>(end - from);
    p_ = end;
    reporter_.once(Severity::note, "path-wait",
                   "! and L are where two paths of a lathe wait for one another: left out, as the "
                   "other path is not read",
                   word, "path-wait");
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

// "G0 Z50. /2M9" of FANUC: words behind the slash are left out where block skip 2 is in force.
bool WordReader::skip_rest(Block& block) {
  if (line_[p_] != '/' || dialect_ != Dialect::fanuc || block.words.empty()) return false;
  std::size_t end = p_ + 1;
  const int level = is_digit(at(end)) ? at(end++) - '0' : 0;
  while (blank(at(end)) && end < line_.size()) ++end;
  if (!is_letter(at(end))) return false;
  warn_of_division(block, end);
  block.inner_skip = level;
  p_ = skips_level(skip_, level) ? line_.size() : end;
  return true;
}

// "X#1/2 F9": the slash is block skip, but whoever wrote it probably means a division.
void WordReader::warn_of_division(const Block& block, std::size_t end) {
  const Word& last = block.words.back();
  const auto from = static_cast<std::size_t>(last.column);
  const bool variable = line_.substr(from, p_ - from).find('#') != line_.npos;
  if (!variable || blank(line_[p_ - 1]) || !is_digit(at(p_ + 1))) return;
  Word word;
  word.column = last.column;
  word.length = static_cast<int>(end - from);
  reporter_.add(Severity::warning, "block-skip-inside",
                "this / skips the rest of the block where its switch is on, it divides nothing: a "
                "division stands in brackets, X[#1/2]; a skip has a blank before it",
                word);
}

void WordReader::read_comment(Block& block, char close) {
  const std::size_t from = p_ + 1;
  if (close == '\0') {
    strange_.doubt_comment(block);
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
  if (text.find('(') != text.npos) end_of_outer_comment(block);
}

// "(HOLE (61.0, 67.7))": where the outer comment ends behind the inner one, no word is lost.
void WordReader::end_of_outer_comment(Block& block) {
  const std::size_t outer = line_.find(')', p_);
  if (outer == line_.npos || line_.find('(', p_) < outer) return;
  const bool at_once = line_.find_first_not_of(" \t", p_) == outer;
  p_ = outer;  // the words of an outer comment are no block
  if (!at_once) return strange_.character(block);
  reporter_.add(Severity::warning, "comment-nested",
                "a comment ends at its first ): some controls stop at this second one",
                static_cast<int>(p_++), 1);
}

void WordReader::bare_number(Block& block) {
  const std::size_t from = p_;
  while (p_ < line_.size() && (starts_number(line_[p_]))) ++p_;
  const std::string text(line_.substr(from, std::min<std::size_t>(p_ - from, 40)));
  const bool named = dialect_ == Dialect::fanuc && block.words.empty() && text.size() == 5 &&
                     text[0] == '0' && text.find_first_not_of("0123456789") == text.npos;
  fault(block, "number-without-address",
        named
            ? fmt::format("{}: the digit 0 stands where the letter O is meant, of a program", text)
            : fmt::format("{} has no address; missing axis letter before {}?{}", text, text,
                          alarm("004")),
        from, p_);
}

// Whether "E-14" or "E+01" is glued to the number that ends here, as programming languages print
// exponents. LinuxCNC has E as a word only beside G76 and M66 to M68.
bool WordReader::exponent_follows(const Block& block, char address) const {
  if (upper(at(p_)) != 'E' || (dialect_ != Dialect::fanuc && dialect_ != Dialect::ngc) ||
      address == 'G' || address == 'M')
    return false;
  const bool sign = at(p_ + 1) == '+' || at(p_ + 1) == '-';
  std::size_t end = p_ + (sign ? 2 : 1);
  if (!is_digit(at(end))) return false;
  while (is_digit(at(end))) ++end;
  if (at(end) == '.') return false;
  return sign || (dialect_ == Dialect::ngc &&
                  std::none_of(block.words.begin(), block.words.end(), [](const Word& word) {
                    return (word.address == letter('G') && word.value == 76) ||
                           (word.address == letter('M') && word.value >= 66 && word.value <= 68);
                  }));
}

// The word of the letter `c` at `from`, whose number, or whose expression that begins with a
// number, is at the place.
void WordReader::numbered_word(Block& block, std::size_t from, char c) {
  Word word;
  word.address = letter(c);
  if (c == 'M' && special_.begins_message()) {
    word.value = parse_number(line_.substr(p_, 3)).value_or(0);
    push(block, word, from);
    p_ = std::min(line_.find(';', p_), line_.size());
    return;
  }
  const std::size_t digits = p_;
  const bool plain = plain_number(word, false), whole = dialect_ == Dialect::codesys;
  if (plain ? whole && operator_follows() : expression_follows(p_)) {
    p_ = digits;
    if (expression(block, word, whole)) push(block, word, from);
    return;
  }
  if (!plain && !number(block, word, false)) return;
  if (exponent_follows(block, c)) {
    for (p_ += 2; is_digit(at(p_));) ++p_;
    return fault(block, "number-malformed",
                 "numbers of this control have no exponent: write them out", digits, p_);
  }
  if (c == 'S' && at(p_) == '=' && special_.spindle_speed(block, word))
    return push(block, word, from);
  if (glued_blanks_) strange_.check_inner_blanks(digits);
  if (c == 'N') return block_number(block, from);
  push(block, word, from);
  if (c == 'G' && word.value == 84 && !block.contour.empty()) return okuma_.skip_conditions(block);
  if (c == 'M' && special_.has_message(word)) p_ = std::min(line_.find(';', p_), line_.size());
}

void WordReader::letter_word(Block& block) {
  const std::size_t from = p_;
  const char c = upper(line_[p_]);
  const bool early =
      (c == 'O' && dialect_ == Dialect::ngc) || (c == 'G' && dialect_ == Dialect::codesys);
  if (early && statement(block, from)) return;
  if (block.words.empty() && okuma_.assigns_name()) return assignment(block, from);
  if (strange_.zero_as_letter(block)) return;
  ++p_;
  if (dialect_ != Dialect::codesys) skip_blanks();
  const bool fadal = c == 'R' && at(p_) == '0' && (at(p_ + 1) == '+' || at(p_ + 1) == '-');
  if (fadal && dialect_ == Dialect::fanuc) ++p_;  // "R0+.1": the level of a cycle is a parameter
  const char n = at(p_);
  if (starts_number(n)) return numbered_word(block, from, c);
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
  if (n == '!' && c == 'L' && dialect_ == Dialect::codesys) return special_.jump_label();
  if (n == '#' || n == '[' || n == '$') return strange_.character(block);
  p_ = from;
  if (statement(block, from) || okuma_.block_name(block) || okuma_.contour_name(block)) return;
  if (dialect_ == Dialect::codesys && (is_letter(n) || n == '_'))
    return special_.codesys_name(block);
  if (special_.macro_word(block) || okuma_.register_word(block) || okuma_.pattern(block) ||
      special_.skips_switch(block) || special_.bare_axis(block) || okuma_.program(block))
    return;
  strange_.word(block, from);
}

}  // namespace mrsim
