#include "interp/cycles/cycle_mover.h"

#include "core/numbers/rounding.h"

namespace mrsim {

void CycleMover::go(Vec2 to, double height, MotionKind kind, double feed) {
  const Basis b = basis();
  Target target;
  target.programmed = from_plane(b, to, height);
  if (length(target.programmed - position_.programmed) <= kRounding && position_.known == kAllAxes)
    return;
  target.named = axes_along(target.programmed - position_.programmed);
  moves_.step(target, where_, kind, 0, feed);
}

// Makes `out` the target. False: the tool is known to be there already.
bool CycleMover::target(Vec2 to, Target& out) const {
  const Basis b = basis();
  out.programmed = from_plane(b, to, height());
  out.named = kAllAxes - axes_along(b.w);
  return length(to - position()) > kRounding || !position_.known.has(out.named);
}

void CycleMover::rapid(Vec2 to) {
  Target there;
  if (target(to, there)) moves_.step(there, where_, MotionKind::rapid);
}

void CycleMover::compensated(Vec2 to, MotionKind kind) {
  Target there;
  if (target(to, there)) moves_.compensated_step(there, where_, 0, kind);
}

void CycleMover::rapid_height(double to) {
  const Basis b = basis();
  Target target;
  target.programmed = from_plane(b, position(), to);
  target.named = axes_along(b.w);
  if (std::abs(to - height()) > kRounding || !position_.known.has(target.named))
    moves_.step(target, where_, MotionKind::rapid);
}

void CycleMover::line(Vec2 to, double feed) { go(to, height(), MotionKind::line, feed); }

void CycleMover::line_height(double to, double feed) { go(position(), to, MotionKind::line, feed); }

void CycleMover::slope(Vec2 to, double height, double feed) {
  go(to, height, MotionKind::line, feed);
}

void CycleMover::piece(const PlanePiece& piece, double rise, double feed) {
  const double level = height();
  if (!piece.arc) return go(piece.end, level + rise, MotionKind::line, feed);
  const Basis b = basis();
  SolvedArc arc;
  arc.kind = SolvedArc::Kind::arc;
  arc.where = &where_;
  arc.center = from_plane(b, piece.center, level);
  arc.u = b.u;
  arc.v = b.v;
  arc.radius = piece.radius;
  arc.sweep = piece.sweep;
  arc.to.programmed = from_plane(b, piece.end, level + rise);
  arc.to.named = kAllAxes;
  moves_.solved_arc(arc, feed);
}

void CycleMover::loop(const Loop& loop, double feed) {
  for (const PlanePiece& each : loop) piece(each, 0, feed);
}

}  // namespace mrsim
