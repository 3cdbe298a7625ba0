#include "interp/statements/sinumerik_statements.h"

#include "core/text/text_io.h"
#include "interp/language/operations.h"
#include "interp/statements/sinumerik_text.h"
#include "interp/text/characters.h"
#include "interp/text/code_names.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::string_view kKeywords[] = {
    "IF",     "ELSE",    "ENDIF", "WHILE", "ENDWHILE", "FOR",   "ENDFOR", "LOOP",  "ENDLOOP",
    "REPEAT", "REPEATB", "UNTIL", "CASE",  "GOTO",     "GOTOF", "GOTOB",  "GOTOC", "GOTOS",
    "DEF",    "EXTERN",  "MCALL", "PROC",  "SETAL",    "PCALL", "DEFINE"};

}  // namespace

// A statement begins with a keyword, with CALL and a variable, or with a subprogram's name and
// brackets.
bool SinumerikStatements::starts_statement(std::string_view line, std::size_t p) {
  const std::size_t from = p;
  while (p < line.size() && is_name(line[p])) ++p;
  const std::string name = upper_case(line.substr(from, std::min<std::size_t>(p - from, 33)));
  p = behind_blanks(line, p);
  const char next = p < line.size() ? line[p] : '\0';
  if (name == "MCALL") {  // MCALL of a cycle is read elsewhere
    const std::string called = word_at(line, p);
    return called.empty() ? has_modal_call()
                          : cycle_files_.calls_program(called, line, p - called.size());
  }
  for (const std::string_view keyword : kKeywords)
    if (name == keyword) return true;
  if (name == "CALL") {  // a text alone is read elsewhere
    const bool joined = next == '"' && line.find("<<", p) != line.npos;
    return is_letter(next) || next == '(' || joined;
  }
  if (name == "RET" || name == "EXECSTRING") return next == '(';
  if (next != '(' || name.size() < 2 || find_function(name).code != Code::unknown) return false;
  return cycle_files_.calls_program(name, line, from);
}

bool SinumerikStatements::statement(std::size_t from) {
  std::size_t p = from;
  const std::string name = name_at(p);
  if (name == "IF" || name == "ELSE" || name == "ENDIF") return branch(from, p);
  if (name.starts_with("GOTO")) return jump_if(true, name, p);
  if (name == "CASE") return case_of(p);
  if (name == "DEF") return define(p);
  if (name == "DEFINE") return define_macro(p, false);
  if (name == "MCALL") return modal_call(p);
  if (name == "RET") return go_back(from, p);
  if (name == "EXECSTRING") return run_text(from, p);
  if (name == "EXTERN" || name == "PROC" || name == "SETAL") {
    if (name == "SETAL")
      note_once("alarm-set", "the program sets an alarm of its own", place_word(from, p), "setal");
    if (name == "PROC" && reader_.depth() == 1) take_initial_values(p);
    reader_.set_position(block_.line.size());
    return true;
  }
  const std::size_t next = skip_blanks(p);
  const bool whole = next >= block_.line.size() || at(next) == ';';
  if (name == "REPEATB" || (name == "REPEAT" && !whole)) return repeat_part(name, p);
  if (name == "PCALL") return call_by_path(from, p);
  std::size_t behind = p;
  if (name == "CALL" && name_at(behind) == "BLOCK") return call_part(behind);
  for (const std::string_view keyword : kKeywords) {
    if (name != keyword) continue;
    const FlowEntry* const entry = entry_at(from);
    if (!entry) return false;
    const bool ends = entry->word == FlowWord::loop_end || entry->word == FlowWord::loop_until;
    return ends ? loop_end(*entry, p) : loop(*entry, p);
  }
  return call_statement(from, p);
}

// Reads a condition. An assignment is none: "IF R1=5" would ask whether R1 is 0.
bool SinumerikStatements::asked(std::size_t& p, bool& holds) {
  if (!condition(p, holds)) return false;
  p = skip_blanks(p);
  return at(p) != '=' ||
         fail("statement", "= assigns: a comparison is written == (alarm 12080)", p, p + 1);
}

// Carries out IF ... GOTOF, or a part of the structure IF ELSE ENDIF. Words behind the condition
// are an error whether it holds or not.
bool SinumerikStatements::branch(std::size_t from, std::size_t p) {
  bool holds = false;
  const bool asks = upper(at(from)) == 'I';
  if (asks && !asked(p, holds)) return false;
  std::size_t behind = p;
  if (const std::string word = asks ? name_at(behind) : ""; word.starts_with("GOTO"))
    return jump_if(holds, word, behind);
  const FlowEntry* const entry = entry_at(from);
  if (!entry) return false;
  if (entry->word == FlowWord::branch_else)
    return jump_behind(places_.outline().entry(entry->last));
  if (!end_statement(p)) return false;
  return !asks || holds || jump_behind(places_.outline().entry(entry->next));
}

// Behind a jump stands the end of the block or another one, IF ... GOTOF, which is asked where this
// one is not taken.
bool SinumerikStatements::jump_if(bool holds, const std::string& word, std::size_t p) {
  const std::size_t from = p = skip_blanks(p);
  const std::string target = word == "GOTOS" ? "" : name_at(p);
  if (variables_.is_defined(target) || at(from) == '"' || at(from) == '(') {
    Value value;
    p = from;
    if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
  }
  const bool named = p > from || word == "GOTOS";
  const std::size_t next = p = skip_blanks(p);
  const bool another = name_at(p) == "IF";
  if (named && !another && !end_statement(next)) return false;
  if (holds || !named) return go_to(word, from);  // tells of the missing label
  return !another || branch(next, p);
}

bool SinumerikStatements::loop(const FlowEntry& entry, std::size_t p) {
  if (entry.word == FlowWord::loop_for) return for_loop(entry, p, !std::exchange(stepping_, false));
  bool holds = true;
  if (entry.word == FlowWord::loop_while && !asked(p, holds)) return false;
  return end_statement(p) && (holds || jump_behind(places_.outline().entry(entry.last)));
}

// Carries out FOR variable = first TO last.
bool SinumerikStatements::for_loop(const FlowEntry& entry, std::size_t p, bool first) {
  const std::size_t from = p = skip_blanks(p);
  std::string name = name_at(p);
  std::vector<Value> at_index;
  if (at(p) == '[' && !indices(block_.line, p, at_index)) return false;
  const std::size_t to = p;
  p = skip_blanks(p);
  if (name.empty() || at(p) != '=')
    return fail("statement", "FOR variable = first TO last (alarm 12080)", from, p);
  ++p;
  double begin = 0, end = 0;
  if (!evaluator_.number_expression(block_.line, p, begin)) return report(evaluator_.fault());
  std::size_t behind = p;
  if (name_at(behind) != "TO") return fail("statement", "TO is expected here", p, p + 1);
  p = behind;
  if (!evaluator_.number_expression(block_.line, p, end)) return report(evaluator_.fault());
  if (!first) {
    std::size_t q = from;
    if (!evaluator_.number_operand(block_.line, q, begin)) return report(evaluator_.fault());
    begin += 1;
  }
  std::size_t target = from;
  const bool r = name.size() > 1 && name[0] == 'R' && is_digit(name[1]);
  const bool stored =
      r ? store(parse_number(name.substr(1)).value_or(-1), Value::of(begin), target, to)
        : store(name, at_index, Value::of(begin), target, to);
  if (!stored) return false;
  return end_statement(p) && (begin <= end || jump_behind(places_.outline().entry(entry.last)));
}

bool SinumerikStatements::loop_end(const FlowEntry& entry, std::size_t p) {
  const FlowEntry& first = places_.outline().entry(entry.first);
  bool done = false;
  if (entry.word == FlowWord::loop_until && !asked(p, done)) return false;
  if (!end_statement(p)) return false;
  if (done) return true;
  stepping_ = first.word == FlowWord::loop_for;
  return jump_in_loop(first.at);
}

// GOTOF jumps forward, GOTOB backward, GOTO in both directions, GOTOC as GOTO but without an alarm.
// The target is a label, N10, or a text. GOTOS jumps to the first block of the program.
bool SinumerikStatements::go_to(const std::string& word, std::size_t p) {
  if (word == "GOTOS") {
    const ProgramOutline& program = places_.outline();
    reader_.leave_stretches();
    return jump_always(program.section_begin(program.section_at(reader_.place_at(0))));
  }
  p = skip_blanks(p);
  const std::size_t from = p;
  std::string target = name_at(p);
  if (variables_.is_defined(target) || at(from) == '"' || at(from) == '(') {
    Value value;
    p = from;
    if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
    target = upper_case(value.text);
    decided_ = true;
  }
  if (target.empty())
    return fail("jump-target", fmt::format("{0} needs a label: {0} LAB1", word), from, p);
  const bool forward = word != "GOTOB", backward = word != "GOTOF";
  Place to;
  if (find_target(target, forward, backward, to)) {
    reader_.leave_stretches();
    return jump_always(to);
  }
  if (word == "GOTOC") {
    reader_.set_position(block_.line.size());
    return true;
  }
  return fail("jump-target",
              fmt::format("there is no label {} {} (alarm 14080)", to_utf8(target.substr(0, 40)),
                          !backward  ? "behind this block"
                          : !forward ? "before this block"
                                     : "in this program"),
              from, p);
}

// Finds a label or a block number, forward or backward from the block being read.
bool SinumerikStatements::find_target(const std::string& target, bool forward, bool backward,
                                      Place& to) {
  const ProgramOutline& all = places_.outline();
  const Place here = reader_.place_at(0);
  const int section = all.section_at(here);
  const bool block = target.size() > 1 && target[0] == 'N' &&
                     target.find_first_not_of("0123456789", 1) == std::string::npos;
  if (block) {
    const double n = parse_number(target.substr(1)).value_or(-1);
    return n < 1e9 && places_.find_number(static_cast<long>(n), forward, backward, to);
  }
  int i = forward ? all.find_label(target, here, all.section_end(section), false) : -1;
  if (i < 0 && backward) i = all.find_label(target, all.section_begin(section), here, !forward);
  if (i >= 0) to = all.entry(i).at;
  return i >= 0;
}

// RET("LABEL", 1, 2) goes back by as many levels as the third value says. There it goes to the
// block of the label or number, or, if the second value is above 0, to the block behind that.
bool SinumerikStatements::go_back(std::size_t from, std::size_t p) {
  std::vector<ProcedureArgument> given;
  if (!arguments(p, given) || !end_statement(p)) return false;
  given.resize(std::max<std::size_t>(given.size(), 4));
  const auto number = [&](std::size_t i, double other) {
    return given[i].value ? given[i].value->number : other;
  };
  const double levels = number(2, 1);
  if (given.size() > 4 || number(3, 0) != 0)
    return fail("not-supported", "RET with a fourth value is not supported", from, p);
  if (!(levels >= 1) || levels != std::floor(levels) ||
      static_cast<double>(reader_.levels()) < levels)
    return fail("value-range", "RET goes back by 1 level up to those there are (alarm 14091)", from,
                p);
  const std::string target = given[0].value ? upper_case(given[0].value->text) : std::string();
  for (int i = 0; i < static_cast<int>(levels); ++i) {
    reader_.leave_stretches();
    if (levels > 1 || !target.empty()) reader_.drop_repeats();
    reader_.end_activation(false);
  }
  if (target.empty()) return true;
  Place to;
  if (!find_target(target, true, true, to))
    return fail("jump-target",
                fmt::format("there is no label {} in the program that RET goes back to (alarm "
                            "14080)",
                            to_utf8(target.substr(0, 40))),
                from, p);
  reader_.leave_stretches();
  return reader_.jump(number(1, 0) > 0 ? places_.behind_line(to) : to);
}

// Carries out CASE (expression) OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C.
bool SinumerikStatements::case_of(std::size_t p) {
  double value = 0;
  if (!evaluator_.number_expression(block_.line, p, value)) return report(evaluator_.fault());
  decided_ = true;
  std::size_t behind = p;
  if (name_at(behind) != "OF") return fail("statement", "OF is expected here", p, p + 1);
  p = behind;
  for (;;) {
    p = skip_blanks(p);
    if (p >= block_.line.size() || at(p) == ';') break;
    behind = p;
    bool taken = name_at(behind) == "DEFAULT";
    if (taken) {
      p = behind;
    } else {
      double constant = 0;
      if (!number(p, constant, false)) return false;
      taken = constant == value;
    }
    const std::string word = name_at(p);
    if (!word.starts_with("GOTO"))
      return fail("statement", "GOTOF or GOTOB is expected here", p, p + 1);
    if (taken) return go_to(word, p);
    name_at(p);  // the label
  }
  reader_.set_position(p);
  return true;
}

// Carries out REPEAT A, REPEAT A B and REPEATB A, each of them with or without P=n.
bool SinumerikStatements::repeat_part(const std::string& word, std::size_t p) {
  const std::size_t from = p;
  std::vector<std::string> labels;
  double runs = 1;
  for (;;) {
    p = skip_blanks(p);
    if (p >= block_.line.size() || at(p) == ';') break;
    const std::size_t begin = p;
    const std::string name = name_at(p);
    if (name.empty()) return fail("statement", "a label or P= is expected here", p, p + 1);
    const std::size_t next = skip_blanks(p);
    if (name == "P" && at(next) == '=') {
      p = next + 1;
      if (!evaluator_.number_expression(block_.line, p, runs)) return report(evaluator_.fault());
    } else if (name[0] == 'P' && name.size() > 1 && is_digit(name[1])) {
      runs = parse_number(name.substr(1)).value_or(1);
    } else if (labels.size() < (word == "REPEATB" ? 1U : 2U)) {
      labels.push_back(name);
    } else {
      return fail("statement", "too many labels", begin, p);
    }
  }
  return run_part(labels, word == "REPEATB", runs, from, p);
}

// CALL BLOCK A TO B has labels, or variables and texts that contain them.
bool SinumerikStatements::call_part(std::size_t p) {
  const std::size_t from = p;
  std::vector<std::string> labels;
  for (const bool last : {false, true}) {
    p = skip_blanks(p);
    std::size_t behind = p;
    std::string label = name_at(behind);
    if (at(p) == '"' || variables_.is_defined(label)) {
      Value value;
      behind = p;
      if (!evaluator_.operand(block_.line, behind, value)) return report(evaluator_.fault());
      label = upper_case(value.text);
    }
    labels.push_back(label);
    p = behind;
    if (!last && name_at(p) != "TO") return fail("statement", "TO is expected here", behind, p);
  }
  return run_part(labels, false, 1, from, p);
}

// Runs the part of the program that begins at the first label: only its line, or up to ENDLABEL or
// this block, or up to the line of the second label.
bool SinumerikStatements::run_part(const std::vector<std::string>& labels, bool line_alone,
                                   double runs, std::size_t from, std::size_t p) {
  const ProgramOutline& all = places_.outline();
  const Place here = reader_.place_at(0);
  const int section = all.section_at(here);
  const Place top = all.section_begin(section), bottom = all.section_end(section);
  std::vector<Place> places;
  for (const std::string& label : labels) {
    int i = all.find_label(label, places.empty() ? top : places[0], here, places.empty());
    if (i < 0) i = all.find_label(label, here, bottom, false);
    if (i < 0)
      return fail("jump-target",
                  fmt::format("there is no label {} (alarm 14080)", to_utf8(label.substr(0, 40))),
                  from, p);
    places.push_back(all.entry(i).at);
  }
  if (places.empty()) return fail("statement", "a label is expected here", from, p);
  CallRequest request;
  request.file = reader_.file();
  request.begin = places[0];
  const bool before = places[0].offset < here.offset;
  const int closing = all.find_label("ENDLABEL", places[0], before ? here : bottom, false);
  Place end = here;
  if (places.size() == 2) {
    end = places_.behind_line(places[1]);
  } else if (line_alone) {
    end = places_.behind_line(places[0]);
  } else if (closing >= 0) {
    end = places_.behind_line(all.entry(closing).at);
  }
  request.end = end.offset;
  request.repeats = static_cast<long>(std::min(std::max(0.0, runs), 1e8));
  request.counts_as_call = false;
  reader_.set_position(p);
  return reader_.enter(std::move(request), place_word(from, p));
}

}  // namespace mrsim
