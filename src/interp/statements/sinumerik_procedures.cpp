#include "interp/statements/sinumerik_procedures.h"

#include "core/text/text_io.h"
#include "interp/frames/frame_chain.h"
#include "interp/language/operations.h"
#include "interp/statements/proc_line.h"
#include "interp/statements/sinumerik_text.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace mrsim {
namespace {

bool fits(VariableType type, const Value& value, std::string& why) {
  VariableArray variable;
  variable.type = type;
  variable.elements.resize(1);
  return variable.store(0, value, VariableForm::sinumerik, why);
}

}  // namespace

// Reads NAME(VAR REAL A, INT B=1) behind PROC; `p` ends at the closing bracket.
std::vector<SinumerikProcedures::Parameter> SinumerikProcedures::read_parameters(
    std::string_view line, std::size_t& p) {
  std::vector<Parameter> out;
  word_at(line, p);
  p = behind_blanks(line, p);
  const std::size_t close = line.find(')', p);
  while (p < line.size() && p < close && close != std::string_view::npos) {
    Parameter one;
    ++p;
    std::string word = word_at(line, p);
    one.by_reference = word == "VAR";
    if (one.by_reference) word = word_at(line, p);
    one.type = type_named(word).value_or(VariableType::real);
    if (p < line.size() && line[p] == '[') p = std::min(line.find(']', p), line.size() - 1) + 1;
    one.name = word_at(line, p);
    p = behind_blanks(line, p);
    one.is_array = p < line.size() && line[p] == '[';
    if (one.is_array) p = behind_blanks(line, std::min(line.find(']', p), line.size() - 1) + 1);
    Value value;
    if (p < line.size() && line[p] == '=' && evaluator_.expression(line, ++p, value))
      one.initial = value;
    if (!one.name.empty()) out.push_back(std::move(one));
    p = std::min(line.find(',', p), close);
  }
  return out;
}

void SinumerikProcedures::take_initial_values(std::string_view line, std::size_t p) {
  std::string ignored;
  for (const Parameter& one : read_parameters(line, p)) {
    if (!one.initial || variables_.is_defined(one.name)) continue;
    variables_.define(one.name, one.type, {}, false, ignored);
    variables_.assign(one.name, {}, *one.initial, ignored);
  }
}

// Reads PROC NAME(VAR REAL A, INT B=1) SAVE in the first lines of a subprogram.
SinumerikProcedures::Procedure SinumerikProcedures::read_procedure(const SubprogramPlace& place) {
  Procedure out;
  const std::optional<ProcLine> proc = find_proc_line(place);
  if (!proc) return out;
  out.has_header = true;
  std::size_t p = proc->behind;
  out.parameters = read_parameters(proc->line, p);
  std::string rest =
      upper_case(std::string_view(proc->line).substr(std::min(p, proc->line.size())));
  rest = rest.substr(0, rest.find(';'));
  out.saves = rest.find("SAVE") != std::string::npos;
  return out;
}

// SAVE restores the G codes of the caller, and with them its frames. But values that a settable
// frame has by now stay, where the subprogram has not chosen another one. F, S and D are no G
// codes.
void SinumerikProcedures::restore(const SavedState& saved) {
  const Modal now = modal_;
  modal_ = saved.modal;
  modal_.feed = now.feed;
  modal_.speed = now.speed;
  modal_.cutting_speed = now.cutting_speed;
  modal_.edge = now.edge;
  modal_.edge_given = now.edge_given;
  FrameChain frames(control_);
  frames.save();
  if (frames_.work_name != saved.frames.work_name) {
    frames_.work = saved.frames.work;
    frames_.work_turn = saved.frames.work_turn;
    frames_.work_name = saved.frames.work_name;
    frames_.work_given = saved.frames.work_given;
  }
  frames_.program = saved.frames.program;
  frames.rebuild();
}

// The caller's variable gets the value that the VAR parameter has at the end.
void SinumerikProcedures::give_back(const ProcedureArgument& to) {
  std::string ignored;
  const bool r = to.variable[0] == 'R' &&
                 to.variable.find_first_not_of("0123456789", 1) == std::string::npos &&
                 (to.variable.size() > 1) != (to.indices.size() == 1);
  if (!r)
    variables_.assign(to.variable, to.indices, *to.value, ignored);
  else
    variables_.assign(to.indices.empty() ? parse_number(to.variable.substr(1)).value_or(-1)
                                         : to.indices[0].number,
                      *to.value, ignored);
}

// Finds the first value of each parameter of PROC: the one given, or the default. False: an error
// was reported.
bool SinumerikProcedures::arguments_of(const SubprogramPlace& place, const Procedure& procedure,
                                       const std::vector<ProcedureArgument>& given,
                                       const Word& word, std::vector<Bound>& out) {
  const auto wrong = [&](const std::string& text) { return error("call-arguments", text, word); };
  if (given.size() > procedure.parameters.size())
    return wrong(fmt::format(
        "{} argument{} for {}, which has {} (alarm 12340)", given.size(),
        given.size() == 1 ? "" : "s", shown_place(place),
        procedure.has_header ? fmt::format("PROC with {} parameter{}", procedure.parameters.size(),
                                           procedure.parameters.size() == 1 ? "" : "s")
                             : "no PROC that takes them"));
  std::string why;
  for (std::size_t i = 0; i < procedure.parameters.size(); ++i) {
    Bound one{procedure.parameters[i], i < given.size() ? given[i] : ProcedureArgument{}};
    one.is_given = one.argument.value || one.argument.array;
    const std::string& name = one.parameter.name;
    if (name.size() > 1 && name[0] == 'R' && is_digit(name[1]))
      return wrong(fmt::format("the parameter {} has the name of an R parameter", name));
    if (!one.argument.value && !one.argument.array) one.argument.value = one.parameter.initial;
    if (one.parameter.by_reference && one.argument.variable.empty())
      return wrong(fmt::format("the VAR parameter {} needs a variable", name));
    if (one.parameter.is_array != one.argument.array.has_value())
      return wrong(fmt::format("the parameter {} {}", name,
                               one.parameter.is_array ? "needs an array" : "takes no array"));
    if (one.argument.value && !fits(one.parameter.type, *one.argument.value, why))
      return wrong(fmt::format("the parameter {}: {}", name, why));
    out.push_back(std::move(one));
  }
  return true;
}

// $P_SUBPAR[n] says whether the call gives the n-th parameter itself.
void SinumerikProcedures::define_parameters(const std::vector<Bound>& bound) {
  std::string ignored;
  if (!bound.empty())
    variables_.define("$P_SUBPAR", VariableType::boolean, {static_cast<int>(bound.size()) + 1},
                      false, ignored);
  for (std::size_t i = 0; i < bound.size(); ++i)
    variables_.assign("$P_SUBPAR", std::array{Value::of(double(i + 1))},
                      Value::of(bound[i].is_given ? 1 : 0), ignored);
  for (const Bound& one : bound) {
    const ProcedureArgument& from = one.argument;
    variables_.define(one.parameter.name, one.parameter.type, {}, false, ignored);
    if (from.array) variables_.set_array(one.parameter.name, *from.array);
    if (!from.value) continue;
    variables_.assign(one.parameter.name, {}, *from.value, ignored);
    if (options_.trace_variables)
      reporter_.assignment(one.parameter.name, value_shown(*from.value));
  }
}

// The values of VAR parameters at the end.
std::vector<ProcedureArgument> SinumerikProcedures::values_back(const std::vector<Bound>& bound) {
  std::vector<ProcedureArgument> back;
  std::string ignored;
  for (const Bound& one : bound) {
    if (!one.parameter.by_reference) continue;
    ProcedureArgument now = one.argument;
    Value value;
    if (const VariableArray* const whole = variables_.array(one.parameter.name))
      now.array = *whole;
    else if (variables_.named(one.parameter.name, {}, value, ignored))
      now.value = value;
    back.push_back(std::move(now));
  }
  return back;
}

bool SinumerikProcedures::bind(const SubprogramPlace& place,
                               const std::vector<ProcedureArgument>& given, const Word& word,
                               CallRequest& request) {
  const Procedure procedure = read_procedure(place);
  std::vector<Bound> bound;
  if (!arguments_of(place, procedure, given, word, bound)) return false;
  const std::optional<SavedState> saved =
      procedure.saves ? std::optional<SavedState>({modal_, frames_}) : std::nullopt;
  request.on_start = [this, bound] {
    variables_.enter_level();
    define_parameters(bound);
  };
  request.on_end = [this, bound, saved] {
    const std::vector<ProcedureArgument> back = values_back(bound);
    variables_.leave_level();
    for (const ProcedureArgument& one : back) {
      if (one.array)
        variables_.set_array(one.variable, *one.array);
      else
        give_back(one);
    }
    if (saved) restore(*saved);
  };
  return true;
}

}  // namespace mrsim
