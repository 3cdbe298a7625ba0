#include "interp/frames/axis_words.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

namespace mrsim {
namespace {

// From this value on, a coordinate without a point may be meant in least increments.
constexpr double kLongWithoutPoint = 500;
constexpr double kFarWithoutPoint = 10'000;  // mm: no machine travels so far

}  // namespace

bool AxisWords::has_move() const {
  if (block_.frame_code || (block_.oneshot && block_.oneshot_code != Code::tap_floating))
    return false;
  const auto unused = [&](Address a) { return block_.unused(a); };
  const auto any = [&](std::initializer_list<Address> list) {
    return std::any_of(list.begin(), list.end(), unused);
  };
  if (any({letter('X'), letter('Y'), letter('Z'), Address::ap, Address::rp, angle_address(),
           letter('@'), letter('^')}))
    return true;
  if (lathe() && is(Dialect::fanuc) && any({letter('U'), letter('V'), letter('W')})) return true;
  const Code code = current_motion();
  if (code == Code::nurbs_end) return block_.motion_code != nullptr;
  if (code == Code::nurbs) return block_.motion_code || unused(letter('P'));
  if (code == Code::spline_cubic || code == Code::spline_quadratic)
    return any({letter('I'), letter('J'), letter('P'), letter('Q')});
  if (!is_circular(code)) return false;
  if (is(Dialect::codesys) && unused(letter('T'))) return true;
  return any({letter('I'), letter('J'), letter('K'), letter('R'), Address::cr, Address::ar,
              Address::i1, Address::j1, Address::k1, Address::turn});
}

// Controls of other kinds also count thousandths: Deckel's Dialog, Bridgeport's BOSS.
void AxisWords::warn_of_increments(const Word& word) {
  reporter_.once(
      Severity::warning, "number-without-point",
      fmt::format("{} without a decimal point is read as {:g} {}: where the program counts "
                  "thousandths, say --dialect fanuc --least-increments",
                  text_of(word), word.value, modal_.inch ? "inch" : "mm"),
      word, "point far");
}

// X50000 is 50 m, and 50 mm may be meant. Sheets of 2.5 m are cut by numbers without points, too.
void AxisWords::tell_of_point(const Word& word) {
  const double size = std::abs(word.value);
  if (word.point || options_.least_increments || size < kLongWithoutPoint) return;
  const bool far = size >= (modal_.inch ? kLongWithoutPoint : kFarWithoutPoint);
  if (!is(Dialect::fanuc)) {
    if (far) warn_of_increments(word);
    return;
  }
  reporter_.once(
      far ? Severity::warning : Severity::note, "number-without-point",
      fmt::format("{} without a decimal point is read as {:g} {}; on a control that counts "
                  "least increments say --least-increments",
                  text_of(word), word.value, modal_.inch ? "inch" : "mm"),
      word, far ? "point far" : "point");
}

// X of a lathe may be a radius: LinuxCNC starts in G8, while lathes of Mach may be set to diameters
// without a word. A lathe whose control is not named may be either.
void AxisWords::tell_of_radius(int axis, const Word& word) {
  if (axis != 0 || !lathe() || modal_.diameter_told || word.value == 0) return;
  if (is(Dialect::iso))
    note_once("diameter-assumed",
              fmt::format("{} is read as a diameter: where the program means radii, as LinuxCNC "
                          "does without G7, say --dialect ngc",
                          text_of(word)),
              word, "diameter");
  if (!is(Dialect::ngc)) return;
  note_once("radius-assumed",
            fmt::format("{} is read as a radius: LinuxCNC does so until G7. Where the program "
                        "means diameters (Mach's lathes), write G7 at its head; G8 says that it "
                        "means radii",
                        text_of(word)),
            word, "radius");
}

bool AxisWords::axis_word(Target& out, int axis, const Word& word, bool incremental_word) {
  bool incremental = modal_.incremental || incremental_word;
  if (word.form == Form::ac || word.form == Form::dac || word.form == Form::rac)
    incremental = false;
  if (word.form == Form::ic || word.form == Form::dic || word.form == Form::ric) incremental = true;
  const bool home = word.value == 0 && block_.oneshot;  // G28 U0 V0 W0
  if (lathe() && axis == 1 && !home) {
    if (word.value != 0 && options_.machine == MachineKind::automatic)
      throw Error("machine-unclear",
                  fmt::format("{}:{}: Y moves in a program that looked like a lathe's ({}): say "
                              "--machine mill or --machine lathe",
                              program_.files.front(), block_.line_number, program_.machine_reason),
                  Error::Kind::usage);
    if (word.value != 0)
      return error("not-supported", "a Y axis on a lathe is not supported yet", word);
  }
  tell_of_point(word);
  tell_of_radius(axis, word);
  const double value = axis_value(axis, word, incremental);
  double base = 0;
  if (incremental) {
    base = component(out.programmed, axis);
    // Setting SD42440 = 1: the first increment after a change of frame also travels the new offset.
    if (is(Dialect::sinumerik) && position_.moved_frame.has(axis) && !block_.suppress_frames)
      base = component(position_.retained, axis);
    const bool known = position_.known.has(axis);
    if (!known && !block_.oneshot && word.value == 0) return true;  // "G28 U0", and "W0" behind it
    // G28 G91 Z0 needs no known start.
    if (!known && !block_.oneshot)
      reporter_.once(Severity::warning, "start-unknown",
                     "an increment from a position that was never given: it is counted from 0; say "
                     "--start X,Y,Z",
                     word, "start");
  } else {
    out.absolute.add(axis);
  }
  const double result = base + value;
  if (!(result >= -1e9 && result <= 1e9))
    return error("number-too-large", "the position is more than 1e9 mm away", word);
  component(out.programmed, axis) = result;
  out.named.add(axis);
  if (!out.first || word.column < out.first->column) out.first = &word;
  return true;
}

bool AxisWords::target(Target& out, const Vec3& from) {
  out.programmed = from;
  if (is(Dialect::ngc) && (peek('@') || peek('^'))) return ngc_polar_target(out, from);
  if (modal_.polar && !block_.suppress_frames) return fanuc_polar_target(out, from);
  for (int i = 0; i < 3; ++i) {
    const Word* word = take("XYZ"[i]);
    const Word* relative = lathe() && is(Dialect::fanuc) ? take("UVW"[i]) : nullptr;
    if (word && relative) {  // the later word counts
      const bool last = relative->column > word->column;
      (last ? word : relative) = nullptr;
      warning("address-twice",
              fmt::format("{}: an axis is given absolute and incremental in one block: the word "
                          "that stands later counts",
                          text_of(last ? *relative : *word)),
              last ? *relative : *word);
    }
    if (word && !axis_word(out, i, *word, false)) return false;
    if (relative && !axis_word(out, i, *relative, true)) return false;
  }
  if (find(Address::ap) || find(Address::rp)) return polar_target(out);
  return true;
}

// LinuxCNC: @ is the distance and ^ the angle about the zero of G17. The one not given stays.
bool AxisWords::ngc_polar_target(Target& out, const Vec3& from) {
  const Word* radius = take('@');
  const Word* angle = take('^');
  const Word& where = radius ? *radius : *angle;
  if (modal_.plane != kPlaneXY)
    return error("polar-mixed", "@ and ^ (polar coordinates) need the plane G17", where);
  if (peek('X') || peek('Y'))
    return error("polar-mixed", "@ or ^ and an axis of the plane in one block", where);
  const Word* height = take('Z');
  if (height && !axis_word(out, 2, *height, false)) return false;
  const Vec2 s{from.x, from.y};
  const double old = length(s), turn = modal_.incremental ? 1 : 0;
  if (old == 0 && (!angle || modal_.incremental))
    return error("value-missing",
                 "the tool stands at the zero of the polar coordinates, from where no direction "
                 "is known: give ^ in G90",
                 where);
  const double r = radius ? radius->value * scale() + turn * old : old;
  const double now = degrees(mrsim::atan2(s.y, s.x));
  const SinCos sc = sincos_deg(angle ? angle->value + turn * now : now);
  out.programmed.x = r * sc.cos;
  out.programmed.y = r * sc.sin;
  out.named |= kAxisX | kAxisY;
  out.absolute |= out.named;
  if (!out.first || where.column < out.first->column) out.first = &where;
  return true;
}

// AP= and RP= are angle and radius about the pole, in the plane.
bool AxisWords::polar_target(Target& out) {
  const Word* ap = take(Address::ap);
  const Word* rp = take(Address::rp);
  const Word& where = ap ? *ap : *rp;
  const Basis b = basis();
  const AxisSet of_plane = axes_along(b.u) | axes_along(b.v);
  if (!(out.named & of_plane).empty())
    return error("polar-mixed", "AP= RP= and an axis of the plane in one block (alarm 14280)",
                 where);
  if (rp) {
    const double base = rp->form == Form::ic ? last_polar_radius(b) : 0;  // G91 does not matter
    position_.polar_radius = base + rp->value * scale();
    position_.has_polar_radius = true;
    if (position_.polar_radius < 0)
      return error("polar-radius", "RP must not be negative (alarm 14200)", *rp);
  }
  if (ap) {
    const bool relative = ap->form == Form::ic || (modal_.incremental && ap->form == Form::plain);
    if (ap->value < -360 || ap->value > 360)
      return error("value-range", "AP is -360 to 360 degrees", *ap);
    position_.polar_angle = ap->value + (relative ? last_polar_angle(b) : 0);
    position_.has_polar_angle = true;
  }
  if (!position_.has_polar_radius) {  // G2 and G3 may leave it out: the pole is the centre
    position_.polar_radius = last_polar_radius(b);
    position_.has_polar_radius = true;
  }
  if (!position_.has_polar_angle)
    return error("value-missing", "AP= was not given since the pole was set (alarm 14270)", where);
  const SinCos sc = sincos_deg(position_.polar_angle);
  const Vec2 pole = in_plane(b, position_.pole);
  const Vec2 end = pole + position_.polar_radius * Vec2{sc.cos, sc.sin};
  out.programmed = from_plane(b, end, dot(out.programmed, b.w));
  out.named |= of_plane;
  out.absolute |= of_plane;
  if (!out.first || where.column < out.first->column) out.first = &where;
  return true;
}

double AxisWords::last_polar_angle(const Basis& b) const {
  if (position_.has_polar_angle) return position_.polar_angle;
  const Vec2 d = in_plane(b, position_.programmed - position_.pole);
  return degrees(mrsim::atan2(d.y, d.x));
}

double AxisWords::last_polar_radius(const Basis& b) const {
  if (position_.has_polar_radius) return position_.polar_radius;
  return length(in_plane(b, position_.programmed - position_.pole));
}

// G16: the word of the plane's first axis is the radius, that of the second the angle. A radius in
// G91 counts from the position; the first angle beside it counts from the plane's first axis.
bool AxisWords::fanuc_polar_target(Target& out, const Vec3& from) {
  const Basis b = basis();
  const Word* radius = take("XYZ"[kFirstOfPlane[modal_.plane]]);
  const Word* angle = take("XYZ"[kSecondOfPlane[modal_.plane]]);
  const Word* height = take("XYZ"[kNormalOfPlane[modal_.plane]]);
  if (height && !axis_word(out, kNormalOfPlane[modal_.plane], *height, false)) return false;
  if (!radius && !angle) return true;
  const Word& where = radius ? *radius : *angle;
  if (radius ? !angle && !position_.has_polar_angle : !position_.has_polar_radius)
    tell_of_polar_word(where, radius ? "angle" : "radius", in_plane(b, from));
  Vec2 pole;
  const bool from_tool = modal_.incremental && radius;
  if (from_tool) pole = in_plane(b, from);
  const bool adds = modal_.incremental && (!from_tool || position_.has_polar_angle);
  if (angle)
    position_.polar_angle = angle_value(*angle) + (adds ? last_polar_angle(b) : 0);
  else if (!position_.has_polar_angle)
    position_.polar_angle = last_polar_angle(b);
  position_.has_polar_angle = true;
  double r = position_.has_polar_radius ? position_.polar_radius : length(in_plane(b, from));
  if (radius) r = radius->value * length_unit(*radius);
  position_.has_polar_radius = true;
  position_.polar_radius = r;
  const SinCos sc = sincos_deg(position_.polar_angle);
  out.programmed = from_plane(b, pole + r * Vec2{sc.cos, sc.sin}, dot(out.programmed, b.w));
  out.named |= AxisSet(kFirstOfPlane[modal_.plane]) | AxisSet(kSecondOfPlane[modal_.plane]);
  out.absolute |= out.named;
  if (!out.first || where.column < out.first->column) out.first = &where;
  return true;
}

// On the plane's first axis the place and the words that led to it say the same.
void AxisWords::tell_of_polar_word(const Word& where, const char* left_out, Vec2 at) {
  if (std::abs(at.y) <= kRounding && at.x > -kRounding) return;
  reporter_.once(
      Severity::warning, "polar-pole",
      fmt::format("no {0} behind G16: that of the tool's place is taken, {1:.6g}; a "
                  "control may take another one, so write it",
                  left_out, left_out[0] == 'a' ? degrees(mrsim::atan2(at.y, at.x)) : length(at)),
      where, fmt::format("polar-{}", left_out));
}

const Word* AxisWords::motion_word(const Target& to) const {
  if (block_.motion_code) return block_.motion_code;
  if (block_.oneshot) return block_.oneshot;
  return to.first ? to.first : &block_.words.front();
}

// ANG= with one coordinate gives the other one.
bool AxisWords::angle_target(Target& out, const Vec3& from) {
  const Word* ang = take(angle_address());
  const Basis b = basis();
  const SinCos sc = sincos_deg(angle_value(*ang));
  const Vec2 direction{sc.cos, sc.sin}, s = in_plane(b, from), e = in_plane(b, out.programmed);
  const bool has_u = named_along(out, b.u), has_v = named_along(out, b.v);
  if (has_u == has_v)
    return error("angle-coordinates",
                 "the angle needs exactly one coordinate of the plane, or the two "
                 "blocks of a corner",
                 *ang);
  const double given = has_u ? e.x - s.x : e.y - s.y;
  const double along = has_u ? direction.x : direction.y;
  if (std::abs(along) < kTurnRounding)
    return error("angle-parallel",
                 "the line runs square to the given coordinate and never reaches it", *ang);
  const double t = given / along;
  if (t < 0 && !angle_of_slope(*ang))
    return error("angle-behind", "the line reaches the given coordinate behind its start", *ang);
  out.programmed = from_plane(b, s + t * direction, dot(out.programmed, b.w));
  out.named |= axes_along(b.u) | axes_along(b.v);
  if (!out.first) out.first = ang;
  return true;
}

bool named_along(const Target& out, const Vec3& direction) {
  return !(out.named & axes_along(direction)).empty();
}

}  // namespace mrsim
