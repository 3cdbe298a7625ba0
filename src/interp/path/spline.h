// Curves in a plane as circular arcs: cubic Bezier curves, and NURBS (rational B-splines with
// clamped uniform knots). Guarantees: tangent-continuous, and the curve's sampled points lie within
// `tolerance` of the arcs. Does not know units or words.
#pragma once

#include "interp/path/arc.h"

#include <array>
#include <vector>

namespace mrsim {

/// A piece of a curve: a line where `arc.sweep` is 0.
struct CurvePiece {
  Vec2 end;
  PlaneArc arc;
};

/// A control point of a NURBS; weight above 0.
struct NurbsPoint {
  Vec2 at;
  double weight = 1;
};

/// The most pieces of a NURBS; a curve of more pieces ends early.
inline constexpr std::size_t kMostCurvePieces = 1'000'000;

/// The arcs of a NURBS. Requires: order from 2 to the number of points. A curve that is one point
/// gives nothing.
std::vector<CurvePiece> nurbs_arcs(const std::vector<NurbsPoint>& control, int order,
                                   double tolerance);

/// The arcs of a cubic Bezier curve, by its control points in order. A curve that is one point
/// gives nothing.
std::vector<CurvePiece> bezier_arcs(const std::array<Vec2, 4>& control, double tolerance);

}  // namespace mrsim
