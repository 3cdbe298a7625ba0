// Circular arcs in a plane and in space, from every way of programming them. Pure geometry: what a
// control tolerates is decided by the caller.
#pragma once

#include "core/numbers/vec.h"

#include <optional>

namespace mrsim {

/// Points nearer than this are one point, mm.
inline constexpr double kSamePoint = 1e-3;

/// An arc in plane coordinates (u, v): signed sweep in radians, counter-clockwise (u towards v)
/// positive.
struct PlaneArc {
  Vec2 center;
  double radius = 0;
  double sweep = 0;
};

/// Angle from a to b as seen from the origin, in (0, 2 pi] when counter-clockwise, else [-2 pi, 0).
double fold_sweep(Vec2 a, Vec2 b, bool ccw);

/// `p` turned about `center` by `angle` radians.
Vec2 rotated(Vec2 p, Vec2 center, double angle);

/// The arc from start to end about `center`; a full circle when they are one point.
PlaneArc arc_about(Vec2 start, Vec2 end, Vec2 center, bool ccw);

/// The point of the perpendicular bisector of start and end that is nearest to `center`.
Vec2 bisector_center(Vec2 start, Vec2 end, Vec2 center);

/// The arc of a radius: above 0 it has at most 180 degrees, below 0 at least that. Nothing when the
/// chord is longer than the diameter by more than rounding (1e-6 of it, or 1 um). Requires:
/// start != end.
std::optional<PlaneArc> arc_by_radius(Vec2 start, Vec2 end, double radius, bool ccw);

/// The arc of an opening angle in radians, in (0, 2 pi). Requires: start != end.
PlaneArc arc_by_angle(Vec2 start, Vec2 end, double angle, bool ccw);

/// The arc that leaves start along the unit vector `tangent`. Nothing when that is the straight
/// line to end.
std::optional<PlaneArc> arc_by_tangent(Vec2 start, Vec2 tangent, Vec2 end);

/// An arc in space: `sweep` > 0 about unit `axis`.
struct SpatialArc {
  Vec3 center, axis;
  double radius = 0, sweep = 0;
};
enum class Fit { arc, line, impossible };
/// The arc from start through `via` to end. `line`: the points lie on one line, with via between
/// the others. Requires: three different points.
Fit arc_through(const Vec3& start, const Vec3& via, const Vec3& end, SpatialArc& out);

/// Turns the axis so that its first non-zero component in the order z, y, x is positive.
void normalise_axis(Motion& arc);

/// The point of an arc motion after the share t of its sweep.
Vec3 arc_point(const Motion& arc, double t);
/// The unit direction of travel at that point.
Vec3 arc_tangent(const Motion& arc, double t);

}  // namespace mrsim
