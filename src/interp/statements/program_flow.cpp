#include "interp/statements/program_flow.h"

#include "core/text/text_io.h"
#include "interp/text/m_codes.h"
#include "interp/text/sinumerik_words.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kMostM = 5;  // M words in a block of SINUMERIK

}  // namespace

bool ProgramFlow::begin_block() {
  call_begins_ = nullptr;
  const Word* program = is(Dialect::codesys) ? nullptr : take('O');
  if (reader_.ends_at_header(program)) {
    block_.forget_words();
    block_.return_after = block_.stop_after = false;
    return true;
  }
  if (const Word* call = take(Address::call)) block_.call_word = call;
  if (const Word* l = is(Dialect::sinumerik) ? take('L') : nullptr) block_.call_word = l;
  if (block_.call_word && !alone(*block_.call_word)) return false;
  for (const Word& word : block_.words)
    if (is(Dialect::sinumerik) && word.code == Code::program_return && block_.words.size() > 1 &&
        word.address == Address::function)
      warning("call-not-alone", "RET stands alone in its block", word);
  if ((is(Dialect::fanuc) || is(Dialect::iso)) && block_.words.size() == 1 && peek('L'))
    return error("call-without-program",
                 "L alone calls a subprogram on other controls (Fadal, DIN): write M98 P or G65 P",
                 block_.words.front());
  if (block_.call_word || find(letter('M'))) {  // repeats of a call
    take('P');
    if (!is(Dialect::codesys)) take('L');
  }
  return true;
}

// Whether the call stands alone in its block. A name beside other words is an unknown word.
bool ProgramFlow::alone(const Word& call) {
  bool others = false, known = true;
  for (const Word& word : block_.words) {
    if (&word == &call || word.address == letter('P')) continue;
    others = true;
    if (word.address != Address::call) continue;
    known =
        error("word-unknown", fmt::format("{} is not a word of this control", text_of(word)), word);
  }
  if (!others) return true;
  if (call.address == Address::call && !call.string)
    return error(
        "word-unknown",
        fmt::format("{} is not a word of this control{}, and a call stands alone in its block{}",
                    text_of(call), is(Dialect::sinumerik) ? " (alarm 12550)" : "",
                    is(Dialect::sinumerik) ? missing_equal_sign(call.text) : ""),
        call);
  return known && error("call-not-alone", "a call stands alone in its block", call);
}

bool ProgramFlow::m_words() {
  bool ok = true;
  int count = 0;
  for (const Word& word : block_.words) {
    if (word.address != letter('M')) continue;
    if (is(Dialect::sinumerik) && ++count == kMostM + 1)
      ok = error("m-words", fmt::format("at most {} M words in a block", kMostM), word);
    if (!m_word(word)) ok = false;
  }
  leave_length();
  return ok;
}

// "G0 G49 Z0" and "G0 H0 Z0" of FANUC's mills: without the length of the tool, Z0 is the upper end
// of Z on the machine. Programs with these blocks have no length in the work offset.
void ProgramFlow::leave_length() {
  const Word* z = peek('Z');
  if (!z || z->value != 0 || lathe() || !(is(Dialect::fanuc) || is(Dialect::iso))) return;
  if (modal_.incremental || block_.suppress_frames || block_.oneshot || block_.frame_code ||
      current_motion() != Code::rapid || modal_.drill.number != 0)
    return;
  const Word* h = peek('H');
  const bool on = modal_.length != Code::length_off;
  if (block_.length_changed ? on : !h || h->value != 0) return;
  block_.home = z;
  block_.home_guessed = false;
  block_.forget(z->address);
}

// M17 switches motors on at boards of printers and the mills that they drive, so it is no return
// there.
bool ProgramFlow::returns_by_m17() const {
  if (is(Dialect::fanuc) || is(Dialect::ngc)) return false;
  return !is(Dialect::iso) || reader_.depth() > 1;
}

bool ProgramFlow::m_word(const Word& word) {
  const double v = word.value;
  if (v < 0 || v != std::floor(v) || v > 1e8)
    return error("value-range", "an M number is a whole number", word);
  const int m = static_cast<int>(v);
  const bool external = m == 198 && is(Dialect::fanuc);
  const bool by_hand = is(Dialect::iso) || is(Dialect::ngc);
  if (m == 0 || (m == 6 && by_hand)) control_.paused = true;
  if (m == 6) {
    block_.tool_change = true;
    changer_retracts(word);
  }
  if (m == 19 && !is(Dialect::ngc) && !peek('X') && !peek('Y') && !peek('Z')) take('R');  // angle
  if (m == 2 || m == 30)  // the same as M17 in a subprogram of SINUMERIK
    (is(Dialect::sinumerik) && reader_.depth() > 1 ? block_.return_after : block_.stop_after) =
        true;
  if (m == 17 && returns_by_m17()) block_.return_after = true;
  if (m >= 97 && m <= 99 && is(Dialect::sinumerik))
    return error("not-supported",
                 fmt::format("M{} calls or returns in ISO mode (G291), which is not supported yet; "
                             "is it a FANUC program? --dialect fanuc",
                             m),
                 word);
  if (m == 99) {
    const Word* p = peek('P');
    if (p && !statements_)
      return error("not-supported", "M99 P (return to a block number) is not supported yet", word);
    block_.return_after = true;
    block_.loops = true;
  }
  if (m >= 70 && m <= 73 && is(Dialect::ngc)) return statements_->saved_modes(m, word);
  if (is(Dialect::ngc) && linuxcnc_signal(m)) return true;
  if (m == 61 && is(Dialect::ngc)) {
    block_.set_tool = take('Q');
    block_.tool_change = true;
    return block_.set_tool || error("value-missing", "M61 needs Q, the tool in the spindle", word);
  }
  if (m == 97 || m == 98 || external) return call_word(word, m);
  if (m == 25 && z_home(word)) return true;
  if (m >= 52 && m <= 54 && okuma_return(m)) return true;
  if (find_m_code(control_.dialect, program_.machine, m) == MCode::unknown)
    note_once("m-unknown",
              fmt::format("M{} is not known: taken to be without effect on the part", m), word,
              fmt::format("M{}", m));
  return true;
}

// M words of LinuxCNC for inputs, outputs, overrides and the spindle's orientation, and M100 to
// M199, which are programs of the machine's owner, take their words. False: it is another M word.
bool ProgramFlow::linuxcnc_signal(int m) {
  const bool quiet = m == 19 || (m >= 48 && m <= 53) || (m >= 62 && m <= 68);
  if (!quiet && (m < 100 || m > 199)) return false;
  for (const char c : {'E', 'L', 'P', 'Q', 'R'}) take(c);
  return quiet;
}

// M25 of Centroid and Hurco moves Z to its upper end. That is certain if the program has M25 G49,
// as Centroid's posts write. Otherwise a cut that goes on without a Z shows that M25 was something
// else.
bool ProgramFlow::z_home(const Word& word) {
  if (lathe() || is(Dialect::sinumerik) || is(Dialect::codesys)) return false;
  for (const char c : {'X', 'Y', 'Z', 'I', 'J', 'K'})
    if (peek(c)) return false;
  const bool named = block_.has_group(Group::length);
  centroid_ = centroid_ || (named && modal_.length == Code::length_off);
  block_.home = &word;
  block_.home_guessed = !centroid_;
  return true;
}

// A tool change moves Z up to the changer. Tools of routers are changed by hand, but their programs
// are of other dialects.
void ProgramFlow::changer_retracts(const Word& word) {
  if (lathe() || !is(Dialect::fanuc) || block_.home) return;
  block_.home = &word;
  block_.home_guessed = true;
}

// M53 of Okuma: drilling cycles end at the level of G71 Z; M54: at R. False: the word is another
// control's.
bool ProgramFlow::okuma_return(int m) {
  if (!is(Dialect::fanuc) || (!modal_.return_level && !(modal_.okuma && m == 54))) return false;
  if (m == 52) return false;
  modal_.hole_return = m == 53 ? HoleReturn::level : HoleReturn::safe;
  return true;
}

// Calls by M97, M98 and M198 (a program on another device).
bool ProgramFlow::call_word(const Word& word, int m) {
  if (m == 97 && is(Dialect::iso))
    return error("not-supported", "M97 (a call of a block number) is not supported yet", word);
  if (m != 97 || is(Dialect::fanuc)) block_.m98 = &word;
  if (is(Dialect::ngc)) return true;
  for (const char c : {'Q', 'H'}) {
    if (!block_.m98 || !peek(c) || (c == 'H' && block_.length_changed)) continue;
    if (m != 97 && is(Dialect::fanuc)) {
      call_begins_ = take(c);
      if (!(call_begins_->value > 0) || call_begins_->value != std::floor(call_begins_->value))
        return error("value-range",
                     fmt::format("{} of M98 is the number of a block, a whole one above 0", c),
                     *call_begins_);
    } else {
      return error(
          "not-supported",
          fmt::format("M{0} with {1} (a call of a block number) is not supported yet: begin "
                      "that program with GOTO and the number, and leave {1} out",
                      m, c),
          word);
    }
  }
  return true;
}

// Whether P is only the number of a program: those of Haas have five digits and those of the 30i
// eight, so that 20002 is O20002 and not O0002.
bool ProgramFlow::is_whole_number(long number) {
  return reader_.has_subprogram({number, {}}) && !reader_.has_subprogram({number % 10000, {}});
}

// The name in M98 <SUB1> of FANUC's 30i, or in M98 (USB0/SUB1.NC) of Haas without its folders,
// which are not those here.
std::string ProgramFlow::program_name(const Word* p) const {
  if (p) return std::string(p->string ? p->text : std::string_view());
  if (!is(Dialect::fanuc) || block_.comments.empty()) return {};
  const std::string_view path = block_.comments.front();
  const std::size_t last = path.find_last_of("/\\");
  const std::string_view name = path.substr(last == path.npos ? 0 : last + 1);
  const std::size_t point = name.find('.');
  const bool is_file = point != name.npos && point > 0 && point + 1 < name.size() &&
                       name.find_first_of(" \t") == name.npos;
  return std::string(is_file ? name : std::string_view());
}

// M98 P2 L50, or M98 P500002: the last four digits are the program, and those before them the
// count.
bool ProgramFlow::fanuc_call(const Word& word) {
  const Word* p = find(letter('P'));
  const Word* l = find(letter('L'));
  if (l && (l->value < 0 || l->value != std::floor(l->value) || l->value > 99999999))
    return error("value-range", "L is how often the program runs", *l);
  const std::string name = program_name(p);
  if (!name.empty()) return call({-1, name}, l ? static_cast<long>(l->value) : 1, p ? *p : word);
  if (!p) return error("call-without-program", "M98 needs P with the number of a program", word);
  if (p->value < 1 || p->value != std::floor(p->value) || p->value > 99999999)
    return error("value-range", "P is the number of a program", *p);
  long number = static_cast<long>(p->value), repeats = 1;
  if (l) {
    repeats = static_cast<long>(l->value);
  } else if (number > 9999 && !is_whole_number(number)) {
    repeats = number / 10000;
    number %= 10000;
  }
  return call({number, {}}, repeats, *p);
}

// Calls a program from its block Q20 or H20 on. It is not known whether a second run also begins
// there.
bool ProgramFlow::call_at_block(const SubprogramName& name, long repeats, const Word& block) {
  if (repeats != 1)
    return error("not-supported",
                 fmt::format("a call from block {} on that is repeated: write it once for each run",
                             text_of(block)),
                 block);
  return statements_ && statements_->call_at_block(name, block);
}

// M97 P10 L2 (Haas) and M98 H10 L2 call blocks N10 to M99 of the same program.
bool ProgramFlow::local_call(const Word& word) {
  const Word* p = find(letter('P'));
  if (!p) p = call_begins_;
  const Word* l = find(letter('L'));
  if (!p || p->value < 0 || p->value != std::floor(p->value))
    return error("call-without-program", "M97 needs P with the number of a block", word);
  if (l && (l->value < 0 || l->value != std::floor(l->value) || l->value > 99999999))
    return error("value-range", "L is how often it runs", *l);
  return statements_ && statements_->call_number(*p, l ? static_cast<long>(l->value) : 1);
}

bool ProgramFlow::call(const SubprogramName& name, long repeats, const Word& word) {
  if (call_begins_) return call_at_block(name, repeats, *call_begins_);
  return statements_ ? statements_->call_program(name, repeats, word)
                     : reader_.call(name, repeats, word);
}

bool ProgramFlow::named_call(const Word& word) {
  const Word* p = find(letter('P'));
  long repeats = 1;
  if (p && is(Dialect::sinumerik)) {
    if (p->value < 1 || p->value > 9999 || p->value != std::floor(p->value))
      return error("value-range", "P is 1 to 9999 runs", *p);
    repeats = static_cast<long>(p->value);
  }
  SubprogramName name;
  name.text = std::string(word.text);
  if (word.address == letter('L')) name.text = text_of(word);
  return call(name, repeats, word);
}

void ProgramFlow::end_block() {
  if (block_.stop_after) {
    reader_.end_program();
  } else if (block_.m98) {
    const bool block = !peek('P') && call_begins_;
    block_.m98->value == 97 || block ? local_call(*block_.m98) : fanuc_call(*block_.m98);
  } else if (block_.call_word) {
    named_call(*block_.call_word);
  } else if (block_.return_after) {
    const Word* target = block_.loops && statements_ ? find(letter('P')) : nullptr;
    const bool from_main = reader_.depth() == 1;
    reader_.leave_stretches();
    if (target && !from_main) reader_.drop_repeats();
    if (!target || !from_main) reader_.end_activation(block_.loops);
    if (target) statements_->jump_to_number(*target, from_main);
  }
}

}  // namespace mrsim
