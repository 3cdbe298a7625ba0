#include "interp/moves/point_arcs.h"

#include "core/numbers/rounding.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {

void set_plane_arc(const ArcBlock& arc, const PlaneArc& solved, SolvedArc& out) {
  out.kind = SolvedArc::Kind::arc;
  out.to = arc.to;
  out.center = from_plane(arc.basis, solved.center, dot(arc.from, arc.basis.w));
  out.u = arc.basis.u;
  out.v = arc.basis.v;
  out.radius = solved.radius;
  out.sweep = solved.sweep;
}

// I1= J1= K1= are the intermediate point. G90 and G91 hold for it as for the end point; in G91 both
// count from the start.
bool PointArcs::via_point(const ArcBlock& arc, Vec3& via) {
  via = arc.from;
  bool any = false;
  static constexpr Address kVia[] = {Address::i1, Address::j1, Address::k1};
  for (int i = 0; i < 3; ++i) {
    const Word* word = take(kVia[i]);
    if (!word) continue;
    any = true;
    bool relative = modal_.incremental;
    if (word->form == Form::ac) relative = false;
    if (word->form == Form::ic) relative = true;
    double value = word->value * scale();
    // An absolute X is a diameter and increments are radii, as PRIMER's turning programs print it.
    if (i == 0 && !relative && modal_.diameter != Code::diameter_off) value /= 2;
    component(via, i) = (relative ? component(arc.from, i) : 0) + value;
  }
  if (!any)
    return error("arc-no-center", "CIP needs an intermediate point I1= J1= K1=", *arc.where);
  return true;
}

bool PointArcs::through_point(const ArcBlock& arc, SolvedArc& out) {
  Vec3 via;
  if (!via_point(arc, via)) return false;
  const Vec3 end = arc.to.programmed;
  if (distance(arc.from, via) <= kSamePoint || distance(via, end) <= kSamePoint ||
      distance(arc.from, end) <= kSamePoint)
    return error("arc-points-coincide", "CIP needs three different points", *arc.where);
  SpatialArc solved;
  const Fit fit = arc_through(arc.from, via, end, solved);
  const Word* turns = find(Address::turn);
  if (fit == Fit::impossible || (fit == Fit::line && turns && turns->value > 0))
    return error("arc-points-collinear",
                 "the three points of CIP lie on a line and make no circle (alarm 14920)",
                 *arc.where);
  if (fit == Fit::line) {
    take(Address::turn);
    out.kind = SolvedArc::Kind::line;
    return true;
  }
  out.kind = SolvedArc::Kind::arc;
  out.spatial = true;
  out.center = solved.center;
  out.u = normalized(arc.from - solved.center);
  out.v = cross(solved.axis, out.u);
  out.radius = solved.radius;
  out.sweep = solved.sweep;
  return true;
}

// CT is an arc in the active plane, tangent to the previous element. A tangent that leaves the
// plane is projected onto it.
bool PointArcs::tangent(const ArcBlock& arc, SolvedArc& out) {
  if (!position_.has_tangent)
    return error("arc-no-tangent", "CT needs an element before it to be tangent to (alarm 14045)",
                 *arc.where);
  const Vec2 t = in_plane(arc.basis, turn_inverse(arc.frame, position_.tangent));
  const double l = length(t);
  if (l < kRounding)
    return error(
        "arc-no-tangent",
        "the element before CT runs square to the plane: there is no tangent (alarm 14045)",
        *arc.where);
  if (length(arc.end - arc.start) <= kSamePoint)
    return error("arc-points-coincide", "CT needs an end point other than its start", *arc.where);
  const Vec2 unit = (1 / l) * t;
  const Vec2 chord = arc.end - arc.start;
  if (std::abs(cross(unit, chord)) <= kTurnRounding * length(chord) && dot(unit, chord) < 0)
    return error("arc-no-tangent",
                 "the end lies straight behind: no circle reaches it (alarm 14045)", *arc.where);
  const std::optional<PlaneArc> solved = arc_by_tangent(arc.start, unit, arc.end);
  if (solved)
    set_plane_arc(arc, *solved, out);
  else
    out.kind = SolvedArc::Kind::line;
  return true;
}

}  // namespace mrsim
