// What the author of a centre's words may have meant: another sign, or a place instead of an
// offset. Private to src/interp.
#pragma once

#include "interp/moves/point_arcs.h"

#include <string>

namespace mrsim {

class CenterHints : public ControlPart {
 public:
  explicit CenterHints(Control& control) : ControlPart(control) {}
  /// Warns of doubts about a full circle: it has no end point that could contradict its centre.
  void full_circle(const ArcBlock& arc, Vec2 center);
  /// Takes an arc whose ends agree with its centre as an offset.
  void learn(const ArcBlock& arc, Vec2 center);
  /// Says what would make radii agree that differ by `apart`, mm; empty: nothing simple.
  std::string for_radii(const ArcBlock& arc, Vec2 center, double apart) const;

 private:
  void sign(const ArcBlock& arc, Vec2 center);
  void absolute_center(const ArcBlock& arc, Vec2 center);
  static bool repeats_the_start(Vec2 start, Vec2 at);
  const char* absolute_mode() const;

  bool offsets_ = false;  ///< an arc has shown that centres are offsets
};

}  // namespace mrsim
