#include "interp/control/spline_words.h"

#include "interp/path/spline.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kSplineTolerance = 1e-3;  // mm

}  // namespace

// Two words that go together. False: one is missing, which was reported; both missing: `out` stays.
bool SplineWords::offset(char first, char second, const Word& where, Vec2& out) {
  const Word* a = take(first);
  const Word* b = take(second);
  if (!a && !b) return true;
  if (!a || !b)
    return error("value-missing", fmt::format("a spline needs both {} and {}", first, second),
                 where);
  out = {a->value * scale(), b->value * scale()};
  return true;
}

bool SplineWords::solve(const Vec3& from, std::vector<SolvedArc>& out) {
  const bool cubic = current_motion() == Code::spline_cubic;
  Target to;
  if (!axes_.target(to, from)) return false;
  const Word& where = *axes_.motion_word(to);
  if (modal_.plane != 0) return error("spline-plane", "a spline needs the plane G17", where);
  if ((to.named & 4U) != 0) return error("spline-plane", "a spline has no Z", where);
  const bool first = peek('I') || peek('J');
  if (cubic && !first && !position_.after_spline)
    return error("value-missing", "the first spline needs I and J, its direction at the start",
                 where);
  if (cubic && !(peek('P') && peek('Q')))
    return error("value-missing", "G5 needs P and Q, its direction at the end", where);
  if (!cubic && !first) return error("value-missing", "G5.1 needs I or J", where);
  const Vec2 start{from.x, from.y}, end{to.programmed.x, to.programmed.y};
  std::array<Vec2, 4> control{start, start, end, end};
  if (cubic) {
    Vec2 lead = Vec2{} - position_.spline_end, tail;
    if (!offset('I', 'J', where, lead) || !offset('P', 'Q', where, tail)) return false;
    control[1] = start + lead;
    control[2] = end + tail;
    position_.spline_end = tail;
  } else {
    const Word* i = take('I');
    const Word* j = take('J');
    const Vec2 middle = start + Vec2{i ? i->value * scale() : 0, j ? j->value * scale() : 0};
    control[1] = (1.0 / 3) * (start + 2.0 * middle);
    control[2] = (1.0 / 3) * (end + 2.0 * middle);
  }
  ArcBlock block{to, from, Frame{}, basis(), false, {}, {}, &where};
  for (const CurvePiece& piece : bezier_arcs(control, kSplineTolerance)) {
    SolvedArc solved;
    block.to.programmed = {piece.end.x, piece.end.y, from.z};
    block.to.named = 3;
    solved.to = block.to;
    solved.where = &where;
    solved.kind = SolvedArc::Kind::line;
    if (piece.arc.sweep != 0) set_plane_arc(block, piece.arc, solved);
    out.push_back(solved);
  }
  return true;
}

}  // namespace mrsim
