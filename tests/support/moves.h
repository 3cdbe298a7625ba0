// Moves as tests write them.
#pragma once

#include <mrsim/types.h>

namespace mrsim::test {

/// A line of line 1, cut by tool 0.
inline Motion line(Vec3 a, Vec3 b) {
  Motion m;
  m.kind = MotionKind::line;
  m.start = a;
  m.end = b;
  m.tool = 0;
  m.line = 1;
  return m;
}

}  // namespace mrsim::test
