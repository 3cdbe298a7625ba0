// Circular interpolation: which form a block uses, and what each control does with bad data.
#include "core/units.h"
#include "interp/engine.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

bool Engine::arc_move(const Vec3& from, const Frame& frame) {
  Target to;
  const bool polar = find(Address::ap) || find(Address::rp);
  if (!target(to, from)) return false;
  ArcBlock arc{to, from, frame, basis(), current_motion() == Code::arc_ccw, {}, {}, nullptr};
  arc.where = motion_word(to);
  arc.start = in_plane(arc.basis, from);
  arc.end = in_plane(arc.basis, to.programmed);
  if (current_motion() == Code::arc_point) return three_point_arc(arc);
  if (current_motion() == Code::arc_tangent) return tangent_arc(arc);
  Vec2 center;
  bool centered = false;
  if (!center_words(arc, center, centered)) return false;
  const Word* ar = take(Address::ar);
  const Word* radius = is(Dialect::sinumerik) ? take(Address::cr) : take('R');
  const Word* t = is(Dialect::codesys) ? take('T') : nullptr;
  if (ar && radius)
    return error("arc-overdetermined", "opening angle and radius in one block: one too many",
                 *radius);
  if (ar) return angle_arc(arc, *ar, centered, center);
  if (t && radius)
    warning("arc-overdetermined", "T and the centre give the arc: the radius is not used", *radius);
  if (t) return codesys_angle_arc(arc, *t, centered, center);
  if (radius && centered) {
    if (is(Dialect::sinumerik) || is(Dialect::iso))
      return error("arc-overdetermined", "radius and centre in one block: only one may be given",
                   *radius);
    reporter_.add(is(Dialect::fanuc) ? Severity::note : Severity::warning, "arc-center-ignored",
                  "radius and centre in one block: the radius counts", radius->column,
                  radius->length);
  }
  if (radius) return radius_arc(arc, *radius);
  if (!centered && polar) {
    center = in_plane(arc.basis, position_.pole);
    centered = true;
  }
  if (centered) return center_arc(arc, center);
  const std::string text = "an arc needs a centre or a radius";
  if (is(Dialect::fanuc)) return arc_to_line("arc-no-center", text + " (alarm 022)", arc);
  if (is(Dialect::codesys)) return arc_to_line("arc-no-center", text, arc);
  return error("arc-no-center", text, *arc.where);
}

// CODESYS and FANUC go straight where they cannot make a circle.
bool Engine::arc_to_line(const char* code, const std::string& text, const ArcBlock& arc) {
  warning(code, text + ": a straight line is run instead", *arc.where);
  return line_move(arc.to, arc.frame);
}

// I J K: offsets from the start, or absolute by AC() and CODESYS G98. `given`: at least one word in
// the plane.
bool Engine::center_words(const ArcBlock& arc, Vec2& center, bool& given) {
  Vec3 at = arc.from;
  if (is(Dialect::codesys) && modal_.center_absolute) at = from_plane(arc.basis, {}, 0);
  bool outside = false;
  const Word* odd = nullptr;
  for (int i = 0; i < 3; ++i) {
    const Word* word = take("IJK"[i]);
    if (!word) continue;
    const bool in = modal_.plane == 3 || component(arc.basis.w, i) == 0;
    if (!in) {
      outside = outside || word->value != 0;
      odd = word;
      continue;
    }
    given = true;
    const bool absolute =
        is(Dialect::codesys)
            ? modal_.center_absolute
            : word->form == Form::ac || word->form == Form::dac || word->form == Form::rac;
    double value = word->value * length_unit(*word);
    if (absolute && i == 0 && word->form != Form::rac && modal_.diameter != Code::diameter_off)
      value /= 2;
    component(at, i) = (absolute ? 0 : component(arc.from, i)) + value;
  }
  if (outside)
    return error("arc-center-outside-plane",
                 fmt::format("the centre word lies outside of the plane G{}{}", 17 + modal_.plane,
                             is(Dialect::fanuc) ? " (alarm 021)" : ""),
                 *odd);
  center = in_plane(arc.basis, at);
  return true;
}

bool Engine::radius_arc(ArcBlock& arc, const Word& word) {
  double radius = word.value * length_unit(word);
  const bool same = length(arc.end - arc.start) <= kSamePoint;
  if (is(Dialect::codesys) && radius < 0) {
    warning("arc-radius-negative",
            "a negative radius: its magnitude is used, always the smaller arc", word);
    radius = -radius;
  }
  if (radius == 0) {
    if (is(Dialect::codesys)) return arc_to_line("arc-radius-zero", "the radius is 0", arc);
    return error("arc-radius-zero", "the radius is 0", word);
  }
  if (same && is(Dialect::fanuc)) {
    note_once("arc-no-motion", "radius without a new end point: an arc of 0 degrees, no motion",
              word, fmt::format("{}:{}", block_.line_number, stack_.back().file));
    return true;
  }
  if (same && is(Dialect::codesys)) {
    PlaneArc circle{arc.start + Vec2{radius, 0}, radius, arc.ccw ? kTwoPi : -kTwoPi};
    return finish_arc(circle, arc);
  }
  if (same)
    return error(
        "arc-radius-full-circle",
        fmt::format("start and end are the same point: a full circle needs its centre, not a "
                    "radius{}",
                    is(Dialect::sinumerik) ? " (alarm 14040)" : ""),
        word);
  if (is(Dialect::fanuc) && lathe() && radius < 0)
    return error("arc-radius-negative", "a negative radius is not allowed on lathes (alarm 023)",
                 word);
  const std::optional<PlaneArc> solved = arc_by_radius(arc.start, arc.end, radius, arc.ccw);
  if (!solved) {
    const double chord = length(arc.end - arc.start);
    const std::string text = fmt::format(
        "radius {:.6g} is too small: start and end are {:.6g} apart, so it must be at least "
        "{:.6g}{}",
        std::abs(radius), chord, chord / 2, is(Dialect::sinumerik) ? " (alarm 14095)" : "");
    if (is(Dialect::codesys)) return arc_to_line("arc-radius-too-small", text, arc);
    return error("arc-radius-too-small", text, word);
  }
  return near_half_circle(*solved, word) && finish_arc(*solved, arc);
}

// Near 180 degrees the centre of a radius arc runs away with the last digit.
bool Engine::near_half_circle(const PlaneArc& arc, const Word& word) {
  const double off = std::abs(std::abs(arc.sweep) - kPi);
  const bool exact = off < 1e-6;
  if (is(Dialect::fanuc) && lathe() && std::abs(arc.sweep) >= kPi - 1e-9)
    return error("arc-half-circle", "an arc of 180 degrees or more needs its centre on this lathe",
                 word);
  if (off > radians(1.0) || (exact && !is(Dialect::fanuc))) return true;
  warning("arc-near-180",
          fmt::format("an arc of {:.6g} degrees by its radius: the centre is uncertain, give I J K",
                      degrees(std::abs(arc.sweep))),
          word);
  return true;
}

bool Engine::center_arc(ArcBlock& arc, Vec2 center) {
  if (length(arc.start - center) <= 1e-6) {
    if (is(Dialect::codesys))
      return arc_to_line("arc-center-is-start", "the centre is the start point", arc);
    return error("arc-center-is-start", "the centre is the start point", *arc.where);
  }
  PlaneArc solved;
  if (length(arc.end - arc.start) <= kSamePoint) {
    hint_sign(arc, center);
    solved = arc_about(arc.start, arc.end, center, arc.ccw);
    return finish_arc(solved, arc);
  }
  solved.center = center;
  bool straight = false;
  if (!check_center(arc, solved, straight)) return false;
  return straight || finish_arc(solved, arc);
}

// A full circle whose centre would fall on the zero point with the other sign: "I12.5 puts the
// centre at X25; I-12.5 would close on X0".
void Engine::hint_sign(const ArcBlock& arc, Vec2 center) {
  static constexpr int kFirst[] = {0, 2, 1}, kSecond[] = {1, 0, 2};
  if (modal_.plane > 2 || modal_.center_absolute) return;
  const Vec2 d = center - arc.start, zero = arc.start - d;
  const double far = length(center);
  if (length(zero) > kSamePoint || far <= kSamePoint) return;
  const bool first = std::abs(d.x) >= std::abs(d.y);
  const int axis = first ? kFirst[modal_.plane] : kSecond[modal_.plane];
  const double word = first ? d.x : d.y, at = first ? center.x : center.y;
  note_once("arc-center-sign",
            fmt::format("{0}{1:.6g} puts the centre at {2}{3:.6g}; {0}{4:.6g} would close on {2}0",
                        "IJK"[axis], word, "XYZ"[axis], at, -word),
            *arc.where, fmt::format("{}:{}", stack_.back().file, block_.line_number));
}

// Both radii must agree; how far the control bends, and to what, is DIALECTS' policy table.
bool Engine::check_center(ArcBlock& arc, PlaneArc& solved, bool& straight) {
  const Vec2 c = solved.center, s = arc.start, e = arc.end;
  const double rs = length(s - c), re = length(e - c), differ = std::abs(rs - re);
  const double tolerance = std::max(0.01, 0.001 * rs);
  const Vec2 moved = bisector_center(s, e, c);
  const double shift = length(moved - c), r_moved = length(moved - s);
  const bool near = differ <= tolerance && shift <= tolerance;
  const auto radii = [&] {
    return fmt::format(
        "the radius is {:.6g} at the start and {:.6g} at the end, {:.3g} mm apart ({:.3g} %){}", rs,
        re, differ, 100 * differ / rs, sign_hint(arc, c));
  };
  if (is(Dialect::sinumerik)) {
    const double turn = std::abs(cross(moved - s, c - s)) / (rs * std::max(r_moved, 1e-12));
    if (!near || turn > 0.0316227766)
      return error("arc-radii-differ", radii() + " (alarm 14040)", *arc.where);
  } else if (differ > tolerance) {
    const double share = is(Dialect::codesys) ? shift / std::max(r_moved, 1e-12) : differ / rs;
    if (is(Dialect::fanuc)) return error("arc-radii-differ", radii() + " (alarm 020)", *arc.where);
    if (share > 0.10 && is(Dialect::iso)) return error("arc-radii-differ", radii(), *arc.where);
    if (share > 0.10) {
      straight = true;
      return arc_to_line("arc-radii-differ", radii(), arc);
    }
    warning("arc-center-moved",
            fmt::format("{}: the centre is moved by {:.3g} mm to the bisector", radii(), shift),
            *arc.where);
  } else if (shift > tolerance) {
    // Nearly a full or an empty circle: the bisector says nothing about the centre. Keep it, and
    // close the hair's breadth to the end with a line.
    solved = arc_about(s, e, c, arc.ccw);
    arc.closing = true;
    return true;
  }
  solved = arc_about(s, e, moved, arc.ccw);
  return true;
}

// "I12.5 puts the centre at X25; I-12.5 would close on X0": a sign that makes the radii agree.
std::string Engine::sign_hint(const ArcBlock& arc, Vec2 c) const {
  const Vec2 d = c - arc.start;
  for (const Vec2 flip : {Vec2{-1, 1}, Vec2{1, -1}, Vec2{-1, -1}}) {
    const Vec2 other = arc.start + Vec2{flip.x * d.x, flip.y * d.y};
    if (other == c) continue;
    const double rs = length(arc.start - other), re = length(arc.end - other);
    if (std::abs(rs - re) > 0.02 * rs) continue;
    const int first = modal_.plane == 0 ? 0 : modal_.plane == 1 ? 2 : 1;
    const int second = (first + 1) % 3;
    std::string words;
    if (flip.x < 0 && d.x != 0) words += fmt::format("{}{:.6g}", "IJK"[first], -d.x);
    if (flip.y < 0 && d.y != 0)
      words += fmt::format("{}{}{:.6g}", words.empty() ? "" : " ", "IJK"[second], -d.y);
    return fmt::format("; {} would give {:.6g} and {:.6g}, is a sign wrong?", words, rs, re);
  }
  return {};
}

// AR=: opening angle with the end point, or with the centre.
bool Engine::angle_arc(ArcBlock& arc, const Word& word, bool centered, Vec2 center) {
  if (!(word.value > 0 && word.value < 360))
    return error(
        "arc-angle-range",
        fmt::format("AR={:g}: the opening angle is above 0 and below 360 degrees (alarm 14910)",
                    word.value),
        word);
  const bool ends = named_along(arc.to, arc.basis.u) || named_along(arc.to, arc.basis.v);
  if (centered && ends)
    return error("arc-overdetermined", "AR= with centre and end point: one too many (alarm 14900)",
                 word);
  const double angle = radians(word.value);
  if (centered) return turned_arc(arc, center, angle);
  if (length(arc.end - arc.start) <= kSamePoint)
    return error("arc-angle-no-end", "AR= needs an end point other than the start, or a centre",
                 word);
  return finish_arc(arc_by_angle(arc.start, arc.end, angle, arc.ccw), arc);
}

// The end follows from centre and angle.
bool Engine::turned_arc(ArcBlock& arc, Vec2 center, double angle) {
  if (length(arc.start - center) <= 1e-6) {
    if (is(Dialect::codesys))
      return arc_to_line("arc-center-is-start", "the centre is the start point", arc);
    return error("arc-center-is-start", "the centre is the start point", *arc.where);
  }
  const double sweep = arc.ccw ? angle : -angle;
  const double turns = angle / kTwoPi;
  const bool whole = turns == std::floor(turns);
  const Vec2 end = whole ? arc.start : rotated(arc.start, center, sweep);
  arc.end = end;
  arc.to.programmed = from_plane(arc.basis, end, dot(arc.to.programmed, arc.basis.w));
  for (int i = 0; i < 3; ++i)
    if (std::abs(component(arc.basis.u, i)) + std::abs(component(arc.basis.v, i)) > 0)
      arc.to.named |= position_.known & (1U << i);
  return finish_arc({center, length(arc.start - center), sweep}, arc);
}

bool Engine::codesys_angle_arc(ArcBlock& arc, const Word& t, bool centered, Vec2 center) {
  if (!(t.value > 0 && t.value <= 1080))
    return error(
        "arc-angle-range",
        fmt::format("T{:g}: the opening angle is above 0 and at most 1080 degrees", t.value), t);
  if (!centered)
    return arc_to_line("arc-no-center", "T is the opening angle and needs the centre I J K", arc);
  if (named_along(arc.to, arc.basis.u) || named_along(arc.to, arc.basis.v)) {
    warning("arc-overdetermined", "T gives the end point: the end in the plane is not used", t);
    const double height = dot(arc.to.programmed, arc.basis.w);
    arc.to.programmed = from_plane(arc.basis, arc.start, height);
  }
  return turned_arc(arc, center, radians(t.value));
}

// TURN=: full circles before the programmed arc.
bool Engine::add_turns(PlaneArc& arc) {
  const Word* word = take(Address::turn);
  if (!word) return true;
  if (word->value < 0 || word->value > 999 || word->value != std::floor(word->value))
    return error("arc-turns", "TURN is a whole number from 0 to 999 (alarm 14048)", *word);
  arc.sweep += (arc.sweep < 0 ? -kTwoPi : kTwoPi) * word->value;
  return true;
}

bool Engine::finish_arc(PlaneArc solved, ArcBlock& arc) {
  if (!add_turns(solved)) return false;
  const Vec3 u = turn(arc.frame, arc.basis.u), v = turn(arc.frame, arc.basis.v);
  const double su = length(u), sv = length(v);
  if (std::abs(su - sv) > 1e-9 * su || std::abs(dot(u, v)) > 1e-9 * su * sv)
    return error(
        "arc-scaled-unequally",
        fmt::format("the scale is {:.6g} and {:.6g} in the plane: the arc would be an ellipse", su,
                    sv),
        *arc.where);
  Motion motion = motion_template(*arc.where, MotionKind::arc);
  const Vec3 normal = normalized(cross(u, v));
  motion.center =
      apply(arc.frame, from_plane(arc.basis, solved.center, dot(arc.from, arc.basis.w)));
  motion.axis = normal;
  motion.radius = solved.radius * su;
  motion.sweep = solved.sweep;
  Target end = arc.to;
  if (arc.closing) {
    const Vec2 out = arc.end - solved.center;
    end.programmed = from_plane(arc.basis, solved.center + (solved.radius / length(out)) * out,
                                dot(arc.to.programmed, arc.basis.w));
  }
  commit(end, arc.frame, motion);
  motion.rise = dot(motion.end - motion.start, normal);
  if (std::abs(motion.rise) < 1e-12) motion.rise = 0;
  normalise_axis(motion);
  position_.tangent = arc_tangent(motion, 1);
  position_.has_tangent = true;
  if (!start_compensation(motion, *arc.where)) return false;
  emit(motion);
  if (!arc.closing) return true;
  Motion rest = motion_template(*arc.where, MotionKind::line);
  commit(arc.to, arc.frame, rest);
  emit(rest);
  return true;
}

}  // namespace mrsim
