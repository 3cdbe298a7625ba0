// Radius compensation as LinuxCNC does it: an element sees the next one alone, so that nothing is
// left out, and an element that two inside corners use up is an error.
#include "core/rounding.h"
#include "core/trig.h"
#include "interp/path/arc.h"
#include "interp/path/compensation.h"
#include "interp/path/offset_contour.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kNoCorner = 0.05;  // radians: smaller turns have none
constexpr double kFarBack = 1e9;    // mm

// The tool runs outside of the circle.
bool outside_circle(const PlanePiece& piece, int side) { return piece.sweep * side < 0; }

// A full turn back is an outside corner, up to kNoCorner before it. Where the tool runs outside of
// the arc behind it, or of the one before a line, it is one from kNoCorner beyond it on.
Corner stepwise_kind(const PathMove& a, const PathMove& b) {
  const PlanePiece p = to_plane(a.motion, a.basis), q = to_plane(b.motion, b.basis);
  const Vec2 t = end_tangent(p), u = start_tangent(q);
  const double turn = a.comp.side * mrsim::atan2(cross(t, u), dot(t, u));  // inwards above 0
  if (std::abs(turn) < kNoCorner) return Corner::smooth;
  const bool later = (q.arc || p.arc) && outside_circle(q.arc ? q : p, a.comp.side);
  const double back = kPi + (later ? kNoCorner : -kNoCorner);
  return (turn < 0 ? turn + kTwoPi : turn) < back ? Corner::inside : Corner::outside;
}

// Where both meet before the end of the first, or failing that behind it.
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

// The arc from `start` that ends where the moved one does, and in its direction: a line where that
// leads there. False where the tool is there already.
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

}  // namespace

// The entry is an element like others, and must be longer than the radius. A line may end however
// far before its start, where the tool is not beside it.
void CompensationStage::enter_beside(double h) {
  const PathMove first = queue_.front();
  const Vec2 start = in_plane(first.basis, at_) + first.comp.tip;
  const double travel = length(corner_of(first) - start);
  if (travel <= first.comp.radius && first.comp.radius > 0)
    reporter_.add_at(Severity::error, "comp-entry",
                     fmt::format("the entry into compensation is {:.6g} long and must be longer "
                                 "than the tool's radius {:.6g}",
                                 travel, first.comp.radius),
                     first.motion);
  PlanePiece piece = moved(first);
  if (piece.arc) {
    if (travel <= first.comp.radius || is_void(piece) || !lead_to_end(piece, start))
      return leave_void(first, h);
  }
  cursor_ = piece.arc ? start : piece.start - kFarBack * end_tangent(piece);
  const CornerWay way = choose_end(piece);
  if (piece.arc)
    run_piece(first, piece, way.end, h);
  else
    send_line(first, way.end, h);
  run_corner(first, way);
}

// Where the first element ends and what leads from there to the next. A rapid goes straight.
CornerWay CompensationStage::step_to(const PlanePiece& piece, const PathMove& after) {
  const PathMove& first = queue_.front();
  const PlanePiece next = moved(after);
  CornerWay way;
  way.end = piece.end;
  if (is_void(next)) return way;  // told of in its turn
  const Corner kind = stepwise_kind(first, after);
  if (kind == Corner::inside && !meets_inside(piece, next, way.end)) {
    corner_too_tight(after.motion);
    return way;
  }
  if (kind == Corner::outside && after.motion.kind == MotionKind::rapid)
    way.add_line(piece.end, next.start);
  else if (kind == Corner::outside)
    way = outside_corner(first.comp, corner_of(first), piece, next);
  if (kind == Corner::inside || (kind == Corner::outside && !next.arc))
    check_room(piece, way.end, after.motion);
  return way;
}

// A line that its inside corners would turn round. Its interpreter looks for that only before an
// inside corner, before a line behind an outside one, and where compensation ends.
void CompensationStage::check_room(const PlanePiece& piece, Vec2 end, const Motion& next) {
  if (!piece.arc && progress(piece, cursor_, end) < -kTouch) corner_too_tight(next);
}

// An arc behind so small a turn that the element before it ends beside its circle.
void CompensationStage::step_onto(const PathMove& first, const PlanePiece& arc) {
  const Vec2 out = cursor_ - arc.center;
  send_line(first, arc.center + (arc.radius / length(out)) * out, dot(at_, first.basis.w));
}

}  // namespace mrsim
