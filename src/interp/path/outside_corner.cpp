#include "interp/path/outside_corner.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/path/arc.h"
#include "interp/path/offset_contour.h"

#include <cmath>

namespace mrsim {
namespace {

double half_tangent(double turn) {
  const SinCos half = sincos(turn / 2);
  return half.sin / half.cos;
}

// Finds where both meet when the first is extended and the second begins earlier.
bool run_on(const PlanePiece& a, const PlanePiece& b, Vec2& out) {
  std::array<Vec2, 2> hits;
  const int n = intersect(a, b, hits);
  double best = kInfinity;
  for (int i = 0; i < n; ++i) {
    const Vec2 p = hits[static_cast<std::size_t>(i)];
    const double far = length(p - a.end);
    if (progress(a, a.end, p) < -kTouch / (a.arc ? a.radius : 1) ||
        progress(b, p, b.start) < -kTouch / (b.arc ? b.radius : 1) || far >= best)
      continue;
    best = far;
    out = p;
  }
  return best < kInfinity;
}

// Goes straight on from both ends by the same length.
void along_tangents(CornerWay& way, const PlanePiece& a, const PlanePiece& b, double out,
                    bool meets) {
  const Vec2 first = a.end + out * end_tangent(a);
  const Vec2 second = meets ? first : b.start - out * start_tangent(b);
  if (a.arc)
    way.add_line(a.end, first);
  else
    way.end = first;
  if (!meets) way.add_line(first, second);
  if (b.arc)
    way.add_line(second, b.start);
  else
    way.entry = second;
}

void round(CornerWay& way, const Compensation& comp, Vec2 corner, const PlanePiece& a,
           const PlanePiece& b, double turn) {
  const double disc = turn <= kSharpestDisc ? comp.disc : 0;
  const double out = disc > 0 ? disc * comp.radius * half_tangent(turn) : 0;
  const double side = comp.side;
  PlanePiece arc;
  arc.arc = true;
  arc.radius = (1 - disc) * comp.radius;
  arc.start = a.end + out * end_tangent(a);
  arc.end = b.start - out * start_tangent(b);
  arc.center = disc > 0 ? arc.start - (side * arc.radius) * left_of(end_tangent(a)) : corner;
  arc.sweep = fold_sweep(arc.start - arc.center, arc.end - arc.center, comp.side < 0);
  way.add_line(a.end, arc.start);
  if (arc.radius > kTouch) way.add(arc);
  way.add_line(arc.end, b.start);
}

}  // namespace

void CornerWay::add_line(Vec2 from, Vec2 to) {
  if (length(to - from) <= kRounding) return;
  PlanePiece line;
  line.start = from;
  line.end = to;
  add(line);
}

CornerWay outside_corner(const Compensation& comp, Vec2 corner, const PlanePiece& piece,
                         const PlanePiece& next) {
  CornerWay way;
  way.end = piece.end;
  way.entry = next.start;
  const double turn = std::abs(fold_sweep(end_tangent(piece), start_tangent(next), comp.side < 0));
  const bool meets = !comp.arcs && turn <= comp.sharpest + kTurnRounding;
  if (comp.two_points && !comp.arcs)
    along_tangents(way, piece, next, comp.radius * (meets ? half_tangent(turn) : 1), meets);
  else if (meets && run_on(piece, next, way.end))
    way.entry = way.end;
  else
    round(way, comp, corner, piece, next, turn);
  return way;
}

bool touching_line(const Compensation& comp, Vec2 corner, Vec2 outer, bool leaving,
                   PlanePiece& line) {
  const Vec2 e = leaving ? outer - corner : corner - outer;
  const double d2 = dot(e, e), along2 = d2 - comp.radius * comp.radius;
  if (along2 <= kTouch) return false;
  const double across = (leaving ? -comp.side : comp.side) * comp.radius;
  const Vec2 direction = (1 / d2) * (std::sqrt(along2) * e + across * left_of(e));
  const Vec2 touch = corner + (comp.side * comp.radius) * left_of(direction);
  line = {};
  line.start = leaving ? touch : outer;
  line.end = leaving ? outer : touch;
  return true;
}

}  // namespace mrsim
