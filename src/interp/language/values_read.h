// The first variables that an expression has read, and their values: a fault names them.
#pragma once

#include "interp/language/value.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace mrsim {

class ValuesRead {
 public:
  void clear() { count_ = 0; }
  /// The variable that stands at `from` to `to` of the line. Texts and frames are not named, nor is
  /// a variable that was never set.
  void add(std::size_t from, std::size_t to, const Value& value) {
    if (count_ == first_.size() || value.never_set || value.kind == Value::Kind::text ||
        value.kind == Value::Kind::frame)
      return;
    first_[count_++] = {from, to, value.number, value.is_number()};
  }
  /// " (#1 = 2, #3 is vacant)"; empty where there are none.
  std::string text(std::string_view line) const;

 private:
  struct One {
    std::size_t from, to;
    double number;
    bool plain;  ///< a number; else vacant
  };
  std::array<One, 6> first_{};
  std::size_t count_ = 0;
};

}  // namespace mrsim
