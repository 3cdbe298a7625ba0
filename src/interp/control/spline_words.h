// LinuxCNC's splines in the plane: G5 (cubic) and G5.1 (quadratic), as arcs within a micrometre.
// Private to src/interp.
#pragma once

#include "interp/control/point_arcs.h"

namespace mrsim {

class SplineWords : public ControlPart {
 public:
  SplineWords(Control& control, AxisWords& axes) : ControlPart(control), axes_(axes) {}
  /// The lines and arcs of the block's spline. False: an error was reported.
  bool solve(const Vec3& from, std::vector<SolvedArc>& out);

 private:
  bool offset(char first, char second, const Word& where, Vec2& out);

  AxisWords& axes_;
};

}  // namespace mrsim
