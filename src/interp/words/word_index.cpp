#include "interp/words/word_index.h"

#include "core/text/text_io.h"
#include "interp/words/okuma_turning.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Writes the numbers of code systems B and C of FANUC's lathes anew as those of system A.
class CodeSystems : public ControlPart {
 public:
  explicit CodeSystems(Control& control) : ControlPart(control) {}

  // Called before the words are entered by address.
  void rewrite();

 private:
  bool has(std::string_view letters) const;
  void see_units();
  void rewrite_feed(Word& code);
  void rewrite_c(Word& code);
  void rename(Word& code, int number, int in_system_a);
};

bool CodeSystems::has(std::string_view letters) const {
  return std::any_of(block_.words.begin(), block_.words.end(), [&](const Word& word) {
    return word.address < Address::function &&
           letters.find(static_cast<char>(word.address)) != letters.npos;
  });
}

void CodeSystems::rewrite() {
  if (!lathe() || !is(Dialect::fanuc) || modal_.okuma) return;
  for (Word& code : block_.words) {
    if (code.address != letter('G')) continue;
    if (code.value == 70 || code.value == 71) see_units();
    if (modal_.system_c) rewrite_c(code);
    if (code.value >= 77 && code.value <= 79 && has("XZUW")) modal_.has_increments = true;
    rewrite_feed(code);
    // System A has no G91. Its G92 is the thread, that of B and C sets the zero.
    if (code.value == 92 && modal_.has_increments && modal_.turn.number != 92 && has("XZUW") &&
        !has("FEI"))
      code.value = 50;
  }
}

// System A has no G95 but for a tap with a live tool (Haas). Its G94 is the facing cycle and no
// motion stands beside it; that of B and C is the feed per minute, and their G98 and G99 say where
// the tool goes between holes.
void CodeSystems::rewrite_feed(Word& code) {
  if (code.value == 95 && !has("R")) modal_.has_increments = true;
  if (code.value == 94 && (modal_.has_increments || block_.has_code('G', 0, 3)))
    code.value = 98;
  else if ((code.value == 98 || code.value == 99) && modal_.has_increments &&
           (modal_.drill.number != 0 || block_.has_code('G', 80, 89)))
    code.address = Address::data;
}

// G70 and G71 without other words are units in system C; in A and B they are cycles.
void CodeSystems::see_units() {
  modal_.system_c = !has("PQRUWDIKA");
  modal_.has_increments |= modal_.system_c;
}

void CodeSystems::rewrite_c(Word& code) {
  const auto n = static_cast<int>(code.value);
  if (code.value != n) return;
  if (n >= 72 && n <= 78)
    rename(code, n - 2, n - 2);
  else if ((n == 20 || n == 21) && has("XZUW"))
    rename(code, n + 57, n == 20 ? 90 : 92);  // by system B: G90 is absolute
  else if (n == 24 && has("XZUW"))
    rename(code, 79, 94);
  else if (n == 92)
    code.value = 50;
  else if (n == 98 || n == 99)  // G98 and G99 say where the tool goes between holes
    code.address = Address::data;
}

void CodeSystems::rename(Word& code, int number, int in_system_a) {
  reporter_.once(Severity::warning, "code-system",
                 fmt::format("{} is read as in code system C, where it is G{} of system A, because "
                             "the program has its units by G70 or G71 alone",
                             text_of(code), in_system_a),
                 code, "code-system-c");
  code.value = number;
}

// G1900 to G1904 (a bar, a pipe, a box ...) only draw the blank.
bool is_blank_of_dialogue(const Word& cycle) { return cycle.value >= 1900 && cycle.value < 1905; }

}  // namespace

WordIndex::WordIndex(Control& control) : ControlPart(control) {
  const std::string_view letters = is(Dialect::sinumerik) ? "ABCDFGHIJKLMNOPSTXYZ"
                                   : is(Dialect::codesys) || is(Dialect::ngc)
                                       ? "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                   : is(Dialect::iso) ? "ABCDFGHIJKLMNOPQRSTXYZ"
                                   : lathe()          ? "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                      : "ABCDFGHIJKLMNOPQRSTXYZ";
  for (const char c : letters) legal_[static_cast<unsigned char>(c)] = true;
  if (is(Dialect::ngc)) legal_['@'] = legal_['^'] = legal_['$'] = true;
  for (auto a = static_cast<std::size_t>(Address::function); a < legal_.size(); ++a)
    legal_[a] = true;
}

// Reports an address that this control does not know.
bool WordIndex::refuse_address(const Word& word) {
  const auto c = static_cast<char>(word.address);
  if (c == 'U' && !is(Dialect::sinumerik))  // U is the time of G4
    for (const Word& other : block_.words)
      if (other.address == letter('G') && other.value == 4) return true;
  if (c == 'E' &&
      !is(Dialect::sinumerik))  // E is the tolerance of G131 and G187, the depth feed of G47
    for (const Word& other : block_.words)
      if (other.address == letter('G') &&
          (other.value == 131 || other.value == 187 || other.value == 47))
        return true;
  if (is(Dialect::sinumerik) && c == 'R')
    return error("not-supported",
                 "R is a variable of SINUMERIK, set by R1=5 and read by X=R1; for a radius write "
                 "CR=",
                 word);
  if (c == 'E' && chooses_fixture()) return true;
  return error("address-unknown",
               fmt::format("unknown address {}{}", c, is(Dialect::fanuc) ? " (alarm 009)" : ""),
               word);
}

// E of Fadal and Centroid is a work offset. It never stands beside a feed.
bool WordIndex::chooses_fixture() const {
  return is(Dialect::fanuc) && !lathe() && !block_.has_code('G', 1, 3);
}

// HA and DA of Okuma are the register whose number is that of the tool in the spindle. HB and HC
// are further ones of that tool, which the tool table does not have.
bool WordIndex::use_own_register(Word& word) {
  const std::optional<double> tool = parse_number(control_.tool.current);
  if (word.value == 1 && tool) {
    word.value = *tool;
    word.own = false;
    return true;
  }
  return error("value-missing",
               fmt::format("{} is a register of the tool in the spindle (Okuma), {}: write its "
                           "number",
                           text_of(word),
                           word.value == 1 ? "where no tool with a number is"
                                           : "of which the tool table has the first alone"),
               word);
}

// G1040T1.L20.: a G word of four digits begins a cycle of FANUC's dialogue, which has its own
// addresses.
const Word* WordIndex::dialogue_cycle() const {
  if (!is(Dialect::fanuc)) return nullptr;
  for (const Word& word : block_.words)
    if (word.address == letter('G') && word.value >= 1000 && word.value < 3000) return &word;
  return nullptr;
}

// In G54.1 P2 M98 P5001 each P stands right behind its word. Gives the P of the offset, or null.
const Word* WordIndex::number_of_offset() const {
  if (!is(Dialect::fanuc) && !is(Dialect::iso)) return nullptr;
  const Word* offset = nullptr;
  bool called = false;
  for (std::size_t i = 1; i < block_.words.size(); ++i) {
    if (block_.words[i].address != letter('P')) continue;
    const Word& owner = block_.words[i - 1];
    const double v = owner.value;
    if (owner.address == letter('G') && (v == 54 || v == 54.1 || v == 154))
      offset = &block_.words[i];
    called = called || (owner.address == letter('M') && (v == 97 || v == 98 || v == 198));
  }
  return called ? offset : nullptr;
}

// L of "G75 X40. L2." and "G76 X40. L2." of Okuma's lathes is a chamfer or a rounding at the end of
// the line. FANUC's cycles of these numbers have no L.
void WordIndex::read_okuma_corner() {
  if (!lathe() || !is(Dialect::fanuc)) return;
  Word* code = nullptr;
  Word* size = nullptr;
  for (Word& word : block_.words) {
    const auto c = static_cast<char>(word.address);
    if (c == 'P' || c == 'Q' || c == 'R' || c == 'K' || c == 'D') return;
    if (c == 'G' && (word.value == 75 || word.value == 76)) code = &word;
    if (c == 'L') size = &word;
  }
  if (!code || !size) return;
  size->address = code->value == 75 ? Address::chr : Address::rnd;
  code->address = Address::data;
}

// MANUAL GUIDE's blank is left out, its cycles are refused.
bool WordIndex::leave_out_dialogue(const Word& cycle) {
  const auto codes = std::count_if(block_.words.begin(), block_.words.end(),
                                   [](const Word& w) { return w.address == letter('G'); });
  if (!is_blank_of_dialogue(cycle) || codes > 1)
    return error("not-supported",
                 fmt::format("{} is a cycle of MANUAL GUIDE i, which is not supported: let the "
                             "control convert the program (NC CNV)",
                             text_of(cycle)),
                 cycle);
  note_once("simulator-line",
            fmt::format("{} is the blank of MANUAL GUIDE's own picture: left out; --stock says "
                        "the same here",
                        text_of(cycle)),
            cycle, "simulator-line");
  block_.words.clear();
  return true;
}

// G and M words may stand several times in a block, and a few letters of some controls.
bool WordIndex::may_repeat(const Word& word) const {
  const auto c = static_cast<char>(word.address);
  return c == 'G' || c == 'M' || word.address == Address::function ||
         word.address == Address::data || (is(Dialect::sinumerik) && c == 'H') ||
         (is(Dialect::fanuc) && c == 'T') ||
         (is(Dialect::codesys) && (c == 'E' || c == 'H' || c == 'L' || c == 'O'));
}

bool WordIndex::refuse_repeat(const Word& word) {
  const auto c = static_cast<char>(word.address);
  const bool axis = (c >= 'I' && c <= 'K') || (c >= 'X' && c <= 'Z');
  const std::string alarm =
      is(Dialect::sinumerik) ? axis ? " (alarm 16420)" : " (alarm 12010)" : "";
  const std::string name =
      word.address < Address::function
          ? std::string(1, c)
          : std::string(block_.line.substr(static_cast<std::size_t>(word.column),
                                           static_cast<std::size_t>(word.length)));
  return error("address-twice", fmt::format("{} is given twice in the block{}", name, alarm), word);
}

bool WordIndex::run() {
  if (const Word* cycle = dialogue_cycle()) return leave_out_dialogue(*cycle);
  read_okuma_corner();
  CodeSystems(control_).rewrite();
  bool ok = OkumaTurning(control_).rewrite();
  block_.offset_number = number_of_offset();
  for (std::size_t i = 0; i < block_.words.size(); ++i) {
    if (block_.words[i].own && !use_own_register(block_.words[i])) ok = false;
    const Word& word = block_.words[i];
    if (&word == block_.offset_number) continue;
    if (!legal_[static_cast<std::size_t>(word.address)] && !refuse_address(word)) ok = false;
    const bool repeats = may_repeat(word);
    if (!block_.add(i, repeats) && !repeats) ok = refuse_repeat(word);
  }
  return ok;
}

// Reports a known address that no part has taken.
void WordIndex::report_unused() {
  for (const Word& word : block_.words) {
    if (!block_.unused(word.address)) continue;
    warning("word-without-effect",
            fmt::format("{} has no effect in this block",
                        block_.line.substr(static_cast<std::size_t>(word.column),
                                           static_cast<std::size_t>(std::min(word.length, 40)))),
            word);
  }
}

}  // namespace mrsim
