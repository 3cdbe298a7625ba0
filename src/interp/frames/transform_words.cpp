#include "interp/frames/transform_words.h"

#include "core/numbers/rounding.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {

// X Y Z of the block are the centre in the plane, or the shift of G52 and G11.
bool TransformWords::run(const Word& word) {
  Vec3 values = position_.programmed;
  AxisSet named;
  const bool factors = names_factors();
  if (block_.frame_op != Code::local_turned_off) arguments(values, named, !factors);
  switch (block_.frame_op) {
    case Code::rotation_on:
      if (word.value != 68) return untilted_plane(values, named, word);
      if (!turn_in_plane(values, word)) return false;
      break;
    case Code::scaling_on:
      if (!(factors ? scale_as_mach(word, values, named) : scale_axes(word, values))) return false;
      break;
    case Code::local_shift:
      shift_locally(values, named, word);
      break;
    case Code::local_turned:
      if (!turn_locally(values, named, word)) return false;
      break;
    case Code::local_turned_off:
      frames_.program = Frame{};
      frames_.local_axes = {};
      frames_.local_angle = false;
      break;
    case Code::mirror_on:
    case Code::mirror_off:
      for (int i = 0; i < 3; ++i)
        if (named.has(i)) component(frames_.mirror_at, i) = component(values, i);
      if (block_.frame_op == Code::mirror_on)
        frames_.mirrored |= named;
      else
        frames_.mirrored = named.empty() ? AxisSet{} : frames_.mirrored - named;
      set_mirror();
      break;
    default:
      break;
  }
  rebuild();
  return true;
}

// G68: `center` is where the block's axes are.
bool TransformWords::turn_in_plane(Vec3 center, const Word& word) {
  const Word* r = take('R');
  if (!r) return error("value-missing", "G68 needs the angle R", word);
  if (turns_in_space())
    return error("not-supported",
                 "G68 with I J K turns about an axis in space, which is not supported yet", word);
  if (!center_of_mach(center, word)) return false;
  const bool adds = modal_.incremental || take('I');
  turn_about(angle_value(*r), kNormalOfPlane[modal_.plane], center, adds, word);
  return true;
}

void TransformWords::end() {
  if (!block_.ends_rotation && !block_.ends_scaling) return;
  save();
  if (block_.ends_rotation) {
    frames_.rotation = Frame{};
    frames_.rotation_angle = 0;
  }
  if (block_.ends_scaling) frames_.scaling = Frame{};
  rebuild();
}

// G68.2 without a tilt: its X Y Z are the zero, its angles turn about Z.
bool TransformWords::untilted_plane(Vec3 zero, AxisSet named, const Word& word) {
  double angle = 0;
  for (const char c : {'I', 'J', 'K'})
    if (const Word* w = take(c)) angle += angle_value(*w);
  for (const char c : {'P', 'Q'}) take(c);
  for (int i = 0; i < 3; ++i)
    if (!named.has(i)) component(zero, i) = 0;
  frames_.rotation_angle = angle;
  frames_.rotation = compose(shift_frame(zero), rotation_frame(2, angle));
  note_once("plane-level", "G68.2 without a tilt: its zero is shifted by X Y Z and turned about Z",
            word, "G68.2");
  rebuild();
  return true;
}

void TransformWords::swivel(const Frame& frame, bool adds, const Word& word) {
  save();
  if (adds) {
    frames_.swivel = compose(compose(frames_.swivel, frames_.program), frame);
  } else {
    if (!(frames_.program == Frame{}))
      warning("frame-deleted",
              "CYCLE800 deletes the frame of TRANS, ROT, SCALE and MIRROR that is in force", word);
    frames_.swivel = frame;
  }
  frames_.program = Frame{};
  frames_.fine = Vec3{};
  if (!(frame == Frame{}))
    note_once("plane-level",
              "CYCLE800 without a tilt: its zero is shifted by X0 Y0 Z0 and X1 Y1 Z1 and turned "
              "about Z",
              word, "CYCLE800");
  rebuild();
}

// G11 X Y Z P of Okuma: the zero lies at X Y Z of the work offset, the plane is turned by P. What a
// second G11 makes of the words that it leaves out is not known.
bool TransformWords::turn_locally(Vec3 zero, AxisSet named, const Word& word) {
  const Word* angle = take('P');
  const bool lacks_words =
      !named.has(frames_.local_axes) || (frames_.local_angle && angle == nullptr);
  if (modal_.incremental || lacks_words)
    return error("not-supported",
                 modal_.incremental
                     ? "G11 (Okuma's local coordinates) in G91 is not supported: write it in G90"
                     : "G11 again without words of the G11 in force is not supported: write them "
                       "all, or G10 before it",
                 word);
  for (int i = 0; i < 3; ++i)
    if (!named.has(i)) component(zero, i) = 0;
  frames_.program = compose(shift_frame(zero), rotation_frame(kNormalOfPlane[modal_.plane],
                                                              angle ? angle_value(*angle) : 0));
  frames_.local_axes = named;
  frames_.local_angle = angle != nullptr;
  return true;
}

// The manuals forbid G52 between G68 and G69, and machines differ in how they read it.
void TransformWords::shift_locally(const Vec3& values, AxisSet named, const Word& word) {
  if (is(Dialect::ngc)) {  // the shift of G92, which G92.1 to G92.3 act on
    const double x = modal_.diameter == Code::diameter_on ? values.x / 2 : values.x;
    for (int i = 0; i < 3; ++i)
      if (named.has(i)) component(frames_.position_shift, i) = i == 0 ? x : component(values, i);
    frames_.position_memory = frames_.position_shift;
    return;
  }
  const Vec3 before = frames_.local;
  for (int i = 0; i < 3; ++i)
    if (named.has(i)) component(frames_.local, i) = component(values, i);
  if (frames_.rotation_angle != 0 && distance(before, frames_.local) > kRounding)
    warning("rotation-shift",
            "G52 while G68 is in force, which controls forbid: read as a shift along the axes that "
            "are not turned; write G52 before G68",
            word);
}

// I J K of G68 are the direction of an axis. The direction of Z turns the plane G17, as G68 without
// these words does.
bool TransformWords::turns_in_space() {
  if (peek('A') || peek('B') || !(peek('I') || peek('J') || peek('K'))) return false;
  const auto value = [&](char c) {
    const Word* w = take(c);
    return w ? w->value : 0;
  };
  const double i = value('I'), j = value('J'), k = value('K');
  return i != 0 || j != 0 || k <= 0 || modal_.plane != kPlaneXY;
}

// G68 A12 B25 R45 of Mach: A and B are the centre.
bool TransformWords::center_of_mach(Vec3& center, const Word& word) {
  const Word* a = take('A');
  const Word* b = take('B');
  if (!a && !b) return true;
  if (!a || !b) return error("value-missing", "G68 of Mach needs A and B, its centre", word);
  if (modal_.plane != kPlaneXY)
    return error("not-supported", "G68 A B of Mach is read in G17 only", word);
  center = {a->value * length_unit(*a), b->value * length_unit(*b), 0};
  return true;
}

// A point passes the mirror and the scale before it is turned. Under G51.1 and G51 the centre
// passes them, too, and a mirror image turns the other way round.
Frame TransformWords::turned(double angle, int axis, const Vec3& center) const {
  const Frame inner = compose(frames_.scaling, frames_.mirror);
  const Basis b = basis();
  const bool reversed = dot(cross(turn(inner, b.u), turn(inner, b.v)), b.w) < 0;
  return about(rotation_frame(axis, reversed ? -angle : angle), apply(inner, center));
}

void TransformWords::place_figure(const Frame& base, double angle, const Vec3& center,
                                  const Vec3& shift) {
  save();
  const Frame inner = compose(frames_.scaling, frames_.mirror);
  frames_.rotation = compose(base, compose(shift_frame(turn(inner, shift)),
                                           turned(angle, kNormalOfPlane[modal_.plane], center)));
  rebuild();
}

// In G91, and beside I of Mach, the angle is added to that of the rotation in force.
void TransformWords::turn_about(double angle, int axis, const Vec3& center, bool adds,
                                const Word& word) {
  if (adds && frames_.rotation_angle != 0) {
    angle += frames_.rotation_angle;
    note_once("rotation-adds", "G68 in G91 or with I adds its angle to the rotation in force", word,
              "G68");
  }
  frames_.rotation_angle = angle;
  frames_.rotation = turned(angle, axis, center);
}

// G51 P for all axes or I J K for each. Without a decimal point a factor counts thousandths from 10
// on, and so does a computed one (P[1500+500]); below, it is the factor, as Centroid and Okuma have
// it: FANUC's 0.002 would leave nothing of the part.
bool TransformWords::scale_axes(const Word& word, const Vec3& center) {
  Vec3 factors{1, 1, 1};
  const auto factor = [&](const Word& w) {
    const bool computed = is_computed(w);
    const bool counts = (computed || !w.point) && std::abs(w.value) >= 10;
    if (!computed && !w.point && !counts && w.value != 1)
      reporter_.once(Severity::warning, "number-without-point",
                     fmt::format("{} is read as a factor of {:g}; on a control that counts "
                                 "thousandths it is {:g}",
                                 text_of(w), w.value, w.value / 1000),
                     w, "factor");
    if (computed && counts)
      note_once("number-without-point",
                fmt::format("{} = {:g} is read as thousandths", text_of(w), w.value), w, "factor");
    return counts ? w.value / 1000 : w.value;
  };
  if (!peek('P') && !peek('I') && !peek('J') && !peek('K'))
    return error("value-missing",
                 "G51 needs P, or I J K: without them the factor is a parameter of the control, or "
                 "X Y Z are factors (Mach)",
                 word);
  if (const Word* p = take('P')) factors = {factor(*p), factor(*p), factor(*p)};
  for (int i = 0; i < 3; ++i)
    if (const Word* each = take("IJK"[i])) component(factors, i) = factor(*each);
  if (factors.x == 0 || factors.y == 0 || factors.z == 0)
    return error("value-range", "a scale factor must not be 0", word);
  frames_.scaling = about(scale_frame(factors), apply(frames_.mirror, center));
  return true;
}

// G51 X2 Y0.5 of Mach: X Y Z are the factors of their axes.
bool TransformWords::names_factors() const {
  return is(Dialect::ngc) && block_.frame_op == Code::scaling_on && !peek('P') && !peek('I') &&
         !peek('J') && !peek('K');
}

// Mach multiplies the words of a block, so it scales about the zero.
bool TransformWords::scale_as_mach(const Word& word, Vec3 factors, AxisSet named) {
  if (named.empty()) return error("value-missing", "G51 needs its factors, X Y Z", word);
  for (int i = 0; i < 3; ++i) {
    if (!named.has(i)) component(factors, i) = 1;
    if (component(factors, i) == 0)
      return error("value-range", "a scale factor must not be 0", word);
  }
  frames_.scaling = scale_frame(factors);
  return true;
}

void TransformWords::set_mirror() {
  frames_.mirror = Frame{};
  if (frames_.mirrored.empty()) return;
  Vec3 factors{1, 1, 1};
  for (int i = 0; i < 3; ++i)
    if (frames_.mirrored.has(i)) component(factors, i) = -1;
  frames_.mirror = about(scale_frame(factors), frames_.mirror_at);
}

bool TransformWords::fagor(Code code, const Word& word) {
  save();
  if (code == Code::fagor_mirror) {
    const int g = static_cast<int>(word.value);
    frames_.mirrored = g == 10 ? AxisSet{} : frames_.mirrored | AxisSet(g - 11);
    frames_.mirror_at = {};
    set_mirror();
  } else if (code == Code::fagor_scale) {
    const double factor = take('S')->value;
    if (!(factor > 1e-6 && factor < 1e6))
      return error("value-range", "S of G72 is the scale, above 0", word);
    frames_.scaling = scale_frame({factor, factor, factor});
  } else if (!fagor_turn(word)) {
    return false;
  }
  rebuild();
  return true;
}

// G73 Q turns the plane further, about I J or the zero; alone it ends the rotation.
bool TransformWords::fagor_turn(const Word& word) {
  const Word* q = take('Q');
  const Basis b = basis();
  Vec3 center;
  if (const Word* i = take('I')) center = center + i->value * length_unit(*i) * b.u;
  if (const Word* j = take('J')) center = center + j->value * length_unit(*j) * b.v;
  if (q && frames_.rotation_angle != 0 && distance(center, frames_.rotation_at) > kRounding)
    return error("not-supported",
                 "G73 about another centre while a rotation is in force: write G73 alone before it",
                 word);
  frames_.rotation_angle = q ? frames_.rotation_angle + q->value : 0;
  frames_.rotation_at = center;
  frames_.rotation =
      about(rotation_frame(kNormalOfPlane[modal_.plane], frames_.rotation_angle), center);
  return true;
}

}  // namespace mrsim
