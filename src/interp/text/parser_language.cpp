// Where words meet the control's language: expressions as values, assignments, statements.
#include "interp/text/characters.h"
#include "interp/text/codes.h"
#include "interp/text/line_scan.h"
#include "interp/text/parser.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Names with an index in brackets that are without effect on geometry: SPOS[2]=90, ACC[X]=50.
constexpr std::string_view kHarmlessArrays[] = {
    "SPOS",    "SPOSA",   "POLF",     "POLFMASK", "ACC",     "OVRA",     "FA",  "FL",   "FGREF",
    "VELOLIM", "ACCLIMA", "VELOLIMA", "LIMS",     "JERKLIM", "JERKLIMA", "FXS", "FXST", "FXSW"};

// Instructions of Fagor's 8060 to 8070 that change no path; any of them may be switched off.
constexpr std::string_view kFagorHarmless[] = {"HSC",    "MSG",   "SLOPE", "FREE",     "DFHOLD",
                                               "EFHOLD", "ESBLK", "DSBLK", "ROUNDPAR", "ESTOP",
                                               "DSTOP",  "FLUSH", "ACC",   "FEEDNDES", "TIME"};

struct GroupOfCodes {
  int group;
  std::initializer_list<double> codes;
};

// G[n]=m is the m-th code of group n.
const GroupOfCodes kGroups[] = {{1, {0, 1, 2, 3}},
                                {6, {17, 18, 19}},
                                {7, {40, 41, 42}},
                                {8, {500, 54, 55, 56, 57}},
                                {10, {60, 64, 641, 642, 643, 644, 645}},
                                {13, {70, 71, 700, 710}},
                                {14, {90, 91}},
                                {15, {93, 94, 95, 96, 97}},
                                {18, {450, 451}}};

double code_of_group(double group, double index) {
  for (const GroupOfCodes& row : kGroups)
    if (row.group == group && index >= 1 && index <= static_cast<double>(row.codes.size()))
      return row.codes.begin()[static_cast<std::size_t>(index) - 1];
  return -1;
}

}  // namespace

// A statement ends the block of words: it is read and carried out by the language.
bool Parser::statement(Block& block, std::size_t from) {
  if (!language_ || !language_->starts_statement(line_, from)) return false;
  if (!block.words.empty()) {
    fault(block, "statement-not-alone", "a statement stands alone in its block", from, from + 1);
    p_ = line_.size();
  } else {
    block.statement = p_ = from;
  }
  return true;
}

void Parser::assignment(Block& block, std::size_t from) {
  p_ = from;
  if (language_->assignment(line_, p_)) return;
  block.bad = true;
  p_ = line_.size();
}

// The value of a word. False: there is none, because it is vacant or because it failed.
bool Parser::expression(Block& block, Word& word, bool whole) {
  const LanguageReader::Answer answer = language_->value(line_, p_, word, whole);
  word.point = true;  // least increments are for numbers that are written
  if (answer == LanguageReader::Answer::failed) {
    block.bad = true;
    p_ = line_.size();
  }
  return answer == LanguageReader::Answer::value;
}

// Behind an address: a variable, a bracket or a function, with or without signs.
bool Parser::expression_follows(std::size_t from) const {
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

// CODESYS: behind a number that an expression begins with.
bool Parser::operator_follows() const {
  std::size_t from = p_;
  while (from < line_.size() && blank(line_[from])) ++from;
  std::size_t end = from;
  while (is_letter(at(end))) ++end;
  if (end == from)
    return at(from) != '\0' && std::string_view("*/+-=<>").find(at(from)) != line_.npos;
  const std::string name = upper_case(line_.substr(from, std::min<std::size_t>(end - from, 4)));
  return name == "MOD" || name == "AND" || name == "OR" || name == "XOR";
}

// L!4 of CODESYS: where G20 L?4 jumps to.
void Parser::jump_label() {
  p_ = line_.find('!', p_) + 1;
  while (is_digit(at(p_))) ++p_;
}

// NAME[index]=value, which is no variable: an axis by AX[ ], a code by G[ ], or data without effect
// on geometry. p_ on the bracket.
// POS[Z3]=-200, POSA[Q1]=0: a sub-spindle, a tailstock or a loader.
bool Parser::of_other_axis(std::size_t close) const {
  std::string axis = upper_case(line_.substr(p_ + 1, close - p_ - 1));
  std::erase(axis, ' ');
  return axis.size() > 1 || axis < "X" || axis > "Z";
}

void Parser::array_word(Block& block, std::size_t from, const std::string& name) {
  const std::string_view run = line_.substr(from, name.size());
  const bool read = language_ && (name == "AX" || name == "G");
  std::size_t close = line_.find(']', p_);
  const bool harmless =
      std::find(std::begin(kHarmlessArrays), std::end(kHarmlessArrays), name) !=
          std::end(kHarmlessArrays) ||
      (name.starts_with("POS") && close != std::string_view::npos && of_other_axis(close));
  Word index;
  if (read) {
    ++p_;
    if (!expression(block, index, true)) return;
    skip_blanks();
    close = at(p_) == ']' ? p_ : std::string_view::npos;
  }
  if ((!read && !harmless) || close == std::string_view::npos)
    return unsupported(block, run, "an array", from);
  p_ = close + 1;
  skip_blanks();
  if (at(p_) != '=') return unsupported(block, run, "an array", from);
  ++p_;
  Word word;
  word.address = Address::data;
  if (!sinumerik_value(block, word)) return;
  if (name == "AX") {
    const char axis = index.string && index.text.size() == 1 ? upper(index.text[0]) : '\0';
    if (axis < 'X' || axis > 'Z') return unsupported(block, run, "an axis other than X Y Z", from);
    word.address = letter(axis);
  } else if (name == "G") {
    word.address = letter('G');
    const double code = code_of_group(index.value, word.value);
    if (code < 0) return unsupported(block, run, "a code of this group", from);
    word.value = code;
  }
  push(block, word, from);
}

// IF, WHILE, GOTO ... of the macro languages.
bool Parser::macro_word(Block& block) {
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
bool Parser::fagor_instruction(Block& block) {
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

// "S1=1000" of Mitsubishi and machines with several spindles: those of others are of no account.
bool Parser::spindle_speed(Block& block, Word& word) {
  if (dialect_ != Dialect::fanuc || !starts_number(at(p_ + 1))) return false;
  if (word.value != 1) word.address = Address::data;
  ++p_;
  return number(block, word, false);
}

// "G64 ON" and "G64 OFF" of Centroid: smoothing.
bool Parser::skips_switch(const Block& block) {
  const std::string name = upper_case(line_.substr(p_, 3));
  const std::size_t length = name.starts_with("OFF") ? 3 : name.starts_with("ON") ? 2 : 0;
  if (length == 0 || is_name(at(p_ + length)) || block.words.empty()) return false;
  const Word& before = block.words.back();
  if (before.address != letter('G') || before.value != 64) return false;
  p_ += length;
  return true;
}

// Marlin: what stands behind M117 and M118, and as words behind M0, is for its display.
bool Parser::has_message(const Word& word) const {
  if (dialect_ != Dialect::iso && dialect_ != Dialect::ngc) return false;
  if (word.value == 117 || word.value == 118) return true;
  std::size_t i = p_;
  while (blank(at(i))) ++i;
  return (word.value == 0 || word.value == 1) && is_letter(at(i)) && is_letter(at(i + 1));
}

// FANUC: ,R rounds the corner to the next block, ,C cuts it off, ,A is the angle of a line.
// Mitsubishi: ,S is the speed of a tap on its way back, ,I and ,J how exactly a place is met.
// Mazak: ,K beside G61.1 is how exactly its shape is.
bool Parser::corner_word(Block& block) {
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

void Parser::codesys_name(Block& block) {
  const std::size_t from = p_;
  while (is_name(at(p_))) ++p_;
  const std::string_view run = line_.substr(from, p_ - from);
  const std::string name = upper_case(run);
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
  if (!what.empty()) return unsupported(block, run, what, from);
  if (run.size() < 3 || run.size() > 80)
    return fault(block, "address-without-number",
                 fmt::format("no number after {}", name.substr(0, 1)), from, p_);
  word.address = Address::call;
  word.text = run;
  skip_blanks();
  if (at(p_) == '{') {
    const std::size_t close = line_.find('}', p_);
    if (close == std::string_view::npos)
      return fault(block, "bracket", "the { here is not closed", p_, p_ + 1);
    p_ = close + 1;
  }
  push(block, word, from);
}

// "$H" homes, as G28 does; "$X", "$32=0" and the like tell Grbl something and move nothing; "$J="
// jogs. False: "$1" names a spindle of LinuxCNC.
bool Parser::grbl_command(Block& block) {
  const std::string_view line = line_.substr(p_);
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
