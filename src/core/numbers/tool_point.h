// The angle of a pointed mill: the interpreter's cycles, its shape and what runs print agree on it.
#pragma once

#include "core/numbers/units.h"
#include <mrsim/types.h>

namespace mrsim {

/// Half the angle of the point of a drill (118 degrees where it is not given) or of a chamfer mill
/// (90), radians.
inline double point_half_angle(const Tool& tool) {
  if (tool.tip_angle > 0) return tool.tip_angle / 2;
  if (tool.type == ToolType::drill) return radians(59);
  return tool.taper_angle > 0 ? tool.taper_angle : kPi / 4;
}

}  // namespace mrsim
