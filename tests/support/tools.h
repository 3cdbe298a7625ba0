// Tools as tests write them: named "1", lengths in mm.
#pragma once

#include <mrsim/types.h>

namespace mrsim::testing {

/// Any mill; 0 = not given.
inline Tool mill(ToolType type, double d, double corner = 0, double flute = 0) {
  Tool t;
  t.id = "1";
  t.type = type;
  t.diameter = d;
  t.corner_radius = corner;
  t.flute_length = flute;
  return t;
}

inline Tool endmill(double d, double corner = 0, double flute = 0) {
  return mill(ToolType::endmill, d, corner, flute);
}

inline Tool ballmill(double d, double flute = 0) { return mill(ToolType::ballmill, d, 0, flute); }

}  // namespace mrsim::testing
