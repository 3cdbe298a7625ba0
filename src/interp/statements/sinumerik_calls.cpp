#include "interp/statements/sinumerik_calls.h"

#include "core/text/text_io.h"
#include "interp/statements/cycle_files.h"
#include "interp/statements/sinumerik_text.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

SinumerikCalls::SinumerikCalls(Control& control, BlockReader& reader)
    : SinumerikAssignments(control, reader), procedures_(control, variables_, evaluator_) {}

// Under MCALL every block of words that moved ends with the call, also in subprograms.
void SinumerikCalls::end_block(bool moved) {
  if (!moved || !modal_call_.active || in_modal_call_) return;
  call(modal_call_.name, modal_call_.arguments, 1, block_.words.front(), [] {});
}

bool SinumerikCalls::call_modal(std::size_t places, const Approach& approach, const Word& word) {
  if (in_modal_call_)
    return error("not-supported",
                 "a pattern of holes in the program of MCALL is not supported: write the places "
                 "as blocks",
                 word);
  return call(modal_call_.name, modal_call_.arguments, static_cast<long>(places), word,
              [approach, i = std::size_t(0)]() mutable { approach(i++); });
}

bool SinumerikCalls::modal_call(std::size_t p) {
  std::string name = name_at(p);
  modal_call_ = {};
  if (name.empty()) return end_statement(p);
  if (at(skip_blanks(p)) == '(' && !arguments(p, modal_call_.arguments)) return false;
  modal_call_.name = called_program(name);
  if (!reader_.locate(modal_call_.name, place_word(p - name.size(), p))) return false;
  modal_call_.active = true;
  return end_statement(p);
}

// EXECSTRING(TEXT): the text replaces the block.
bool SinumerikCalls::run_text(std::size_t from, std::size_t p) {
  Value text;
  if (!evaluator_.expression(block_.line, p, text)) return report(evaluator_.fault());
  if (text.kind != Value::Kind::text)
    return fail("statement", "EXECSTRING(TEXT): a text is expected", from, p);
  if (!end_statement(p)) return false;
  std::size_t behind = 0;
  const std::string first = word_at(text.text, behind);
  const bool jumps = first == "IF" && upper_case(text.text).find("GOTO") != std::string::npos;
  if ((is_structure(first) && !jumps) || first == "DEF" || first == "PROC" || first == "DEFINE")
    return fail("not-supported", fmt::format("{} in EXECSTRING is not supported", first), from, p);
  return reader_.replace_line(text.text);
}

// Reads a value, or a variable that may get another value: NAME, NAME[2], an array.
bool SinumerikCalls::argument(std::size_t& p, ProcedureArgument& out) {
  std::size_t q = p;
  std::string name = name_at(q);
  const auto ends = [&] {
    const char behind = at(skip_blanks(q));
    return behind == ',' || behind == ')';
  };
  const bool element = at(q) == '[' && (name == "R" || variables_.array(name));
  if (element && !indices(block_.line, q, out.indices)) return false;
  const bool r = name.size() > 1 && name[0] == 'R' &&
                 name.find_first_not_of("0123456789", 1) == std::string::npos;
  if (ends() && (r || element || variables_.is_defined(name))) out.variable = name;
  const VariableArray* const whole = element ? nullptr : variables_.array(name);
  if (whole && !out.variable.empty()) {
    out.array = *whole;
    p = skip_blanks(q);
    return true;
  }
  Value value;
  if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
  out.value = std::move(value);
  p = skip_blanks(p);
  return true;
}

// A value may be left out.
bool SinumerikCalls::arguments(std::size_t& p, std::vector<ProcedureArgument>& out) {
  p = skip_blanks(p);
  const std::size_t from = p;
  do {
    p = skip_blanks(p + 1);
    if (at(p) == ')' && out.empty()) break;
    out.emplace_back();
    if (at(p) != ',' && at(p) != ')' && !argument(p, out.back())) return false;
  } while (at(p) == ',' && out.size() < 128);
  if (at(p) != ')')
    return fail("bracket", "the ( here is not closed (alarm 12080)", from, from + 1);
  ++p;
  return true;
}

// Carries out NAME(1, 2), NAME(1) P3, and CALL with a variable.
bool SinumerikCalls::call_statement(std::size_t from, std::size_t p) {
  std::size_t q = from;
  SubprogramName name = called_program(name_at(q));
  std::vector<ProcedureArgument> given;
  if (name.text == "CALL") {
    Value value;
    std::size_t behind = p;
    if (const std::string plain = name_at(behind); !plain.empty() &&
                                                   !variables_.is_defined(plain) &&
                                                   skip_blanks(behind) >= block_.line.size())
      return fail(
          "expression",
          fmt::format("CALL needs the name of a program as text: CALL \"{0}\", or {0} alone",
                      plain),
          p, behind);
    if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
    if (value.kind != Value::Kind::text)
      return fail("expression", "CALL needs the name of a program as text", from, p);
    name = {-1, value.text};
  } else if (!arguments(p, given)) {
    return false;
  }
  double runs = 1;
  q = p;
  const std::string word = name_at(q);
  if (word.size() > 1 && word[0] == 'P') {
    runs = parse_number(word.substr(1)).value_or(-1);
    if (!(runs >= 1 && runs <= 9999) || runs != std::floor(runs))
      return fail("value-range", "P is 1 to 9999 runs", p, q);
    p = q;
  }
  if (!end_statement(p)) return false;
  call(name, given, static_cast<long>(runs), place_word(from, p));
  return true;
}

// PCALL /_N_WKS_DIR/_N_PART_WPD/_N_HOLES_SPF(1, 2) calls the program that the last part of the path
// names, which is looked for beside the program.
bool SinumerikCalls::call_by_path(std::size_t from, std::size_t p) {
  const std::string_view line = block_.line;
  std::size_t end = std::min(line.find_first_of("(;", p), line.size());
  std::string path(line.substr(p, end - p));
  path.erase(std::remove_if(path.begin(), path.end(),
                            [](char c) { return c == '"' || c == ' ' || c == '\t' || c == '\r'; }),
             path.end());
  SubprogramName name;
  name.text = program_of_path(path);
  if (name.text.empty()) return fail("statement", "PCALL needs the path of a program", from, end);
  std::vector<ProcedureArgument> given;
  if (at(end) == '(' && !arguments(end, given)) return false;
  if (!end_statement(end)) return false;
  call(name, given, 1, place_word(from, end));
  return true;
}

bool SinumerikCalls::call_program(const SubprogramName& name, long repeats, const Word& word) {
  return call(name, {}, repeats, word);
}

// CALL and EXTCALL may name a path, of which only the last part is used.
bool SinumerikCalls::call(const SubprogramName& name, const std::vector<ProcedureArgument>& given,
                          long repeats, const Word& word, std::function<void()> before) {
  SubprogramName program = name;
  if (name.text.find_first_of("/\\") != name.text.npos) program.text = program_of_path(name.text);
  const auto place = reader_.locate(program, word);
  if (!place) return false;
  CallRequest request = call_of(*place, repeats);
  if (!procedures_.bind(*place, given, word, request)) return false;
  if (before) {
    request.on_start = [this, before = std::move(before), start = std::move(request.on_start)] {
      in_modal_call_ = true;
      before();
      start();
    };
    request.on_left = [this] { in_modal_call_ = false; };
  }
  return reader_.enter(std::move(request), word);
}

}  // namespace mrsim
