#include "interp/text/sinumerik_words.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"
#include "interp/text/code_names.h"
#include "interp/text/codes.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kLongestVariable = 32;
constexpr std::pair<std::string_view, Address> kAddresses[] = {
    {"CR", Address::cr},     {"AR", Address::ar},       {"AP", Address::ap},
    {"RP", Address::rp},     {"TURN", Address::turn},   {"RND", Address::rnd},
    {"RNDM", Address::rndm}, {"CHF", Address::chf},     {"CHR", Address::chr},
    {"FZ", Address::fz},     {"ANG", Address::ang},     {"FRC", Address::frc},
    {"FRCM", Address::frcm}, {"RPL", Address::rpl},     {"LIMS", Address::lims},
    {"SF", Address::sf},     {"DISC", Address::disc},   {"OFFN", Address::offn},
    {"SPOS", Address::data}, {"SPOSA", Address::data},  {"ADIS", Address::data},
    {"MEAS", Address::meas}, {"MEAW", Address::meas},   {"ADISPOS", Address::data},
    {"OVR", Address::data},  {"OVRRAP", Address::data}, {"FP", Address::data},
    {"CTOL", Address::data}, {"OTOL", Address::data},   {"STOLF", Address::data},
    {"SVC", Address::data},  {"FB", Address::data},     {"DITS", Address::data},
    {"DITE", Address::data}, {"ATOL", Address::data}};

// Names of the tool carrier, of tool offsets and tilts: read only where they are switched off by 0.
constexpr std::string_view kOffWithZero[] = {"TCARR",  "TOFF",   "TOFFL", "TOFFR",
                                             "TOFFLR", "CUTMOD", "LEAD",  "TILT"};

Address find_address(std::string_view name) {
  for (const auto& [known, address] : kAddresses)
    if (known == name) return address;
  return Address::none;
}

}  // namespace

std::string missing_equal_sign(std::string_view name) {
  std::size_t letters = 0;
  while (letters < name.size() && is_letter(name[letters])) ++letters;
  const std::string_view digits = name.substr(letters);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) return {};
  std::size_t end = letters;
  if (find_address(upper_case(name.substr(0, letters))) == Address::none) {
    if (letters != 2 || upper(name[1]) != 'R') return {};
    end = 1;  // "XR1"
  }
  return fmt::format("; is {}={} meant?", name.substr(0, end), name.substr(end));
}

void SinumerikWords::read(Block& block) {
  const std::size_t from = p_;
  const char c = upper(line_[p_]);
  char n = at(p_ + 1);
  if (is_letter(n) || n == '_' || c == '_' || calls_number()) return name(block);
  Word word;
  word.address = letter(c);
  ++p_;
  while (blank(n) && p_ < line_.size()) n = at(++p_);
  if (n == '=') {
    ++p_;
    if (value(block, word)) push(block, word, from);
    return;
  }
  if (n == ':' && block.words.empty()) return label(block, from, from + 1);
  if (n == '[' && c == 'R' && language_) return assignment(block, from);
  if (n == '[') return arrays_.read(block, from, std::string(1, c));
  if (lacks_equal_sign(block, from)) return;
  if (!starts_number(n))
    return fault(block, "address-without-number", fmt::format("no number after {}", c), from, p_);
  if (!number(block, word, true)) return;
  if (at(p_) == ':' && block.words.empty()) return short_label(block, from);
  std::size_t sign = p_;
  while (sign < line_.size() && blank(line_[sign])) ++sign;
  if (at(sign) == '=' && at(sign + 1) != '=') p_ = sign;  // "R1 = 5"
  if (at(p_) == '=') return numbered_address(block, word, from, c);
  if (c == 'N') return block_number(block, from);
  push(block, word, from);
}

// "L70(5)": a call with arguments.
bool SinumerikWords::calls_number() const {
  std::size_t end = p_ + 1;
  while (is_digit(at(end))) ++end;
  const bool numbered = upper(line_[p_]) == 'L' && end > p_ + 1;
  while (numbered && end < line_.size() && blank(line_[end])) ++end;
  return numbered && at(end) == '(';
}

// "X-R1" and "X(R1+2)": an expression stands behind "=".
bool SinumerikWords::lacks_equal_sign(Block& block, std::size_t from) {
  std::size_t end = p_;
  while (at(end) == '-' || at(end) == '+') ++end;
  const bool parameter = upper(at(end)) == 'R' && (is_digit(at(end + 1)) || at(end + 1) == '[');
  if (!parameter && at(end) != '(' && at(end) != '$') return false;
  fault(block, "address-without-number",
        fmt::format("= is missing: what is computed stands behind it, as in {}=R1 (alarm 12080)",
                    upper(line_[from])),
        from, end + 1);
  p_ = std::min(line_.find(';', end), line_.size());
  return true;
}

// I1= X1= S2= M2= R5=: `word` has the number, the place is at the "=".
void SinumerikWords::numbered_address(Block& block, Word& word, std::size_t from, char c) {
  const int index = static_cast<int>(word.value);
  ++p_;
  if (c == 'R' && language_) return assignment(block, from);
  if (c == 'R') return unsupported(block, line_.substr(from, p_ - from), "a variable", from);
  if (index == 1 && c == 'T') {  // T1= names a tool of the first spindle, as M1=6 changes it
    if (value(block, word)) push(block, word, from);
    return;
  }
  if (index == 1 && (c == 'I' || c == 'J' || c == 'K'))
    word.address = c == 'I' ? Address::i1 : c == 'J' ? Address::j1 : Address::k1;
  else if (index >= 2 && index <= 7 && c >= 'A' && c <= 'C')
    word.address = Address::data;  // the direction of the tool
  else if (c == 'S' || c == 'M' || c == 'H' || c == 'X' || c == 'Y' || c == 'Z')
    word.address = Address::data;
  else
    fault(block, "address-unknown",
          fmt::format("unknown address {}", line_.substr(from, p_ - from - 1)), from, p_);
  word.code = static_cast<Code>(c);  // the letter, which matters for a few
  if (!value(block, word) || word.address == letter(c)) return;
  if (index == 1 && c == 'M' && word.value == 6) {
    word.address = letter(c);
    word.code = Code::unknown;
  }
  push(block, word, from);
}

// "NAME:"; p_ is at the colon.
void SinumerikWords::label(Block& block, std::size_t from, std::size_t end) {
  ++p_;
  if (end - from < 2 || end - from > kLongestVariable)
    fault(block, "label-length", fmt::format("a label has 2 to {} characters", kLongestVariable),
          from, end);
}

// "L1:" and "N10:" are words, so they name no place.
void SinumerikWords::short_label(Block& block, std::size_t from) {
  ++p_;
  const std::string_view name = line_.substr(from, p_ - from - 1);
  const char* advice = upper(name.front()) == 'N'
                           ? "a block number is the target of a jump without a colon"
                           : "a label begins with two letters or underscores, such as LB1:";
  fault(block, "label-length", fmt::format("{} is a word with a number: {}", name, advice), from,
        p_);
}

bool SinumerikWords::zero_follows() {
  skip_blanks();
  const std::size_t from = p_;
  while (at(p_) == '0' || at(p_) == '.') ++p_;
  return p_ > from && (at(p_) == '\0' || at(p_) == ';' || blank(at(p_)));
}

void SinumerikWords::name(Block& block) {
  const std::size_t from = p_;
  while (is_name(at(p_))) ++p_;
  const std::string_view token = line_.substr(from, p_ - from);
  const std::string name = upper_case(token.substr(0, 33));
  const std::size_t after_name = p_;
  skip_blanks();
  const char c = at(p_);
  if (c == ':' && block.words.empty()) return label(block, from, after_name);
  const bool assigned = (c == '=' && at(p_ + 1) != '=') || c == '[';
  if (assigned && language_ && language_->is_variable(token)) return assignment(block, from);
  p_ = after_name;
  if (!assigned && statement(block, from)) return;
  skip_blanks();
  if (c == '=' && at(p_ + 1) != '=') {
    Word word;
    word.address = find_address(name);
    ++p_;
    if (word.address != Address::none) {
      if (value(block, word)) push(block, word, from);
      return;
    }
    for (const std::string_view off : kOffWithZero)
      if (name == off && zero_follows()) return;
    constexpr std::string_view kOther =
        "no variable of DEF or of a .DEF file (--path), but an address";
    const bool action = name == "ID" || name == "IDS";  // ID=1 WHEN ...
    return unsupported(block, token, action ? unsupported_name(name) : kOther, from);
  }
  if (c == '(') return call(block, from, token);
  if (name == "MCALL") {
    block.modal_call = true;
    return;
  }
  if (c == '[') return arrays_.read(block, from, name);
  p_ = after_name;
  const CodeEntry entry = find_function(name);
  Word word;
  if (entry.code != Code::unknown) {
    word.address = Address::function;
    word.code = entry.code;
    if (entry.code == Code::header) p_ = line_.size();  // PROC NAME ...
    word.text = token;
    return push(block, word, from);
  }
  program_name(block, from, token);
}

// A name that is no function: a subprogram's, alone or behind CALL.
void SinumerikWords::program_name(Block& block, std::size_t from, std::string_view token) {
  const std::string name = upper_case(token.substr(0, 33));
  Word word;
  word.address = Address::call;
  if (name == "CALL" || name == "EXTCALL") {
    skip_blanks();
    if (at(p_) != '"') return unsupported(block, token, "a call by variable", from);
    text_value(block, word);
    skip_blanks();
    if (upper_case(line_.substr(std::min(p_, line_.size()), 6)) == "BLOCK ")
      return unsupported(block, token, "a call of a part of another program (BLOCK)", from);
    if (!block.bad) push(block, word, from);
    return;
  }
  for (const std::string_view cycle : cycles_of_802()) {
    if (name != cycle) continue;
    block.function_name = cycle;
    return;
  }
  const std::string_view what = unsupported_name(name);
  if (!what.empty()) return unsupported(block, token, what, from);
  if (token.size() > kLongestVariable)
    return fault(block, "name-too-long",
                 fmt::format("a name has at most {} characters", kLongestVariable), from, p_);
  word.text = token;
  push(block, word, from);
}

// Moves the place from a "(" behind the ")" that closes it. Quotes hide brackets. False: there is
// none, which is reported.
bool SinumerikWords::skip_brackets(Block& block) {
  const std::size_t open = p_;
  int depth = 0;
  bool quoted = false;
  for (; p_ < line_.size(); ++p_) {
    const char c = line_[p_];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) break;
  }
  if (quoted)
    fault(block, "string-unterminated", "a text is not closed with \" (alarm 12080)", open,
          open + 1);
  else if (depth != 0)
    fault(block, "bracket", "the ( here is not closed (alarm 12080)", open, open + 1);
  else
    ++p_;
  return !quoted && depth == 0;
}

// NAME( ... ): a call with arguments.
void SinumerikWords::call(Block& block, std::size_t from, std::string_view token) {
  const std::size_t open = p_;
  if (!skip_brackets(block)) return;
  const std::string_view argument = line_.substr(open + 1, p_ - open - 2);
  const std::string name = upper_case(token.substr(0, 33));
  for (const std::string_view harmless : harmless_calls())
    if (name == harmless) return;
  if (name == "GEOAX" && argument.find_first_not_of(" \t") == argument.npos) return;  // X, Y, Z
  for (const std::string_view read : read_calls()) {
    if (name != read) continue;
    block.function_name = read;
    block.argument = argument;
    return;
  }
  Word word;
  word.address = Address::call;
  word.text = token;
  const std::size_t first = argument.find_first_not_of(" \t");
  if ((name == "EXTCALL" || name == "CALL") && first != std::string_view::npos &&
      argument[first] == '"' && argument.find('"', first + 1) != std::string_view::npos) {
    word.string = true;
    word.text = argument.substr(first + 1, argument.find('"', first + 1) - first - 1);
    return push(block, word, from);
  }
  const CodeEntry entry = find_function(name);
  if (entry.code == Code::unsupported) {  // TRAORI(1) is refused as TRAORI
    word.address = Address::function;
    word.code = entry.code;
    return push(block, word, from);
  }
  std::string_view what = unsupported_name(name);
  if (entry.code != Code::unknown) what = "a function with arguments";
  if (what.empty() && first == std::string_view::npos) return push(block, word, from);
  if (what.empty())
    return fault(block, "subprogram-missing",
                 fmt::format("{0} is no cycle and no subprogram: in this file one begins with "
                             "%_N_{0}_SPF and PROC {0}, else it is a file {0}.SPF beside it",
                             name),
                 from, p_);
  unsupported(block, token, what, from);
}

}  // namespace mrsim
