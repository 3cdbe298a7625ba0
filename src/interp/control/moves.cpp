// From a target to Motions: lines, rapids, threads, and what every motion carries.
#include "core/trig.h"
#include "interp/engine.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

bool is_circular(Code c) {
  return c == Code::arc_cw || c == Code::arc_ccw || c == Code::arc_point || c == Code::arc_tangent;
}
bool is_thread(Code c) {
  return c == Code::thread || c == Code::thread_growing || c == Code::thread_shrinking ||
         c == Code::tap_in || c == Code::tap_out || c == Code::tap_floating;
}

bool Engine::move() {
  const Frame frame = frame_now();
  const Vec3 from = suppress_ ? apply_inverse(frame, position_.physical) : position_.programmed;
  const Word* ang = find(Address::ang);
  if (pending_angle_.active && !ang) {
    pending_angle_.active = false;
    return error("angle-incomplete",
                 "the block before gives only ANG=, so this one needs ANG= and both coordinates",
                 block_.words.front());
  }
  if (is_circular(current_motion())) {
    if (ang) return error("angle-line-only", "ANG= is for straight lines only", *ang);
    return arc_move(from, frame);
  }
  Target to;
  if (!target(to, from)) return false;
  if (ang) {
    const Basis b = basis();
    const bool u = named_along(to, b.u), v = named_along(to, b.v);
    if (!u && !v && !pending_angle_.active) return hold_angle(*ang);
    if (pending_angle_.active) return two_angle_lines(to, from, frame);
    if (!angle_target(to, from)) return false;
  }
  if (to.named == 0) return true;
  if (is_thread(current_motion()) && !thread_values(to, from)) return false;
  return line_move(to, frame);
}

bool Engine::line_move(const Target& to, const Frame& frame) {
  const Word* where = motion_word(to);
  const MotionKind kind = current_motion() == Code::rapid ? MotionKind::rapid : MotionKind::line;
  Motion motion = motion_template(*where, kind);
  commit(to, frame, motion);
  if (!start_compensation(motion, *where)) return false;
  emit(motion);
  return true;
}

// The first of two blocks ANG=a1, ANG=a2 X Z: its end is known with the second.
bool Engine::hold_angle(const Word& ang) {
  take(Address::ang);
  pending_angle_.active = true;
  pending_angle_.angle = ang.value;
  pending_angle_.motion = motion_template(motion_code_ ? *motion_code_ : ang, MotionKind::line);
  pending_angle_.corner = corner_spec();
  return true;
}

bool Engine::two_angle_lines(const Target& to, const Vec3& from, const Frame& frame) {
  const Word& ang = *take(Address::ang);
  pending_angle_.active = false;
  const Basis b = basis();
  if (!named_along(to, b.u) || !named_along(to, b.v))
    return error("angle-coordinates", "the second ANG= needs both end coordinates", ang);
  const SinCos a = sincos_deg(pending_angle_.angle), c = sincos_deg(ang.value);
  const Vec2 d1{a.cos, a.sin}, d2{c.cos, c.sin};
  const Vec2 s = in_plane(b, from), e = in_plane(b, to.programmed);
  const double det = cross(d1, d2);
  if (std::abs(det) < 1e-9)
    return error("angle-parallel", "the two lines are parallel and have no corner", ang);
  const double t = cross(e - s, d2) / det, rest = cross(d1, e - s) / det;
  if (t < 0 || rest < 0) return error("angle-behind", "the two lines meet behind their ends", ang);
  Target middle = to;
  middle.programmed = from_plane(b, s + t * d1, dot(from, b.w));
  Motion first = pending_angle_.motion;
  first.start = position_.physical;
  commit(middle, frame, first);
  if (!start_compensation(first, ang)) return false;
  emit_with(first, pending_angle_.corner);
  Motion second = motion_template(*motion_word(to), MotionKind::line);
  commit(to, frame, second);
  emit(second);
  return true;
}

// Lead of G33 G34 G35 (SINUMERIK K along Z, I along X; FANUC F) and of tapping, whose sign is the
// hand of the thread; that of a cut thread follows from the spindle and the direction.
bool Engine::thread_values(const Target& to, const Vec3& from) {
  const Code code = current_motion();
  take(Address::sf);
  const Vec3 d = to.programmed - from;
  if (code == Code::tap_floating) {
    modal_.lead = modal_.speed > 0 ? modal_.feed / modal_.speed : 0;
    return true;
  }
  if (!is(Dialect::sinumerik)) {
    const Word* f = take('F');
    if (const Word* k = take('K')) f = f ? f : k;
    if (f) modal_.lead = f->value * feed_scale();
  } else {
    const double along[] = {std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    double longest = -1;
    const Word* used = nullptr;
    for (int i = 0; i < 3; ++i) {
      const Word* lead = take("IJK"[i]);
      if (!lead || along[i] <= longest) continue;
      longest = along[i];
      used = lead;
      modal_.lead = lead->value * scale();
    }
    if (used && longest < *std::max_element(std::begin(along), std::end(along)))
      warning("thread-lead", "the lead belongs to the axis of the longer path, and this is another",
              *used);
  }
  if (modal_.lead == 0)
    return error("thread-lead", "a thread needs its lead",
                 motion_code_ ? *motion_code_ : *to.first);
  if (modal_.lead < 0 && code != Code::tap_in && code != Code::tap_out)
    return error("thread-lead", "the lead of a cut thread is above 0",
                 motion_code_ ? *motion_code_ : *to.first);
  return true;
}

const Word* Engine::motion_word(const Target& to) const {
  if (motion_code_) return motion_code_;
  if (oneshot_) return oneshot_;
  return to.first ? to.first : &block_.words.front();
}

Motion Engine::motion_template(const Word& where, MotionKind kind) {
  if (kind == MotionKind::rapid)
    require_tool(where, modal_.comp != Code::comp_off);  // its radius counts from here on
  else
    begin_cut(where);
  Motion m;
  m.kind = kind;
  m.feed_unit = modal_.feed_unit;
  m.constant_surface_speed = modal_.surface_speed;
  m.assumed_start = position_.known != 7U;
  m.start = position_.physical;
  m.tool = tool_.index;
  m.feed = modal_.feed;
  m.speed = modal_.surface_speed ? modal_.cutting_speed : modal_.speed;
  if (is_thread(current_motion())) m.lead = modal_.lead;
  const Activation& top = stack_.back();
  m.file = top.file;
  m.line = block_.line_number;
  m.column = where.column + 1;
  m.call = top.call;
  return m;
}

// What a cut needs: a tool, and once a feed.
void Engine::begin_cut(const Word& where) {
  require_tool(where, true);
  if (modal_.feed != 0 || feed_warned_ || is_thread(current_motion())) return;
  feed_warned_ = true;
  warning(
      "feed-missing",
      is(Dialect::fanuc) ? "no F before the first cut (alarm 011)" : "no F before the first cut",
      where);
}

// Moves the position to the target; motion.end becomes the physical end.
void Engine::commit(const Target& to, const Frame& frame, Motion& motion) {
  Vec3 end = position_.physical;
  if (frame.plain) {
    for (int i = 0; i < 3; ++i)
      if (to.named >> i & 1U)
        component(end, i) = component(to.programmed, i) + component(frame.shift, i);
  } else {
    end = apply(frame, to.programmed);
  }
  motion.end = end;
  position_.physical = end;
  position_.programmed = suppress_ ? apply_inverse(frames_.total, end) : to.programmed;
  position_.known |= to.named;
  position_.moved_frame &= ~to.named;
  if (motion.kind != MotionKind::arc) {
    const Vec3 d = end - motion.start;
    const double l = length(d);
    if (l > 1e-9) {
      position_.tangent = (1 / l) * d;
      position_.has_tangent = true;
    }
  }
}

void Engine::emit(const Motion& motion) {
  emit_with(motion, motion.kind == MotionKind::rapid ? CornerSpec{} : corner_spec());
}

void Engine::emit_with(Motion motion, const CornerSpec& corner) {
  if (motion.kind != MotionKind::rapid) {
    ++cuts_;
    motion.tool = tool_.index;
  }
  motion.start.z += last_length_;
  motion.end.z += modal_.length_offset;
  motion.center.z += modal_.length_offset;
  last_length_ = modal_.length_offset;
  if (motion.kind != MotionKind::arc && distance(motion.start, motion.end) <= 1e-9) {
    for (const Address a : {Address::rnd, Address::chr, Address::chf})
      if (const Word* word = find(a))
        warning("corner-void", "the block moves nothing: no rounding or chamfer is inserted",
                *word);
    return;
  }
  const bool plain = corner.kind == CornerSpec::Kind::none && modal_.comp == Code::comp_off;
  if (plain && contour_idle_) return output(motion);
  PathMove path;
  path.motion = motion;
  path.basis = stock_basis();
  path.corner = corner;
  path.comp = compensation();
  path.block = blocks_;
  corners_.push(path);
  contour_idle_ = corners_.idle() && compensation_.idle();
}

// The plane's axes in the stock's coordinates, unit length; left-handed under a mirror.
Basis Engine::stock_basis() const {
  const Basis b = basis();
  const Frame& f = frames_.total;
  if (f.plain) return b;
  return {normalized(turn(f, b.u)), normalized(turn(f, b.v)), normalized(turn(f, b.w))};
}

// RND CHF CHR of the block, else RNDM.
CornerSpec Engine::corner_spec() {
  CornerSpec spec;
  const Word* round = take(Address::rnd);
  const Word* leg = take(Address::chr);
  const Word* cut = take(Address::chf);
  const Word* feed = take(Address::frc);
  using Kind = CornerSpec::Kind;
  if (round) {
    spec = {Kind::round, round->value * scale(), 0};
  } else if (leg) {
    spec = {Kind::leg, leg->value * scale(), 0};
  } else if (cut) {
    spec = {Kind::cut, cut->value * scale(), 0};
  } else if (modal_.rndm > 0) {
    spec = {Kind::round, modal_.rndm, 0};
  }
  for (const Word* word : {round, leg, cut})
    if (word && word->value < 0)
      warning("corner-void", "the size is negative: no rounding or chamfer is inserted", *word);
  if (spec.size <= 0) spec.kind = Kind::none;
  spec.feed = feed ? feed->value * feed_scale() : modal_.frcm;
  return spec;
}

}  // namespace mrsim
