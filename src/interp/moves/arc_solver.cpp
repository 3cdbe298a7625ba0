#include "interp/moves/arc_solver.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

// The radii at start and end may differ by the larger of a length and a share of the radius
// (SINUMERIK's MD21000 and MD21010 at their defaults).
constexpr double kRadiiApart = 0.01, kRadiiShare = 0.001;  // mm; of the radius
// On LinuxCNC they may differ by 2 sqrt(2) times 0.01 mm or 0.001 inch, or by the share above. A
// hundred times that is always a fault.
constexpr double kSpiralApart = 0.0282842712, kSpiralApartInch = 0.00282842712 * 25.4;  // mm
// Moving the centre may turn the start of an arc by sqrt(0.001) radians, 1.8 degrees (SINUMERIK,
// alarm 14040).
constexpr double kMostTurn = 0.0316227766;
constexpr double kNoRadius = 1e-6;       // mm: a centre this near to the start is the start
constexpr double kLeastDivisor = 1e-12;  // mm: no division by the radius 0
constexpr double kMostMoved = 0.10;  // share of the radius: how far other controls move the centre
// A radius may be less than half the chord. A difference up to the first share of it is rounding of
// numbers, which arc_by_radius() accepts. A difference up to the larger of a length (mm) and the
// second share comes from posts that round (docs/interp.md).
constexpr double kRadiusRounding = 1e-6, kRadiusShort = 0.005, kRadiusShortShare = 0.0005;
constexpr double kExactHalf = 1e-6;  // rad: an arc this near to half a turn is meant to be one

}  // namespace

bool ArcSolver::solve(const Vec3& from, const Frame& frame, SolvedArc& out) {
  Target to;
  if (!axes_.target(to, from)) return false;
  ArcBlock arc{to, from, frame, basis(), current_motion() == Code::arc_ccw, {}, {}, nullptr};
  arc.where = axes_.motion_word(to);
  arc.start = in_plane(arc.basis, from);
  arc.end = in_plane(arc.basis, to.programmed);
  out.to = to;
  out.where = arc.where;
  const bool ok = current_motion() == Code::arc_point     ? points_.through_point(arc, out)
                  : current_motion() == Code::arc_tangent ? points_.tangent(arc, out)
                                                          : solve_form(arc, out);
  return ok && (out.kind != SolvedArc::Kind::arc || turns_.add(out));
}

// Solves the circle by the words that the block has: a centre, a radius or an angle.
bool ArcSolver::solve_form(ArcBlock& arc, SolvedArc& out) {
  const bool polar = find(Address::ap) || find(Address::rp);
  Vec2 center;
  bool centered = false;
  if (!center_words(arc, center, centered)) return false;
  const Word* ar = take(Address::ar);
  const Word* radius = is(Dialect::sinumerik) ? take(Address::cr) : take('R');
  if (!radius && !centered) radius = okuma_radius();
  const Word* t = is(Dialect::codesys) ? take('T') : nullptr;
  if (ar && radius)
    return error("arc-overdetermined", "opening angle and radius in one block: one too many",
                 *radius);
  if (ar) return angle_arc(arc, *ar, centered, center, out);
  if (t && radius)
    warning("arc-overdetermined", "T and the centre give the arc: the radius is not used", *radius);
  if (t) return codesys_angle_arc(arc, *t, centered, center, out);
  if (radius && centered) {
    if (is(Dialect::sinumerik) || is(Dialect::iso) || is(Dialect::ngc))
      return error("arc-overdetermined", "radius and centre in one block: only one may be given",
                   *radius);
    reporter_.add(is(Dialect::fanuc) ? Severity::note : Severity::warning, "arc-center-ignored",
                  "radius and centre in one block: the radius counts", radius->column,
                  radius->length);
  }
  if (radius) return radius_arc(arc, *radius, out);
  if (!centered && polar) {
    center = in_plane(arc.basis, position_.pole);
    centered = true;
  }
  if (centered) return center_arc(arc, center, out);
  const std::string text = "an arc needs a centre or a radius";
  if (is(Dialect::fanuc)) return straight("arc-no-center", text + " (alarm 022)", arc, out);
  if (is(Dialect::codesys)) return straight("arc-no-center", text, arc, out);
  return error("arc-no-center", text, *arc.where);
}

// L5 of "G2 X Z L5" is the radius on Okuma's lathes.
const Word* ArcSolver::okuma_radius() {
  const Word* word = lathe() && is(Dialect::fanuc) ? take('L') : nullptr;
  if (word)
    note_once(
        "okuma-radius",
        fmt::format("{} is read as the radius of the arc, as on Okuma's lathes", text_of(*word)),
        *word, "L");
  return word;
}

// CODESYS and FANUC move on a straight line where they cannot make a circle.
bool ArcSolver::straight(const char* code, const std::string& text, const ArcBlock& arc,
                         SolvedArc& out) {
  warning(code, text + ": a straight line is run instead", *arc.where);
  out.kind = SolvedArc::Kind::line;
  out.to = arc.to;
  return true;
}

// I J K are offsets from the start, or absolute by AC() and CODESYS G98. `given`: the block has at
// least one of them in the plane.
bool ArcSolver::center_words(const ArcBlock& arc, Vec2& center, bool& given) {
  Vec3 at = arc.from;
  if (!is(Dialect::sinumerik) && modal_.center_absolute) at = from_plane(arc.basis, {}, 0);
  bool outside = false;
  const Word* odd = nullptr;
  for (int i = 0; i < 3; ++i) {
    const Word* word = take("IJK"[i]);
    if (!word) continue;
    const bool in = modal_.plane == kPlaneOfNormal || component(arc.basis.w, i) == 0;
    if (!in && turns_.is_pitch(arc.to, arc.basis.w)) continue;
    if (!in) {
      outside = outside || word->value != 0;
      odd = word;
      continue;
    }
    given = true;
    const bool absolute =
        is(Dialect::sinumerik)
            ? word->form == Form::ac || word->form == Form::dac || word->form == Form::rac
            : modal_.center_absolute || word->form == Form::ac;
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
  return !given || center_complete(arc);
}

// A centre as a place needs both coordinates. An offset that is left out is 0.
bool ArcSolver::center_complete(const ArcBlock& arc) {
  if (!is(Dialect::ngc) || !modal_.center_absolute) return true;
  for (int i = 0; i < 3; ++i)
    if (component(arc.basis.w, i) == 0 && !find(letter("IJK"[i])))
      return error("arc-no-center",
                   fmt::format("{} is missing: in G90.1 the centre is a place, and needs both of "
                               "its coordinates",
                               "IJK"[i]),
                   *arc.where);
  return true;
}

bool ArcSolver::radius_arc(ArcBlock& arc, const Word& word, SolvedArc& out) {
  double radius = word.value * length_unit(word);
  const bool same = length(arc.end - arc.start) <= kSamePoint;
  if (is(Dialect::codesys) && radius < 0) {
    warning("arc-radius-negative",
            "a negative radius: its magnitude is used, always the smaller arc", word);
    radius = -radius;
  }
  if (radius == 0) {
    if (is(Dialect::codesys)) return straight("arc-radius-zero", "the radius is 0", arc, out);
    return error("arc-radius-zero", "the radius is 0", word);
  }
  if (same) return same_point_radius(arc, word, radius, out);
  if (is(Dialect::fanuc) && lathe() && radius < 0)
    return error("arc-radius-negative", "a negative radius is not allowed on lathes (alarm 023)",
                 word);
  const std::optional<PlaneArc> solved = arc_of_radius(arc, radius, word);
  if (!solved) {
    const double chord = length(arc.end - arc.start);
    const std::string text = fmt::format(
        "radius {:.6g} is too small: start and end are {:.6g} apart, so it must be at least "
        "{:.6g}{}",
        std::abs(radius), chord, chord / 2, is(Dialect::sinumerik) ? " (alarm 14095)" : "");
    if (is(Dialect::codesys)) return straight("arc-radius-too-small", text, arc, out);
    return error("arc-radius-too-small", text, word);
  }
  if (!near_half_circle(*solved, word)) return false;
  set_plane_arc(arc, *solved, out);
  return true;
}

// The block has a radius and no new end point.
bool ArcSolver::same_point_radius(ArcBlock& arc, const Word& word, double radius, SolvedArc& out) {
  if (is(Dialect::fanuc)) {
    note_once("arc-no-motion", "radius without a new end point: an arc of 0 degrees, no motion",
              word, fmt::format("{}:{}", block_.line_number, block_.file));
    return true;
  }
  if (is(Dialect::codesys)) {
    PlaneArc circle{arc.start + Vec2{radius, 0}, radius, arc.ccw ? kTwoPi : -kTwoPi};
    set_plane_arc(arc, circle, out);
    return true;
  }
  return error(
      "arc-radius-full-circle",
      fmt::format("start and end are the same point: a full circle needs its centre, not a "
                  "radius{}",
                  is(Dialect::sinumerik) ? " (alarm 14040)" : ""),
      word);
}

// A radius that rounding has made smaller than half the chord becomes half the chord: half a turn.
std::optional<PlaneArc> ArcSolver::arc_of_radius(const ArcBlock& arc, double radius,
                                                 const Word& word) {
  const double half = length(arc.end - arc.start) / 2;
  const double missing = half - std::abs(radius);
  if (missing <= kRadiusRounding * half ||
      missing > std::max(kRadiusShort, kRadiusShortShare * half))
    return arc_by_radius(arc.start, arc.end, radius, arc.ccw);
  reporter_.add(Severity::note, "arc-radius-rounded",
                fmt::format("radius {:.6g} is {:.3g} mm less than half the chord: half a turn with "
                            "radius {:.6g}",
                            std::abs(radius), missing, half),
                word);
  return arc_by_radius(arc.start, arc.end, radius < 0 ? -half : half, arc.ccw);
}

// Near 180 degrees the last digit of the radius moves the centre far.
bool ArcSolver::near_half_circle(const PlaneArc& arc, const Word& word) {
  const double off = std::abs(std::abs(arc.sweep) - kPi);
  const bool exact = off < kExactHalf;
  if (is(Dialect::fanuc) && lathe() && std::abs(arc.sweep) >= kPi - kTurnRounding)
    return error("arc-half-circle", "an arc of 180 degrees or more needs its centre on this lathe",
                 word);
  if (off > radians(2.0) || (exact && !is(Dialect::fanuc))) return true;
  const std::string text =
      fmt::format("an arc of {:.6g} degrees by its radius: the centre is uncertain, give I J K",
                  degrees(std::abs(arc.sweep)));
  if (exact)
    reporter_.once(Severity::warning, "arc-near-180", text, word, "arc-near-180");
  else
    warning("arc-near-180", text, word);
  return true;
}

bool ArcSolver::center_arc(ArcBlock& arc, Vec2 center, SolvedArc& out) {
  if (length(arc.start - center) <= kNoRadius) {
    if (is(Dialect::codesys))
      return straight("arc-center-is-start", "the centre is the start point", arc, out);
    return error("arc-center-is-start", "the centre is the start point", *arc.where);
  }
  if (length(arc.end - arc.start) > kSamePoint) return check_center(arc, center, out);
  hints_.full_circle(arc, center);
  set_plane_arc(arc, arc_about(arc.start, arc.end, center, arc.ccw), out);
  return true;
}

// Nearly a full or an empty circle: the bisector of its ends says nothing about the centre, so the
// centre stays, and a line closes the small gap to the end.
void ArcSolver::keep_center(ArcBlock& arc, Vec2 center, SolvedArc& out) {
  const PlaneArc kept = arc_about(arc.start, arc.end, center, arc.ccw);
  set_plane_arc(arc, kept, out);
  out.closing = true;
  const Vec2 away = arc.end - center;
  out.arc_end = from_plane(arc.basis, center + (kept.radius / length(away)) * away,
                           dot(arc.to.programmed, arc.basis.w));
}

// The radii at both ends must agree. docs/interp.md says how much each control accepts, and what it
// does then.
bool ArcSolver::check_center(ArcBlock& arc, Vec2 c, SolvedArc& out) {
  const Vec2 s = arc.start, e = arc.end;
  const double rs = length(s - c), re = length(e - c), differ = std::abs(rs - re);
  const double tolerance = std::max(kRadiiApart, kRadiiShare * rs);
  const Vec2 moved = bisector_center(s, e, c);
  const double shift = length(moved - c), r_moved = length(moved - s);
  const bool near = differ <= tolerance && shift <= tolerance;
  const auto radii = [&] {
    return fmt::format(
        "the radius is {:.6g} at the start and {:.6g} at the end, {:.3g} mm apart ({:.3g} %){}", rs,
        re, differ, 100 * differ / rs, hints_.for_radii(arc, c, differ));
  };
  if (near) hints_.learn(arc, c);
  if (is(Dialect::ngc)) {
    const double least = modal_.inch ? kSpiralApartInch : kSpiralApart;
    const bool apart = differ > least && differ > kRadiiShare * std::max(rs, re);
    if (apart || differ > 100 * least) return error("arc-radii-differ", radii(), *arc.where);
  }
  if (is(Dialect::sinumerik)) {
    const double turn = std::abs(cross(moved - s, c - s)) / (rs * std::max(r_moved, kLeastDivisor));
    if (!near || turn > kMostTurn)
      return error("arc-radii-differ", radii() + " (alarm 14040)", *arc.where);
  } else if (differ > tolerance) {
    const double share =
        is(Dialect::codesys) ? shift / std::max(r_moved, kLeastDivisor) : differ / rs;
    if (is(Dialect::fanuc)) return error("arc-radii-differ", radii() + " (alarm 020)", *arc.where);
    if (share > kMostMoved && !is(Dialect::codesys))
      return error("arc-radii-differ", radii(), *arc.where);
    if (share > kMostMoved) return straight("arc-radii-differ", radii(), arc, out);
    warning("arc-center-moved",
            fmt::format("{}: the centre is moved by {:.3g} mm to the bisector", radii(), shift),
            *arc.where);
  } else if (shift > tolerance) {
    keep_center(arc, c, out);
    return true;
  }
  set_plane_arc(arc, arc_about(s, e, moved, arc.ccw), out);
  return true;
}

// AR= is the opening angle, given with the end point or with the centre.
bool ArcSolver::angle_arc(ArcBlock& arc, const Word& word, bool centered, Vec2 center,
                          SolvedArc& out) {
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
  if (centered) return turned_arc(arc, center, angle, out);
  if (length(arc.end - arc.start) <= kSamePoint)
    return error("arc-angle-no-end", "AR= needs an end point other than the start, or a centre",
                 word);
  set_plane_arc(arc, arc_by_angle(arc.start, arc.end, angle, arc.ccw), out);
  return true;
}

// The end of the arc follows from centre and angle.
bool ArcSolver::turned_arc(ArcBlock& arc, Vec2 center, double angle, SolvedArc& out) {
  if (length(arc.start - center) <= kNoRadius) {
    if (is(Dialect::codesys))
      return straight("arc-center-is-start", "the centre is the start point", arc, out);
    return error("arc-center-is-start", "the centre is the start point", *arc.where);
  }
  const double sweep = arc.ccw ? angle : -angle;
  const double turns = angle / kTwoPi;
  const bool whole = turns == std::floor(turns);
  const Vec2 end = whole ? arc.start : rotated(arc.start, center, sweep);
  arc.end = end;
  arc.to.programmed = from_plane(arc.basis, end, dot(arc.to.programmed, arc.basis.w));
  arc.to.named |= position_.known & (axes_along(arc.basis.u) | axes_along(arc.basis.v));
  set_plane_arc(arc, {center, length(arc.start - center), sweep}, out);
  return true;
}

bool ArcSolver::codesys_angle_arc(ArcBlock& arc, const Word& t, bool centered, Vec2 center,
                                  SolvedArc& out) {
  if (!(t.value > 0 && t.value <= 1080))
    return error(
        "arc-angle-range",
        fmt::format("T{:g}: the opening angle is above 0 and at most 1080 degrees", t.value), t);
  if (!centered)
    return straight("arc-no-center", "T is the opening angle and needs the centre I J K", arc, out);
  if (named_along(arc.to, arc.basis.u) || named_along(arc.to, arc.basis.v)) {
    warning("arc-overdetermined", "T gives the end point: the end in the plane is not used", t);
    const double height = dot(arc.to.programmed, arc.basis.w);
    arc.to.programmed = from_plane(arc.basis, arc.start, height);
  }
  return turned_arc(arc, center, radians(t.value), out);
}

}  // namespace mrsim
