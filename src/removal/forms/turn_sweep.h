// What a convex turning insert sweeps along a line or an arc in the (X, Z) half plane, turned about
// the spindle.
#pragma once

#include "core/numbers/vec.h"
#include "removal/field/field.h"
#include "removal/forms/sweep_sample.h"
#include "removal/tool/polygon.h"
#include "removal/tool/tool.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Part of a circle, folded about its middle as in sweep_lanes.inl.
struct CircularArc {
  Vec2 center, middle;
  double radius = 0, cos_half = -1, sin_half = 0;
  int way = 0;  ///< 1: the swept area lies towards the centre, -1: away from it, 0: on both sides
};

/// Two sides of an insert that are not parallel: the difference m of their normals, and 1 / |m|^2.
struct SidePair {
  std::size_t first = 0, second = 0;
  Vec2 m;
  double inverse = 0;
};

/// One sweep of an insert. A line makes a polygon; an arc the boundary curves of arc + polygon:
/// arcs drawn by corners, sides at the ends and where the path runs along them.
struct TurnSweep {
  ConvexPolygon polygon;  ///< line: the swept polygon; arc: the insert's core
  bool arc = false;
  CircularArc path;                        ///< arc
  std::vector<CircularArc> arcs;           ///< arc: by corners
  std::vector<ConvexPolygon::Side> sides;  ///< arc: sides at rest
  std::vector<double> reach;    ///< arc: farthest point of the path along each side's normal, mm
  std::vector<SidePair> pairs;  ///< arc: sides of the core that can be equally far
  double round = 0;
  bool inside = false;
  bool one_sided = false;  ///< never beyond the spindle axis: the mirror image is never nearer
  Vec2 lo, hi;             ///< bounds in (X, Z)
  Vec2 start, end;         ///< the path lies within `bulge` mm of the segment between them
  double bulge = 0;
};

/// Path from `start` to `end` in (X, Z), or the arc from start about `center` by `turn` radians,
/// counter-clockwise in (X, Z).
TurnSweep turn_line(const InsertOutline& insert, Vec2 start, Vec2 end);
TurnSweep turn_arc(const InsertOutline& insert, Vec2 start, Vec2 center, double turn);

/// Signed distance in space; patches of the mirror image (behind the spindle axis) from
/// kMirrorPatch.
inline constexpr std::int32_t kMirrorPatch = 1 << 16;
double turn_distance(const TurnSweep& s, const Vec3& p);
/// Signed distance in the half plane, for one side of the axis.
double section_distance(const TurnSweep& s, Vec2 q);
/// Distance and nearest face, and the unit gradient of one face.
SweepSample turn_sample(const TurnSweep& s, const Vec3& p);
Vec3 turn_gradient(const TurnSweep& s, const Vec3& p, std::int32_t patch);
/// Encloses turn_face_distance() on a triangle.
FaceRange turn_face_range(const TurnSweep& s, const Corners3& t, std::int32_t patch);
/// Signed distance to one curve, continued beyond its ends: what turn_gradient is the gradient of.
double turn_face_distance(const TurnSweep& s, const Vec3& p, std::int32_t patch);

}  // namespace mrsim
