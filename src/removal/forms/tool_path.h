// The path of a tool's tip in one motion: a straight line, an arc in any plane or a helix about any
// axis. Lengths are millimetres.
#pragma once

#include "core/numbers/vec.h"

namespace mrsim {

/// Tool tip along the path: start + t * travel, t in [0, 1] (line), or
/// center + cos(t) * u + sin(t) * v + t * rise, t in [0, sweep] (arc and helix, |u| = |v|).
struct ToolPath {
  bool arc = false;
  Vec3 start, travel;            ///< line
  Vec3 center, u, v, rise;       ///< arc; rise in mm per radian
  double sweep = 0;              ///< radians, positive
  double radius = 0, speed = 0;  ///< arc: |u|; both: largest |d position / dt|
  bool horizontal = false;       ///< arc in a horizontal plane, or helix about Z
  bool lowest_turn = false;      ///< horizontal and falling, at most one turn, tool rising
  bool bored = false;            ///< a whole lowest turn of an end mill
  Vec2 last{1, 0};               ///< arc: direction of its end from its centre, in (u, v)

  bool disc = false;  ///< disc_minimum() answers (disc_sweep.h)

  // Arc in an upright plane, at most one turn, of a tool that reaches up: an end mill
  // (upright_sweep.h), or one with has_flank() (flank_sweep.h).
  bool upright = false, flanked = false;
  Vec2 along;             ///< x of the plane, on the ground; the motion goes from x to z
  Vec2 begin, end;        ///< directions of the ends from the centre, in the plane
  int first_quarter = 0;  ///< of the circle, counter-clockwise from x: the one it begins in
  int quarters = 0;       ///< how many it passes
};
struct PathPoint {
  Vec3 position, direction;  ///< d position / dt
};
/// Where the tip is at t: 0 to 1 on a line, radians from the start on an arc.
PathPoint path_point(const ToolPath& path, double t);

/// Whether what an arc leaves has one flank on each side of it in plan: about Z, or in an upright
/// plane.
bool is_two_sided(const ToolPath& arc);

/// Radians: a place of an arc nearer than this to one of its ends is that end.
inline constexpr double kAtPathEnd = 1e-12;

/// The least distance, mm, and the place of the path from which it is reached.
struct PathSample {
  double distance = 0, t = 0;
};
inline constexpr double kPathError = 2e-7;  ///< mm: what a search along a path may add to it

}  // namespace mrsim
