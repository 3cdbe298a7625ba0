// SINUMERIK's patterns of holes HOLES1, HOLES2, CYCLE801 and CYCLE802: where the holes are. Private
// to src/interp.
#pragma once

#include "interp/control/control.h"
#include "interp/cycles/cycle_call.h"

#include <string_view>
#include <vector>

namespace mrsim {

/// An object lives for one call.
class HolePattern : public ControlPart {
 public:
  HolePattern(Control& control, const CycleCall& call, const Word& where)
      : ControlPart(control), call_(call), where_(where) {}

  /// Whether places() knows the cycle of this name.
  static bool knows(std::string_view name);
  /// Whether all its values are supported. False: some are not, which was reported.
  bool reads_all_of();
  /// The places in the plane in force, mm, in the order of drilling. False: an error was reported.
  bool places(std::vector<Vec2>& out);

 private:
  bool row(std::vector<Vec2>& list);
  bool circle(std::vector<Vec2>& list);
  bool grid(std::vector<Vec2>& list);
  bool points(std::vector<Vec2>& list);

  const CycleCall& call_;
  const Word& where_;
};

}  // namespace mrsim
