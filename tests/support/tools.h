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

/// A turning tool named "2".
inline Tool insert(const char* shape, double nose, int tip = 0, double edge_length = 0) {
  Tool t;
  t.id.assign(1, '2');  // GCC 12 warns of overlap on = "2"
  t.type = ToolType::turning;
  t.insert.assign(shape);
  t.nose_radius = nose;
  t.tip = tip;
  t.edge_length = edge_length;
  return t;
}

}  // namespace mrsim::testing
