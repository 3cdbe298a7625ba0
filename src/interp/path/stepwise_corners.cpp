#include "interp/path/stepwise_corners.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "interp/path/arc.h"
#include "interp/path/offset_contour.h"

#include <cmath>

namespace mrsim {
namespace {

constexpr double kNoCorner = 0.05;  // radians: a smaller turn is no corner

// Whether the tool runs outside of the circle.
bool outside_circle(const PlanePiece& piece, int side) { return piece.sweep * side < 0; }

// A path that turns back by 180 degrees has an outside corner, and so has one that turns by up to
// kNoCorner less. Where the tool runs outside of the arc behind the corner (or of the arc before
// it, if a line follows), only turns by kNoCorner more than 180 degrees are outside corners.
Corner stepwise_kind(const PathMove& a, const PathMove& b) {
  const PlanePiece p = to_plane(a.motion, a.basis), q = to_plane(b.motion, b.basis);
  const Vec2 t = end_tangent(p), u = start_tangent(q);
  const double turn = a.comp.side * mrsim::atan2(cross(t, u), dot(t, u));  // inwards above 0
  if (std::abs(turn) < kNoCorner) return Corner::smooth;
  const bool later = (q.arc || p.arc) && outside_circle(q.arc ? q : p, a.comp.side);
  const double back = kPi + (later ? kNoCorner : -kNoCorner);
  return (turn < 0 ? turn + kTwoPi : turn) < back ? Corner::inside : Corner::outside;
}

// Finds the point in which both pieces meet: before the end of the first one if there is such a
// point, else behind it.
bool meets_inside(const PlanePiece& piece, const PlanePiece& next, Vec2& out) {
  std::array<Vec2, 2> hits;
  const int n = intersect(piece, next, hits);
  if (n == 0) return false;
  const auto cost = [&](Vec2 hit) {
    const double beyond = progress(piece, piece.end, hit) > kTouch ? kFarBack : 0;
    return beyond + length(hit - piece.end);
  };
  out = n == 2 && cost(hits[1]) < cost(hits[0]) ? hits[1] : hits[0];
  return true;
}

}  // namespace

bool lead_to_end(PlanePiece& piece, Vec2 start) {
  const Vec2 inwards = (1 / piece.radius) * (piece.center - piece.end), chord = start - piece.end;
  if (length(chord) <= kTouch) return false;
  if (std::abs(dot(chord, inwards)) <= kRounding * length(chord)) {
    piece.start = start;
    piece.arc = false;
    return true;
  }
  const double turns = std::floor(std::abs(piece.sweep) / kTwoPi) * kTwoPi;
  const bool left = piece.sweep > 0;
  const double radius = dot(chord, chord) / (2 * dot(chord, inwards));
  piece.start = start;
  piece.center = piece.end + radius * inwards;
  piece.radius = std::abs(radius);
  piece.sweep = fold_sweep(piece.start - piece.center, piece.end - piece.center, left);
  piece.sweep += left ? turns : -turns;
  return true;
}

bool turns_round(const PlanePiece& piece, Vec2 from, Vec2 end) {
  return !piece.arc && progress(piece, from, end) < -kTouch;
}

CornerWay stepwise_way(const PathMove& first, const PlanePiece& piece, const PathMove& after,
                       Vec2 from, bool& too_tight) {
  const PlanePiece next = moved(after);
  CornerWay way;
  way.end = piece.end;
  if (is_void(next)) return way;  // it is reported when it is run
  const Corner kind = stepwise_kind(first, after);
  if (kind == Corner::inside && !meets_inside(piece, next, way.end)) {
    too_tight = true;
    return way;
  }
  if (kind == Corner::outside && after.motion.kind == MotionKind::rapid)
    way.add_line(piece.end, next.start);
  else if (kind == Corner::outside)
    way = outside_corner(first.comp, corner_of(first), piece, next);
  if (kind == Corner::inside || (kind == Corner::outside && !next.arc))
    too_tight = turns_round(piece, from, way.end);
  return way;
}

}  // namespace mrsim
