#include "interp/moves/spline_words.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kSplineTolerance = 1e-3;  // mm
constexpr std::size_t kMostPoints = 100'000;

}  // namespace

// Takes two words that belong together; `out` stays where both are missing. False: one is missing,
// which was reported.
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
  if (modal_.plane != kPlaneXY) return error("spline-plane", "a spline needs the plane G17", where);
  if (to.named.has(kAxisZ)) return error("spline-plane", "a spline has no Z", where);
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
  pieces(bezier_arcs(control, kSplineTolerance), to, from, where, out);
  return true;
}

void SplineWords::pieces(const std::vector<CurvePiece>& curve, const Target& to, const Vec3& from,
                         const Word& where, std::vector<SolvedArc>& out) {
  ArcBlock block{to, from, Frame{}, basis(), false, {}, {}, &where};
  for (const CurvePiece& piece : curve) {
    SolvedArc solved;
    block.to.programmed = {piece.end.x, piece.end.y, from.z};
    block.to.named = kAxisX | kAxisY;
    solved.to = block.to;
    solved.where = &where;
    solved.kind = SolvedArc::Kind::line;
    if (piece.arc.sweep != 0) set_plane_arc(block, piece.arc, solved);
    out.push_back(solved);
  }
}

// G5.2 P L opens the NURBS, and X Y P follow. The first control point is where the tool is; its
// weight is the P of a block without axes.
bool SplineWords::control_point(const Vec3& from) {
  const Word& where = block_.motion_code ? *block_.motion_code : block_.words.front();
  if (modal_.plane != kPlaneXY) return error("spline-plane", "a NURBS needs the plane G17", where);
  if (modal_.incremental)
    return error("not-supported", "control points of a NURBS in G91 are not supported yet", where);
  if (modal_.comp != Code::comp_off)
    return error("cycle-compensation", "a NURBS under radius compensation", where);
  Target to;
  if (!axes_.target(to, from)) return false;
  if (to.named.has(kAxisZ)) return error("spline-plane", "a NURBS has no Z", where);
  const Word* p = take('P');
  if (p && p->value <= 0) return error("value-range", "the weight P must be above 0", *p);
  const double weight = p ? p->value : 1;
  if (const Word* l = take('L')) {
    if (l->value < 2 || l->value > 20 || l->value != std::floor(l->value))
      return error("value-range", "L, the order of a NURBS, is 2 to 20", *l);
    order_ = static_cast<int>(l->value);
  } else if (nurbs_.empty()) {
    order_ = 3;
  }
  if (!to.named.empty() && to.named != (kAxisX | kAxisY))
    return error("value-missing", "a control point needs both X and Y", where);
  if (nurbs_.size() >= kMostPoints)
    return error("value-range", fmt::format("more than {} control points", kMostPoints), where);
  if (nurbs_.empty()) {
    opening_.file = block_.file;
    opening_.line = block_.line_number;
    opening_.column = where.column + 1;
    opening_.call = block_.call;
    nurbs_.push_back({{from.x, from.y}, to.named.empty() ? weight : 1});
  }
  if (!to.named.empty()) nurbs_.push_back({{to.programmed.x, to.programmed.y}, weight});
  return true;
}

bool SplineWords::close(const Vec3& from, std::vector<SolvedArc>& out) {
  const Word& where = *block_.motion_code;
  const std::vector<NurbsPoint> points = std::exchange(nurbs_, {});
  if (points.empty()) return error("value-missing", "G5.3 without G5.2", where);
  if (points.size() < static_cast<std::size_t>(order_))
    return error("value-missing",
                 fmt::format("a NURBS of order {} needs as many control points, not {}", order_,
                             points.size()),
                 where);
  const std::vector<CurvePiece> curve = nurbs_arcs(points, order_, kSplineTolerance);
  if (curve.size() > kMostCurvePieces)
    return error("value-range", fmt::format("a NURBS of more than {} arcs", kMostCurvePieces),
                 where);
  pieces(curve, Target{}, from, where, out);
  return true;
}

}  // namespace mrsim
