// SINUMERIK: assignments, DEF, and calls with parameters.
#include "core/text_io.h"
#include "interp/language/operations.h"
#include "interp/statements/sinumerik_statements.h"
#include "interp/statements/sinumerik_text.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostValues = 10'000;  // of SET( )
constexpr std::size_t kAllElements = std::numeric_limits<std::size_t>::max();
constexpr std::string_view kStructures[] = {"IF",       "ELSE",   "ENDIF",  "WHILE",
                                            "ENDWHILE", "FOR",    "ENDFOR", "LOOP",
                                            "ENDLOOP",  "REPEAT", "UNTIL"};

}  // namespace

bool SinumerikStatements::indices(std::string_view line, std::size_t& p, std::vector<Value>& out) {
  const std::size_t from = p;
  do {
    ++p;
    Value value;
    if (!evaluator_.expression(line, p, value)) return report(evaluator_.fault());
    out.push_back(std::move(value));
    p = blanks(line, p);
  } while (at(p) == ',' && out.size() < 3);
  if (at(p) != ']') return fail("bracket", "the [ here is not closed with ]", from, from + 1);
  ++p;
  return true;
}

// R1=..., R[n]=..., NAME=..., NAME[n]=SET(1,2), $P_PFRAME=...
bool SinumerikStatements::assignment(std::string_view line, std::size_t& p) {
  const std::size_t from = p;
  if (at(p) == '$') ++p;
  while (is_name(at(p))) ++p;
  const std::string name(line.substr(from, p - from));
  std::vector<Value> at_index;
  p = blanks(line, p);
  if (at(p) == '[' && !indices(line, p, at_index)) return false;
  const std::size_t to = p;
  p = blanks(line, p);
  if (at(p) != '=') return fail("assignment", "= is expected here (alarm 12080)", p, p + 1);
  p = blanks(line, p + 1);
  return assign_all(line, p, name, at_index, from, to);
}

bool SinumerikStatements::assign_all(std::string_view line, std::size_t& p, std::string_view name,
                                     std::span<const Value> at_index, std::size_t from,
                                     std::size_t to) {
  std::size_t q = p;
  const std::string word = word_at(line, q);
  const bool list = (word == "SET" || word == "REP") && at(q) == '(';
  const bool r = upper(name[0]) == 'R' &&
                 name.find_first_not_of("0123456789", 1) == std::string_view::npos &&
                 (name.size() > 1) != (at_index.size() == 1);
  if (list) {
    p = q;
    return fill(line, p, name, at_index, word == "REP", from);
  }
  Value value;
  if (!evaluator_.expression(line, p, value)) {
    report(evaluator_.fault());
    value = {};
    value.kind = Value::Kind::faulty;
    std::string ignored;
    if (!r) variables_.assign(name, at_index, value, ignored);
    if (r && at_index.empty())
      variables_.assign(parse_number(name.substr(1)).value_or(-1), value, ignored);
    return false;
  }
  if (!r) return store(name, at_index, value, from, to);
  const double number =
      at_index.empty() ? parse_number(name.substr(1)).value_or(-1) : at_index[0].number;
  const bool text = !at_index.empty() && !at_index[0].is_number();
  if (text || number != std::floor(number))
    return fail("variable-number", "the number of an R parameter is a whole number", from, to);
  return store(number, value, from, to);
}

// SET(1, , 3), where a value left out leaves its element; REP(2) of all elements, REP(2, 5) of
// five.
bool SinumerikStatements::fill(std::string_view line, std::size_t& p, std::string_view name,
                               std::span<const Value> at_index, bool repeats, std::size_t from) {
  const std::size_t open = p;
  std::vector<std::optional<Value>> values;
  do {
    p = blanks(line, p + 1);
    values.emplace_back();
    if (at(p) == ',' || at(p) == ')') continue;
    Value value;
    if (!evaluator_.expression(line, p, value)) return report(evaluator_.fault());
    values.back() = std::move(value);
    p = blanks(line, p);
  } while (at(p) == ',' && values.size() < kMostValues);
  if (at(p) != ')') return fail("bracket", "the ( here is not closed with )", open, open + 1);
  ++p;
  std::size_t count = repeats ? kAllElements : 0;
  if (repeats && values.size() == 2 && values[1]) {
    if (!values[1]->is_number() || !(values[1]->number >= 1))
      return fail("value-range", "REP needs a number of elements from 1 on", open, p);
    count = static_cast<std::size_t>(std::min(values[1]->number, 1e9));
  }
  std::string why;
  if (!variables_.fill(name, at_index, values, count, why))
    return fail("variable-unset", why, from, p);
  if (options_.trace_variables)
    reporter_.assignment(
        name, fmt::format("{}{}", repeats ? "REP" : "SET", to_utf8(line.substr(open, p - open))));
  return true;
}

// DEF REAL A, B=2, C[3,2]; DEF STRING[20] NAME
bool SinumerikStatements::define(std::size_t p) {
  return definitions(p, false) && end_statement(p);
}

// NCK, CHAN, SYNR ...: who shares a variable; PHU 1, LLI 0, APRP 7 ...: unit, limits and rights.
std::string SinumerikStatements::behind_attributes(std::size_t& p, bool& global) {
  static constexpr std::string_view kPlain[] = {"NCK", "CHAN", "SYNR", "SYNW", "SYNRW"};
  static constexpr std::string_view kCounted[] = {"PHU",  "LLI",  "ULI",  "APR", "APW",
                                                  "APRP", "APWP", "APRB", "APWB"};
  for (;;) {
    std::size_t q = p;
    std::string word = name_at(q);
    const bool plain = std::find(std::begin(kPlain), std::end(kPlain), word) != std::end(kPlain);
    const bool counted =
        std::find(std::begin(kCounted), std::end(kCounted), word) != std::end(kCounted);
    if (!plain && !counted) return word;
    p = q;
    global = global || word == "NCK" || word == "CHAN";
    double ignored = 0;
    if (counted && !number(p, ignored, false)) return {};
  }
}

bool SinumerikStatements::definitions(std::size_t& p, bool global) {
  const std::string word = behind_attributes(p, global);
  const std::size_t from = p = skip_blanks(p);
  const std::optional<VariableType> type = type_named(word);
  if (!type)
    return fail("statement", "REAL, INT, BOOL, CHAR, STRING, AXIS or FRAME is expected here", from,
                p + 1);
  name_at(p);
  std::size_t longest = std::string::npos;
  if (*type == VariableType::text && at(p) == '[') {
    std::vector<Value> length;
    if (!indices(block_.line, p, length)) return false;
    if (!(length[0].number >= 1) || length[0].number > 1e6)
      return fail("value-range", "the length of a STRING is 1 and more", from, p);
    longest = static_cast<std::size_t>(length[0].number);
  }
  behind_attributes(p, global);
  for (;;) {
    if (!define_one(p, *type, longest, global)) return false;
    p = skip_blanks(p);
    if (at(p) != ',') return true;
    ++p;
  }
}

// DEFINE NAME AS TEXT. Structures are found in the lines as they are written, so that none may be
// behind a name.
bool SinumerikStatements::define_macro(std::size_t p, bool everywhere) {
  const std::size_t from = p;
  const std::string name = name_at(p);
  std::size_t q = p;
  if (name.empty() || name_at(q) != "AS")
    return fail("statement", "DEFINE NAME AS TEXT (alarm 12080)", from, q);
  const std::size_t begin = p = skip_blanks(q);
  for (bool quoted = false; p < block_.line.size() && (quoted || at(p) != ';'); ++p)
    if (at(p) == '"') quoted = !quoted;
  std::string_view text = block_.line.substr(begin, p - begin);
  text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
  q = begin;
  const std::string first = name_at(q);
  if (std::ranges::find(kStructures, first) != std::end(kStructures) || first == "DEFINE")
    return fail("not-supported", fmt::format("{} behind a name of DEFINE is not supported", first),
                begin, q);
  reader_.define_macro(name, text, everywhere);
  if (!everywhere) reader_.set_position(block_.line.size());
  return true;
}

// A block of words under MCALL ends with the call, where it moved, in subprograms too.
void SinumerikStatements::end_block(bool moved) {
  if (!moved || !modal_call_.active || in_modal_call_) return;
  call(modal_call_.name, modal_call_.arguments, 1, block_.words.front(), true);
}

bool SinumerikStatements::modal_call(std::size_t p) {
  std::string name = name_at(p);
  modal_call_ = {};
  if (name.empty()) return end_statement(p);
  if (at(skip_blanks(p)) == '(' && !arguments(p, modal_call_.arguments)) return false;
  modal_call_.name.text = name;
  if (!reader_.locate(modal_call_.name, place_word(p - name.size(), p))) return false;
  modal_call_.active = true;
  return end_statement(p);
}

// EXECSTRING(TEXT): the text stands for the block.
bool SinumerikStatements::run_text(std::size_t from, std::size_t p) {
  Value text;
  if (!evaluator_.expression(block_.line, p, text)) return report(evaluator_.fault());
  if (text.kind != Value::Kind::text)
    return fail("statement", "EXECSTRING(TEXT): a text is expected", from, p);
  if (!end_statement(p)) return false;
  std::size_t behind = 0;
  const std::string first = word_at(text.text, behind);
  const bool jumps = first == "IF" && upper_case(text.text).find("GOTO") != std::string::npos;
  if ((std::ranges::find(kStructures, first) != std::end(kStructures) && !jumps) ||
      first == "DEF" || first == "PROC" || first == "DEFINE")
    return fail("not-supported", fmt::format("{} in EXECSTRING is not supported", first), from, p);
  return reader_.replace_line(text.text);
}

// Files of definitions (UGUD.DEF) among the search path: their variables live as long as the run.
void SinumerikStatements::read_definitions() {
  for (const std::string& file : options_.search_path) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) continue;
    program_.files.push_back(file);
    const int index = static_cast<int>(program_.files.size()) - 1;
    LineSource source(file, std::size_t(1) << 14);
    std::string_view line;
    while (source.next(line)) {
      block_.line = line;
      reporter_.set_place(index, source.line_number(), -1, line);
      std::size_t p = 0;
      const std::string word = name_at(p);
      if (word == "DEF") definitions(p, true);
      if (word == "DEFINE") define_macro(p, true);
    }
    block_.line = {};
    reporter_.forget_text();
  }
}

bool SinumerikStatements::define_one(std::size_t& p, VariableType type, std::size_t longest,
                                     bool global) {
  p = skip_blanks(p);
  const std::size_t from = p;
  const std::string name = name_at(p);
  if (name.size() < 2 || is_digit(name[0]))
    return fail("statement", "a name of at least two characters is expected here", from, p + 1);
  std::array<int, 3> dimensions{};
  if (at(p) == '[') {
    std::vector<Value> sizes;
    if (!indices(block_.line, p, sizes)) return false;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (!(sizes[i].number >= 1) || sizes[i].number > 1e6)
        return fail("value-range", "the size of an array is 1 and more", from, p);
      dimensions[i] = static_cast<int>(sizes[i].number);
    }
  }
  const std::size_t to = p;
  std::string why;
  if (!variables_.define(name, type, dimensions, global, why))
    return fail("variable-defined", why, from, to);
  variables_.limit_texts(name, longest);
  p = skip_blanks(p);
  if (at(p) != '=') return true;
  p = skip_blanks(p + 1);
  std::size_t q = p;
  const std::string word = name_at(q);
  if (dimensions[0] == 0 || word == "SET" || word == "REP")
    return assign_all(block_.line, p, name, {}, from, to);
  if (at(p) == '(') return fill(block_.line, p, name, {}, false, from);
  Value value;
  if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
  const std::optional<Value> all[] = {value};
  return variables_.fill(name, {}, all, kAllElements, why) || fail("variable-unset", why, from, p);
}

// A value, or a variable that may get another one: NAME, NAME[2], an array.
bool SinumerikStatements::argument(std::size_t& p, Argument& out) {
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
  const Variables::Array* const whole = element ? nullptr : variables_.array(name);
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

// The values between brackets; one may be left out.
bool SinumerikStatements::arguments(std::size_t& p, std::vector<Argument>& out) {
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

// NAME(1, 2), NAME(1) P3, CALL variable
bool SinumerikStatements::call_statement(std::size_t from, std::size_t p) {
  SubprogramName name;
  std::size_t q = from;
  name.text = name_at(q);
  std::vector<Argument> given;
  if (name.text == "CALL") {
    Value value;
    if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
    if (value.kind != Value::Kind::text)
      return fail("expression", "CALL needs the name of a program as text", from, p);
    name.text = value.text;
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

// PCALL /_N_WKS_DIR/_N_PART_WPD/_N_HOLES_SPF(1, 2): the path's last part, beside the program.
bool SinumerikStatements::call_by_path(std::size_t from, std::size_t p) {
  const std::string_view line = block_.line;
  std::size_t end = std::min(line.find_first_of("(;", p), line.size());
  std::string path(line.substr(p, end - p));
  path.erase(std::remove_if(path.begin(), path.end(),
                            [](char c) { return c == '"' || c == ' ' || c == '\t' || c == '\r'; }),
             path.end());
  SubprogramName name;
  name.text = upper_case(path.substr(path.rfind('/') + 1));
  if (name.text.starts_with("_N_")) name.text.erase(0, 3);
  for (const std::string_view kind : {"_SPF", "_MPF", ".SPF", ".MPF"})
    if (name.text.size() > kind.size() && name.text.ends_with(kind))
      name.text.resize(name.text.size() - kind.size());
  if (name.text.empty()) return fail("statement", "PCALL needs the path of a program", from, end);
  std::vector<Argument> given;
  if (at(end) == '(' && !arguments(end, given)) return false;
  if (!end_statement(end)) return false;
  call(name, given, 1, place_word(from, end));
  return true;
}

bool SinumerikStatements::call_program(const SubprogramName& name, long repeats, const Word& word) {
  return call(name, {}, repeats, word);
}

}  // namespace mrsim
