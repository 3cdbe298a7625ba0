// Checks travel limits: whether the machine reaches the places that a program leads it to, in
// machine coordinates. It checks the tool's point on finished motions, with compensation; heights
// are those of the tip, without the tool's length. It does not check motions in work offsets whose
// place on the machine is unknown, nor X of tools that a lathe has beyond its axis. Private to
// src/interp.
#pragma once

#include "interp/control/control.h"

#include <array>

namespace mrsim {

class TravelCheck : public ControlPart {
 public:
  explicit TravelCheck(Control& control) : ControlPart(control) {}

  /// The axes, a bit each, in which the motion of this block leads to a place that can be checked.
  AxisSet axes(const Motion& motion);
  /// Notes where `motion`, in the stock's coordinates, leaves the limits of these axes.
  void check(const Motion& motion, AxisSet axes);
  /// Reports what was found, and what could not be checked.
  void finish();

 private:
  struct Excess {
    std::size_t motions = 0;
    double most = 0;  ///< mm
    Motion first, worst;
  };
  bool knows_offset() const;

  AxisSet known_;              ///< axes whose position was known before this block
  std::size_t unchecked_ = 0;  ///< motions in a work offset whose place is not known
  std::array<std::array<Excess, 2>, 3> found_;  ///< by axis: below and above
};

}  // namespace mrsim
