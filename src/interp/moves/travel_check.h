// Whether the machine reaches the places that a program leads it to: travel limits in machine
// coordinates. Checked is the tool's point on finished motions, compensation applied; heights are
// those of its tip, without its length. Not checked: motions in work offsets whose place on the
// machine is unknown, and X of tools that a lathe has beyond its axis. Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <array>

namespace mrsim {

class TravelCheck : public ControlPart {
 public:
  explicit TravelCheck(Control& control) : ControlPart(control) {}

  /// The axes, a bit each, in which the motion of this block leads to a place that can be checked.
  unsigned axes(const Motion& motion);
  /// Notes where `motion`, in the stock's coordinates, leaves the limits of these axes.
  void check(const Motion& motion, unsigned axes);
  /// Reports what was found, and what could not be checked.
  void finish();

 private:
  struct Excess {
    std::size_t motions = 0;
    double most = 0;  ///< mm
    Motion first, worst;
  };
  bool knows_offset() const;

  unsigned known_ = 0;         ///< axes whose position was known before
  std::size_t unchecked_ = 0;  ///< motions in a work offset whose place is not known
  std::array<std::array<Excess, 2>, 3> found_;  ///< by axis: below and above
};

}  // namespace mrsim
