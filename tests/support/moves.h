// Moves as tests write them.
#pragma once

#include <mrsim/types.h>

namespace mrsim::testing {

/// A straight cut by tool 0, made by line `number` of the program.
inline Motion line(Vec3 a, Vec3 b, int number = 1) {
  Motion m;
  m.kind = MotionKind::line;
  m.start = a;
  m.end = b;
  m.tool = 0;
  m.line = number;
  return m;
}

}  // namespace mrsim::testing
