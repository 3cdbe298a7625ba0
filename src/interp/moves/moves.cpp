#include "interp/moves/moves.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

bool Moves::run() {
  if (block_.suppress_frames) return machine_move();
  const Code code = current_motion();
  if (code == Code::probe) return probe();
  if (is(Dialect::ngc) && block_.ends_cycle && !block_.motion_code)
    return error("motion-missing", "axis words beside G80, which ends the motion in force",
                 *block_.ends_cycle);
  if (code == Code::motion_off) return refuse_without_motion();
  const Frame frame = frame_words_.now();
  const Vec3 from = position_.programmed;
  const Word* ang = find(angle_address());
  if (pending_angle_.active && !ang) {
    pending_angle_.active = false;
    return error(
        "angle-incomplete",
        "the block before gives only an angle, so this one needs an angle and both coordinates",
        block_.words.front());
  }
  if (code == Code::nurbs) return splines_.control_point(from);
  if (splines_.under_way() && code != Code::nurbs_end) {
    splines_.forget();
    return error("nurbs-open", "a NURBS is open: G5.3 closes it", block_.words.front());
  }
  if (code == Code::nurbs_end && !block_.motion_code) return refuse_without_motion();
  if (code == Code::spline_cubic || code == Code::spline_quadratic || code == Code::nurbs_end)
    return spline(from, frame);
  position_.after_spline = false;
  if (!is_circular(code)) return straight(from, frame, ang);
  if (ang) return error("angle-line-only", "the angle of a line is for straight lines only", *ang);
  return arc(from, frame);
}

bool Moves::refuse_without_motion() {
  return error("motion-missing", "axis words, and no motion is in force: G0 or G1 before them",
               block_.words.front());
}

// A line, a rapid or a thread. `ang`: the line's angle, or null.
bool Moves::straight(const Vec3& from, const Frame& frame, const Word* ang) {
  const Code code = current_motion();
  Target to;
  if (!axes_.target(to, from)) return false;
  if (ang) {
    const Basis b = basis();
    const bool u = named_along(to, b.u), v = named_along(to, b.v);
    if (!u && !v && !pending_angle_.active) return hold_angle(*ang);
    if (pending_angle_.active) return two_angle_lines(to, from, frame);
    if (!axes_.angle_target(to, from)) return false;
  }
  if (to.named.empty()) return true;
  if (is_thread(code) && !threads_.take_lead(to, from)) return false;
  if (!line(to, frame)) return false;
  if (code != Code::tap_return) return true;
  to.programmed = from;  // and out again
  return line(to, frame);
}

// G53 and SUPA move in machine coordinates. Without a machine zero only the machine knows where
// that is, so the move is neither swept nor checked.
bool Moves::machine_move() {
  const Frame machine = shift_frame(control_.machine_shift);
  Target to;
  if (!axes_.target(to, apply_inverse(machine, position_.physical))) return false;
  if (modal_.incremental && is(Dialect::ngc))
    return error("machine-incremental", "G53 does not go with G91", *axes_.motion_word(to));
  const bool undecided = modal_.incremental && !is(Dialect::sinumerik);
  if (undecided)
    reporter_.once(Severity::warning, "machine-incremental",
                   "G53 in G91 moves nothing on some controls, and on others the axis to its place "
                   "of the machine: where it is counts as unknown until it is given again; write "
                   "G90",
                   *axes_.motion_word(to), "incremental");
  if (control_.machine_known && !undecided && !is_circular(current_motion()))
    return line(to, machine);
  unknown(to.named, *axes_.motion_word(to));
  return true;
}

// G38.2 and its kin, and G31: the tool stops somewhere on its way.
bool Moves::probe() {
  Target to;
  if (!axes_.target(to, position_.programmed)) return false;
  forget_place(to.named);
  note_once("probe",
            "a probing move stops where it touches: it is not run, and its axes' position is "
            "unknown until they are given again",
            *axes_.motion_word(to), "probe");
  return true;
}

void Moves::to_place(const Vec3* place, AxisSet axes, const Word& where) {
  if (!control_.machine_known || !place) return unknown(axes, where);
  to_stored(*place + control_.machine_shift, axes, where);
}

void Moves::to_stored(const Vec3& place, AxisSet axes, const Word& where) {
  Target to;
  to.programmed = position_.physical;
  to.named = axes;
  for (int i = 0; i < 3; ++i)
    if (axes.has(i)) component(to.programmed, i) = component(place, i);
  to.programmed = apply_inverse(frames_.total, to.programmed);
  if (!axes.empty()) step(to, where, MotionKind::rapid);
}

void Moves::guess_retract(const Word& where) {
  const bool change = where.value == 6;
  const bool known = position_.known.has(kAxisZ);
  if (change && !known) return;
  retract_guessed_ = known;
  position_.known -= kAxisZ;
  note_once("reference-point",
            change ? fmt::format("{} takes Z up to where tools are changed, unless a cut is next",
                                 text_of(where))
                   : fmt::format("{} is read as a retract of Z, as on Centroid and Hurco mills, "
                                 "unless a cut is next",
                                 text_of(where)),
            where, change ? "change" : "retract");
}

void Moves::unknown(AxisSet axes, const Word& where) {
  if (!lathe() && out_.ends_in_cut() && !axes.empty() && !axes.has(kAxisZ))
    reporter_.once(Severity::warning, "leaves-in-cut",
                   "the tool is in a cut here: its way to a place of the machine may lead through "
                   "the part, and is neither swept nor checked; lift Z first",
                   where, fmt::format("leaves:{}:{}", block_.file, block_.line_number));
  if (axes.has(kAxisZ)) retract_guessed_ = false;
  forget_place(axes);
  if (!axes.empty()) out_.leave_part();
  position_.has_tangent = false;
  note_once("reference-point",
            "machine coordinates and reference points lie outside of the program: the axes' "
            "position is unknown until they are given again",
            where, "reference");
}

bool Moves::line(const Target& to, const Frame& frame) {
  const Word* where = axes_.motion_word(to);
  const MotionKind kind = current_motion() == Code::rapid ? MotionKind::rapid : MotionKind::line;
  Motion motion = motion_template(*where, kind, lead_in_force());
  commit(to, frame, motion);
  if (!compensation_.begin_move(motion, *where)) return false;
  out_.emit(motion);
  return true;
}

bool Moves::arc(const Vec3& from, const Frame& frame) {
  SolvedArc arc;
  if (!arcs_.solve(from, frame, arc)) return false;
  if (arc.kind == SolvedArc::Kind::none) return true;
  return arc.kind == SolvedArc::Kind::line ? line(arc.to, frame) : emit_arc(arc, frame);
}

bool Moves::spline(const Vec3& from, const Frame& frame) {
  std::vector<SolvedArc> pieces;
  const bool nurbs = current_motion() == Code::nurbs_end;
  if (!(nurbs ? splines_.close(from, pieces) : splines_.solve(from, pieces))) return false;
  for (SolvedArc& piece : pieces) {
    // Each piece starts where the one before ended.
    const bool ok =
        piece.kind == SolvedArc::Kind::line ? line(piece.to, frame) : emit_arc(piece, frame);
    if (!ok) return false;
  }
  position_.after_spline = current_motion() == Code::spline_cubic;
  return true;
}

bool Moves::emit_arc(const SolvedArc& arc, const Frame& frame, double feed) {
  const Vec3 u = turn(frame, arc.u), v = turn(frame, arc.v);
  const double su = length(u), sv = length(v);
  if (plane_scale(frame, arc.u, arc.v) == 0)
    return error("arc-scaled-unequally",
                 arc.spatial
                     ? std::string("the frame scales the arc's plane unequally: it would be an "
                                   "ellipse")
                     : fmt::format("the scale is {:.6g} and {:.6g} in the plane: the arc would be "
                                   "an ellipse",
                                   su, sv),
                 *arc.where);
  Motion motion = motion_template(*arc.where, MotionKind::arc, 0, feed);
  motion.center = apply(frame, arc.center);
  motion.axis = normalized(cross(u, v));
  motion.radius = arc.radius * su;
  motion.sweep = arc.sweep;
  Target end = arc.to;
  if (arc.closing) end.programmed = arc.arc_end;
  commit(end, frame, motion);
  if (!arc.spatial) motion.rise = dot(motion.end - motion.start, motion.axis);
  constexpr double kNoRise = 1e-12;  // mm: rounding of the turn into the frame
  if (std::abs(motion.rise) < kNoRise) motion.rise = 0;
  normalise_axis(motion);
  position_.tangent = arc_tangent(motion, 1);
  position_.has_tangent = true;
  if (!compensation_.begin_move(motion, *arc.where)) return false;
  out_.emit(motion);
  if (!arc.closing) return true;
  Motion rest = motion_template(*arc.where, MotionKind::line);
  commit(arc.to, frame, rest);
  out_.emit(rest);
  return true;
}

void Moves::step(const Target& to, const Word& where, MotionKind kind, double lead, double feed) {
  Motion motion = motion_template(where, kind, lead, feed);
  commit(to, frame_words_.now(), motion);
  out_.emit(motion);
}

bool Moves::compensated_step(const Target& to, const Word& where, double feed, MotionKind kind) {
  Motion motion = motion_template(where, kind, 0, feed);
  commit(to, frame_words_.now(), motion);
  if (!compensation_.begin_move(motion, where)) return false;
  out_.emit(motion, {});
  return true;
}

void Moves::follow(const Motion& like, const Vec3& shift, const Word& where) {
  const Motion own = motion_template(where, like.kind);
  Motion motion = like;
  motion.start = own.start;
  motion.assumed_start = own.assumed_start;
  motion.tool = own.tool;
  motion.feed = own.feed;
  motion.feed_unit = own.feed_unit;
  motion.speed = own.speed;
  motion.speed_limit = own.speed_limit;
  motion.constant_surface_speed = own.constant_surface_speed;
  motion.end = like.end + shift;
  motion.center = like.center + shift;
  position_.physical = motion.end;
  position_.programmed = apply_inverse(frames_.total, motion.end);
  position_.has_tangent = false;
  out_.emit(motion, {});
}

void Moves::jump(const Target& to) {
  Motion unused;
  commit(to, frame_words_.now(), unused);
  position_.has_tangent = false;
}

void Moves::finish() {
  if (splines_.under_way())
    reporter_.add_at(Severity::error, "nurbs-open",
                     "the program ends inside the NURBS that begins here: G5.3 closes it",
                     splines_.opening());
  if (!pending_angle_.active) return;
  reporter_.add_at(Severity::error, "angle-incomplete",
                   "the program ends after a block that gives only an angle",
                   pending_angle_.motion);
}

// The first of two blocks ANG=a1, ANG=a2 X Z: its end is known with the second.
bool Moves::hold_angle(const Word& ang) {
  take(angle_address());
  pending_angle_.active = true;
  pending_angle_.angle = angle_value(ang);
  pending_angle_.motion = motion_template(block_.motion_code ? *block_.motion_code : ang,
                                          MotionKind::line, lead_in_force());
  pending_angle_.corner = out_.corner_spec();
  return true;
}

bool Moves::two_angle_lines(const Target& to, const Vec3& from, const Frame& frame) {
  const Word& ang = *take(angle_address());
  pending_angle_.active = false;
  const Basis b = basis();
  if (!named_along(to, b.u) || !named_along(to, b.v))
    return error("angle-coordinates", "the second angle needs both end coordinates", ang);
  const SinCos a = sincos_deg(pending_angle_.angle), c = sincos_deg(angle_value(ang));
  const Vec2 d1{a.cos, a.sin}, d2{c.cos, c.sin};
  const Vec2 s = in_plane(b, from), e = in_plane(b, to.programmed);
  const double det = cross(d1, d2);
  if (std::abs(det) < kTurnRounding)
    return error("angle-parallel", "the two lines are parallel and have no corner", ang);
  const double t = cross(e - s, d2) / det, rest = cross(d1, e - s) / det;
  if ((t < 0 || rest < 0) && !angle_of_slope(ang))
    return error("angle-behind", "the two lines meet behind their ends", ang);
  Target middle = to;
  middle.programmed = from_plane(b, s + t * d1, dot(from, b.w));
  Motion first = pending_angle_.motion;
  first.start = position_.physical;
  commit(middle, frame, first);
  if (!compensation_.begin_move(first, ang)) return false;
  out_.emit(first, pending_angle_.corner);
  Motion second = motion_template(*axes_.motion_word(to), MotionKind::line, lead_in_force());
  commit(to, frame, second);
  out_.emit(second);
  return true;
}

Motion Moves::motion_template(const Word& where, MotionKind kind, double lead, double feed) {
  if (kind == MotionKind::line && tools_.only_touches(where)) kind = MotionKind::rapid;
  if (kind == MotionKind::rapid)
    tools_.require(where, modal_.comp != Code::comp_off);  // its radius counts from here on
  else
    begin_cut(where, feed > 0 || lead != 0);
  if (kind != MotionKind::rapid &&
      retract_guessed_) {  // the cut begins where Z was, so M25 was no retract
    position_.known |= kAxisZ;
    retract_guessed_ = false;
  }
  Motion m;
  m.kind = kind;
  m.feed_unit = modal_.feed_unit;
  m.constant_surface_speed = modal_.surface_speed;
  m.assumed_start = position_.known != kAllAxes;
  m.start = position_.physical;
  m.tool = control_.tool.index;
  m.feed = feed > 0 ? feed : modal_.feed;
  m.speed = modal_.surface_speed ? modal_.cutting_speed : modal_.speed;
  // FANUC and LinuxCNC limit what G96 computes, SINUMERIK every speed.
  if (modal_.surface_speed || is(Dialect::sinumerik)) m.speed_limit = modal_.speed_limit;
  m.lead = lead;
  m.file = block_.file;
  m.line = block_.line_number;
  m.column = where.column + 1;
  m.call = block_.call;
  return m;
}

// Checks what a cut needs: a tool, and a feed, which is asked for once.
void Moves::begin_cut(const Word& where, bool has_feed) {
  tools_.require(where, true);
  if (!frames_.work_given) compare_origins(where);
  if (modal_.feed != 0 || feed_warned_ || has_feed) return;
  feed_warned_ = true;
  reporter_.add(
      is(Dialect::ngc) ? Severity::error : Severity::warning, "feed-missing",
      is(Dialect::fanuc) ? "no F before the first cut (alarm 011)" : "no F before the first cut",
      where);
}

// Warns of two work offsets without entries: two vises, or two sides of a part, in the same place.
void Moves::compare_origins(const Word& where) {
  if (assumed_origin_.empty()) assumed_origin_ = frames_.work_name;
  if (assumed_origin_ == frames_.work_name) return;
  reporter_.once(
      Severity::warning, "origins-coincide",
      fmt::format("{0} and {1} both cut, and neither is in the tool table: their cuts lie in one "
                  "place. [work.{1}] of --tools tools.toml says where it is; --until ends the run "
                  "before another side of the part",
                  assumed_origin_, frames_.work_name),
      where, "origins-coincide");
}

// Moves the position to the target. motion.end becomes its place in the stock's coordinates.
void Moves::commit(const Target& to, const Frame& frame, Motion& motion) {
  Vec3 end = position_.physical;
  if (frame.plain) {
    for (int i = 0; i < 3; ++i)
      if (to.named.has(i))
        component(end, i) = component(to.programmed, i) + component(frame.shift, i);
  } else {
    end = apply(frame, to.programmed);
  }
  motion.end = end;
  const Basis b = basis();
  if (length(in_plane(b, to.programmed - position_.programmed)) > kSamePoint) {
    position_.before = position_.programmed;
    position_.has_before = position_.known == kAllAxes && motion.kind != MotionKind::rapid;
  }
  position_.physical = end;
  position_.programmed = block_.suppress_frames ? apply_inverse(frames_.total, end) : to.programmed;
  position_.known |= to.named;
  position_.moved_frame -= to.named;
  if (motion.kind != MotionKind::arc) {
    const Vec3 d = end - motion.start;
    const double l = length(d);
    if (l > kRounding) {
      position_.tangent = (1 / l) * d;
      position_.has_tangent = true;
    }
  }
}

}  // namespace mrsim
