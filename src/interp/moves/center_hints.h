// What the words of a centre may have meant: another sign, or a place instead of an offset.
// Private to src/interp.
#pragma once

#include "interp/moves/point_arcs.h"

#include <string>

namespace mrsim {

class CenterHints : public ControlPart {
 public:
  explicit CenterHints(Control& control) : ControlPart(control) {}
  /// Doubts about a full circle, which has no end point to contradict its centre.
  void full_circle(const ArcBlock& arc, Vec2 center);
  /// What would make radii agree that differ by `apart`; empty: nothing simple.
  std::string for_radii(const ArcBlock& arc, Vec2 center, double apart) const;

 private:
  void sign(const ArcBlock& arc, Vec2 center);
  void absolute_center(const ArcBlock& arc, Vec2 center);
  static bool repeats_the_start(Vec2 start, Vec2 at);
  const char* absolute_mode() const;
};

}  // namespace mrsim
