// A call of a SINUMERIK cycle: its name, its values, its place. Private to src/interp.
#pragma once

#include "interp/cycles/hole_maker.h"
#include "interp/language/value.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

struct CycleCall {
  std::string name;
  std::string written;  ///< where the program writes it otherwise: G87 of Fagor
  std::vector<std::optional<Value>> values;
  BlockPlace place;

  bool given(std::size_t i) const {
    return i < values.size() && values[i] && values[i]->kind == Value::Kind::number;
  }
  double get(std::size_t i, double otherwise = 0) const {
    return given(i) ? values[i]->number : otherwise;
  }
  const std::string& shown() const { return written.empty() ? name : written; }
  /// Empty where it is no text.
  std::string text(std::size_t i) const {
    return i < values.size() && values[i] ? values[i]->text : std::string();
  }
  /// Digit `n` (0 = units) of value i, as the modes of cycles are written.
  int digit(std::size_t i, int n) const {
    double v = std::floor(std::abs(get(i)));
    for (; n > 0; --n) v = std::floor(v / 10);
    return static_cast<int>(std::fmod(v, 10));
  }
};

}  // namespace mrsim
