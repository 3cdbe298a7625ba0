#include "interp/language/variable_array.h"

#include "core/text/text_io.h"
#include "interp/language/operations.h"
#include "interp/path/frame_parts.h"
#include "interp/text/characters.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {

bool VariableArray::place_of(std::string_view name, std::span<const Value> indices, std::size_t& at,
                             std::string& why) const {
  at = 0;
  std::size_t wanted = 0;
  for (const int size : dimensions) wanted += size > 0 ? 1U : 0U;
  if (indices.size() != wanted) {
    why = fmt::format("{} has {} indices, and {} are given", to_utf8(name.substr(0, 60)), wanted,
                      indices.size());
    return false;
  }
  for (std::size_t i = 0; i < wanted; ++i) {
    const double index = indices[i].is_number() ? nearest_whole(indices[i].number) : -1;
    if (index < 0 || index >= dimensions[i]) {
      why = fmt::format("index {} of {} is 0 to {} (alarm 17020)", i + 1,
                        to_utf8(name.substr(0, 60)), dimensions[i] - 1);
      return false;
    }
    at = at * static_cast<std::size_t>(dimensions[i]) + static_cast<std::size_t>(index);
  }
  return true;
}

bool VariableArray::store(std::size_t at, const Value& value, VariableForm form, std::string& why) {
  using Kind = Value::Kind;
  Value& out = elements[at];
  if (value.kind == Kind::faulty) {
    out = value;
    return true;
  }
  const Kind wanted = type == VariableType::frame                                ? Kind::frame
                      : type == VariableType::text || type == VariableType::axis ? Kind::text
                                                                                 : Kind::number;
  const bool letter =
      type == VariableType::character && value.kind == Kind::text && value.text.size() == 1;
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
                      form == VariableForm::sinumerik ? " (alarm 12150)" : "");
    return false;
  }
  if (type == VariableType::text && value.text.size() > longest) {
    why = fmt::format("the text has {} characters, its variable is a STRING[{}]", value.text.size(),
                      longest);
    return false;
  }
  if (type == VariableType::character && !(value.number >= 0 && value.number < 255.5)) {
    why = "a CHAR is 0 to 255";
    return false;
  }
  out = value;
  if (type == VariableType::integer || type == VariableType::character)
    out.number = nearest_whole(value.number);
  out.letter = type == VariableType::character;
  if (type == VariableType::boolean) out.number = value.number != 0;
  return true;
}

// Whether the last two indices name an axis and a part of a frame, as in FR[X,TR].
bool VariableArray::names_part(std::span<const Value> indices) const {
  return type == VariableType::frame && indices.size() >= 2 &&
         indices.back().kind == Value::Kind::text;
}

// Whether the index names a character, counted from 0, of a text that is no array: VS[2].
bool VariableArray::names_character(std::span<const Value> indices) const {
  return type == VariableType::text && dimensions[0] == 0 && indices.size() == 1 &&
         indices[0].is_number();
}

bool VariableArray::read(std::string_view name, std::span<const Value> indices, Value& out,
                         std::string& why) const {
  std::size_t at = 0;
  const bool part = names_part(indices), letter = names_character(indices);
  const auto whole = part ? indices.first(indices.size() - 2) : letter ? indices.first(0) : indices;
  if (!place_of(name, whole, at, why)) return false;
  out = elements[at];
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

// Changes a character that the text has.
bool VariableArray::write_character(const Value& index, const Value& value, std::string& why) {
  Value& out = elements[0];
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

bool VariableArray::write(std::string_view name, std::span<const Value> indices, const Value& value,
                          VariableForm form, std::string& why) {
  std::size_t at = 0;
  if (names_character(indices)) return write_character(indices[0], value, why);
  if (!names_part(indices)) return place_of(name, indices, at, why) && store(at, value, form, why);
  const int axis = axis_named(indices[indices.size() - 2].text);
  if (!place_of(name, indices.first(indices.size() - 2), at, why)) return false;
  Value& out = elements[at];
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

}  // namespace mrsim
