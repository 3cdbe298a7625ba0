// Enclosures of a face's distance on a triangle: what no sample can miss (docs/mesh.md, Tolerance).
//
// Everything rests on two facts. A convex function on a triangle lies below its largest corner and
// above its tangent plane at any point. And where a function's second derivatives are at most k in
// size, it strays from the linear interpolation of its corners by at most k / 2 times the square of
// the radius of the smallest circle about the triangle. Only + - * / sqrt; rounding (1e-12 of the
// coordinates) is not counted.
#pragma once

#include "core/numbers/vec.h"
#include "removal/field/field.h"

#include <array>

namespace mrsim {

using Corners2 = std::array<Vec2, 3>;

/// Distance of a place in a triangle from its nearest corner, in longest sides, at most: sqrt(1/3).
inline constexpr double kNearestCorner = 0.5773502691896258;

/// Weights of the corners in the centre of the smallest circle about a triangle, and the square of
/// its radius, from the squared sides opposite to the corners.
struct SmallestCircle {
  std::array<double, 3> weight;
  double squared = 0;
};
/// The smallest circle about a triangle, given by its squared sides (mm^2) or its corners.
SmallestCircle smallest_circle(double opposite_a, double opposite_b, double opposite_c);
SmallestCircle smallest_circle(const Corners3& t);
SmallestCircle smallest_circle(const Corners2& t);

/// The centre of the circle.
template <class V>
V weighted(const SmallestCircle& circle, const std::array<V, 3>& t) {
  return circle.weight[0] * t[0] + circle.weight[1] * t[1] + circle.weight[2] * t[2];
}

/// The range of -f, where that of f is r.
inline constexpr FaceRange negated(const FaceRange& r) { return {-r.hi, -r.lo}; }
/// Range of a linear function, from its values at the corners.
FaceRange range_of(const std::array<double, 3>& linear);

/// Range of a convex function from its values at the corners and its tangent plane at `at`.
template <class V>
FaceRange convex_range(const std::array<V, 3>& t, const std::array<double, 3>& values, const V& at,
                       double value, const V& slope) {
  FaceRange range = range_of(values);
  range.lo = value + dot(slope, t[0] - at);
  for (int k = 1; k < 3; ++k) {
    const double tangent = value + dot(slope, t[k] - at);
    if (tangent < range.lo) range.lo = tangent;
  }
  return range;
}

/// mm: coordinates are floats, so that the corners of a triangle on a border lie this far beyond
/// it. There a face that goes on smoothly differs from its neighbour by the square of it.
inline constexpr double kBorder = 1e-5;

/// Whether the plan directions w (from an arc's centre) see the arc, the far side of one of its
/// ends, or both. `c`: ArcSlot.
struct ArcView {
  enum class Part { arc, end, both, unknown } part = Part::unknown;
  int side = 0;  ///< which end: 1 or -1
};
/// Requires: w are those of the corners of one triangle.
ArcView arc_view(const double* c, std::span<const Vec2> w);
/// The end of the arc on that side, from its centre.
Vec2 arc_end(const double* c, int side);

/// A function v of space on a triangle, that of its corners interpolated up to what lies between
/// two affine functions, given by their values at the corners.
struct Envelope {
  std::array<double, 3> at, low, high;
  bool is_known = false;
};
/// Between the least of the lower and the largest of the upper function.
inline FaceRange whole_range(const Envelope& v) {
  return {range_of(v.low).lo, range_of(v.high).hi};
}
/// v = |w|. Convex, so that corners and one tangent enclose it; true up to the centre itself.
Envelope length_envelope(const Corners2& w);
/// v = the distance in plan from a segment (line_rho of c) or an arc (arc_rho), or, where
/// `is_signed` and all of the triangle sees the arc, that from its circle, negative inside. `side`:
/// the one end of the arc that counts, 0 for both. Unknown where the distance may have a crease.
Envelope line_envelope(const double* c, const Corners3& t);
Envelope arc_envelope(const double* c, const Corners3& t, bool is_signed, int side);

/// The image of a triangle under (v, y) with y affine: corners, and hull of what is not plane.
struct Section {
  Corners2 at;
  std::array<Vec2, 6> hull;
  double below = 0, above = 0;  ///< of v under and over its interpolation
};
/// Requires: v.is_known. `y`: by corners.
Section section_of(const Envelope& v, const std::array<double, 3>& y);

/// Bounds of dH/dv.
struct Slopes {
  double lo = -1, hi = 1;
};
/// Range of H(v, y) on a section, from that on the plane triangle of its corners.
FaceRange widened(const FaceRange& plane, const Section& s, const Slopes& slopes);

/// Range over a section of a convex function with `value`, `slope` (at most 1 long) and second
/// derivatives up to 1 / (value + round) at any point.
template <class Value, class Slope>
FaceRange convex_section_range(const Section& s, double round, Value value, Slope slope);

/// Bounds of a slope over the section, from the one at its centre and second derivatives of at most
/// `bend`.
Slopes slopes_about(const Section& s, Vec2 centre, Vec2 slope, double bend);

template <class Value, class Slope>
FaceRange convex_section_range(const Section& s, double round, Value value, Slope slope) {
  const Vec2 m = weighted(smallest_circle(s.at), s.at), g = slope(m);
  const double at_m = value(m);
  double least = at_m + round;  // distance from what the face is an offset of
  for (const Vec2& q : s.hull) {
    const double tangent = at_m + round + dot(g, q - m);
    if (tangent < least) least = tangent;
  }
  const double bend = least > 0 ? 1 / least : std::numeric_limits<double>::infinity();
  const FaceRange plane =
      convex_range(s.at, {value(s.at[0]), value(s.at[1]), value(s.at[2])}, m, at_m, g);
  return widened(plane, s, slopes_about(s, m, g, bend));
}

}  // namespace mrsim
