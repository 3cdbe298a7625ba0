// A call of a SINUMERIK cycle: its name, its values, its place, its levels. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_lists.h"
#include "interp/cycles/hole_maker.h"
#include "interp/language/value.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

inline constexpr double kPosted = 1e-3;  ///< mm: by so much posts round a size or a depth

/// A value counts as given only if the cycle's list has it and the program does not leave it out.
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

/// The levels at the beginning of a cycle's list: RTP RFP SDIS DP, and DPR where it has one.
/// Heights along the normal of the plane, mm.
struct CyclePlanes {
  double top = 0, reference = 0, safe = 0, bottom = 0;
  double up = 1;  ///< sign of the way out of the part
  bool cuts() const { return (reference - bottom) * up > 0; }
};

/// `mode` is the unit of AMODE: 0, DPR holds where it is not 0; 1, the depth counts from the
/// reference plane; 2, the depth is a level. `unit`: mm of a length of 1. Nothing: a value is
/// missing.
std::optional<CyclePlanes> cycle_planes(const CycleCall& call, int mode, double unit);

}  // namespace mrsim
