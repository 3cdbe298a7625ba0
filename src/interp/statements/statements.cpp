#include "interp/statements/statements.h"

#include "core/text/text_io.h"
#include "interp/language/flow_scan.h"
#include "interp/language/operations.h"
#include "interp/statements/codesys_statements.h"
#include "interp/statements/fagor_statements.h"
#include "interp/statements/osp_statements.h"
#include "interp/statements/oword_statements.h"
#include "interp/statements/sinumerik_statements.h"
#include "interp/text/characters.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLargest = 1e9;              // the largest value of a word
constexpr double kOffWhole = 1e-6;            // rounding of an expression whose value is whole
constexpr std::size_t kMostCallValues = 128;  // values of a call
constexpr std::size_t kMostTexts = 100;       // texts of a block

}  // namespace

std::unique_ptr<Statements> Statements::make(Control& control, BlockReader& reader) {
  switch (control.dialect) {
    case Dialect::fanuc:
      return std::make_unique<OspStatements>(control, reader);
    case Dialect::ngc:
      return std::make_unique<OwordStatements>(control, reader);
    case Dialect::sinumerik:
      return std::make_unique<SinumerikStatements>(control, reader);
    case Dialect::iso:
      return std::make_unique<FagorStatements>(control, reader);
    case Dialect::codesys:
      return std::make_unique<CodesysStatements>(control, reader);
    default:
      return nullptr;
  }
}

Statements::Statements(Control& control, BlockReader& reader, const ExpressionRules& rules,
                       VariableForm variables, OutlineForm outline)
    : ControlPart(control),
      reader_(reader),
      system_(control),
      variables_(variables),
      evaluator_(rules, variables_),
      places_(reader, outline) {
  variables_.set_system(&system_);
  variables_.set_watch(&reader_.watch());
  for (const auto& [name, text] : options_.variables) {
    const std::optional<double> given = parse_number(text, true);
    std::string why;
    if (!variables_.preset(name, given ? Value::of(*given) : Value::of_text(text), why))
      throw Error("variable-unknown", fmt::format("--set {}={}: {}", name, text, why),
                  Error::Kind::usage);
  }
}

void Statements::tell_unread_presets() {
  std::string names;
  for (const UnreadPresets::Preset& one : variables_.unread())
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", to_utf8(one.given),
                         one.is_replaced ? "set before it is read" : "never read");
  if (!names.empty())
    reporter_.add_general(Severity::note, "set-unused",
                          fmt::format("--set does nothing to this program for {}", names));
}

bool Statements::fail(const char* code, const std::string& text, std::size_t from, std::size_t to) {
  reporter_.add(Severity::error, code, text, static_cast<int>(from),
                static_cast<int>(to > from ? to - from : 1));
  return false;
}

bool Statements::report(const Fault& fault) {
  if (fault.code[0] != '\0') return fail(fault.code, fault.text, fault.from, fault.to);
  return false;
}

Word Statements::place_word(std::size_t from, std::size_t to) const {
  Word word;
  word.column = static_cast<int>(from);
  word.length = static_cast<int>(to > from ? to - from : 1);
  return word;
}

std::size_t Statements::skip_blanks(std::size_t p) const {
  while (at(p) == ' ' || at(p) == '\t' || at(p) == '\r') ++p;
  return p;
}

std::string Statements::letters_of(std::string_view line, std::size_t& p) {
  return letters_at(line, p);
}

// Evaluates what stands behind the word's address. False: reported.
bool Statements::evaluate(std::string_view line, std::size_t& p, const Word& word, bool whole,
                          Value& out) {
  const auto c = static_cast<char>(word.address);
  const bool length = word.address < Address::function &&
                      std::string_view("XYZUVWIJKRABCQ").find(c) != std::string_view::npos;
  const bool steps = length && is(Dialect::fanuc) &&
                     !whole;  // ROUND in a word of FANUC's macros rounds to increments
  evaluator_.set_round_step(!steps ? 1 : modal_.least_increment());
  const bool way = !(word.address < Address::function) ||
                   std::string_view("GHLMNOPQDT").find(c) != std::string_view::npos;
  const DataReads data(reader_.watch(), !way);
  const bool ok = whole ? evaluator_.expression(line, p, out) : evaluator_.operand(line, p, out);
  evaluator_.set_round_step(1);
  return ok || report(evaluator_.fault());
}

LanguageReader::Answer Statements::value(std::string_view line, std::size_t& p, Word& word,
                                         bool whole) {
  const std::size_t from = p;
  Value out;
  if (!evaluate(line, p, word, whole, out)) return Answer::failed;
  if (out.kind == Value::Kind::text && !is(Dialect::sinumerik)) {  // words of CODESYS have numbers
    fail("expression", "a number is needed here", from, p);
    return Answer::failed;
  }
  switch (out.kind) {
    case Value::Kind::vacant:
      reader_.watch().decide();  // it gives no argument
      return Answer::vacant;
    case Value::Kind::text:
      if (texts_.size() > kMostTexts) texts_.pop_front();
      texts_.push_back(std::move(out.text));
      word.string = true;
      word.text = texts_.back();
      return Answer::value;
    case Value::Kind::number:
      break;
    default:
      fail("expression", "a number is needed here", from, p);
      return Answer::failed;
  }
  if (!(std::abs(out.number) <= kLargest)) {
    fail("number-too-large",
         fmt::format("{} is too large (limit 1e9){}", value_text(out.number),
                     evaluator_.values_read()),
         from, p);
    return Answer::failed;
  }
  word.value = out.number;
  const auto c = static_cast<char>(word.address);
  const double tenth = nearest_whole(out.number * 10);
  if ((c == 'G' || c == 'M') && std::abs(out.number * 10 - tenth) < kOffWhole)
    word.value = tenth / 10;
  return Answer::value;
}

bool Statements::starts_function(std::string_view line, std::size_t p) const {
  const std::string name = letters_of(line, p);
  p = behind_blanks(line, p);
  if (p >= line.size() || line[p] != '[' || name.size() < 2) return false;
  for (const FunctionRow& row : evaluator_.rules().functions)
    if (row.name == name) return true;
  return false;
}

bool Statements::variable(double number, double& out) {
  Value value;
  std::string why;
  if (!variables_.numbered(number, value, why) || !value.is_number()) return false;
  out = value.number;
  return true;
}

void Statements::set_variable(double number, double value) {
  std::string why;
  variables_.assign(number, Value::of(value), why);
}

void Statements::set_argument(int number, double value) {
  set_variable(number, value);
  if (options_.trace_variables) reporter_.assignment(fmt::format("#{}", number), value_text(value));
}

bool Statements::store(double number, const Value& value, std::size_t from, std::size_t to) {
  std::string why;
  if (!variables_.assign(number, value, why)) return fail("variable-number", why, from, to);
  if (options_.trace_variables && value.kind != Value::Kind::faulty)
    reporter_.assignment(block_.line.substr(from, to - from), value_shown(value));
  return true;
}

bool Statements::store(std::string_view name, std::span<const Value> indices, const Value& value,
                       std::size_t from, std::size_t to) {
  std::string why;
  if (!variables_.assign(name, indices, value, why)) return fail("variable-unset", why, from, to);
  if (options_.trace_variables && value.kind != Value::Kind::faulty)
    reporter_.assignment(block_.line.substr(from, to - from), value_shown(value));
  return true;
}

// Reads the number of the variable that is set. Variables in that number decide which variable
// changes, so the loop watch does not take them for mere data.
bool Statements::target_number(std::string_view line, std::size_t& p, double& out) {
  const DataReads way(reader_.watch(), false);
  return evaluator_.variable_number(line, p, out);
}

// Carries out #target = expression. LinuxCNC's assignments are different, see OwordStatements.
bool Statements::assignment(std::string_view line, std::size_t& p) {
  const DataReads data(reader_.watch());
  const std::size_t from = p;
  ++p;
  double index = 0;
  if (!target_number(line, p, index)) return report(evaluator_.fault());
  const std::size_t to = p;
  p = skip_blanks(p);
  if (at(p) != '=')
    return fail("assignment", "= is expected here: a variable is read only behind an address", p,
                p + 1);
  ++p;
  Value value;
  if (!evaluator_.expression(line, p, value)) {
    report(evaluator_.fault());
    value.kind = Value::Kind::faulty;
    std::string ignored;
    variables_.assign(index, value, ignored);
    return false;
  }
  return store(index, value, from, to);
}

bool Statements::call_values(std::string_view argument, std::vector<std::optional<Value>>& out) {
  const auto from = static_cast<std::size_t>(argument.data() - block_.line.data());
  const std::size_t to = from + argument.size();
  std::size_t p = skip_blanks(from);
  while (out.size() < kMostCallValues) {
    out.emplace_back();
    if (p < to && at(p) != ',') {
      Value value;
      const std::size_t begin = p;
      if (!evaluator_.expression(block_.line, p, value)) return report(evaluator_.fault());
      if (value.is_number() && !(std::abs(value.number) <= kLargest))
        return fail("number-too-large", fmt::format("{:g} is too large (limit 1e9)", value.number),
                    begin, p);
      out.back() = std::move(value);
      p = skip_blanks(p);
    }
    if (p >= to) return true;
    if (at(p) != ',') return fail("bracket", "a comma is expected here (alarm 12080)", p, p + 1);
    p = skip_blanks(p + 1);
  }
  return fail("value-range", fmt::format("more than {} values", kMostCallValues), from, to);
}

bool Statements::value_of(std::string_view expression, Value& out, const Word& word) {
  std::size_t p = 0;
  return evaluator_.expression(expression, p, out) ||
         error(evaluator_.fault().code, evaluator_.fault().text, word);
}

bool Statements::condition(std::size_t& p, bool& out) {
  double value = 0;
  decided_ = true;
  p = skip_blanks(p);
  if (evaluator_.rules().spelling == Spelling::hash && at(p) != '[')
    return fail("bracket", "the condition stands in brackets here: [#1 EQ 2]", p, p + 1);
  if (!evaluator_.number_expression(block_.line, p, value)) return report(evaluator_.fault());
  out = value != 0;
  return true;
}

bool Statements::number(std::size_t& p, double& out, bool whole) {
  const std::size_t from = p;
  if (!evaluator_.number_operand(block_.line, p, out)) return report(evaluator_.fault());
  if (whole && std::abs(out - nearest_whole(out)) > kOffWhole)
    return fail("value-range", "a whole number is needed here", from, p);
  if (whole) out = nearest_whole(out);
  return std::abs(out) <= kLargest || fail("number-too-large", "too large", from, p);
}

void Statements::run() {
  if (!statement(block_.statement) && !reader_.finished()) reader_.stop();
}

bool Statements::saved_modes(int m, const Word& word) {
  return error("not-supported", fmt::format("M{} is not a word of this control", m), word);
}

bool Statements::call_modal(std::size_t, const Approach&, const Word& word) {
  return error("not-supported", "a modal call at a pattern of places is not supported", word);
}

bool Statements::call_sub(const std::string& name, CallRequest&&, const Word& word) {
  return error("subprogram-missing", "there is no subprogram " + name, word);
}

}  // namespace mrsim
