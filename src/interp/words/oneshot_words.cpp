#include "interp/words/oneshot_words.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace mrsim {

bool OneShotWords::run() {
  switch (block_.oneshot_code) {
    case Code::dwell:
      return dwell();
    case Code::reference:
    case Code::reference_second:
      return reference();
    case Code::reference_leave:
      return leave_reference();
    case Code::reference_approach:
    case Code::fixed_point:
      return reference_sinumerik();
    case Code::reference_check:
    case Code::one_way:
      return rapid_to();
    case Code::data_setting:
      return offsets_.run();
    case Code::position_reset:
    case Code::position_suspend:
    case Code::position_resume:
      return suspend_position();
    case Code::set_position:
      return set_position();
    case Code::position_jump:
      return position_jump();
    case Code::decoder_length:
      for (const char c : {'I', 'J', 'K'}) take(c);
      note_once("tool-length", "G43: positions are read as those of the tool's tip",
                *block_.oneshot, "G43");
      return true;
    default:
      return true;
  }
}

// Beside G4, words mean seconds or turns, not axes or feeds.
bool OneShotWords::dwell() {
  if (is(Dialect::sinumerik)) {
    for (const char c : {'X', 'Y', 'Z'})
      if (const Word* axis = peek(c))
        return error("call-not-alone", "G4 stands alone in its block, without axes", *axis);
  } else if (const Word* time = peek('P') ? peek('P') : peek('K')) {
    for (const char c : {'X', 'U'})
      if (const Word* axis = peek(c))
        return error("call-not-alone",
                     fmt::format("{} beside {} of G4: a block with G4 does not move",
                                 text_of(*axis), text_of(*time)),
                     *axis);
  }
  moves_.dwell(dwell_.of_block());
  return true;
}

// G28 and G30 are a rapid to the intermediate point, then to the reference point. Without axes all
// of them go there (LinuxCNC, Haas).
bool OneShotWords::reference() {
  const Word* p = take('P');
  Target to;
  if (!axes_.target(to, position_.programmed)) return false;
  if (const AxisSet homed = bare_axes(); !homed.empty()) {
    moves_.to_place(&options_.places.reference, homed | to.named, *block_.oneshot);
    return true;
  }
  if (!to.named.empty()) moves_.step(to, *block_.oneshot, MotionKind::rapid);
  for (int i = 0; i < 3; ++i)
    if (to.named.has(i)) component(control_.intermediate, i) = component(to.programmed, i);
  control_.has_intermediate |= to.named;
  const bool first = block_.oneshot_code == Code::reference;
  if (const std::optional<Vec3>& stored = control_.stored_places[first ? 0 : 1]; stored) {
    moves_.to_stored(*stored, reference_axes(to.named), *block_.oneshot);
    return true;
  }
  const MachinePlaces& places = options_.places;
  const Vec3* second = places.second && (!p || p->value == 2) ? &*places.second : nullptr;
  moves_.to_place(first ? &places.reference : second, reference_axes(to.named), *block_.oneshot);
  return true;
}

// G29 goes back over the intermediate point of the last G28, from which its increments count.
bool OneShotWords::leave_reference() {
  Target via;
  via.programmed = position_.programmed;
  for (int i = 0; i < 3; ++i) {
    const bool named = peek("XYZ"[i]) || (lathe() && i != 1 && peek("U W"[i]));
    if (!named) continue;
    if (!control_.has_intermediate.has(i))
      return error("value-missing", "G29 needs a G28 of its axes before it", *block_.oneshot);
    component(via.programmed, i) = component(control_.intermediate, i);
    via.named.add(i);
  }
  if (via.named.empty()) return error("motion-missing", "G29 needs an axis", *block_.oneshot);
  moves_.step(via, *block_.oneshot, MotionKind::rapid);
  return rapid_to();
}

// The axes that the block names, or all of them; "G28 H0" names only the axis of the spindle.
AxisSet OneShotWords::reference_axes(AxisSet named) const {
  const std::string_view others = "ABCHUVW";
  const bool all = named.empty() && std::none_of(others.begin(), others.end(),
                                                 [&](char c) { return peek(c) != nullptr; });
  return !all ? named : lathe() ? kAxisX | kAxisZ : kAllAxes;
}

// Axes without a coordinate: "X1=0" behind G74 of SINUMERIK, "X" without a number behind G28.
AxisSet OneShotWords::bare_axes() const {
  AxisSet axes;
  for (const Word& word : block_.words) {
    const auto c = static_cast<char>(word.code);
    if (word.address == Address::data && c >= 'X' && c <= 'Z') axes.add(c - 'X');
  }
  return axes;
}

// G74 goes to the reference point, G75 to a fixed point.
bool OneShotWords::reference_sinumerik() {
  AxisSet axes = bare_axes();
  for (const char c : {'X', 'Y', 'Z'})
    if (take(c)) axes.add(c - 'X');
  const MachinePlaces& places = options_.places;
  const Vec3* second = places.second ? &*places.second : nullptr;
  moves_.to_place(block_.oneshot_code == Code::reference_approach ? &places.reference : second,
                  axes, *block_.oneshot);
  return true;
}

// G92 (G50 on a lathe) gives the position new coordinates, and nothing moves. S alone is a speed
// limit.
bool OneShotWords::set_position() {
  frame_words_.save();
  if (lathe() && peek('S'))  // the lowest speed (Mitsubishi), and which spindle (Mazak)
    for (const char c : {'P', 'Q', 'R'}) take(c);
  for (int i = 0; i < 3; ++i) {
    const Word* word = take("XYZ"[i]);
    if (!word) continue;
    const double value = axis_value(i, *word, false);
    const bool is_known = position_.known.has(i);
    const bool of_tool = states_tip();
    if (is_known && of_tool) note_tip(*word);
    if (is_known && control_.paused)
      note_once("touch-off",
                fmt::format("G92 behind a pause: {} may have been moved by hand. It is taken to be "
                            "where G92 says, and the zero stays as it was",
                            "XYZ"[i]),
                *word, fmt::format("touch-off {}", i));
    if (!is_known || control_.paused ||
        of_tool) {  // it is the first position that the program states
      component(position_.physical, i) = value + component(frames_.total.shift, i);
      component(position_.programmed, i) = value;
      position_.known.add(i);
      continue;
    }
    if (is(Dialect::fanuc) && modal_.incremental && value != 0)
      reporter_.once(Severity::warning, "position-added",
                     "G92 in G91 is read as the place where the tool is; newer controls add its "
                     "words to the position",
                     *word, "G92");
    if (is(Dialect::fanuc)) end_local(i);
    if (position_.told_axes.empty()) position_.shift_before = frames_.position_shift;
    position_.told_axes.add(i);
    component(position_.told, i) = value;
    component(frames_.position_shift, i) += component(position_.programmed, i) - value;
  }
  for (int i = 0; lathe() && i < 3; i += 2)  // U and W: the coordinates grow by that much
    if (const Word* more = take("UVW"[i]))
      component(frames_.position_shift, i) -= axis_value(i, *more, true);
  frames_.position_memory = frames_.position_shift;
  frame_words_.rebuild();
  return true;
}

// Old lathes have no geometry offsets: the part of the program for each tool begins with a G50 that
// says where its tip is, while the turret stands at one place for all tools. The zero does not
// change.
bool OneShotWords::states_tip() const {
  return lathe() && is(Dialect::fanuc) && position_.new_tool;
}

void OneShotWords::note_tip(const Word& word) {
  note_once("touch-off",
            fmt::format("G50 beside the change to tool {} is taken to say where its tip is: the "
                        "zero stays as it was",
                        control_.tool.current),
            word, "tip");
}

// The tool of such a G50 comes in a block behind it.
void OneShotWords::settle_tip() {
  if (!states_tip() || position_.told_axes.empty()) return;
  frame_words_.save();
  for (int i = 0; i < 3; ++i)
    if (position_.told_axes.has(i))
      component(frames_.position_shift, i) = component(position_.shift_before, i);
  frames_.position_memory = frames_.position_shift;
  frame_words_.rebuild();
  for (int i = 0; i < 3; ++i) {
    if (!position_.told_axes.has(i)) continue;
    component(position_.programmed, i) = component(position_.told, i);
    component(position_.physical, i) =
        component(position_.told, i) + component(frames_.total.shift, i);
  }
  position_.told_axes = {};
  note_tip(block_.words.front());
}

// G27 and G60 arrive with a rapid. The direction from which G60 arrives has no effect on the part.
bool OneShotWords::rapid_to() {
  Target to;
  if (!axes_.target(to, position_.programmed)) return false;
  if (!to.named.empty()) moves_.step(to, *block_.oneshot, MotionKind::rapid);
  return true;
}

// G92 of FANUC ends G52 for its axes: the shift of G52 becomes part of that of G92.
void OneShotWords::end_local(int axis) {
  component(frames_.position_shift, axis) += component(frames_.local, axis);
  component(frames_.local, axis) = 0;
}

// G92.1 deletes the shift of G92; on FANUC only for the axes beside it, and the shift of G52 with
// it. G92.2 sets the shift aside, G92.3 takes it back.
bool OneShotWords::suspend_position() {
  AxisSet axes;
  if (is(Dialect::fanuc) || is(Dialect::iso))
    for (int i = 0; i < 3; ++i)
      if (take("XYZ"[i])) axes.add(i);
  frame_words_.save();
  const bool resets = block_.oneshot_code == Code::position_reset;
  if (block_.oneshot_code == Code::position_resume)
    frames_.position_shift = frames_.position_memory;
  for (int i = 0; i < 3; ++i) {
    if (block_.oneshot_code == Code::position_resume) break;
    if (!axes.empty() && !axes.has(i)) continue;
    if (resets) component(frames_.position_memory, i) = 0;
    if (resets && is(Dialect::fanuc)) component(frames_.local, i) = 0;
    component(frames_.position_shift, i) = 0;
  }
  frame_words_.rebuild();
  if (is(Dialect::ngc)) block_.oneshot = nullptr;  // axes beside it belong to a motion
  return true;
}

// G92 of CODESYS moves the position without a path.
bool OneShotWords::position_jump() {
  Target to;
  if (!axes_.target(to, position_.programmed)) return false;
  moves_.jump(to);
  return true;
}

}  // namespace mrsim
