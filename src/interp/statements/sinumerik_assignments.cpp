#include "interp/statements/sinumerik_assignments.h"

#include "core/text/text_io.h"
#include "interp/language/operations.h"
#include "interp/statements/sinumerik_text.h"
#include "interp/text/characters.h"
#include "interp/text/source.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostValues = 10'000;  // values of SET( )
constexpr std::size_t kAllElements = std::numeric_limits<std::size_t>::max();

}  // namespace

SinumerikAssignments::SinumerikAssignments(Control& control, BlockReader& reader)
    : Statements(control, reader, sinumerik_rules(), VariableForm::sinumerik,
                 OutlineForm::sinumerik) {
  std::string ignored;  // a name: the contour of LCYC95
  variables_.define("_CNAME", VariableType::text, {}, true, ignored);
  read_definitions();
}

std::string SinumerikAssignments::name_at(std::size_t& p) const {
  p = skip_blanks(p);
  const std::size_t from = p;
  while (is_name(at(p))) ++p;
  return upper_case(block_.line.substr(from, std::min<std::size_t>(p - from, 64)));
}

bool SinumerikAssignments::end_statement(std::size_t p) {
  p = skip_blanks(p);
  if (p < block_.line.size() && at(p) != ';')
    return fail("statement", "the end of the block is expected here (alarm 12080)", p, p + 1);
  reader_.set_position(p);
  return true;
}

bool SinumerikAssignments::indices(std::string_view line, std::size_t& p, std::vector<Value>& out) {
  const DataReads way(reader_.watch(), false);  // they decide which variable changes
  const std::size_t from = p;
  do {
    ++p;
    Value value;
    if (!evaluator_.expression(line, p, value)) return report(evaluator_.fault());
    out.push_back(std::move(value));
    p = behind_blanks(line, p);
  } while (at(p) == ',' && out.size() < 3);
  if (at(p) != ']') return fail("bracket", "the [ here is not closed with ]", from, from + 1);
  ++p;
  return true;
}

// Carries out R1=..., R[n]=..., NAME=..., NAME[n]=SET(1,2), $P_PFRAME=....
bool SinumerikAssignments::assignment(std::string_view line, std::size_t& p) {
  const DataReads data(reader_.watch());
  const std::size_t from = p;
  if (at(p) == '$') ++p;
  while (is_name(at(p))) ++p;
  const std::string name(line.substr(from, p - from));
  std::vector<Value> at_index;
  p = behind_blanks(line, p);
  if (at(p) == '[' && !indices(line, p, at_index)) return false;
  const std::size_t to = p;
  p = behind_blanks(line, p);
  if (at(p) != '=') return fail("assignment", "= is expected here (alarm 12080)", p, p + 1);
  p = behind_blanks(line, p + 1);
  return assign_all(line, p, name, at_index, from, to);
}

bool SinumerikAssignments::assign_all(std::string_view line, std::size_t& p, std::string_view name,
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

// SET(1, , 3) sets elements in order; a value that is left out leaves its element as it is. REP(2)
// sets all elements, and REP(2, 5) sets five.
bool SinumerikAssignments::fill(std::string_view line, std::size_t& p, std::string_view name,
                                std::span<const Value> at_index, bool repeats, std::size_t from) {
  const std::size_t open = p;
  std::vector<std::optional<Value>> values;
  do {
    p = behind_blanks(line, p + 1);
    values.emplace_back();
    if (at(p) == ',' || at(p) == ')') continue;
    Value value;
    if (!evaluator_.expression(line, p, value)) return report(evaluator_.fault());
    values.back() = std::move(value);
    p = behind_blanks(line, p);
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

// DEF defines variables: DEF REAL A, B=2, C[3,2] or DEF STRING[20] NAME.
bool SinumerikAssignments::define(std::size_t p) {
  return definitions(p, false) && end_statement(p);
}

// NCK, CHAN, SYNR ... say who shares a variable; PHU 1, LLI 0, APRP 7 ... are unit, limits and
// rights.
std::string SinumerikAssignments::behind_attributes(std::size_t& p, bool& global) {
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

bool SinumerikAssignments::definitions(std::size_t& p, bool global) {
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

// DEFINE NAME AS TEXT. Structures are found in the lines as they are written, so that the text must
// not contain one.
bool SinumerikAssignments::define_macro(std::size_t p, bool everywhere) {
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
  if (is_structure(first) || first == "DEFINE")
    return fail("not-supported", fmt::format("{} behind a name of DEFINE is not supported", first),
                begin, q);
  reader_.define_macro(name, text, everywhere);
  if (!everywhere) reader_.set_position(block_.line.size());
  return true;
}

// Reads files of definitions (UGUD.DEF) in the search path. Their variables live as long as the
// run.
void SinumerikAssignments::read_definitions() {
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

bool SinumerikAssignments::define_one(std::size_t& p, VariableType type, std::size_t longest,
                                      bool global) {
  p = skip_blanks(p);
  const std::size_t from = p;
  const std::string name = name_at(p);
  if (name.size() < 2 || is_digit(name[0]) || is_digit(name[1]))
    return fail("statement",
                name.size() < 2 ? "a name of at least two characters is expected here"
                                : "the name of a variable begins with two letters or underscores",
                from, std::max(p, from + 1));
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

}  // namespace mrsim
