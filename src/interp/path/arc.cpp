#include "interp/path/arc.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>

namespace mrsim {
namespace {

// Share of a diameter: a chord up to this long is a diameter whose ends the program has rounded.
constexpr double kRoundedChord = 1 + 1e-6;

}  // namespace

double fold_sweep(Vec2 a, Vec2 b, bool ccw) {
  const double angle = atan2(cross(a, b), dot(a, b));
  if (ccw) return angle > 0 ? angle : angle + kTwoPi;
  return angle < 0 ? angle : angle - kTwoPi;
}

Vec2 rotated(Vec2 p, Vec2 center, double angle) {
  const SinCos sc = sincos(angle);
  const Vec2 d = p - center;
  return center + Vec2{d.x * sc.cos - d.y * sc.sin, d.x * sc.sin + d.y * sc.cos};
}

PlaneArc arc_about(Vec2 start, Vec2 end, Vec2 center, bool ccw) {
  PlaneArc arc;
  arc.center = center;
  arc.radius = length(start - center);
  const bool full = length(end - start) <= kSamePoint;
  arc.sweep = full ? (ccw ? kTwoPi : -kTwoPi) : fold_sweep(start - center, end - center, ccw);
  return arc;
}

Vec2 bisector_center(Vec2 start, Vec2 end, Vec2 center) {
  const Vec2 chord = end - start;
  const Vec2 middle = 0.5 * (start + end);
  const double off = dot(center - middle, chord) / dot(chord, chord);
  return center - off * chord;
}

std::optional<PlaneArc> arc_by_radius(Vec2 start, Vec2 end, double radius, bool ccw) {
  const Vec2 chord = end - start;
  const double l = length(chord), r = std::abs(radius);
  if (l > 2 * r * kRoundedChord && l - 2 * r > kSamePoint) return std::nullopt;
  const double used =
      std::max(r, l / 2);  // a radius rounded to less than half the chord becomes that
  // A difference of squares below its rounding counts as 0: half a circle.
  constexpr double kNoDifference = 1e-12;
  const double square = used * used - l * l / 4;
  const double h = square < kNoDifference * used * used ? 0 : std::sqrt(square);
  const double side = (radius > 0) == ccw ? 1 : -1;
  const Vec2 normal = (1 / l) * Vec2{-chord.y, chord.x};
  PlaneArc arc;
  arc.center = 0.5 * (start + end) + (side * h) * normal;
  arc.radius = used;
  const double half = atan2(l / 2, h);
  const double angle = radius > 0 ? 2 * half : kTwoPi - 2 * half;
  arc.sweep = ccw ? angle : -angle;
  return arc;
}

PlaneArc arc_by_angle(Vec2 start, Vec2 end, double angle, bool ccw) {
  const Vec2 chord = end - start;
  const double l = length(chord);
  const SinCos half = sincos(angle / 2);
  const Vec2 normal = (1 / l) * Vec2{-chord.y, chord.x};
  PlaneArc arc;
  arc.radius = l / (2 * half.sin);
  // Left of the chord for a counter-clockwise arc below 180 degrees; cos changes sign there.
  arc.center = 0.5 * (start + end) + ((ccw ? 1 : -1) * arc.radius * half.cos) * normal;
  arc.sweep = ccw ? angle : -angle;
  return arc;
}

std::optional<PlaneArc> arc_by_tangent(Vec2 start, Vec2 tangent, Vec2 end) {
  const Vec2 chord = end - start;
  const double across = cross(tangent, chord), l2 = dot(chord, chord);
  if (std::abs(across) <= kTurnRounding * std::sqrt(l2) && dot(tangent, chord) > 0)
    return std::nullopt;
  const double signed_radius = l2 / (2 * across);  // > 0: the centre lies left of the tangent
  PlaneArc arc;
  arc.center = start + signed_radius * Vec2{-tangent.y, tangent.x};
  arc.radius = std::abs(signed_radius);
  arc.sweep = fold_sweep(start - arc.center, end - arc.center, signed_radius > 0);
  return arc;
}

Fit arc_through(const Vec3& start, const Vec3& via, const Vec3& end, SpatialArc& out) {
  const Vec3 a = via - start, b = end - start;
  const Vec3 n = cross(a, b);
  const double n2 = dot(n, n), a2 = dot(a, a), b2 = dot(b, b);
  // The three points lie on a line, so that the arc has no plane, if the sine between the two
  // chords is up to 1e-9 or `via` lies within 1e-12 mm of the chord.
  constexpr double kNoSineSquared = 1e-18, kNoHeightSquared = 1e-24;
  if (n2 <= kNoSineSquared * a2 * b2 + kNoHeightSquared * b2) {
    const double along = dot(a, b);
    return along > 0 && along < b2 ? Fit::line : Fit::impossible;
  }
  const Vec3 to_center = (1 / (2 * n2)) * (a2 * cross(b, n) + b2 * cross(n, a));
  out.center = start + to_center;
  out.axis = (1 / std::sqrt(n2)) * n;
  out.radius = length(to_center);
  const Vec3 from = start - out.center, to = end - out.center;
  const double angle = atan2(dot(out.axis, cross(from, to)), dot(from, to));
  out.sweep = angle > 0 ? angle : angle + kTwoPi;
  return Fit::arc;
}

void normalise_axis(Motion& arc) {
  constexpr double kZero = 1e-12;  // rounding of a unit vector that was turned
  Vec3& n = arc.axis;
  for (int i = 0; i < 3; ++i)  // leaves no -0, and no rounding beside a coordinate axis
    if (std::abs(component(n, i)) < kZero) component(n, i) = 0;
  const double first = n.z != 0 ? n.z : n.y != 0 ? n.y : n.x;
  if (first >= 0) return;
  for (int i = 0; i < 3; ++i)
    if (component(n, i) != 0) component(n, i) = -component(n, i);
  arc.sweep = -arc.sweep;
  arc.rise = arc.rise == 0 ? 0 : -arc.rise;
}

Vec3 arc_point(const Motion& arc, double t) {
  const SinCos sc = sincos(arc.sweep * t);
  const Vec3 r = arc.start - arc.center;
  return arc.center + sc.cos * r + sc.sin * cross(arc.axis, r) + (arc.rise * t) * arc.axis;
}

Vec3 arc_tangent(const Motion& arc, double t) {
  const SinCos sc = sincos(arc.sweep * t);
  const Vec3 r = arc.start - arc.center;
  const Vec3 around = sc.cos * cross(arc.axis, r) - sc.sin * r;
  return normalized(arc.sweep * around + arc.rise * arc.axis);
}

}  // namespace mrsim
