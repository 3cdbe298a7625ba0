// The value of an expression, and the faults of one. Plain values, no logic.
#pragma once

#include "interp/path/frames.h"

#include <cstddef>
#include <memory>
#include <string>

namespace mrsim {

struct Value {
  enum class Kind : unsigned char {
    number,
    text,
    frame,   ///< SINUMERIK
    vacant,  ///< FANUC: holds nothing, like #0
    faulty,  ///< it could not be computed, which was reported: readers fail silently
  };
  Kind kind = Kind::number;
  bool never_set = false;  ///< vacant, and no assignment ever gave it a value
  bool letter = false;     ///< the code of a CHAR; in texts it is the character
  double number = 0;
  std::string text;                    ///< of Kind::text
  std::shared_ptr<const Frame> frame;  ///< of Kind::frame

  static Value of(double number) {
    Value value;
    value.number = number;
    return value;
  }
  static Value of_text(std::string text) {
    Value value;
    value.kind = Kind::text;
    value.text = std::move(text);
    return value;
  }
  static Value of_frame(const Frame& frame) {
    Value value;
    value.kind = Kind::frame;
    value.frame = std::make_shared<const Frame>(frame);
    return value;
  }
  static Value nothing(bool never_set) {
    Value value;
    value.kind = Kind::vacant;
    value.never_set = never_set;
    return value;
  }
  bool is_number() const { return kind == Kind::number; }
};

/// The character of a CHAR, whose code is 0 to 255.
inline char letter_of(const Value& value) {
  return static_cast<char>(static_cast<unsigned char>(value.number));
}

/// Why an expression has no value, and where; an empty code: the cause was reported before.
struct Fault {
  const char* code = "";
  std::string text;
  std::size_t from = 0, to = 0;  ///< bytes of the line
};

}  // namespace mrsim
