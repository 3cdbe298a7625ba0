// A variable that DEF and its kin define, with its elements, and parts of frames and texts. Private
// to src/interp.
#pragma once

#include "interp/language/value.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// How a control's variables are named and how long they live.
enum class VariableForm : unsigned char {
  linuxcnc,   ///< #1-#30 by call, #31-#5000, #<local>, #<_global>
  fanuc,      ///< #1-#33 by level, #100-#199, #400-#999, #98000-#98499, #900000-#907399
  sinumerik,  ///< R parameters, DEF by program, GUD
  fagor,      ///< P0-P25 by level, P100-P299, P1000-P1255, P2000-P2255
  codesys,    ///< #NAME by subprogram, $NAME$
};

/// Types of SINUMERIK's DEF.
enum class VariableType : unsigned char { real, integer, boolean, character, text, axis, frame };

/// A defined variable. A dimension that it does not have is 0. Where a function returns false,
/// `why` says what is wrong.
struct VariableArray {
  VariableType type = VariableType::real;
  std::array<int, 3> dimensions{};
  std::vector<Value> elements;
  std::size_t longest = std::string::npos;  ///< most characters of a text, STRING[20]

  /// Finds the element that the indices name. `name` is that of the variable, for `why`.
  bool place_of(std::string_view name, std::span<const Value> indices, std::size_t& at,
                std::string& why) const;
  /// Sets an element to the value, converted to the variable's type.
  bool store(std::size_t at, const Value& value, VariableForm form, std::string& why);
  /// Reads an element, a part of a frame (FR[X,TR]) or a character of a text (VS[2]).
  bool read(std::string_view name, std::span<const Value> indices, Value& out,
            std::string& why) const;
  bool write(std::string_view name, std::span<const Value> indices, const Value& value,
             VariableForm form, std::string& why);

 private:
  bool names_part(std::span<const Value> indices) const;
  bool names_character(std::span<const Value> indices) const;
  bool write_character(const Value& index, const Value& value, std::string& why);
};

}  // namespace mrsim
