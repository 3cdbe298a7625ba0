#include "interp/statements/fagor_statements.h"

#include "core/text/text_io.h"
#include "interp/language/bracket_statement.h"
#include "interp/language/flow_scan.h"
#include "interp/text/characters.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kMostLocals = 26;  // P0 to P25, which calls also write as A to Z

}  // namespace

FagorStatements::FagorStatements(Control& control, BlockReader& reader)
    : Statements(control, reader, fagor_rules(), VariableForm::fagor, OutlineForm::fagor) {}

bool FagorStatements::starts_statement(std::string_view line, std::size_t p) {
  if (p >= line.size() || line[p] != '(') return false;
  const std::size_t close = closing_bracket(line, p);
  return close != std::string_view::npos &&
         !bracket_statement(line.substr(p + 1, close - p - 1)).empty();
}

bool FagorStatements::statement(std::size_t from) {
  end_ = close_ = closing_bracket(block_.line, from);
  return action(from + 1);
}

// Carries out one action, which ends at end_.
bool FagorStatements::action(std::size_t from) {
  std::size_t p = skip_blanks(from);
  if (upper(at(p)) == 'P' && is_digit(at(p + 1))) return assignments(p);
  const std::size_t begin = p;
  const std::string word = letters(p);
  if (word == "IF") return if_statement(p);
  if (word == "GOTO") return go_to(p);
  if (word == "RPT") return repeat_part(p);
  if (word == "CALL" || word == "PCALL" || word == "MCALL") return call_statement(word, p);
  if (word == "RET") return go_back(p);
  if (word == "MDOFF") {
    modal_call_.active = false;
    return end_action(p);
  }
  if (word == "SUB")
    return fail("structure", "a subroutine begins here, and nothing has called it", begin, p);
  if (word == "ERROR")
    return fail("program-alarm",
                fmt::format("the program stops with its own error:{}",
                            to_utf8(block_.line.substr(p, end_ - p))),
                begin, end_);
  return fail("not-supported",
              fmt::format("({} ...) is a statement of this control, which is not supported", word),
              begin, p);
}

bool FagorStatements::ends_here(std::size_t p) {
  p = skip_blanks(p);
  return p == end_ || fail("statement", "the end of the statement is expected here", p, p + 1);
}

// Ends the statement. Only a comment may stand behind it.
bool FagorStatements::finish(std::size_t behind) {
  const std::size_t p = skip_blanks(behind);
  const char c = at(p);
  const bool comment = c == ';' || (c == '(' && !starts_statement(block_.line, p));
  if (p < block_.line.size() && !comment)
    return fail("statement-not-alone", "a statement stands alone in its block", p, p + 1);
  reader_.set_position(p);
  return true;
}

// The place of ELSE in the statement, outside of texts; that of the closing bracket if there is
// none.
std::size_t FagorStatements::else_at(std::size_t p) const {
  bool quoted = false;
  for (; p + 4 <= close_; ++p) {
    if (at(p) == '"') quoted = !quoted;
    const bool begins = !quoted && !is_letter(at(p - 1)) && !is_name(at(p + 4));
    if (begins && upper_case(block_.line.substr(p, 4)) == "ELSE") return p;
  }
  return close_;
}

// Carries out IF condition action ELSE action.
bool FagorStatements::if_statement(std::size_t p) {
  bool holds = false;
  if (!condition(p, holds)) return false;
  const std::size_t other = else_at(p);
  if (holds) {
    end_ = other;
    return action(p);
  }
  if (other != close_) return action(other + 4);
  return end_action(close_);
}

// Carries out assignments: P1=2, P2=P1+3.
bool FagorStatements::assignments(std::size_t p) {
  const DataReads data(reader_.watch());
  for (;;) {
    const std::size_t from = p = skip_blanks(p);
    std::size_t to = p + 1;
    while (is_digit(at(to))) ++to;
    if (upper(at(p)) != 'P' || to == p + 1)
      return fail("assignment", "a parameter (P1) is expected here", p, p + 1);
    const double number = parse_number(block_.line.substr(p + 1, to - p - 1)).value_or(-1);
    p = skip_blanks(to);
    if (at(p) != '=') return fail("assignment", "= is expected here", p, p + 1);
    Value value;
    if (!evaluator_.expression(block_.line, ++p, value)) {
      report(evaluator_.fault());
      value = {};
      value.kind = Value::Kind::faulty;
      std::string ignored;
      variables_.assign(number, value, ignored);
      reader_.set_position(block_.line.size());
      return true;  // the program goes on; reading the parameter fails without a report
    }
    if (!store(number, value, from, to)) return false;
    p = skip_blanks(p);
    if (at(p) != ',') return end_action(p);
    ++p;
  }
}

// Finds a block of this file: N10, N(P1+5), NP1.
bool FagorStatements::label(std::size_t& p, Place& out) {
  const std::size_t from = p = skip_blanks(p);
  if (upper(at(p)) != 'N') return fail("statement", "N and the number of a block", p, p + 1);
  double wanted = 0;
  if (!number(++p, wanted, true)) return false;
  const long n = static_cast<long>(wanted);
  if (!places_.find_number(n, true, true, out))
    return fail("jump-target", fmt::format("there is no block N{} in this file", n), from, p);
  if (!unique_.contains(n) && places_.find_number_twice(n))
    return fail("jump-target", fmt::format("two blocks of this file are N{}", n), from, p);
  unique_.insert(n);
  return true;
}

bool FagorStatements::go_to(std::size_t p) {
  Place to;
  if (!label(p, to) || !end_action(p)) return false;
  reader_.leave_stretches();
  return jump_in_loop(to);
}

// (RPT N10,N20) N3 runs blocks N10 to N20 three times.
bool FagorStatements::repeat_part(std::size_t p) {
  const std::size_t from = p;
  Place first, last;
  if (!label(p, first)) return false;
  p = skip_blanks(p);
  if (at(p) != ',') return fail("statement", "RPT needs two blocks: (RPT N10,N20)", p, p + 1);
  if (!label(++p, last)) return false;
  if (last < first) return fail("jump-target", "the second block stands before the first", from, p);
  if (!ends_here(p)) return false;
  double runs = 1;
  p = skip_blanks(close_ + 1);
  if (upper(at(p)) == 'N') {
    if (!number(++p, runs, true)) return false;
    if (runs < 0 || runs > 9999)
      return fail("value-range", "N behind RPT is how often it runs", p - 1, p);
  }
  const Place behind = places_.behind_line(last);
  if (!finish(p)) return false;
  CallRequest request;
  request.file = reader_.file();
  request.begin = first;
  request.end = behind.offset;
  request.repeats = static_cast<long>(runs);
  request.counts_as_call = false;
  return reader_.enter(std::move(request), place_word(from, p));
}

// Reads the local parameters of a call: P1=5, A5, B(P1+2).
bool FagorStatements::arguments(std::size_t& p, Arguments& out) {
  for (p = skip_blanks(p); at(p) == ','; p = skip_blanks(p)) {
    const std::size_t from = p = skip_blanks(p + 1);
    const char c = upper(at(p));
    if (!is_letter(c)) return fail("macro-arguments", "a parameter is expected here", p, p + 1);
    int local = c - 'A';
    std::size_t value_at = p + 1;
    if (c == 'P' && is_digit(at(value_at))) {
      while (is_digit(at(value_at))) ++value_at;
      const std::size_t equal = skip_blanks(value_at);
      if (at(equal) == '=') {
        local = static_cast<int>(
            parse_number(block_.line.substr(p + 1, std::min<std::size_t>(value_at - p - 1, 5)))
                .value_or(kMostLocals));
        value_at = equal + 1;
      } else {
        value_at = p + 1;  // the letter P as a name, with a value
      }
    } else if (at(skip_blanks(value_at)) == '=') {
      value_at = skip_blanks(value_at) + 1;
    }
    if (local >= kMostLocals)
      return fail("macro-arguments", "the arguments of a call are P0 to P25", from, value_at);
    double value = 0;
    p = value_at;
    if (!evaluator_.number_expression(block_.line, p, value)) return report(evaluator_.fault());
    out.emplace_back(local, value);
  }
  return true;
}

// CALL 5 calls a subroutine; PCALL 5, A1, P2=3 gives it its own parameters; MCALL calls it behind
// each move.
bool FagorStatements::call_statement(const std::string& word, std::size_t p) {
  const std::size_t from = p;
  double wanted = 0;
  if (!evaluator_.number_expression(block_.line, p, wanted)) return report(evaluator_.fault());
  if (!(wanted >= 0 && wanted <= 9999) || wanted != std::floor(wanted))
    return fail("value-range", "the number of a subroutine is a whole number", from, p);
  Arguments given;
  if (word != "CALL" && !arguments(p, given)) return false;
  const std::size_t to = p;
  if (!end_action(p)) return false;
  const long subprogram = static_cast<long>(wanted);
  const Word where = place_word(skip_blanks(from), to);
  if (word != "MCALL")
    return call(subprogram, word == "CALL" ? CallKind::plain : CallKind::own_parameters, given,
                where);
  modal_call_ = {true, subprogram, std::move(given), where};
  return true;
}

// MCALL: the subroutine runs at the end of every block that moves.
void FagorStatements::end_block(bool moved) {
  if (!moved || !modal_call_.active || in_modal_call_) return;
  in_modal_call_ =
      call(modal_call_.subprogram, CallKind::modal, modal_call_.arguments, block_.words.front());
}

bool FagorStatements::call(long subprogram, CallKind kind, const Arguments& arguments,
                           const Word& where) {
  const ProgramOutline& all = places_.outline();
  const std::string name = std::to_string(subprogram);
  const int found = all.find_name(FlowWord::label, name);
  if (found < 0)
    return error("subprogram-missing",
                 fmt::format("there is no (SUB {}) in the program's file", subprogram), where);
  if (const int again = all.find_name(FlowWord::label, name, found); again >= 0)
    reader_.tell_second(fmt::format("(SUB {})", name), all.entry(found).at.line + 1,
                        all.entry(again).at.line + 1, where);
  CallRequest request;
  request.file = reader_.file();
  request.begin = all.entry(found).at;
  request.begin.position = all.entry(found).behind;
  if (kind != CallKind::plain) {
    request.on_start = [this, arguments] {
      variables_.enter_level();
      std::string ignored;
      for (const auto& [local, value] : arguments)
        variables_.assign(local, Value::of(value), ignored);
    };
    request.on_end = [this, kind] {
      variables_.leave_level();
      if (kind == CallKind::modal) in_modal_call_ = false;
    };
  }
  return reader_.enter(std::move(request), where);
}

bool FagorStatements::go_back(std::size_t p) {
  if (!end_action(p)) return false;
  reader_.leave_stretches();
  if (reader_.depth() < 2) return fail("structure", "RET stands outside of a subroutine", p - 3, p);
  reader_.end_activation(false);
  return true;
}

}  // namespace mrsim
