// Arcs that are not bound to centre or radius words: CIP through a point in space, CT tangent to
// the element before.
#include "interp/engine.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {

// The intermediate point: I1= J1= K1=, G90/G91 as for the end point, both from the start.
bool Engine::via_point(const ArcBlock& arc, Vec3& via) {
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
    // As PRIMER's turning family prints it: absolute X is a diameter, increments are radii.
    if (i == 0 && !relative && modal_.diameter != Code::diameter_off) value /= 2;
    component(via, i) = (relative ? component(arc.from, i) : 0) + value;
  }
  if (!any)
    return error("arc-no-center", "CIP needs an intermediate point I1= J1= K1=", *arc.where);
  return true;
}

bool Engine::three_point_arc(ArcBlock& arc) {
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
    return line_move(arc.to, arc.frame);
  }
  PlaneArc sweep{{}, solved.radius, solved.sweep};
  return add_turns(sweep) && emit_spatial_arc(arc, solved, sweep.sweep);
}

bool Engine::emit_spatial_arc(ArcBlock& arc, const SpatialArc& solved, double sweep) {
  const Vec3 radial = normalized(arc.from - solved.center);
  const Vec3 u = turn(arc.frame, radial), v = turn(arc.frame, cross(solved.axis, radial));
  const double su = length(u), sv = length(v);
  if (std::abs(su - sv) > 1e-9 * su || std::abs(dot(u, v)) > 1e-9 * su * sv)
    return error("arc-scaled-unequally",
                 "the frame scales the arc's plane unequally: it would be an "
                 "ellipse",
                 *arc.where);
  Motion motion = motion_template(*arc.where, MotionKind::arc);
  motion.center = apply(arc.frame, solved.center);
  motion.axis = normalized(cross(u, v));
  motion.radius = solved.radius * su;
  motion.sweep = sweep;
  commit(arc.to, arc.frame, motion);
  normalise_axis(motion);
  position_.tangent = arc_tangent(motion, 1);
  position_.has_tangent = true;
  if (!start_compensation(motion, *arc.where)) return false;
  emit(motion);
  return true;
}

// CT: in the active plane, tangent to the previous element; a tangent out of the plane is
// projected.
bool Engine::tangent_arc(ArcBlock& arc) {
  if (!position_.has_tangent)
    return error("arc-no-tangent", "CT needs an element before it to be tangent to (alarm 14045)",
                 *arc.where);
  const Vec2 t = in_plane(arc.basis, turn_inverse(arc.frame, position_.tangent));
  const double l = length(t);
  if (l < 1e-9)
    return error(
        "arc-no-tangent",
        "the element before CT runs square to the plane: there is no tangent (alarm 14045)",
        *arc.where);
  if (length(arc.end - arc.start) <= kSamePoint)
    return error("arc-points-coincide", "CT needs an end point other than its start", *arc.where);
  const Vec2 unit = (1 / l) * t;
  const Vec2 chord = arc.end - arc.start;
  if (std::abs(cross(unit, chord)) <= 1e-9 * length(chord) && dot(unit, chord) < 0)
    return error("arc-no-tangent",
                 "the end lies straight behind: no circle reaches it (alarm 14045)", *arc.where);
  const std::optional<PlaneArc> solved = arc_by_tangent(arc.start, unit, arc.end);
  if (solved) return finish_arc(*solved, arc);
  return line_move(arc.to, arc.frame);
}

}  // namespace mrsim
