// A cubic Bezier curve in a plane as circular arcs. Guarantees: tangent-continuous, and the curve's
// sampled points lie within `tolerance` of the arcs. Does not know units or words.
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

/// Control points in order. A curve that is one point gives nothing.
std::vector<CurvePiece> bezier_arcs(const std::array<Vec2, 4>& control, double tolerance);

}  // namespace mrsim
