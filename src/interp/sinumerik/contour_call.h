// A call of a SINUMERIK cycle whose contours have been read. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include <mrsim/types.h>

#include <vector>

namespace mrsim {

struct ContourCall {
  const CycleCall& values;
  const Word& where;
  /// The motions of each contour in the order of CYCLE62; the first motion of a contour leads to
  /// its start. None is empty.
  const std::vector<std::vector<Motion>>& contours;
};

}  // namespace mrsim
