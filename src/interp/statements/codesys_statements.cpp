#include "interp/statements/codesys_statements.h"

#include "core/text/text_io.h"
#include "interp/language/flow_scan.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kLongestName = 80;
constexpr std::size_t kMostArguments = 64;
constexpr std::size_t kMostLabels = 10000;  // how many places of jump labels are kept

// The name at `p`. Of a name of more than 80 characters only the beginning, because each word of a
// block without blanks looks for a name.
std::string name_at(std::string_view line, std::size_t& p) {
  const std::size_t from = p = behind_blanks(line, p);
  const std::size_t end = std::min(line.size(), from + kLongestName + 1);
  while (p < end && is_name(line[p])) ++p;
  return upper_case(line.substr(from, p - from));
}

// The number of a G word at `p`, or -1.
int g_word(std::string_view line, std::size_t p) {
  if (p >= line.size() || upper(line[p]) != 'G') return -1;
  int number = 0;
  std::size_t end = p + 1;
  for (; end < line.size() && is_digit(line[end]) && end < p + 6; ++end)
    number = number * 10 + (line[end] - '0');
  const bool more = end < line.size() && (is_name(line[end]) || line[end] == '.');
  return end == p + 1 || more ? -1 : number;
}

// Whether the name is words before an expression in braces, G1X or N10G1X, and not a subprogram.
bool is_words(std::string_view name) {
  if (name.size() < 2 || is_digit(name.back())) return name.size() < 2;
  if (name == "EF" || name == "FF") return true;
  std::size_t p = 0;
  while (p + 1 < name.size() && (name[p] == 'N' || name[p] == 'G') && is_digit(name[p + 1]))
    for (++p; p < name.size() && is_digit(name[p]);) ++p;
  return p > 0 && p + 1 == name.size();
}

std::optional<VariableType> codesys_type(const std::string& name) {
  if (name == "LREAL") return VariableType::real;
  if (name == "BOOL") return VariableType::boolean;
  if (name == "STRING") return VariableType::text;
  return std::nullopt;
}

// Reads "#NAME : LREAL" at `p`. False: it is something else.
bool declaration(std::string_view line, std::size_t& p, std::string& name, VariableType& type) {
  p = behind_blanks(line, p);
  if (p >= line.size() || line[p] != '#') return false;
  ++p;
  name = "#" + name_at(line, p);
  p = behind_blanks(line, p);
  if (name.size() < 2 || p >= line.size() || line[p] != ':') return false;
  const auto known = codesys_type(name_at(line, ++p));
  if (known) type = *known;
  p = behind_blanks(line, p);
  return known.has_value();
}

bool starts_comment(std::string_view line, std::size_t p) {
  return p < line.size() && line[p] == '(';
}

// The line in capitals, with blanks instead of comments.
std::string without_comments(std::string_view line) {
  std::string out = upper_case(line);
  for (std::size_t p = out.find('('); p != out.npos; p = out.find('(', p)) {
    const std::size_t end = std::min(out.find(')', p), out.size() - 1);
    out.replace(p, end + 1 - p, end + 1 - p, ' ');
  }
  return out;
}

}  // namespace

CodesysStatements::CodesysStatements(Control& control, BlockReader& reader)
    : Statements(control, reader, codesys_rules(), VariableForm::codesys, OutlineForm::codesys) {}

// Statements are G20, G36, G37, LET, and calls NAME{...}.
bool CodesysStatements::starts_statement(std::string_view line, std::size_t p) {
  const int code = g_word(line, p);
  if (code == 20 || code == 36 || code == 37) return true;
  const std::string name = name_at(line, p);
  if (name == "LET") return true;
  p = behind_blanks(line, p);
  return !is_words(name) && name != "SUBPROGRAM" && p < line.size() && line[p] == '{';
}

bool CodesysStatements::starts_function(std::string_view line, std::size_t p) const {
  const std::string name = name_at(line, p);
  for (const std::string_view word : {"NOT", "PI", "TRUE", "FALSE"})
    if (name == word) return true;
  for (const FunctionRow& row : evaluator_.rules().functions)
    if (row.name == name) return true;
  return false;
}

bool CodesysStatements::assignment(std::string_view line, std::size_t& p) {
  const std::size_t from = p++;
  const std::string name = name_at(line, p);
  return fail("assignment", fmt::format("a variable is set by a word: G36 O#{} D10", name), from,
              p);
}

bool CodesysStatements::statement(std::size_t from) {
  const int code = g_word(block_.line, from);
  if (code < 0) {
    std::size_t p = from;
    return name_at(block_.line, p) == "LET" ? define(p) : call_statement(from);
  }
  std::size_t p = from + 1;
  while (is_digit(at(p))) ++p;
  return code == 20 ? jump(p) : write(code == 37, p);
}

// The next character that is neither blank nor in a comment. A comment that is not closed is not
// skipped, so that the reader reports it.
std::size_t CodesysStatements::behind_comments(std::size_t p) const {
  for (p = skip_blanks(p); starts_comment(block_.line, p);) {
    const std::size_t end = block_.line.find(')', p);
    if (end == block_.line.npos) break;
    p = skip_blanks(end + 1);
  }
  return p;
}

// Ends the statement. A comment may follow, or the N word of another block.
bool CodesysStatements::end_statement(std::size_t p) {
  p = skip_blanks(p);
  const bool next = upper(at(p)) == 'N' && is_digit(at(p + 1));
  if (p < block_.line.size() && !next && !starts_comment(block_.line, p))
    return fail("statement", "the end of the block is expected here", p, p + 1);
  reader_.set_position(p);
  return true;
}

// G20 L20 K$a$ jumps to block N20 if K is not 0. G20 L?4 jumps to the next block below with L!4.
bool CodesysStatements::jump(std::size_t p) {
  const std::size_t from = p;
  double target = -1, condition = counter_;
  bool label = false;
  for (p = behind_comments(p); p < block_.line.size(); p = behind_comments(p)) {
    const char c = upper(at(p));
    if (c != 'L' && c != 'K') break;
    ++p;
    if (c == 'L' && at(p) == '?') label = ++p > 0;
    double& out = c == 'L' ? target : condition;
    if (!evaluator_.number_expression(block_.line, p, out)) return report(evaluator_.fault());
  }
  if (!(target >= 0 && target < 1e9) || target != static_cast<double>(static_cast<long>(target)))
    return fail("jump-target", "G20 needs L with the number of a block", from, p);
  if (!end_statement(p)) return false;
  if (condition == 0) return true;
  Place to;
  const long number = static_cast<long>(target);
  if (!(label ? find_label(number, to) : places_.find_number(number, true, true, to)))
    return fail("jump-target",
                fmt::format("there is no block {}{}", label ? "below with L!" : "N", number), from,
                p);
  reader_.leave_stretches();
  return jump_in_loop(to);
}

// Finds the first line below that has L!index outside of comments.
bool CodesysStatements::find_label(long index, Place& out) {
  const Place here = reader_.place_at(0);
  if (labels_.size() > kMostLabels) labels_.clear();
  const auto [known, fresh] = labels_.try_emplace({here.offset, index});
  auto& [found, place] = known->second;
  if (fresh) {
    const Place end = places_.outline().section_end(places_.outline().section_at(here));
    const std::string wanted = fmt::format("L!{}", index);
    LineSource source(reader_.file(), std::size_t(1) << 16);
    source.seek(here.offset, here.line);
    std::string_view line;
    source.next(line);
    for (std::uint64_t offset = source.next_offset(); !found && offset < end.offset;
         offset = source.next_offset()) {
      if (!source.next(line)) break;
      const std::string code = without_comments(line);
      const std::size_t at = code.find(wanted);
      found = at != code.npos &&
              (at + wanted.size() >= code.size() || !is_digit(code[at + wanted.size()]));
      place = {offset, source.line_number() - 1, 0};
    }
  }
  out = place;
  return found;
}

// G36 O$a$ D5 sets a variable and G37 O$a$ D-1 adds to it. Without O it is the decoder's own
// variable.
bool CodesysStatements::write(bool adds, std::size_t p) {
  const DataReads data(reader_.watch());
  std::size_t from = p, to = 0;  // place of the variable, else of the words
  std::string target;
  Value value;
  bool given = false;
  for (p = behind_comments(p); p < block_.line.size(); p = behind_comments(p)) {
    const char c = upper(at(p));
    if (c != 'O' && c != 'D') break;
    ++p;
    if (c == 'D') {
      if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
      given = true;
      continue;
    }
    p = behind_comments(p);
    const std::size_t begin = p;
    const bool global = at(p) == '$';
    if (!global && at(p) != '#') return fail("assignment", "O names a variable", p, p + 1);
    ++p;
    while (p < block_.line.size() && (is_name(at(p)) || (global && at(p) != '$' && at(p) != ' ')))
      ++p;
    if (global && at(p++) != '$') return fail("assignment", "O$NAME$ is expected", begin, p);
    target = std::string(block_.line.substr(begin, p - begin));
    from = begin;
    to = p;
  }
  if (!given) return fail("assignment", "D with the value is needed", from, p);
  return change(target, adds, value, from, to > 0 ? to : p) && end_statement(p);
}

bool CodesysStatements::change(std::string_view target, bool adds, const Value& value,
                               std::size_t from, std::size_t to) {
  if (target.empty()) {
    if (!value.is_number()) return fail("expression", "a number is needed here", from, to);
    reader_.watch().forget();
    counter_ = value.number + (adds ? counter_ : 0);
    return true;
  }
  Value sum = value;
  if (adds) {
    std::string why;
    Value old;
    if (!variables_.named(target, {}, old, why)) return fail("variable-unset", why, from, to);
    if (old.kind != value.kind)
      return fail("expression", "a text and a number cannot be added", from, to);
    sum = old;
    sum.number += value.number;
    sum.text += value.text;
    if (sum.text.size() > 1000) return fail("expression", "the text grows too long", from, to);
  }
  return store(target, {}, sum, from, to);
}

// LET defines a variable: LET #WIDTH : LREAL := 40.
bool CodesysStatements::define(std::size_t p) {
  const std::size_t from = p;
  std::string name, why;
  VariableType type{};
  if (!declaration(block_.line, p, name, type))
    return fail("statement",
                "LET #NAME : LREAL is expected here (or BOOL or STRING), with := and "
                "a value if it has one",
                from, p + 1);
  if (!variables_.define(name, type, {}, false, why)) return fail("variable-defined", why, from, p);
  if (at(p) != ':' || at(p + 1) != '=') return end_statement(p);
  p += 2;
  Value first;
  if (!evaluator_.expression(block_.line, p, first)) return report(evaluator_.fault());
  return store(name, {}, first, from, p) && end_statement(p);
}

// Calls NAME{1, #A*2}. DYNCALL{'NAME', 1} computes the name.
bool CodesysStatements::call_statement(std::size_t from) {
  std::size_t p = from;
  SubprogramName name;
  name.text = name_at(block_.line, p);
  std::vector<Value> given;
  p = skip_blanks(skip_blanks(p) + 1);
  while (at(p) != '}') {
    given.emplace_back();
    if (!evaluator_.expression(block_.line, p, given.back())) return report(evaluator_.fault());
    p = skip_blanks(p);
    const bool more = at(p) == ',';
    if ((!more && at(p) != '}') || given.size() > kMostArguments)
      return fail("bracket", "a comma or } is expected here", p, p + 1);
    if (more) p = skip_blanks(p + 1);
  }
  if (!end_statement(p + 1)) return false;
  if (name.text == "DYNCALL") {
    if (given.empty() || given[0].kind != Value::Kind::text)
      return fail("expression", "DYNCALL needs the name of a subprogram as text", from, p);
    name.text = given[0].text;
    given.erase(given.begin());
  }
  return call(name, given, place_word(from, p + 1));
}

bool CodesysStatements::call_program(const SubprogramName& name, long, const Word& word) {
  return call(name, {}, word);
}

// Reads the formals in the header of a subprogram: SUBPROGRAM NAME{#A : LREAL, #B : BOOL}.
bool CodesysStatements::formals(const SubprogramPlace& place, const Word& where,
                                std::vector<Formal>& out) {
  LineSource source(place.file, std::size_t(1) << 14);
  source.seek(place.offset, place.line);
  std::string_view line;
  std::size_t p = 0;
  do {
    if (!source.next(line)) return true;  // the file has no header
    p = behind_blanks(line, 0);
  } while (p >= line.size() || line[p] == '(' || line[p] == '%' || line[p] == '\r');
  long number = -1;
  p = behind_number(line, 0, number);
  if (name_at(line, p) != "SUBPROGRAM") return true;
  name_at(line, p);
  p = behind_blanks(line, p);
  if (p < line.size() && line[p] == '{') {
    p = behind_blanks(line, p + 1);
    while (p < line.size() && line[p] != '}') {
      Formal one;
      if (!declaration(line, p, one.name, one.type) || out.size() > kMostArguments)
        return error("call-arguments", "the header of the subprogram has a formal that is not read",
                     where);
      out.push_back(std::move(one));
      if (p < line.size() && line[p] == ',') ++p;
    }
    p = behind_blanks(line, p + 1);
  }
  if (p < line.size() && line[p] != '(' && line[p] != '\r')
    return error("not-supported",
                 fmt::format("{} behind the subprogram's formals is not supported",
                             to_utf8(line.substr(p, 40))),
                 where);
  return true;
}

bool CodesysStatements::call(const SubprogramName& name, const std::vector<Value>& given,
                             const Word& where) {
  const auto place = reader_.locate(name, where);
  std::vector<Formal> wanted;
  if (!place || !formals(*place, where, wanted)) return false;
  if (given.size() != wanted.size())
    return error(
        "call-arguments",
        fmt::format("{} arguments, and the subprogram has {} formals", given.size(), wanted.size()),
        where);
  for (std::size_t i = 0; i < given.size(); ++i)
    if ((given[i].kind == Value::Kind::text) != (wanted[i].type == VariableType::text))
      return error("call-arguments",
                   fmt::format("{} is {}", wanted[i].name,
                               wanted[i].type == VariableType::text ? "a text" : "no text"),
                   where);
  CallRequest request = call_of(*place);
  request.on_start = [this, wanted, given] {
    variables_.enter_level();
    std::string ignored;
    for (std::size_t i = 0; i < given.size(); ++i) {
      variables_.define(wanted[i].name, wanted[i].type, {}, false, ignored);
      variables_.assign(wanted[i].name, {}, given[i], ignored);
    }
  };
  request.on_end = [this] { variables_.leave_level(); };
  return reader_.enter(std::move(request), where);
}

}  // namespace mrsim
