// Variables that DEF and its kin define: their elements, and the parts of frames and texts.
#include "core/text_io.h"
#include "interp/language/operations.h"
#include "interp/language/variables.h"
#include "interp/path/frame_parts.h"
#include "interp/text/characters.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostElements = 1'000'000;

}  // namespace

bool Variables::define(std::string_view name, VariableType type, std::array<int, 3> dimensions,
                       bool global, std::string& why) {
  Names& names = global ? globals_ : levels_.back()->names;
  std::size_t count = 1;
  for (const int size : dimensions) {
    if (size < 0 || static_cast<std::size_t>(size) > kMostElements) count = kMostElements + 1;
    if (size > 0 && count <= kMostElements) count *= static_cast<std::size_t>(size);
  }
  if (elements_ + count > kMostElements) {
    why = fmt::format("more than {} variables and elements of arrays", kMostElements);
    return false;
  }
  const auto [at, fresh] = names.try_emplace(key(name));
  if (!fresh && !global) {
    why = fmt::format("{} is defined twice (alarm 12170)", to_utf8(name.substr(0, 60)));
    return false;
  }
  elements_ += count - at->second.elements.size();
  at->second.type = type;
  at->second.dimensions = dimensions;
  const Value first = type == VariableType::frame ? Value::of_frame({})
                      : type == VariableType::text || type == VariableType::axis
                          ? Value::of_text({})
                          : Value::of(0);
  at->second.elements.assign(count, first);
  return true;
}

bool Variables::element(std::string_view name, const Array& variable,
                        std::span<const Value> indices, std::size_t& at, std::string& why) const {
  at = 0;
  std::size_t wanted = 0;
  for (const int size : variable.dimensions) wanted += size > 0 ? 1U : 0U;
  if (indices.size() != wanted) {
    why = fmt::format("{} has {} indices, and {} are given", to_utf8(name.substr(0, 60)), wanted,
                      indices.size());
    return false;
  }
  for (std::size_t i = 0; i < wanted; ++i) {
    const double index = indices[i].is_number() ? nearest_whole(indices[i].number) : -1;
    if (index < 0 || index >= variable.dimensions[i]) {
      why = fmt::format("index {} of {} is 0 to {} (alarm 17020)", i + 1,
                        to_utf8(name.substr(0, 60)), variable.dimensions[i] - 1);
      return false;
    }
    at = at * static_cast<std::size_t>(variable.dimensions[i]) + static_cast<std::size_t>(index);
  }
  return true;
}

bool Variables::store(Array& variable, std::size_t at, const Value& value, std::string& why) const {
  using Kind = Value::Kind;
  Value& out = variable.elements[at];
  if (value.kind == Kind::faulty) {
    out = value;
    return true;
  }
  const Kind wanted = variable.type == VariableType::frame ? Kind::frame
                      : variable.type == VariableType::text || variable.type == VariableType::axis
                          ? Kind::text
                          : Kind::number;
  const bool letter = variable.type == VariableType::character && value.kind == Kind::text &&
                      value.text.size() == 1;
  if (letter) {
    out = Value::of(static_cast<unsigned char>(value.text[0]));
    out.letter = true;
    return true;
  }
  if (value.kind != wanted) {
    why = fmt::format("the variable is a {}{}",
                      wanted == Kind::frame    ? "FRAME"
                      : wanted == Kind::number ? "number"
                                               : "text",
                      form_ == VariableForm::sinumerik ? " (alarm 12150)" : "");
    return false;
  }
  if (variable.type == VariableType::text && value.text.size() > variable.longest) {
    why = fmt::format("the text has {} characters, its variable is a STRING[{}]", value.text.size(),
                      variable.longest);
    return false;
  }
  if (variable.type == VariableType::character && !(value.number >= 0 && value.number < 255.5)) {
    why = "a CHAR is 0 to 255";
    return false;
  }
  out = value;
  if (variable.type == VariableType::integer || variable.type == VariableType::character)
    out.number = nearest_whole(value.number);
  out.letter = variable.type == VariableType::character;
  if (variable.type == VariableType::boolean) out.number = value.number != 0;
  return true;
}

// FR[X,TR]: the last two indices are an axis and a part of the frame.
bool Variables::names_part(const Array& variable, std::span<const Value> indices) {
  return variable.type == VariableType::frame && indices.size() >= 2 &&
         indices.back().kind == Value::Kind::text;
}

// VS[2], counted from 0, of a text that is no array: one of its characters.
bool Variables::names_character(const Array& variable, std::span<const Value> indices) {
  return variable.type == VariableType::text && variable.dimensions[0] == 0 &&
         indices.size() == 1 && indices[0].is_number();
}

bool Variables::read_element(std::string_view name, const Array& variable,
                             std::span<const Value> indices, Value& out, std::string& why) const {
  std::size_t at = 0;
  const bool part = names_part(variable, indices), letter = names_character(variable, indices);
  const auto whole = part ? indices.first(indices.size() - 2) : letter ? indices.first(0) : indices;
  if (!element(name, variable, whole, at, why)) return false;
  out = variable.elements[at];
  if (out.kind == Value::Kind::faulty || !(part || letter)) return true;
  if (letter) {
    const double place = nearest_whole(indices[0].number);
    if (!(place >= 0 && place < static_cast<double>(out.text.size()))) {
      why = fmt::format("{} has {} characters, counted from 0", to_utf8(name.substr(0, 60)),
                        out.text.size());
      return false;
    }
    out = Value::of_text(out.text.substr(static_cast<std::size_t>(place), 1));
    return true;
  }
  const auto value =
      frame_part(*out.frame, axis_named(indices[indices.size() - 2].text), indices.back().text);
  if (value) out = Value::of(*value);
  if (!value) why = fmt::format("{} has no such part here", to_utf8(name.substr(0, 60)));
  return value.has_value();
}

// Of a text that has one there.
bool Variables::write_character(Array& variable, const Value& index, const Value& value,
                                std::string& why) {
  Value& out = variable.elements[0];
  if (out.kind == Value::Kind::faulty || value.kind == Value::Kind::faulty) {
    out.kind = Value::Kind::faulty;
    return true;
  }
  const double place = nearest_whole(index.number);
  const bool one = value.letter || value.text.size() == 1;
  if (!one || !(place >= 0 && place < static_cast<double>(out.text.size()))) {
    why = "one character is set in the place of one that is there";
    return false;
  }
  out.text[static_cast<std::size_t>(place)] = value.letter ? letter_of(value) : value.text[0];
  return true;
}

bool Variables::write_element(std::string_view name, Array& variable,
                              std::span<const Value> indices, const Value& value,
                              std::string& why) const {
  std::size_t at = 0;
  if (names_character(variable, indices)) return write_character(variable, indices[0], value, why);
  if (!names_part(variable, indices))
    return element(name, variable, indices, at, why) && store(variable, at, value, why);
  const int axis = axis_named(indices[indices.size() - 2].text);
  if (!element(name, variable, indices.first(indices.size() - 2), at, why)) return false;
  Value& out = variable.elements[at];
  if (out.kind == Value::Kind::faulty) return true;
  if (value.kind == Value::Kind::faulty) {
    out = value;
    return true;
  }
  Frame frame = *out.frame;
  if (!value.is_number() || !set_frame_part(frame, axis, indices.back().text, value.number)) {
    why = fmt::format("this part of {} cannot be set here", to_utf8(name.substr(0, 60)));
    return false;
  }
  out = Value::of_frame(frame);
  return true;
}

const Variables::Array* Variables::array(std::string_view name) {
  const Array* const found = find(name);
  return found && found->dimensions[0] > 0 ? found : nullptr;
}

void Variables::set_array(std::string_view name, const Array& values) {
  if (Array* const found = find(name)) {
    elements_ += values.elements.size() - found->elements.size();
    *found = values;
  }
}

bool Variables::fill(std::string_view name, std::span<const Value> indices,
                     std::span<const std::optional<Value>> values, std::size_t repeats,
                     std::string& why) {
  Array* const variable = find(name);
  std::size_t at = 0;
  if (!variable) {
    why = fmt::format("{} is not defined (alarm 12550)", to_utf8(name.substr(0, 60)));
    return false;
  }
  if (!indices.empty() && !element(name, *variable, indices, at, why)) return false;
  const std::size_t left = variable->elements.size() - at;
  const std::size_t count = repeats > 0 ? std::min(repeats, left) : values.size();
  if (count > left) {
    why = fmt::format("{} values for {} elements", count, left);
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Value>& value = values[repeats > 0 ? 0 : i];
    if (value && !store(*variable, at + i, *value, why)) return false;
  }
  return true;
}

}  // namespace mrsim
