#include "interp/statements/macro_statements.h"

#include "interp/language/flow_scan.h"
#include "interp/statements/macro_words.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::string_view kOutputs[] = {"POPEN", "PCLOS", "DPRNT", "BPRNT"};
constexpr std::string_view kSetNames = "SETVN";  // sets names for the display
constexpr std::size_t kMostMacroLevels = 4;

bool is_branch(const std::string& name) {
  return name == "ELSEIF" || name == "ELSE" || name == "ENDIF";
}

// "[#1 LT 10] M99 P5" of Haas: M99 where the condition holds.
bool is_return_on_condition(std::string_view line, std::size_t p) {
  const std::size_t close = line.substr(p, 1) == "[" ? closing_bracket(line, p) : line.npos;
  if (close == line.npos) return false;
  const std::string word = upper_case(line.substr(behind_comments(line, close + 1), 4));
  return word.starts_with("M99") && (word.size() == 3 || !is_digit(word[3]));
}

bool abbreviates(const std::string& name, std::string_view whole) {
  return name.size() >= 2 && whole.starts_with(name);
}

}  // namespace

MacroStatements::MacroStatements(Control& control, BlockReader& reader)
    : Statements(control, reader, fanuc_rules(), VariableForm::fanuc, OutlineForm::macro) {}

bool MacroStatements::starts_statement(std::string_view line, std::size_t p) {
  const std::string name = letters_of(line, p);
  if (name.size() < 2) return name.empty() && is_return_on_condition(line, p);
  for (const std::string_view whole : {"GOTO", "WHILE", "END"})
    if (abbreviates(name, whole)) return true;
  for (const std::string_view output : kOutputs)
    if (name == output) return true;
  return name == "IF" || name == "DO" || is_branch(name) || name == kSetNames;
}

std::size_t MacroStatements::end_of_block(std::size_t p) const {
  for (; p < block_.line.size() && block_.line[p] != ';'; ++p)
    if (block_.line[p] == '(') p = std::min(block_.line.find(')', p), block_.line.size() - 1);
  return p;
}

bool MacroStatements::statement(std::size_t from) {
  std::size_t p = from;
  const std::string name = letters(p);
  if (bool holds = false; name.empty()) {  // M99 on a condition
    if (!condition(p, holds)) return false;
    reader_.set_position(holds ? behind_comments(block_.line, p) : end_of_block(p));
    return true;
  }
  if (name == "IF") return if_statement(from, p);
  if (name == "ELSEIF" && std::exchange(arriving_, false)) return if_statement(from, p);
  if (is_branch(name)) return branch(from, std::nullopt);
  if (abbreviates(name, "WHILE")) return while_statement(from, p);
  if (abbreviates(name, "GOTO")) return go_to(p, true);
  if (abbreviates(name, "END")) return loop_end(from);
  if (name == "DO") {
    const FlowEntry* const entry = entry_at(from);
    if (entry) reader_.set_position(entry->behind);
    return entry != nullptr;
  }
  if (name != kSetNames)  // SETVN 500[DEPTH]
    note_once("output-ignored", fmt::format("{} writes to a device: it is not read", name),
              place_word(from, p), "output");
  reader_.set_position(end_of_block(p));
  return true;
}

// The place of ELSE in the rest of the block, outside of comments; the end of the line if there is
// none.
std::size_t MacroStatements::else_at(std::size_t p) const {
  const std::size_t end = end_of_block(p);
  for (; p < end; ++p) {
    if (at(p) == '(') p = std::min(block_.line.find(')', p), end);
    if (!is_letter(at(p - 1)) && upper_case(block_.line.substr(p, 4)) == "ELSE") return p;
  }
  return block_.line.size();
}

// Carries out IF [...] GOTO 10, IF [...] THEN #1 = 2, and IF [...] THEN with its blocks below.
bool MacroStatements::if_statement(std::size_t from, std::size_t p) {
  bool holds = false;
  p = behind_comments(block_.line, p);
  if (!condition(p, holds)) return false;
  std::size_t behind = p = behind_comments(block_.line, p);
  const std::string word = letters(behind);
  if (abbreviates(word, "GOTO")) return go_to(behind, holds);
  const bool then = abbreviates(word, "THEN");
  if (!then && !begins_word(block_.line, p))
    return fail("statement", "GOTO or THEN is expected here", p, p + 1);
  if (!then) {
    reporter_.once(Severity::warning, "statement",
                   "THEN is left out here, as Haas's controls read it; FANUC's stop (alarm)",
                   place_word(p, p + 1), "then");
    behind = p;
  }
  if (then && ends_block(block_.line, behind)) return branch(from, holds);
  if (const std::size_t other = else_at(behind); other < block_.line.size())
    return fail("not-supported",
                "ELSE in the block of its IF is not supported: write THEN, ELSE and ENDIF at the "
                "ends of blocks of their own",
                other, other + 4);
  reader_.set_position(holds ? behind : end_of_block(behind));
  return true;
}

// IF [...] THEN, ELSEIF [...] THEN, ELSE, ENDIF of the 30i-B. `holds` is the condition; it is empty
// at an ELSE or ELSEIF that follows blocks which were run.
bool MacroStatements::branch(std::size_t from, std::optional<bool> holds) {
  const FlowEntry* const entry = entry_at(from);
  if (!entry) return false;
  const ProgramOutline& all = places_.outline();
  if (!holds && entry->word != FlowWord::branch_end) return jump_behind(all.entry(entry->last));
  if (holds.value_or(true)) {
    reader_.set_position(end_of_block(entry->behind));
    return true;
  }
  const FlowEntry& next = all.entry(entry->next);
  if (next.word != FlowWord::branch_else_if) return jump_behind(next);
  arriving_ = true;
  return reader_.jump(next.at);
}

bool MacroStatements::while_statement(std::size_t from, std::size_t p) {
  bool holds = false;
  p = behind_comments(block_.line, p);
  if (at(p) != '[') return condition(p, holds);  // reports its fault
  const FlowEntry* const entry = entry_at(from);
  if (!entry) return false;
  if (!condition(p, holds)) return false;
  if (!holds) return jump_behind(places_.outline().entry(entry->last));
  reader_.set_position(entry->behind);
  return true;
}

bool MacroStatements::loop_end(std::size_t from) {
  const FlowEntry* const entry = entry_at(from);
  if (!entry || entry->first < 0) return false;
  return jump_in_loop(places_.outline().entry(entry->first).at);
}

// Words behind a GOTO are lost even where it is not taken.
bool MacroStatements::go_to(std::size_t p, bool taken) {
  if (const std::size_t words = words_behind_jump(block_.line, p); words < block_.line.size())
    warning("word-without-effect", kBehindJump, place_word(words, end_of_block(words)));
  if (!taken) {
    reader_.set_position(end_of_block(p));
    return true;
  }
  const std::size_t from = p = skip_blanks(p);
  double target = 0;
  if (!number(p, target, true)) return false;
  decided_ = decided_ || !is_digit(at(from));
  reader_.leave_stretches();
  Place to;
  if (!places_.find_number(static_cast<long>(target), true, true, to))
    return fail("jump-target",
                fmt::format("there is no block N{:.0f} in this program (alarm 128)", target), from,
                p);
  return jump_always(to);
}

// With --least-increments an argument without a point counts the least increments of its address.
double MacroStatements::argument_value(const Word& word) const {
  const auto c = static_cast<char>(word.address);
  if (!options_.least_increments || word.point) return word.value;
  if (c >= 'A' && c <= 'C') return angle_value(word);
  const bool length = std::string_view("IJKQRUVWXYZ").find(c) != std::string_view::npos;
  return length ? word.value * modal_.least_increment() : word.value;
}

// Collects the words behind G65 as local variables. If I J K stand more than once, it is argument
// list II. `code`: G65 or G66; null in a block under G66.1.
bool MacroStatements::collect(const Word* code, Arguments& out) {
  if (!code || code->value != 65) reader_.watch().decide();  // the macro of G66 runs later
  int triples = 0;
  char last = 'Z';
  for (const Word& word : block_.words) {
    const auto c = static_cast<char>(word.address);
    const bool head = c == 'N' && (code || &word == &block_.words.front());
    if (&word == code || (code && (c == 'P' || c == 'L')) || c == 'O' || head) continue;
    int local = local_of_letter(c);
    if (c >= 'I' && c <= 'K') {
      if (triples == 0 || c <= last) ++triples;
      last = c;
      local = 4 + 3 * (triples - 1) + (c - 'I');
    }
    if (local > 33) return error("macro-arguments", "more than ten groups I J K (alarm 129)", word);
    if (local == 0) return no_argument(word, code != nullptr);
    if (code && &word < code)
      return error(
          "macro-arguments",
          fmt::format("{0} stands before {1}: {1} comes first", text_of(word), text_of(*code)),
          word);
    out.values[static_cast<std::size_t>(local)] = argument_value(word);
    out.given |= std::uint64_t(1) << local;
  }
  return true;
}

// Manuals of G66.1 also make G L N P arguments (#10 #12 #14 #16), but differ in whether G takes
// effect.
bool MacroStatements::no_argument(const Word& word, bool simple) {
  if (!simple)
    return error("not-supported",
                 fmt::format("{} in a block under G66.1: whether it acts or is an argument of the "
                             "macro is not known; call the macro by G65 here",
                             text_of(word)),
                 word);
  return error("macro-arguments",
               fmt::format("{} is no argument of a macro (alarm 129){}", text_of(word),
                           word.address == letter('G') ? ": write it into a block of its own" : ""),
               word);
}

// The arguments are set before the first run of a command. The next runs begin with the local
// variables as the run before left them.
bool MacroStatements::call_macro(const SubprogramName& program, long repeats,
                                 const Arguments& arguments, const Kept& kept,
                                 const MacroLevel& level, const Word& where) {
  if (levels_.size() >= kMostMacroLevels)
    return error("subprogram-depth", "more than 4 macros inside one another (alarm 118)", where);
  const auto place = reader_.locate(program, where);
  if (!place) return false;
  CallRequest request = call_of(*place, repeats);
  request.on_start = [this, arguments, kept, level] {
    levels_.push_back(level);
    variables_.enter_level();
    if (*kept) return variables_.set_locals(**kept);
    for (int i = 1; i < Variables::kLocals; ++i)
      if ((arguments.given >> i & 1U) != 0)
        set_argument(i, arguments.values[static_cast<std::size_t>(i)]);
  };
  request.on_end = [this, kept] {
    *kept = variables_.locals();
    levels_.pop_back();
    variables_.leave_level();
  };
  return reader_.enter(std::move(request), where);
}

// The macro of a probe is not available. It cuts nothing, and only the machine knows where it ends.
bool MacroStatements::probing(long number, const Word& code) {
  if (!is_probing_macro(number) || reader_.has_subprogram({number, {}})) return false;
  forget_place(kAllAxes);
  note_once("probe",
            fmt::format("O{} is a macro of a probe: it is not run, and the axes' position is "
                        "unknown until they are given again",
                        number),
            code, "probing");
  return true;
}

bool MacroStatements::call_program(const SubprogramName& name, long repeats, const Word& word) {
  return probing(name.number, word) || Statements::call_program(name, repeats, word);
}

// G65 P9010 L2 A1 B2 calls a macro. G66 and G66.1 call it later.
bool MacroStatements::macro_call(const Word& code) {
  if (is_macro_a(block_.words, code))
    return error("not-supported",
                 fmt::format("{} H (a calculation or a jump of macro A, of old controls) is not "
                             "supported: write it as #101=#102+5 or IF [#101 EQ #102] GOTO 10",
                             text_of(code)),
                 code);
  const Word* p = nullptr;
  const Word* l = nullptr;
  for (const Word& word : block_.words) {
    if (word.address == letter('P')) p = &word;
    if (word.address == letter('L')) l = &word;
  }
  if (!p || (!p->string && (p->value < 1 || p->value != std::floor(p->value))))
    return error("call-without-program", "P with the number of the macro is needed", code);
  if (l && (l->value < 0 || l->value != std::floor(l->value) || l->value > 9999))
    return error("value-range", "L is how often the macro runs", *l);
  SubprogramName program;
  if (p->string)
    program.text = std::string(p->text);
  else
    program.number = static_cast<long>(p->value);
  if (code.value == 65 && probing(program.number, code)) return true;
  const long repeats = l ? static_cast<long>(l->value) : 1;
  Arguments arguments;
  if (!collect(&code, arguments)) return false;
  const auto kept = std::make_shared<Kept::element_type>();
  if (code.value == 65)
    return call_macro(program, repeats, arguments, kept, {modal_count(), modal_calls_.size(), true},
                      code);
  if (modal_calls_.size() >= kMostMacroLevels)
    return error("subprogram-depth", "more than 4 macros inside one another (alarm 118)", code);
  modal_calls_.push_back({code.value > 66, program, repeats, arguments, kept});
  return true;
}

// How many modal calls are in force: all of them; in a macro only those that it has made itself, or
// if it has made none, those before the one that runs it.
std::size_t MacroStatements::modal_count() const {
  if (levels_.empty() || modal_calls_.size() > levels_.back().base) return modal_calls_.size();
  return std::min(levels_.back().modal, modal_calls_.size());
}

// No manual says whether a move in a macro of G65 runs the macro of a G66 before it.
bool MacroStatements::is_modal_unclear() const {
  return !levels_.empty() && levels_.back().simple && modal_count() > 0 &&
         modal_calls_.size() <= levels_.back().base;
}

// The macro that a move calls: that of the last G66. A move in that macro calls the one before.
const MacroStatements::ModalCall* MacroStatements::modal_call(bool every_block) const {
  const std::size_t count = modal_count();
  if (count == 0) return nullptr;
  const ModalCall& last = modal_calls_[count - 1];
  return last.every_block == every_block ? &last : nullptr;
}

bool MacroStatements::run_modal(const ModalCall& call, const Arguments& arguments) {
  const auto before = static_cast<std::size_t>(&call - modal_calls_.data());
  const Kept kept = call.every_block ? std::make_shared<Kept::element_type>() : call.locals;
  return call_macro(call.program, call.repeats, arguments, kept,
                    {before, modal_calls_.size(), false}, block_.words.front());
}

// Whether the N word leads the block: under G66.1 an N behind other words is no block number.
bool MacroStatements::number_leads() {
  long number = -1;
  behind_number(block_.line, 0, number);
  return !block_.has_number || number >= 0 ||
         error(
             "not-supported",
             "N behind words of a block under G66.1 is an argument on the control (#14): write it "
             "at the head of the block",
             block_.words.front());
}

// #3000=1(NO TOOL) ends the program.
bool MacroStatements::stopped_by_alarm() {
  const std::optional<double> alarm = system_.fanuc().alarm();
  if (!alarm) return false;
  fail("program-alarm", fmt::format("the program stops with its own alarm #3000 = {:g}", *alarm), 0,
       block_.line.size());
  reader_.stop();
  return true;
}

bool MacroStatements::take_block() {
  if (stopped_by_alarm()) return true;
  for (const Word& word : block_.words) {
    if (word.address != letter('G')) continue;
    if (word.value == 65 || word.value == 66 || word.value == 66.1) {
      macro_call(word);
      return true;
    }
    if (word.value == 67 && !modal_calls_.empty()) modal_calls_.pop_back();
    if (word.value == 67 && block_.words.size() == 1) return false;
  }
  const ModalCall* const call = is_modal_unclear() ? nullptr : modal_call(true);
  if (!call || block_.words.empty() || block_.words[0].address == letter('M')) return false;
  Arguments arguments = call->arguments;  // under G66.1 the words of the block are arguments
  if (number_leads() && collect(nullptr, arguments)) run_modal(*call, arguments);
  return true;
}

// The macro of G66 runs at the end of every block that moves.
void MacroStatements::end_block(bool moved) {
  if (moved && is_modal_unclear()) {
    error("not-supported",
          "a move in a macro of G65 while G66 is in force: whether it calls the macro of G66 is "
          "not known; write G67 before G65",
          block_.words.front());
    return;
  }
  const ModalCall* const call = modal_call(false);
  if (!call) return;
  reader_.watch().decide();  // a vacant word is no word, and the block does not move
  if (moved) {
    run_modal(*call, call->arguments);
  } else if (modal_.drill.number != 0 && (peek('X') || peek('Y') || peek('Z'))) {
    error("not-supported",
          "a hole of a drilling cycle while G66 is in force: whether it calls the macro is not "
          "known; write G67 before the cycle",
          block_.words.front());
  }
}

}  // namespace mrsim
