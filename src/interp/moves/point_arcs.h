// Arcs without centre or radius: CIP through a point in space, CT tangent to the element before.
// Private to src/interp.
#pragma once

#include "interp/frames/axis_words.h"
#include "interp/path/arc.h"

namespace mrsim {

/// A circular block while it is being solved, in the frame in force.
struct ArcBlock {
  Target to;
  Vec3 from;
  Frame frame;
  Basis basis;  ///< of the plane
  bool ccw = false;
  Vec2 start, end;  ///< in the plane
  const Word* where = nullptr;
};

/// The result of a circular block, in the frame in force.
struct SolvedArc {
  enum class Kind { arc, line, none };
  Kind kind = Kind::none;
  Target to;  ///< the end; completed where an angle gives it
  const Word* where = nullptr;
  Vec3 center;
  Vec3 u, v;  ///< unit axes of its plane
  double radius = 0, sweep = 0;
  bool spatial = false;  ///< not in the plane in force
  /// The end lies slightly beside the arc: the arc ends at `arc_end`, and a line leads to the end.
  bool closing = false;
  Vec3 arc_end;
};

/// Fills `out` with `solved` as the result of `arc`.
void set_plane_arc(const ArcBlock& arc, const PlaneArc& solved, SolvedArc& out);

class PointArcs : public ControlPart {
 public:
  explicit PointArcs(Control& control) : ControlPart(control) {}
  /// CIP and CT. False: an error was reported.
  bool through_point(const ArcBlock& arc, SolvedArc& out);
  bool tangent(const ArcBlock& arc, SolvedArc& out);

 private:
  bool via_point(const ArcBlock& arc, Vec3& via);
};

}  // namespace mrsim
