#include "interp/statements/oword_statements.h"

#include "core/text/text_io.h"
#include "interp/language/flow_scan.h"
#include "interp/language/operations.h"
#include "interp/text/characters.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostSubArguments = 30;

}  // namespace

OwordStatements::OwordStatements(Control& control, BlockReader& reader)
    : Statements(control, reader, linuxcnc_rules(), VariableForm::linuxcnc, OutlineForm::owords),
      saved_modes_(control) {}

bool OwordStatements::starts_statement(std::string_view line, std::size_t p) {
  std::string name;
  return oword_name(line, p, name);
}

// #1 = 2 and #<name> = [...] have one operand. The value is kept until the block has been read.
bool OwordStatements::assignment(std::string_view line, std::size_t& p) {
  const DataReads data(reader_.watch());
  Pending one;
  one.from = p++;
  p = behind_blanks(line, p);
  one.named = p < line.size() && line[p] == '<';
  if (one.named ? !evaluator_.bracketed_name(line, p, one.name)
                : !target_number(line, p, one.number))
    return report(evaluator_.fault());
  one.to = p;
  p = skip_blanks(p);
  if (at(p) != '=')
    return fail("assignment", "= is expected here: a variable is read only behind an address", p,
                p + 1);
  ++p;
  if (!evaluator_.operand(line, p, one.value)) {
    report(evaluator_.fault());
    one.value = {};
    one.value.kind = Value::Kind::faulty;
    pending_.push_back(std::move(one));
    commit();
    return false;
  }
  pending_.push_back(std::move(one));
  return true;
}

void OwordStatements::commit() {
  for (const Pending& one : pending_)
    if (!(one.named ? store(one.name, {}, one.value, one.from, one.to)
                    : store(one.number, one.value, one.from, one.to)))
      block_.bad = true;
  pending_.clear();
}

bool OwordStatements::take_block() {
  if (!pending_.empty()) commit();
  for (const std::string_view comment : block_.comments) message(comment);
  return reader_.finished();
}

// Programs of Grbl and others end where the text ends. A program with O words is for LinuxCNC,
// where that is a fault.
bool OwordStatements::end_of_main() {
  if (!has_owords_) return true;
  reporter_.forget_text();
  return fail("program-end-missing", "the program ends without M2, M30 or %: LinuxCNC refuses that",
              0, 1);
}

// (debug, #1), (print, ...) and (msg, ...) show a text; (abort, ...) also ends the program.
void OwordStatements::message(std::string_view comment) {
  std::size_t p = 0;
  const std::string kind = letters_of(comment, p);
  if (p >= comment.size() || comment[p] != ',') return;
  const bool aborts = kind == "ABORT";
  if (!aborts && kind != "DEBUG" && kind != "PRINT" && kind != "MSG") return;
  std::string text;
  for (++p; p < comment.size();) {
    Value value;
    std::size_t q = p;
    if (comment[p] == '#' && kind != "MSG" && evaluator_.operand(comment, q, value)) {
      text += fmt::format("{:.6f}", value.number);
      p = q;
    } else {
      text += comment[p++];
    }
  }
  const auto column = static_cast<std::size_t>(comment.data() - block_.line.data());
  const std::string shown = to_utf8(text.substr(0, 400));
  if (!aborts) return note_once("message", shown, place_word(column, column + p), shown);
  fail("program-abort", fmt::format("the program ends itself: {}", shown), column, column + p);
  reader_.stop();
}

std::size_t OwordStatements::end_of_line(std::size_t p) const {
  p = skip_blanks(p);
  while (at(p) == '(') {
    const std::size_t end = block_.line.find(')', p);
    if (end == std::string_view::npos) return p;
    p = skip_blanks(end + 1);
  }
  return p;
}

// LinuxCNC refuses words behind an O word. It reads them before it carries that out, so the
// refusal does not depend on what the condition says.
bool OwordStatements::ends_line(std::size_t& p) {
  p = end_of_line(p);
  if (p >= block_.line.size() || at(p) == ';') return true;
  if (at(p) == '(')
    return fail("comment-unterminated", "the comment that starts here is not closed with )", p,
                block_.line.size());
  return fail("statement",
              "nothing but a comment stands behind an O word (\"Unexpected character after "
              "O-word\"): write this into a block of its own",
              p, block_.line.size());
}

bool OwordStatements::statement(std::size_t from) {
  has_owords_ = true;
  std::size_t p = from;
  std::string name;
  oword_name(block_.line, p, name);
  if (name.empty()) {  // the name is computed: O[#2 * 10] call, O#<n> call
    std::size_t q = skip_blanks(from + 1);
    double value = 0;
    if (!number(q, value, true)) return false;
    name = fmt::format("{:.0f}", value);
    p = q;
  }
  std::size_t behind = p;
  const std::string word = oword_keyword(block_.line, behind);
  if (word == "CALL") return call(name, from, behind);
  const FlowEntry* const entry = entry_at(from);
  if (!entry) return false;
  if (word.empty()) {  // it is the header of a numbered or named program
    titled_ = titled_ || reader_.depth() == 1;
    reader_.set_position(block_.line.size());
    return true;
  }
  return oword(*entry, behind);
}

bool OwordStatements::oword(const FlowEntry& entry, std::size_t p) {
  switch (entry.word) {
    case FlowWord::branch:
    case FlowWord::branch_else_if:
    case FlowWord::branch_else:
      return branch(entry, p);
    case FlowWord::loop_while:
    case FlowWord::loop_repeat:
      return loop(entry, p);
    case FlowWord::loop_end:
      return ends_line(p) && loop_again(entry);
    case FlowWord::loop_until: {
      bool again = false;
      if (!condition(p, again) || !ends_line(p)) return false;
      if (again) return jump_in_loop(past(places_.outline().entry(entry.first)));
      reader_.set_position(p);
      return true;
    }
    case FlowWord::loop_break:
      if (!ends_line(p)) return false;
      return jump_past(places_.outline().entry(places_.outline().entry(entry.first).last));
    case FlowWord::loop_continue: {
      if (!ends_line(p)) return false;
      const FlowEntry& last = places_.outline().entry(places_.outline().entry(entry.first).last);
      return reader_.jump(last.at);
    }
    case FlowWord::sub:  // it is defined here and runs when it is called
      if (titled_ && reader_.depth() == 1)
        return fail("program-end-missing",
                    "the program that began with a bare O word has no M2 or M30 before this sub",
                    entry.at.position, p);
      return jump_past(places_.outline().entry(entry.last));
    case FlowWord::sub_end:
    case FlowWord::sub_return:
      return leave(p, true);
    default:
      if (!ends_line(p)) return false;
      reader_.set_position(p);
      return true;
  }
}

// Behind a false condition the next elseif is evaluated; behind the blocks of a true one the
// structure ends.
bool OwordStatements::branch(const FlowEntry& entry, std::size_t p) {
  const bool first = entry.word == FlowWord::branch;
  const bool asked = first || std::exchange(arriving_, false);
  if (!asked) return jump_past(places_.outline().entry(entry.last));
  bool holds = true;
  if (entry.word != FlowWord::branch_else && !condition(p, holds)) return false;
  if (!ends_line(p)) return false;
  if (holds) {
    reader_.set_position(p);
    return true;
  }
  const FlowEntry& next = places_.outline().entry(entry.next);
  if (next.word == FlowWord::branch_end) return jump_past(next);
  arriving_ = true;
  return reader_.jump(next.at);
}

bool OwordStatements::loop(const FlowEntry& entry, std::size_t p) {
  const FlowEntry& end = places_.outline().entry(entry.last);
  if (entry.word == FlowWord::loop_repeat) {
    double count = 0;
    p = skip_blanks(p);
    if (at(p) != '[') return fail("bracket", "the number of passes stands in brackets", p, p + 1);
    if (!evaluator_.number_expression(block_.line, p, count)) return report(evaluator_.fault());
    if (!ends_line(p)) return false;
    if (count < 1) return jump_past(end);
    passes_left(entry.last) = static_cast<long>(std::min(nearest_whole(count), 1e9));
    reader_.set_position(p);
    return true;
  }
  bool holds = false;
  if (!condition(p, holds) || !ends_line(p)) return false;
  if (!holds) return jump_past(end);
  reader_.set_position(p);
  return true;
}

bool OwordStatements::loop_again(const FlowEntry& entry) {
  const FlowEntry& first = places_.outline().entry(entry.first);
  if (first.word == FlowWord::loop_while) return jump_in_loop(first.at);
  reader_.watch().count_pass(reader_.depth(), first.at, entry.at);
  long& left = passes_left(first.last);
  if (--left <= 0) {
    reader_.set_position(entry.behind);
    return true;
  }
  return jump_past(first);
}

// Behind the whole line of a statement.
Place OwordStatements::past(const FlowEntry& entry) {
  Place next = entry.at;
  next.position = std::numeric_limits<std::size_t>::max();
  return next;
}

// Reads values in brackets up to the end of the line: "[1] (comment) [#2]".
bool OwordStatements::values(std::size_t p, std::vector<double>& out) {
  for (;;) {
    p = end_of_line(p);
    if (p >= block_.line.size() || at(p) == ';') break;
    if (at(p) != '[') return fail("statement", "[ or the end of the line is expected here", p, p);
    double value = 0;
    if (!evaluator_.number_operand(block_.line, p, value)) return report(evaluator_.fault());
    if (out.size() == kMostSubArguments)
      return fail("statement", fmt::format("more than {} arguments", kMostSubArguments), p, p);
    out.push_back(value);
  }
  reader_.set_position(p);
  return true;
}

// Finds a sub in one file.
bool OwordStatements::locate_in(const std::string& file, const std::string& name,
                                CallRequest& request, const Word& word) {
  const ProgramOutline& all = places_.outline(file);
  const int i = all.find_name(FlowWord::sub, name);
  if (i < 0) return false;
  request.file = file;
  request.begin = all.entry(i).at;
  request.begin.position = all.entry(i).behind;
  if (const int again = all.find_name(FlowWord::sub, name, i); again >= 0)
    reader_.tell_second(fmt::format("o<{}>", to_utf8(name.substr(0, 60))), request.begin.line + 1,
                        all.entry(again).at.line + 1, word);
  return true;
}

// Finds a sub in the main program, or in its own file. Other subs of such a file are not found.
bool OwordStatements::locate(const std::string& name, CallRequest& request, const Word& word) {
  if (locate_in(program_.files.front(), name, request, word)) return true;
  std::string lower = name;
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  SubprogramName wanted;
  wanted.text = lower;
  wanted.own_file = true;
  if (!reader_.has_subprogram(wanted)) return false;
  return locate_in(reader_.locate(wanted, {})->file, name, request, word);
}

bool OwordStatements::call(const std::string& name, std::size_t from, std::size_t p) {
  std::vector<double> arguments;
  return values(p, arguments) && enter_sub(name, {}, std::move(arguments), place_word(from, p));
}

bool OwordStatements::call_sub(const std::string& name, CallRequest&& request, const Word& word) {
  return enter_sub(name, std::move(request), {}, word);
}

bool OwordStatements::enter_sub(const std::string& name, CallRequest request,
                                std::vector<double> arguments, const Word& word) {
  if (!locate(name, request, word))
    return error("subprogram-missing",
                 fmt::format("there is no \"o<{}> sub\" in this file, nor in a file of that name "
                             "beside it or in --path",
                             to_utf8(name.substr(0, 60))),
                 word);
  const ProgramOutline& all = places_.outline(request.file);
  if (const OutlineFault* wrong = all.fault_in(0)) {
    const std::string text = wrong->text;
    return error("structure",
                 fmt::format("{}, line {}: {}", request.file, wrong->at.line + 1, text), word);
  }
  request.on_start = [this, arguments = std::move(arguments), before = request.on_start] {
    variables_.enter_level();
    for (std::size_t i = 0; i < arguments.size(); ++i)
      set_argument(static_cast<int>(i + 1), arguments[i]);
    system_.linuxcnc().set_returned(0, false);
    system_.linuxcnc().add_call_level(1);
    if (before) before();
  };
  request.on_end = [this, behind = request.on_end] {
    variables_.leave_level();
    system_.linuxcnc().add_call_level(-1);
    saved_modes_.leave(reader_.depth());
    if (behind) behind();
  };
  return reader_.enter(std::move(request), word);
}

// M98 P100 calls a program that begins with the bare word O100. It shares all variables with its
// caller.
bool OwordStatements::call_program(const SubprogramName& name, long repeats, const Word& word) {
  const std::string number = fmt::format("{}", name.number);
  const ProgramOutline& all = places_.outline(program_.files.front());
  const int i = name.number >= 0 ? all.find_name(FlowWord::label, number) : -1;
  if (i < 0 && all.find_name(FlowWord::sub, number) >= 0)
    return error("subprogram-missing",
                 fmt::format("O{} is defined with sub: call it with \"O{} call\"", number, number),
                 word);
  CallRequest request;
  if (i >= 0) {
    request.file = program_.files.front();
    request.begin = all.entry(i).at;
  } else if (const auto place = reader_.locate(name, word)) {
    request = call_of(*place);
  } else {
    return false;
  }
  request.repeats = repeats;
  request.on_end = [this] { saved_modes_.leave(reader_.depth()); };
  return reader_.enter(std::move(request), word);
}

// Carries out endsub and return, with or without a value.
bool OwordStatements::leave(std::size_t p, bool required) {
  std::vector<double> result;
  if (!values(p, result)) return false;
  if (required && variables_.levels() < 2)
    return fail("structure", "this ends a subprogram, and none is being run", block_.statement, p);
  system_.linuxcnc().set_returned(result.empty() ? 0 : result[0], !result.empty());
  reader_.leave_stretches();
  reader_.end_activation(false);
  return true;
}

}  // namespace mrsim
