#include "interp/path/offset_contour.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"

#include <cmath>

namespace mrsim {
namespace {

constexpr double kCusp = 0.1;  // |t1 x t2| above which a path does not turn back

// 1 / radius in 1 / mm, above 0 to the left; 0 for a line.
double curvature(const PlanePiece& piece) {
  return !piece.arc ? 0 : piece.sweep > 0 ? 1 / piece.radius : -1 / piece.radius;
}

bool collinear(const PlanePiece& a, const PlanePiece& b) {
  const Vec2 t = start_tangent(a), u = start_tangent(b);
  return std::abs(cross(t, u)) < kTurnRounding && dot(t, u) > 0 &&
         std::abs(cross(t, b.start - a.end)) < kTouch;
}

}  // namespace

PlanePiece moved(const PathMove& m) {
  return offset_piece(to_plane(m.motion, m.basis), m.comp.side * m.comp.radius);
}

bool takes_part(const PathMove& m) {
  return m.comp.side != 0 && !m.comp.suspended && !is_infeed(m) && !is_tilted(m);
}

bool meeting(const PlanePiece& a, const PlanePiece& b, Vec2 from, Vec2 corner, Vec2& out) {
  if (!a.arc && !b.arc && collinear(a, b)) {
    out = a.end;
    return progress(b, a.end, b.end) > kTouch;
  }
  std::array<Vec2, 2> hits;
  const int n = intersect(a, b, hits);
  double best = kInfinity;
  for (int i = 0; i < n; ++i) {
    const Vec2 p = hits[static_cast<std::size_t>(i)];
    const double scale = a.arc ? a.radius : 1, scale_b = b.arc ? b.radius : 1;
    const double ahead = a.arc ? position_on(a, p) : progress(a, from, p);
    const bool on_a =
        a.arc ? (ahead <= extent(a) + kTouch / scale || ahead >= kTwoPi - kTouch / scale)
              : ahead >= -kTouch && progress(a, p, a.end) >= -kTouch;
    const double on = position_on(b, p);
    const bool on_b = (on >= -kTouch / scale_b && on <= extent(b) + kTouch / scale_b) ||
                      (b.arc && on >= kTwoPi - kTouch / scale_b);
    const double far = length(p - corner);
    if (!on_a || !on_b || far >= best) continue;
    best = far;
    out = p;
  }
  return best < kInfinity;
}

Corner corner_kind(const PathMove& a, const PathMove& b) {
  const PlanePiece p = to_plane(a.motion, a.basis), q = to_plane(b.motion, b.basis);
  const Vec2 t1 = end_tangent(p), t2 = start_tangent(q);
  double c = cross(t1, t2);
  if (dot(t1, t2) < 0 && std::abs(c) < kCusp && (p.arc || q.arc))
    c -= a.comp.radius * (curvature(p) + curvature(q));
  const double step = std::abs(c) * a.comp.radius;  // between the offset ends
  if ((std::abs(c) < kTurnRounding || step < kLastDigit) && dot(t1, t2) > 0) return Corner::smooth;
  if (std::abs(c) < kTurnRounding) return Corner::outside;  // straight back
  return a.comp.side * c > 0 ? Corner::inside : Corner::outside;
}

bool nearly_tangent(const PathMove& a, const PathMove& b) {
  const Vec2 t1 = end_tangent(to_plane(a.motion, a.basis)),
             t2 = start_tangent(to_plane(b.motion, b.basis));
  return dot(t1, t2) > 0 && std::abs(cross(t1, t2)) < 0.02;
}

}  // namespace mrsim
