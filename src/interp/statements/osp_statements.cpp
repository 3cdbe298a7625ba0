#include "interp/statements/osp_statements.h"

#include "core/text/text_io.h"
#include "interp/language/flow_scan.h"
#include "interp/statements/lap_contour.h"
#include "interp/statements/macro_words.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostRunsOfCall = 9999;

// The letters and digits at `p`.
std::string_view name_from(std::string_view line, std::size_t p) {
  std::size_t end = p;
  while (end < line.size() && (is_letter(line[end]) || is_digit(line[end]))) ++end;
  return line.substr(p, end - p);
}

// Whether the line only sets what the screen shows, shapes of tools, chuck and tailstock, or the
// load monitor: "VGRIN[1]=1 VGRL[1]=40", "VCHKL=0 VWKR=602", "VLMON[1]=11".
bool sets_picture(std::string_view line, std::size_t p) {
  constexpr std::string_view kNames[] = {"VGR", "VTS", "VCHK", "VWKR", "VLMON"};
  while (p < line.size() && line[p] != '(') {
    const std::string name = upper_case(name_from(line, p));
    if (std::ranges::none_of(kNames, [&](std::string_view n) { return name.starts_with(n); }))
      return false;
    const std::size_t value = line.find('=', p += name.size());
    if (value == line.npos ||
        line.substr(p, value - p).find_first_not_of("[]0123456789 ") != line.npos)
      return false;
    const std::size_t end =
        std::min(line.size(), line.find_first_not_of("0123456789.+-", value + 1));
    p = std::min(line.size(), line.find_first_not_of(" \t", end));
  }
  return true;
}

// Whether the line draws the blank on the control's screen: "DEF WORK", "PS LC,[-400,0],[400,19]",
// "PT LF,LC,[0,0],[80,80]", "END", "DRAW" and "CLEAR".
bool draws_blank(std::string_view line, std::size_t p) {
  if (upper(line[p]) == 'V') return sets_picture(line, p);
  const std::string name = upper_case(name_from(line, p).substr(0, 6));
  const std::size_t behind = behind_blanks(line, p + name.size());
  const std::string next = upper_case(name_from(line, behind).substr(0, 5));
  if (name == "DEF") return next == "WORK";
  if (name == "PS" || name == "PT") return next == "LC" || next == "RC" || next == "LF";
  const bool alone = behind == line.size() || line[behind] == '(';
  return alone && (name == "CLEAR" || name == "DRAW" || name == "END");
}

}  // namespace

bool OspStatements::starts_statement(std::string_view line, std::size_t p) {
  const std::string name = upper_case(name_from(line, p).substr(0, 8));
  return draws_blank(line, p) || name == "MSG" || name == "CALL" || name == "RTS" ||
         name == "MODIN" || name == "MODOUT" || name.starts_with("GOTON") ||
         MacroStatements::starts_statement(line, p);
}

// The place of the name of a block behind GOTO: "GOTO N10", "GOTONEND". Nothing: another jump.
std::optional<std::size_t> OspStatements::named_target(std::size_t p) const {
  p = skip_blanks(p);
  if (upper_case(block_.line.substr(p, 4)) != "GOTO") return std::nullopt;
  p = skip_blanks(p + 4);
  return upper(at(p)) == 'N' ? std::optional(p) : std::nullopt;
}

// Reads only the brackets of IF: behind IF [VC1 GE 2] NEND names a block, and is no comparison by
// NE.
bool OspStatements::bracketed(std::size_t& p, bool& holds) {
  p = behind_comments(block_.line, p);
  if (at(p) != '[') return condition(p, holds);
  double value = 0;
  decided_ = true;
  if (!evaluator_.number_operand(block_.line, p, value)) return report(evaluator_.fault());
  holds = value != 0;
  return true;
}

void OspStatements::note_picture(std::size_t from) {
  note_once("simulator-line", "what the control shows of blank, tools and load is not read",
            place_word(from, block_.line.size()), "DRAW");
}

bool OspStatements::statement(std::size_t from) {
  std::size_t p = from;
  if (draws_blank(block_.line, from)) {
    note_picture(from);
    reader_.set_position(block_.line.size());
    return true;
  }
  const std::string name = letters(p);
  if (name == "MSG") {  // "MSG (TEXT)": for the operator
    reader_.set_position(block_.line.size());
    return true;
  }
  if (name == "IF") {
    std::size_t behind = p;
    bool holds = false;
    if (!bracketed(behind, holds)) return false;
    behind = named_target(behind).value_or(skip_blanks(behind));
    if (upper(at(behind)) != 'N') return MacroStatements::statement(from);
    return jump(behind, holds);
  }
  if (const auto target = named_target(from)) return jump(*target, true);
  if (name == "RTS") {
    if (reader_.depth() < 2)
      return fail("call-missing", "RTS in a program that is no subprogram", from, p);
    reader_.leave_stretches();
    reader_.end_activation(false);
    return true;
  }
  if (name != "CALL" && name != "MODIN" && name != "MODOUT")
    return MacroStatements::statement(from);
  reader_.set_position(end_of_block(p));
  const bool nested = modal_.has_value();
  modal_ = name == "CALL" ? modal_ : std::nullopt;
  if (name == "MODOUT") return true;
  Call call;
  if (!read_call(p, call)) return false;
  if (name == "CALL") return enter(call);
  if (nested)
    return fail("not-supported", "MODIN under MODIN is not supported: write MODOUT before it", from,
                p);
  modal_ = std::move(call);
  return true;
}

// Reads the words of a call: "O100 Q3 XA=5 LP=VC1*2".
bool OspStatements::read_call(std::size_t p, Call& out) {
  p = skip_blanks(p);
  const std::string_view name = name_from(block_.line, p);
  if (name.size() < 2 || upper(name[0]) != 'O')
    return fail("call-without-program", "O with the name of a program is expected here", p, p + 1);
  out.place = place_word(p, p + name.size());
  const auto number = parse_number(name.substr(1));
  const bool numbered = name.find_first_not_of("0123456789", 1) == name.npos && number;
  out.program = {
      numbered ? static_cast<long>(*number) : -1, numbered ? std::string() : upper_case(name), {}};
  p = skip_blanks(p + name.size());
  const std::size_t end = end_of_block(p);
  while (p < end) {
    if (!argument(p, out)) return false;
    p = skip_blanks(p);
    if (at(p) == '(') p = end;
  }
  return true;
}

// Reads a word of a call: Q3, Q=VC1, XA=5.
bool OspStatements::argument(std::size_t& p, Call& out) {
  const std::size_t from = p;
  std::string_view name = name_from(block_.line, p);
  const bool repeats = upper(at(p)) == 'Q' && name.find_first_not_of("0123456789", 1) == name.npos;
  if (repeats) name = name.substr(0, 1);
  p = skip_blanks(p + name.size());
  const bool assigned = at(p) == '=';
  if (name.empty() || (!assigned && !repeats))
    return fail("macro-arguments", "a variable and = are expected here: NAME=1", from, from + 1);
  if (assigned) ++p;
  Value value;
  if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
  if (!value.is_number()) return fail("expression", "a number is needed here", from, p);
  if (!repeats) {
    out.arguments.emplace_back(upper_case(name), value.number);
    return true;
  }
  if (value.number < 0 || value.number != std::floor(value.number) ||
      value.number > kMostRunsOfCall)
    return fail("value-range", "Q is how often the program runs", from, p);
  out.repeats = static_cast<long>(value.number);
  return true;
}

bool OspStatements::enter(const Call& call, bool modal) {
  const auto place = reader_.locate(call.program, call.place);
  if (!place) return false;
  CallRequest request = call_of(*place, call.repeats);
  request.on_start = [this, arguments = call.arguments, modal] {
    ++calls_;
    if (modal) runs_modal_ = true;
    variables_.enter_level();
    for (const auto& [name, value] : arguments) set(name, Value::of(value), 0, 0);
  };
  request.on_end = [this, modal] {
    --calls_;
    if (modal) runs_modal_ = false;
    variables_.leave_level();
  };
  return reader_.enter(std::move(request), call.place);
}

// Jumps to block N100, or to the block of a name. Words behind it are lost even where the jump is
// not taken.
bool OspStatements::jump(std::size_t p, bool taken) {
  const std::string_view name = name_from(block_.line, p);
  const std::size_t behind = skip_blanks(p + name.size());
  if (!ends_block(block_.line, behind))
    warning("word-without-effect", kBehindJump, place_word(behind, end_of_block(behind)));
  if (!taken) {
    reader_.set_position(end_of_block(p));
    return true;
  }
  reader_.leave_stretches();
  Place to;
  if (name.size() > 1 && name.find_first_not_of("0123456789", 1) == name.npos) {
    if (places_.find_number(static_cast<long>(parse_number(name.substr(1)).value_or(-1)), true,
                            true, to))
      return jump_always(to);
  } else {
    const auto [begin, end] = places_.section();
    if (const auto found = find_named_block(reader_.file(), begin, end, name))
      return jump_always(*found);
  }
  return fail("jump-target", fmt::format("there is no block {} in this program", name), p,
              p + name.size());
}

// Carries out VC1=2 and DIA=VC1+3. "#1=2" is FANUC's.
bool OspStatements::assignment(std::string_view line, std::size_t& p) {
  const DataReads data(reader_.watch());
  if (line[p] == '#') return MacroStatements::assignment(line, p);
  const std::size_t from = p;
  const std::string_view name = name_from(line, p);
  p += name.size();
  const std::size_t to = p;
  while (p < line.size() && line[p] != '=') ++p;
  ++p;
  if (draws_blank(line, from)) {
    note_picture(from);
    p = line.size();
    return true;
  }
  if (upper(name[0]) == 'V' && !Variables::is_common(name))
    return fail("variable-unset", fmt::format("the system variable {} cannot be set here", name),
                from, to);
  Value value;
  if (evaluator_.expression(line, p, value)) return set(name, value, from, to);
  report(evaluator_.fault());
  value.kind = Value::Kind::faulty;
  set(name, value, from, to);
  return false;
}

bool OspStatements::set(std::string_view name, const Value& value, std::size_t from,
                        std::size_t to) {
  std::string why;
  const bool common = Variables::is_common(name);
  if (!variables_.is_defined(name) && !variables_.define(name, VariableType::real, {}, common, why))
    return fail("variable-number", why, from, to);
  return store(name, {}, value, from, to);
}

// The program of MODIN runs behind every block that moves. No manual at hand says whether it also
// does in programs of CALL.
void OspStatements::end_block(bool moved) {
  if (modal_) reader_.watch().decide();  // an empty word is no word, and the block does not move
  if (!moved || !modal_ || runs_modal_) return MacroStatements::end_block(moved);
  if (calls_ == 0) {
    enter(*modal_, true);
    return;
  }
  error("not-supported",
        "a move in a program of CALL under MODIN: whether it calls the program of MODIN is not "
        "known; write MODOUT before CALL",
        block_.words.front());
}

}  // namespace mrsim
