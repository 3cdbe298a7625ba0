#include "interp/text/special_words.h"

#include "interp/text/characters.h"
#include "interp/text/code_names.h"
#include "interp/text/codes.h"

#include <algorithm>
#include <iterator>
#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Instructions of Fagor's 8060 to 8070 that change no path; any of them may be switched off.
constexpr std::string_view kFagorHarmless[] = {"HSC",    "MSG",   "SLOPE", "FREE",     "DFHOLD",
                                               "EFHOLD", "ESBLK", "DSBLK", "ROUNDPAR", "ESTOP",
                                               "DSTOP",  "FLUSH", "ACC",   "FEEDNDES", "TIME"};

}  // namespace

// IF, WHILE, GOTO ... of the macro languages.
bool SpecialWords::macro_word(Block& block) {
  std::size_t end = p_;
  while (is_letter(at(end))) ++end;
  const std::string name = upper_case(line_.substr(p_, std::min<std::size_t>(end - p_, 12)));
  const std::string_view what = name.size() < 2 ? std::string_view() : unsupported_name(name);
  if (what.empty()) return false;
  const std::size_t from = p_;
  p_ = end;
  unsupported(block, line_.substr(from, end - from), what, from);
  return true;
}

// "#HSC ON [CONTERROR 0.01]" of Fagor's 8060 to 8070.
bool SpecialWords::fagor_instruction(Block& block) {
  if (dialect_ != Dialect::iso || !is_letter(at(p_ + 1))) return false;
  const std::size_t from = p_++;
  while (is_letter(at(p_))) ++p_;
  const std::string name = upper_case(line_.substr(from + 1, p_ - from - 1));
  const std::size_t end = std::min(line_.find(';', p_), line_.size());
  const std::string rest = upper_case(line_.substr(p_, end - p_));
  const bool off = rest.find("OFF") != rest.npos;
  const bool harmless = std::find(std::begin(kFagorHarmless), std::end(kFagorHarmless), name) !=
                        std::end(kFagorHarmless);
  if (!harmless && !off)
    unsupported(block, line_.substr(from, p_ - from), "an instruction of Fagor's 8070", from);
  p_ = end;
  return true;
}

// "S1=1000" of Mitsubishi and machines with several spindles. Only the first spindle counts.
bool SpecialWords::spindle_speed(Block& block, Word& word) {
  if (dialect_ != Dialect::fanuc || !starts_number(at(p_ + 1))) return false;
  if (word.value != 1) word.address = Address::data;
  ++p_;
  return number(block, word, false);
}

// "G64 ON" and "G64 OFF" of Centroid switch smoothing.
bool SpecialWords::skips_switch(const Block& block) {
  const std::string name = upper_case(line_.substr(p_, 3));
  const std::size_t length = name.starts_with("OFF") ? 3 : name.starts_with("ON") ? 2 : 0;
  if (length == 0 || is_name(at(p_ + length)) || block.words.empty()) return false;
  const Word& before = block.words.back();
  if (before.address != letter('G') || before.value != 64) return false;
  p_ += length;
  return true;
}

// "M117 2D Pocket1" of Marlin: the text may begin with a digit.
bool SpecialWords::begins_message() const {
  if (dialect_ != Dialect::iso && dialect_ != Dialect::ngc) return false;
  const std::string_view number = line_.substr(p_, 3);
  return (number == "117" || number == "118") && blank(at(p_ + 3));
}

// Marlin shows the text behind M117 and M118, and words behind M0, on its display.
bool SpecialWords::has_message(const Word& word) const {
  if (dialect_ != Dialect::iso && dialect_ != Dialect::ngc) return false;
  if (word.value == 117 || word.value == 118) return true;
  std::size_t i = p_;
  while (blank(at(i))) ++i;
  return (word.value == 0 || word.value == 1) && is_letter(at(i)) && is_letter(at(i + 1));
}

// FANUC: ,R rounds the corner to the next block, ,C cuts it off, ,A is the angle of a line.
// Mitsubishi: ,S is the speed of a tap on its way back; ,I and ,J say how exactly a place is met.
// Mazak: ,K beside G61.1 says how exactly the shape is met.
bool SpecialWords::corner_word(Block& block) {
  const std::size_t from = p_;
  std::size_t value = p_ + 1;
  while (value < line_.size() && blank(line_[value])) ++value;
  const char c = upper(at(value));
  if ((dialect_ != Dialect::fanuc && dialect_ != Dialect::iso) ||
      std::string_view("RCASIJK").find(c) == std::string_view::npos)
    return false;
  ++value;
  while (value < line_.size() && blank(line_[value])) ++value;
  Word word;
  word.address = c == 'R'   ? Address::rnd
                 : c == 'C' ? Address::chr
                 : c == 'A' ? Address::ang
                            : Address::data;
  if (expression_follows(value)) {
    p_ = value;
    if (expression(block, word, false)) push(block, word, from);
    return true;
  }
  if (!starts_number(at(value))) return false;
  p_ = value;
  if (number(block, word, false)) push(block, word, from);
  return true;
}

// "G53 Z" of WinCNC goes to the machine's zero, "G28 X" of Marlin homes X, without a point between.
bool SpecialWords::bare_axis(Block& block) {
  const char axis = upper(at(p_));
  const auto has = [&](double g) {
    return std::any_of(block.words.begin(), block.words.end(), [g](const Word& word) {
      return word.address == letter('G') && word.value == g;
    });
  };
  if ((dialect_ != Dialect::ngc && dialect_ != Dialect::iso) || axis < 'X' || axis > 'Z' ||
      is_letter(at(p_ + 1)) || (!has(53) && !has(28)))
    return false;
  const std::size_t from = p_++;
  Word word;
  word.address = has(28) ? Address::data : letter(axis);
  word.code = static_cast<Code>(axis);
  push(block, word, from);
  word.column = static_cast<int>(from);
  word.length = 1;
  reporter_.once(Severity::note, "axis-without-number",
                 "an axis without a number: behind G53 it goes to the machine's zero (WinCNC), "
                 "behind G28 it is homed (Marlin)",
                 word, "axis-without-number");
  return true;
}

// L!4 of CODESYS is the label that G20 L?4 jumps to.
void SpecialWords::jump_label() {
  p_ = line_.find('!', p_) + 1;
  while (is_digit(at(p_))) ++p_;
}

void SpecialWords::codesys_name(Block& block) {
  const std::size_t from = p_;
  while (is_name(at(p_))) ++p_;
  const std::string_view token = line_.substr(from, p_ - from);
  const std::string name = upper_case(token);
  Word word;
  if ((name.starts_with("FF") || name.starts_with("EF")) &&
      (name.size() == 2 || is_digit(name[2]))) {
    p_ = from + 2;
    word.address = name[0] == 'F' ? Address::ff : Address::ef;
    if (number(block, word, false)) push(block, word, from);
    return;
  }
  word.address = Address::function;
  if (name == "SUBPROGRAM") {
    word.code = Code::header;
    p_ = line_.size();
    return push(block, word, from);
  }
  if (name == "END_SUBPROGRAM" || name == "RETURN") {
    word.code = Code::program_return;
    return push(block, word, from);
  }
  const std::string_view what = unsupported_name(name);
  if (!what.empty()) return unsupported(block, token, what, from);
  if (token.size() < 3 || token.size() > 80)
    return fault(block, "address-without-number",
                 fmt::format("no number after {}", name.substr(0, 1)), from, p_);
  word.address = Address::call;
  word.text = token;
  skip_blanks();
  if (at(p_) == '{') {
    const std::size_t close = line_.find('}', p_);
    if (close == std::string_view::npos)
      return fault(block, "bracket", "the { here is not closed", p_, p_ + 1);
    p_ = close + 1;
  }
  push(block, word, from);
}

// "$H" homes, as G28 does. "$X" and "$32=0" change the state or a setting of Grbl and move nothing,
// "?" asks for its state. "$J=" jogs. False: "$1" names a spindle of LinuxCNC.
bool SpecialWords::grbl_command(Block& block) {
  const std::string_view line = line_.substr(p_);
  if (line.front() == '?') {
    if (block.words.empty()) ++p_;
    return block.words.empty();
  }
  const std::size_t digits = line.find_first_not_of("0123456789", 1);
  const bool setting = digits != line.npos && (digits > 1 ? line[digits] == '=' : true);
  if (!block.words.empty() || line.size() < 2 || !setting) return false;
  const std::size_t from = p_;
  std::size_t end = line.find_last_not_of(" \t\r") + 1;
  end = std::min(end, line.find_first_of("(;"));
  p_ += end;
  if (upper(line[1]) == 'J') {
    unsupported(block, line.substr(0, std::min<std::size_t>(end, 40)), "a jog of Grbl", from);
  } else if (upper(line[1]) == 'H') {
    Word word;
    word.address = letter('G');
    word.value = 28;
    word.column = static_cast<int>(from);
    word.length = static_cast<int>(end);
    block.words.push_back(word);
  }
  return true;
}

}  // namespace mrsim
