#include "interp/language/operands.h"

#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "interp/language/operations.h"
#include "interp/path/frame_parts.h"
#include "interp/text/characters.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLargestOfFrame = 1e9;
constexpr std::size_t kMostIndices = 3;

}  // namespace

bool Operands::answered(std::size_t from, const Value& value) {
  if (value.kind == Value::Kind::faulty) return fail("", {}, from, p_);
  read_.add(from, p_, value);
  return true;
}

bool Operands::number_of_vacant(Value& value, std::size_t from) {
  if (value.kind == Value::Kind::faulty) return fail("", {}, from, p_);
  if (value.kind != Value::Kind::vacant) return true;
  if (value.never_set) return fail("variable-unset", value.text, from, p_);
  if (!rules_.vacant_is_zero) return fail("variable-unset", "the variable holds nothing", from, p_);
  value = Value::of(0);
  return true;
}

bool Operands::unary(Value& out) {
  skip_blanks();
  const char c = at(p_);
  if (is_digit(c) || c == '.') return number(out);
  if (c == '#' && spelled(Spelling::hash)) return hash_variable(out);
  if ((c == '#' || c == '$') && spelled(Spelling::plc)) return plc_variable(out);
  if (upper(c) == 'P' && is_digit(at(p_ + 1)) && spelled(Spelling::parameter))
    return parameter_variable(out);
  if (c == rules_.open) return bracketed(out);
  if (c == '-' || c == '+') {
    const std::size_t from = p_++;
    if (++depth_ > kDeepest) return fail("expression-deep", "too many signs", from, p_);
    if (!unary(out)) return false;
    --depth_;
    if (!usable(out, from)) return false;
    if (!out.is_number()) return fail("expression", "a sign needs a number", from, p_);
    if (c == '-') out.number = -out.number;
    out.letter = false;
    return true;
  }
  if (is_letter(c)) return word(out);
  if ((c == '_' || c == '$' || c == '"') && spelled(Spelling::names))
    return c == '"' ? text(out) : word(out);
  if (c == '\'' && spelled(Spelling::names)) return radix(out);
  if (c == '\'' && spelled(Spelling::plc)) return text(out);
  if (p_ >= line_.size()) return fail("expression", "the expression ends too early", p_, p_ + 1);
  return fail("expression", fmt::format("a number, a variable or {} is expected here", rules_.open),
              p_, p_ + 1);
}

bool Operands::bracketed(Value& out) {
  const std::size_t from = p_++;
  if (++depth_ > kDeepest)
    return fail("expression-deep",
                fmt::format("more than {} brackets inside one another", kDeepest), from, p_);
  if (!expression_within(out)) return false;
  --depth_;
  skip_blanks();
  if (at(p_) == '=' && rules_.spelling == Spelling::hash)
    return fail("expression", "a comparison is written EQ here: [#1 EQ 2]", p_, p_ + 1);
  return close(from);
}

// Reads the bracket that closes the one at `from`.
bool Operands::close(std::size_t from) {
  if (at(p_) != rules_.close)
    return fail("bracket",
                fmt::format("the {} here is not closed with {}", rules_.open, rules_.close), from,
                from + 1);
  ++p_;
  return true;
}

// A variable: "#", then a number, a name in < >, or any operand that gives the number.
bool Operands::hash_variable(Value& out) {
  const std::size_t from = p_++;
  skip_blanks();
  std::string why;
  if (at(p_) == '<' && rules_.named_hash) {
    std::string name;
    if (!bracketed_name(line_, p_, name)) return false;
    if (!variables_.named(name, {}, out, why))
      return fail("variable-unset", std::move(why), from, p_);
  } else {
    if (++depth_ > kDeepest) return fail("expression-deep", "too many # in a row", from, p_);
    Value index;
    const std::size_t inner = p_;
    if (!unary(index) || !usable(index, inner)) return false;
    --depth_;
    if (!index.is_number() || std::abs(index.number - nearest_whole(index.number)) > kNearWhole)
      return fail("variable-number", kNotWhole, from, p_);
    if (!variables_.numbered(nearest_whole(index.number), out, why))
      return fail("variable-number", std::move(why), from, p_);
  }
  return answered(from, out);
}

const FunctionRow* Operands::function_named(std::string_view name) const {
  for (const FunctionRow& row : rules_.functions)
    if (row.name == name) return &row;
  if (!rules_.abbreviated || name.size() < 2) return nullptr;
  for (const FunctionRow& row : rules_.functions)
    if (row.name.starts_with(name)) return &row;
  return nullptr;
}

bool Operands::word(Value& out) {
  const std::size_t from = p_;
  if (at(p_) == '$') ++p_;
  const bool whole = spelled(Spelling::names) || spelled(Spelling::plc);
  while (whole ? is_name(at(p_)) : is_letter(at(p_))) ++p_;
  const std::string name = upper_case(line_.substr(from, std::min<std::size_t>(p_ - from, 64)));
  const bool bits = name == "B_NOT" && spelled(Spelling::names);
  if (bits || (name == "NOT" && !spelled(Spelling::hash))) return negation(from, bits, out);
  const std::size_t end = p_;
  skip_blanks();
  const FunctionRow* const row = function_named(name);
  const bool system =
      rules_.plain_names && name.starts_with('V');  // a system variable of Okuma, VTOFH[1]
  if (at(p_) == rules_.open && !system) {
    if (row) return call(*row, from, out);
    return fail("function-unknown", fmt::format("{} is no function of this control", name), from,
                end);
  }
  if (row && rules_.bare_functions) return bare_call(*row, from, out);
  if (spelled(Spelling::plc) && (name == "PI" || name == "TRUE" || name == "FALSE")) {
    p_ = end;
    out = Value::of(name == "PI" ? kPi : name == "TRUE");
    return true;
  }
  if (rules_.plain_names) return plain_variable(from, out);
  if (row)
    return fail("expression",
                fmt::format("{0} needs its value in brackets: {0}{1}...{2}", row->name, rules_.open,
                            rules_.close),
                from, end);
  if (!spelled(Spelling::names))
    return fail("expression", fmt::format("{} is not known in an expression", name), from, end);
  p_ = end;
  return name_variable(from, line_.substr(from, end - from), out);
}

// NOT and B_NOT. Fagor's NOT is for bits and for conditions; for other numbers than 0 and 1 it is
// refused, because the two differ.
bool Operands::negation(std::size_t from, bool bits, Value& out) {
  if (++depth_ > kDeepest) return fail("expression-deep", "too many NOT in a row", from, p_);
  if (!unary(out) || !usable(out, from)) return false;
  --depth_;
  if (!out.is_number()) return fail("expression", "NOT needs a number", from, p_);
  if (spelled(Spelling::parameter) && out.number != 0 && out.number != 1)
    return fail("expression", "NOT is read only of conditions, which are 0 or 1", from, p_);
  out = Value::of(bits ? -nearest_whole(out.number) - 1 : (out.number == 0 ? 1.0 : 0.0));
  return true;
}

// A function of one operand without brackets: SIN 30, ABS -8.
bool Operands::bare_call(const FunctionRow& row, std::size_t from, Value& out) {
  if (row.least > 1)
    return fail("function-arguments",
                fmt::format("{} needs {} arguments in brackets", row.name, row.least), from, p_);
  if (++depth_ > kDeepest) return fail("expression-deep", "too many functions", from, p_);
  std::array<Value, 1> argument;
  if (!unary(argument[0]) || !usable(argument[0], from)) return false;
  --depth_;
  std::string why;
  if (!apply_function(rules_, row.function, argument, round_step_, out, why))
    return fail("expression", std::move(why), from, p_);
  return true;
}

// Variables of CODESYS: $NAME$ of the controller, #NAME of the program.
bool Operands::plc_variable(Value& out) {
  const std::size_t from = p_++;
  const bool global = line_[from] == '$';
  while (is_name(at(p_)) || (global && (at(p_) == '.' || at(p_) == '[' || at(p_) == ']'))) ++p_;
  if (p_ == from + 1) return fail("expression", "a name is expected here", from, p_ + 1);
  if (global && at(p_) != '$')
    return fail("expression", "the name that starts here is not closed with $", from, p_);
  if (global) ++p_;
  std::string why;
  if (!variables_.named(line_.substr(from, p_ - from), {}, out, why))
    return fail("variable-unset", std::move(why), from, p_);
  return answered(from, out);
}

// A parameter of Fagor: P12.
bool Operands::parameter_variable(Value& out) {
  const std::size_t from = p_++;
  const std::size_t digits = p_;
  while (is_digit(at(p_))) ++p_;
  std::string why;
  const double number = parse_number(line_.substr(digits, p_ - digits)).value_or(-1);
  if (!variables_.numbered(number, out, why))
    return fail("variable-number", std::move(why), from, p_);
  return answered(from, out);
}

// Names of SINUMERIK: R1, R[2], a name with up to three indices, TRUE, FALSE.
bool Operands::name_variable(std::size_t from, std::string_view name, Value& out) {
  std::array<Value, kMostIndices> indices;
  std::size_t count = 0;
  const std::string upper_name = upper_case(name);
  if (upper_name == "TRUE" || upper_name == "FALSE") {
    out = Value::of(upper_name == "TRUE");
    return true;
  }
  if (at(p_) == '[') {
    if (++depth_ > kDeepest) return fail("expression-deep", "too many brackets", from, p_);
    do {
      ++p_;
      if (count == kMostIndices) return fail("expression", "too many indices", from, p_);
      if (!expression_within(indices[count]) || !usable(indices[count], from)) return false;
      ++count;
      skip_blanks();
    } while (at(p_) == ',');
    if (at(p_) != ']') return fail("bracket", "the [ here is not closed with ]", from, p_);
    ++p_;
    --depth_;
  }
  std::string why;
  const bool r_number =
      upper_name[0] == 'R' && upper_name.find_first_not_of("0123456789", 1) == std::string::npos;
  if (r_number && (upper_name.size() > 1) != (count == 1)) {
    const double number =
        count == 1 ? indices[0].number : parse_number(upper_name.substr(1)).value_or(-1);
    if ((count == 1 && !indices[0].is_number()) || number != std::floor(number))
      return fail("variable-number", "the number of an R parameter is a whole number", from, p_);
    if (!variables_.numbered(number, out, why))
      return fail("variable-unset", std::move(why), from, p_);
  } else if (!variables_.named(name, {indices.data(), count}, out, why)) {
    return fail("variable-unset", std::move(why), from, p_);
  }
  return answered(from, out);
}

// The values between the brackets of a function; `p_` is at the opening one.
bool Operands::arguments(std::vector<Value>& values, std::size_t most) {
  const std::size_t from = p_;
  if (++depth_ > kDeepest) return fail("expression-deep", "too many brackets", from, p_);
  do {
    ++p_;
    Value value;
    const std::size_t begin = p_;
    if (!expression_within(value) || !usable(value, begin)) return false;
    values.push_back(std::move(value));
    skip_blanks();
  } while (at(p_) == ',' && values.size() < most);
  if (!close(from)) return false;
  --depth_;
  return true;
}

bool Operands::call(const FunctionRow& row, std::size_t from, Value& out) {
  if (row.function == Function::exists && spelled(Spelling::hash)) return exists_call(from, out);
  if (row.function >= Function::frame_trans && row.function <= Function::frame_mirror)
    return frame_call(row, from, out);
  std::vector<Value> values;
  if (!arguments(values, static_cast<std::size_t>(row.most))) return false;
  skip_blanks();
  if (row.function == Function::arc_tangent && spelled(Spelling::hash) && at(p_) == '/') {
    std::size_t behind = p_ + 1;
    while (at(behind) == ' ' || at(behind) == '\t') ++behind;
    if (at(behind) == rules_.open) {  // ATAN[y]/[x]
      p_ = behind;
      if (!arguments(values, 1)) return false;
    }
  }
  const bool bare = row.function == Function::arc_tangent && rules_.named_hash;
  if (values.size() < static_cast<std::size_t>(row.least) || (bare && values.size() != 2))
    return fail("function-arguments",
                bare ? std::string("ATAN is written ATAN[y]/[x]")
                     : fmt::format("{} needs {} arguments", row.name, row.least),
                from, p_);
  std::string why;
  if (row.function == Function::exists) return is_variable(values.front(), from, out);
  if (!apply_function(rules_, row.function, values, round_step_, out, why))
    return fail("expression", std::move(why), from, p_);
  return !out.is_number() || std::abs(out.number) <= kLargestValue ||
         fail("number-too-large", "the result is too large", from, p_);
}

// EXISTS[#<name>] and EXISTS[#1] ask for a variable without reading it.
bool Operands::exists_call(std::size_t from, Value& out) {
  ++p_;
  skip_blanks();
  if (at(p_) != '#')
    return fail("expression", "EXISTS asks for a variable: # expected", p_, p_ + 1);
  ++p_;
  skip_blanks();
  if (at(p_) == '<') {
    std::string name;
    if (!bracketed_name(line_, p_, name)) return false;
    out = Value::of(variables_.exists(name));
  } else {
    Value index;
    if (!unary(index) || !usable(index, from)) return false;
    out = Value::of(index.is_number() && variables_.exists(nearest_whole(index.number)));
  }
  skip_blanks();
  if (at(p_) != rules_.close)
    return fail("bracket", "EXISTS asks for one variable: ] expected", p_, p_ + 1);
  ++p_;
  return true;
}

// ISVAR("NAME"), ISVAR("NAME[]"). Variables that the machine's maker has defined are not known.
bool Operands::is_variable(const Value& name, std::size_t from, Value& out) {
  const std::string key = upper_case(name.text.substr(0, name.text.find('[')));
  if (key.empty() || key[0] == '$')
    return fail("expression", "ISVAR is answered for variables of the program", from, p_);
  const bool numbered = key[0] == 'R' && key.find_first_not_of("0123456789", 1) == key.npos;
  out = Value::of(numbered || variables_.exists(key));
  return true;
}

// CTRANS(X, 10, Y, 5), CROT(Z, 30), CMIRROR(X): each axis is followed by its value, if it has one.
bool Operands::frame_call(const FunctionRow& row, std::size_t from, Value& out) {
  FrameParts parts;
  const bool mirror = row.function == Function::frame_mirror;
  const std::size_t first = line_.find_first_not_of(" \t", p_ + 1);
  if (first != line_.npos && line_[first] == ')') {  // CTRANS(): no shift
    p_ = first + 1;
    out = Value::of_frame({});
    return true;
  }
  do {
    ++p_;
    skip_blanks();
    const char axis = upper(at(p_));
    if (axis < 'X' || axis > 'Z' || is_name(at(p_ + 1)))
      return fail("frame-axis", "the axis X, Y or Z is expected here", p_, p_ + 1);
    ++p_;
    skip_blanks();
    Value value = Value::of(-1);
    if (!mirror) {
      if (at(p_) != ',') return fail("expression", "a comma is expected here", p_, p_ + 1);
      ++p_;
      const std::size_t begin = p_;
      if (!expression_within(value) || !usable(value, begin)) return false;
      if (!value.is_number()) return fail("expression", "a number is needed here", begin, p_);
      if (std::abs(value.number) > kLargestOfFrame)
        return fail("number-too-large", "too large for a frame", begin, p_);
    }
    const int i = axis - 'X';
    Vec3& values = row.function == Function::frame_trans ? parts.shift
                   : row.function == Function::frame_rot ? parts.turns
                                                         : parts.scale;
    component(values, i) = value.number;
    skip_blanks();
  } while (at(p_) == ',');
  if (at(p_) != ')') return fail("bracket", "the ( here is not closed with )", from, p_);
  ++p_;
  if (parts.scale.x == 0 || parts.scale.y == 0 || parts.scale.z == 0)
    return fail("expression", "a scale of 0 leaves nothing", from, p_);
  out = Value::of_frame(frame_of(parts));
  return true;
}

// VC1 and V1 of Okuma, which end with their digits, and local names.
bool Operands::plain_variable(std::size_t from, Value& out) {
  p_ = from;
  while (is_letter(at(p_))) ++p_;
  const std::string letters = upper_case(line_.substr(from, std::min<std::size_t>(p_ - from, 3)));
  const bool common = letters == "V" || letters == "VC";
  while (is_digit(at(p_)) || (!common && is_letter(at(p_)))) ++p_;
  const std::string_view name = line_.substr(from, p_ - from);
  if (at(p_) == '[')
    return fail("variable-unset", fmt::format("the system variable {} is not answered here", name),
                from, p_);
  std::string why;
  if (!variables_.named(name, {}, out, why))
    return fail("variable-unset", std::move(why), from, p_);
  return answered(from, out);
}

}  // namespace mrsim
