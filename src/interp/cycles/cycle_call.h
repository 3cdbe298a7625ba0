// A call of a SINUMERIK cycle: its name, its values, its place. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_lists.h"
#include "interp/cycles/hole_maker.h"
#include "interp/language/value.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

/// Its values. One that the list of the cycle does not have, or that the program leaves out, is not
/// given.
struct CycleCall {
  std::string name;
  std::string written;  ///< how the program writes the cycle, if not by its name: G87 of Fagor
  std::vector<std::optional<Value>> values;
  BlockPlace place;

  /// Whether the list of the cycle has this value.
  bool lists(ValueName value) const {
    return place_in_list(list_of_cycle(name), value.text()).has_value();
  }
  /// Whether the program gives a number for it.
  bool given(ValueName value) const;
  bool given(std::initializer_list<ValueName> all) const;
  double get(ValueName value, double otherwise = 0) const;
  /// The text of the value; empty where it is no text.
  std::string text(ValueName value) const;
  /// Digit `n` (0 = units) of a value, as the modes of cycles are written.
  int digit(ValueName value, int n) const;
  void set(ValueName value, double number);
  const std::string& shown() const { return written.empty() ? name : written; }

 private:
  const Value* find(ValueName value) const;
};

}  // namespace mrsim
