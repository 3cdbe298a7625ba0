// Tools as tests write them: named "1", lengths in mm.
#pragma once

#include <mrsim/types.h>

#include <utility>

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

/// Eight teeth of a pitch of 1.5 mm between two radii.
inline Tool thread_mill(double root, double crest) {
  Tool t = mill(ToolType::form, 0);
  t.profile = {{0, 0, 0}, {root, 0, 0}};
  for (double z = 0; z < 11; z += 1.5)
    for (const auto& [r, up] : {std::pair(root, 0.1), {crest, 0.65}, {crest, 0.85}, {root, 1.4}})
      t.profile.push_back({r, z + up, 0});
  t.profile.push_back({root, 18, 0});
  return t;
}

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
