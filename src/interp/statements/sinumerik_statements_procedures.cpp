// PROC with parameters: read from a subprogram's first lines, bound to the values of a call.
#include "core/text_io.h"
#include "interp/language/operations.h"
#include "interp/statements/sinumerik_statements.h"
#include "interp/statements/sinumerik_text.h"
#include "interp/text/characters.h"
#include "interp/text/source.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kHeaderLines = 50;  // a PROC stands in the first lines

}  // namespace

// NAME(VAR REAL A, INT B=1) behind PROC; `p` ends at the bracket.
std::vector<SinumerikStatements::Parameter> SinumerikStatements::read_parameters(
    std::string_view line, std::size_t& p) {
  std::vector<Parameter> out;
  word_at(line, p);
  p = blanks(line, p);
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
    p = blanks(line, p);
    Value value;
    if (p < line.size() && line[p] == '=' && evaluator_.expression(line, ++p, value))
      one.initial = value;
    if (!one.name.empty()) out.push_back(std::move(one));
    p = std::min(line.find(',', p), close);
  }
  return out;
}

// A main program is not called: its parameters have the values that PROC gives them.
void SinumerikStatements::take_initial_values(std::size_t p) {
  std::string ignored;
  for (const Parameter& one : read_parameters(block_.line, p)) {
    if (!one.initial || variables_.is_defined(one.name)) continue;
    variables_.define(one.name, one.type, {}, false, ignored);
    variables_.assign(one.name, {}, *one.initial, ignored);
  }
}

// PROC NAME(VAR REAL A, INT B=1) SAVE, in the first lines of a subprogram.
SinumerikStatements::Procedure SinumerikStatements::read_procedure(const SubprogramPlace& place) {
  Procedure out;
  LineSource source(place.file, std::size_t(1) << 14);
  source.seek(place.offset, place.line);
  std::string_view line;
  for (int i = 0; i < kHeaderLines && source.next(line); ++i) {
    std::size_t p = 0;
    if (word_at(line, p) == "PROC") {
      out.parameters = read_parameters(line, p);
      std::string rest = upper_case(line.substr(std::min(p, line.size())));
      rest = rest.substr(0, rest.find(';'));
      out.saves = rest.find("SAVE") != std::string::npos;
      return out;
    }
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string_view::npos && line[first] != ';' && line[first] != '%') return out;
  }
  return out;
}

bool SinumerikStatements::bind(const Procedure& procedure, const std::vector<Argument>& given,
                               const Word& word, CallRequest& request) {
  if (given.size() > procedure.parameters.size())
    return error("call-arguments",
                 fmt::format("{} arguments, and PROC has {} parameters (alarm 12340)", given.size(),
                             procedure.parameters.size()),
                 word);
  struct Bound {
    Parameter parameter;
    Value value;
    bool has_value = false;
    std::string variable;
  };
  std::vector<Bound> bound;
  for (std::size_t i = 0; i < procedure.parameters.size(); ++i) {
    Bound one;
    one.parameter = procedure.parameters[i];
    const bool has = i < given.size() && given[i].value;
    if (has) one.variable = given[i].variable;
    if (has || one.parameter.initial) {
      one.value = has ? *given[i].value : *one.parameter.initial;
      one.has_value = true;
    }
    if (one.parameter.by_reference && one.variable.empty())
      return error("call-arguments",
                   fmt::format("the VAR parameter {} needs a variable", one.parameter.name), word);
    bound.push_back(std::move(one));
  }
  const Modal modal = modal_;
  const bool saves = procedure.saves;
  request.on_start = [this, bound] {
    variables_.enter_level();
    std::string ignored;
    for (const Bound& one : bound) {
      variables_.define(one.parameter.name, one.parameter.type, {}, false, ignored);
      if (one.has_value) variables_.assign(one.parameter.name, {}, one.value, ignored);
    }
  };
  request.on_end = [this, bound, modal, saves] {
    std::vector<std::pair<std::string, Value>> back;
    std::string ignored;
    for (const Bound& one : bound) {
      Value value;
      if (one.parameter.by_reference && variables_.named(one.parameter.name, {}, value, ignored))
        back.emplace_back(one.variable, value);
    }
    variables_.leave_level();
    for (const auto& [name, value] : back) {
      const bool r = name[0] == 'R' && name.size() > 1 && is_digit(name[1]);
      if (r)
        variables_.assign(parse_number(name.substr(1)).value_or(-1), value, ignored);
      else
        variables_.assign(name, {}, value, ignored);
    }
    if (saves) modal_ = modal;
  };
  return true;
}

bool SinumerikStatements::call(const SubprogramName& name, const std::vector<Argument>& given,
                               long repeats, const Word& word) {
  const auto place = reader_.locate(name, word);
  if (!place) return false;
  CallRequest request;
  request.file = place->file;
  request.begin = {place->offset, place->line, 0};
  request.repeats = repeats;
  if (!bind(read_procedure(*place), given, word, request)) return false;
  return reader_.enter(std::move(request), word);
}

}  // namespace mrsim
