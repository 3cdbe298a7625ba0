#include "interp/frames/frame_words.h"

#include "core/numbers/trig.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostScale = 1e9, kMostShift = 1e10;  // volumes of a frame; mm

}  // namespace

void FrameWords::start() {
  if (!is(Dialect::sinumerik) && !is(Dialect::codesys)) set_work("G54");
  rebuild();
}

// G15 H1 to H200 of Okuma select a work offset.
bool FrameWords::select_numbered(const Word& h) {
  if (h.value < 1 || h.value > 200 || h.value != std::floor(h.value))
    return error("value-range", "G15 needs H1 to H200, a work offset of Okuma's OSP", h);
  modal_.okuma = true;
  return use_work(fmt::format("G15H{:g}", h.value), h);
}

// E1 to E48 of Fadal and Centroid select a work offset; E0 is the machine's own zero.
bool FrameWords::select_fixture() {
  const bool engraves = block_.oneshot && block_.oneshot_code == Code::engrave;
  if (!is(Dialect::fanuc) || lathe() || engraves || !block_.unused(letter('E'))) return true;
  const Word& e = *take('E');
  if (e.value < 0 || e.value > 48 || e.value != std::floor(e.value))
    return error("value-range", "E is a work offset of Fadal and Centroid, E1 to E48", e);
  if (e.value == 0) {
    block_.suppress_frames = true;
    return true;
  }
  return use_work(fmt::format("E{:g}", e.value), e);
}

const Word* FrameWords::offset_number() {
  return block_.offset_number ? block_.offset_number : take('P');
}

bool FrameWords::select_work(const CodeEntry& entry, const Word& word) {
  if (modal_.okuma && word.value == 56 && peek('H')) {  // the length of the tool along Z
    modal_.length = Code::length_plus;
    block_.length_changed = true;
    return true;
  }
  std::string name;
  if (entry.code == Code::work_extended) {
    const Word* p = offset_number();
    if (!p || p->value < 1 || p->value > 300 || p->value != std::floor(p->value))
      return error("value-range", "G54.1 needs P1 to P300", word);
    name = fmt::format("{}P{:g}", word.value == 154 ? "G154" : "G54.1", p->value);
  } else if (word.value == 54 && !is(Dialect::ngc) && extends_work()) {
    name = fmt::format("G54.1P{:g}", offset_number()->value);
  } else if (word.value == 59 && extends_work()) {
    const double n = offset_number()->value;
    if (n > 9) return error("value-range", "G59 P (of Mach) is read up to P9, G59.3", word);
    name = n > 6 ? fmt::format("G59.{:g}", n - 6) : fmt::format("G{:g}", 53 + n);
  } else if (entry.code == Code::work_offset) {
    name = fmt::format("G{:g}", word.value);
  }
  return use_work(name, word);
}

bool FrameWords::use_work(const std::string& name, const Word& word) {
  if (is(Dialect::ngc) && name == frames_.work_name)
    return true;  // values set since then do not count
  save();
  if (!set_work(name))
    note_once("work-offset-unset",
              fmt::format("{} is not in the tool table: its zero is that of the stock, as for G54 "
                          "without an entry",
                          name),
              word, name);
  rebuild();
  return true;
}

// G54 P2 of FANUC is G54.1 P2, and G59 P7 of Mach is the offset that G10 L2 P7 sets; but only where
// no other word of the block needs the P.
bool FrameWords::extends_work() const {
  const Word* p = block_.offset_number ? block_.offset_number : peek('P');
  if (!p || is(Dialect::sinumerik) || is(Dialect::codesys)) return false;
  if (p->value < 1 || p->value > 300 || p->value != std::floor(p->value)) return false;
  if (block_.offset_number) return true;
  if (modal_.drill.number != 0) return false;
  static constexpr Group kApart[] = {Group::distance, Group::plane, Group::units, Group::comp,
                                     Group::length,   Group::feed,  Group::speed, Group::work};
  const CodeTable& codes = code_table(control_.dialect, program_.machine);
  for (const Word& word : block_.words) {
    if (word.address == letter('M') && word.value >= 96) return false;
    if (word.address != letter('G')) continue;
    if (word.value >= 1000 || word.value != std::floor(word.value)) return false;
    const CodeEntry other = codes[static_cast<std::size_t>(word.value)];
    const bool apart =
        std::find(std::begin(kApart), std::end(kApart), other.group) != std::end(kApart);
    if (!apart && other.code != Code::rapid && other.code != Code::line &&
        other.code != Code::cycle_off)
      return false;
  }
  return true;
}

void FrameWords::renew_work() {
  set_work(frames_.work_name);
  rebuild();
}

bool FrameWords::set_work(const std::string& written) {
  const std::string name = control_.offset_name(written);
  frames_.work = {};
  frames_.work_name = name;
  const auto turn = control_.work_turns.find(name);
  frames_.work_turn = turn == control_.work_turns.end() ? 0 : turn->second;
  frames_.work_given = name.empty();
  for (const WorkOffset& offset : control_.work) {
    const bool external = offset.name == "EXT" && !name.empty();
    if (offset.name != name && !external) continue;
    frames_.work = frames_.work + offset.shift;
    frames_.work_given = frames_.work_given || !external;
  }
  return frames_.work_given || name == "G54";
}

// ROT turns about Z, then about the new Y, then about the new X; RPL= turns in the plane.
void FrameWords::rotation_arguments(Frame& frame) {
  if (const Word* rpl = take(Address::rpl)) {
    frame = rotation_frame(kNormalOfPlane[modal_.plane], rpl->value);
    return;
  }
  Vec3 angles;
  AxisSet named;
  arguments(angles, named, false);
  frame = Frame{};
  if (named.has(kAxisZ)) frame = compose(frame, rotation_frame(2, angles.z));
  if (named.has(kAxisY)) frame = compose(frame, rotation_frame(1, angles.y));
  if (named.has(kAxisX)) frame = compose(frame, rotation_frame(0, angles.x));
}

bool FrameWords::sinumerik_step(const Vec3& values, AxisSet named) {
  Frame step;
  switch (block_.frame_op) {
    case Code::trans:
    case Code::atrans:
      step = shift_frame(values);
      break;
    case Code::scale:
    case Code::ascale: {
      Vec3 factors{1, 1, 1};
      for (int i = 0; i < 3; ++i)
        if (named.has(i)) component(factors, i) = component(values, i);
      if (factors.x == 0 || factors.y == 0 || factors.z == 0)
        return error("value-range", "a scale factor must not be 0", *block_.frame_code);
      if (!named.empty()) step = scale_frame(factors);
      break;
    }
    case Code::mirror:
    case Code::amirror: {
      Vec3 factors{1, 1, 1};
      for (int i = 0; i < 3; ++i)
        if (named.has(i)) component(factors, i) = -1;
      if (!named.empty()) step = scale_frame(factors);
      break;
    }
    default:
      rotation_arguments(step);
  }
  const bool appends = block_.frame_op == Code::atrans || block_.frame_op == Code::arot ||
                       block_.frame_op == Code::ascale || block_.frame_op == Code::amirror;
  if (!appends) frames_.fine = Vec3{};
  if (block_.frame_op == Code::atrans)
    frames_.fine = frames_.fine + turn(frames_.program, step.shift);
  frames_.program = appends ? compose(frames_.program, step) : step;
  return true;
}

// Scales that multiply again and again would end in positions that are no numbers.
bool FrameWords::in_range() {
  const double d = std::abs(determinant(frames_.total));
  if (d >= 1 / kMostScale && d <= kMostScale && length(frames_.total.shift) <= kMostShift)
    return true;
  return error("value-range", "the frame scales or shifts beyond all measure", *block_.frame_code);
}

bool FrameWords::run() {
  if (block_.frame_op == Code::pole_position || block_.frame_op == Code::pole_zero ||
      block_.frame_op == Code::pole_pole)
    return pole();
  if (block_.frame_op == Code::speed_limit) {
    for (const char c : {'X', 'Y', 'Z', 'S'}) take(c);
    return true;
  }
  save();
  if (is(Dialect::codesys)) return codesys() && in_range();
  if (!is(Dialect::sinumerik)) return transforms_.run(*block_.frame_code) && in_range();
  return sinumerik() && in_range();
}

bool FrameWords::sinumerik() {
  if (block_.motion_code)
    return error("frame-own-block", "a frame word needs a block of its own", *block_.frame_code);
  const bool lengths = block_.frame_op == Code::trans || block_.frame_op == Code::atrans ||
                       block_.frame_op == Code::trans_coarse || block_.frame_op == Code::trans_fine;
  const bool rotates = block_.frame_op == Code::rot || block_.frame_op == Code::arot;
  Vec3 values;
  AxisSet named;
  if (!rotates) arguments(values, named, lengths);
  if (block_.frame_op == Code::trans_coarse || block_.frame_op == Code::trans_fine) {
    trans_part(values, named);
  } else if (!sinumerik_step(values, named)) {
    return false;
  }
  rebuild();
  return true;
}

// G58 replaces the absolute part of the shift, that of TRANS, and G59 the additive part, that of
// ATRANS; each leaves the other part.
void FrameWords::trans_part(const Vec3& values, AxisSet named) {
  for (int i = 0; i < 3; ++i) {
    if (!named.has(i)) continue;
    double& shift = component(frames_.program.shift, i);
    const double fine = component(frames_.fine, i);
    component(frames_.fine, i) = block_.frame_op == Code::trans_fine ? component(values, i) : fine;
    shift = block_.frame_op == Code::trans_fine ? shift - fine + component(values, i)
                                                : component(values, i) + fine;
  }
}

// G53 resets the decoder's frame, G54 sets its shift, G55 adds to it, G56 puts it at the position.
bool FrameWords::codesys() {
  Vec3 values;
  AxisSet named;
  arguments(values, named, true);
  for (const char c : {'A', 'B', 'C'})
    if (const Word* word = peek(c); word && word->value != 0)
      return error("not-supported", "a rotated decoder frame is not supported yet", *word);
  switch (block_.frame_op) {
    case Code::decoder_reset:
      frames_.program = Frame{};
      break;
    case Code::decoder_set:
      frames_.program = shift_frame(values);
      break;
    case Code::decoder_add:
      frames_.program = compose(frames_.program, shift_frame(values));
      break;
    default:
      frames_.program = shift_frame(position_.physical + values);
  }
  rebuild();
  return true;
}

// G110 gives the pole from the last position, G111 from workpiece zero, G112 from the last pole.
// G90 and G91 have no effect on it.
bool FrameWords::pole() {
  const Basis b = basis();
  Vec3 from;
  if (block_.frame_op == Code::pole_position) from = position_.programmed;
  if (block_.frame_op == Code::pole_pole) from = position_.pole;
  Vec3 at = from;
  const Word* rp = take(Address::rp);
  const Word* ap = take(Address::ap);
  if (ap || rp) {
    if (peek('X') || peek('Y') || peek('Z'))
      return error("polar-mixed", "a pole is given by axes or by AP= RP=, not both (alarm 14270)",
                   ap ? *ap : *rp);
    const double angle = ap ? ap->value : 0, radius = rp ? rp->value * scale() : 0;
    if (radius < 0) return error("polar-radius", "RP must not be negative (alarm 14250)", *rp);
    const SinCos sc = sincos_deg(angle);
    at = from + (radius * sc.cos) * b.u + (radius * sc.sin) * b.v;
  }
  for (int i = 0; i < 3; ++i) {
    const Word* word = take("XYZ"[i]);
    if (!word) continue;
    const bool relative = block_.frame_op != Code::pole_zero;
    component(at, i) = (relative ? component(from, i) : 0) + axis_value(i, *word, relative);
  }
  position_.pole = at;
  position_.has_polar_angle = false;
  return true;
}

}  // namespace mrsim
