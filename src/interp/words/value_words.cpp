#include "interp/words/value_words.h"

#include "core/text/text_io.h"
#include "core/words/tool_types.h"
#include "interp/text/characters.h"
#include "interp/words/unread_modes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace mrsim {

bool ValueWords::apply() {
  if (block_.turn_cycle != 0)  // A D H K of a turning cycle have other meanings
    return speed() && (block_.turn_cycle == 76 || feed()) && tools_.apply();
  const bool own = is(Dialect::codesys) ? codesys() : rotary_axes() && speed() && edge();
  if (!own || !feed() || !tools_.apply() || !length_register()) return false;
  return !is(Dialect::sinumerik) || sinumerik();
}

// On FANUC lathes A is the angle of a line, and C beside one axis is a chamfer.
bool ValueWords::turned_line(char c) {
  if (!lathe() || !is(Dialect::fanuc) || current_motion() != Code::line || block_.oneshot)
    return false;
  const Word* word = peek(c);
  if (!word || c == 'B') return false;
  const bool x = peek('X') || peek('U'), z = peek('Z') || peek('W');
  if (c == 'C' && (x == z || word->value == 0 || axis_c_)) return false;
  note_once("lathe-corner",
            fmt::format("{} is read as {} (on a machine with an axis {} write ,{})", text_of(*word),
                        c == 'A' ? "the angle of the line" : "a chamfer", c, c),
            *word, std::string(1, c));
  return true;
}

// What the letter probably is: on a lathe B and A are rarely rotary axes.
std::string ValueWords::unread_axis(char c) const {
  if (!lathe()) return fmt::format("{} is a rotary axis", c);
  if (c == 'C') return "C turns the spindle of the lathe to an angle";
  return fmt::format(
      "{} of a lathe is the place of its sub-spindle or tailstock, or the tilt of its tools", c);
}

// "M11 C8" and "M12 C8" of WinCNC switch an output of the board on and off.
bool ValueWords::switches_channel() {
  const Word* m = is(Dialect::ngc) ? peek('M') : nullptr;
  return m && (m->value == 11 || m->value == 12) && take('C');
}

// Reports that a rotary axis leaves 0. True: in a mode that is not read any more from here on.
bool ValueWords::turns_in_mode(char c, const Word& word) {
  UnreadModes(control_).turn();
  reporter_.once(Severity::error, "not-supported",
                 unread_axis(c) +
                     ", which is not supported yet; --until LINE simulates what "
                     "stands before it",
                 word, std::string("turned ") + c);
  return control_.unread_end != 0;
}

bool ValueWords::rotary_axes() {
  const bool turns = block_.frame_code && block_.frame_op == Code::rotation_on;
  for (const char c : {'A', 'B', 'C'}) {
    if (turns && c != 'C') continue;  // A and B are the centre of Mach's G68
    if (control_.unread_end == 0 && turned_line(c)) continue;
    if (c == 'C' && switches_channel()) continue;
    const Word* word = block_.unused(letter(c)) ? take(c) : nullptr;
    if (!word) continue;
    axis_c_ = axis_c_ || c == 'C';
    if (control_.unread_end != 0) continue;
    if (word->value != 0) {
      if (!turns_in_mode(c, *word)) return false;
      continue;
    }
    note_once("rotary-axis", fmt::format("rotary axis {} stays at 0", c), *word, std::string(1, c));
  }
  if (!is(Dialect::ngc)) return true;
  for (const char c : {'U', 'V', 'W'}) {
    const Word* word = take(c);
    if (!word) continue;
    if (word->value != 0)
      return error("not-supported",
                   fmt::format("{} is an auxiliary axis, which is not supported yet", c), *word);
    note_once("auxiliary-axis", fmt::format("auxiliary axis {} stays at 0", c), *word,
              std::string(1, c));
  }
  return true;
}

// CODESYS: P Q U V W are axes that the PLC uses for something else (a gripper, a laser's power).
void ValueWords::auxiliary_axes() {
  for (const char c : {'P', 'Q', 'U', 'V', 'W'}) {
    const Word* word = take(c);
    if (!word) continue;
    const std::string axis(1, c);
    if (word->value == 0)
      note_once("auxiliary-axis", fmt::format("auxiliary axis {} stays at 0", c), *word, axis);
    else
      reporter_.once(Severity::warning, "auxiliary-axis",
                     fmt::format("{} moves an auxiliary axis: it is taken to move neither the tool "
                                 "nor the part",
                                 c),
                     *word, "moved " + axis);
  }
}

bool ValueWords::sinumerik() {
  take('H');
  const bool machine_axes = block_.oneshot && (block_.oneshot_code == Code::reference_approach ||
                                               block_.oneshot_code == Code::fixed_point);
  for (const Word& word : block_.words) {
    const auto c = static_cast<char>(word.code);
    const bool turns = word.address == Address::data && c >= 'A' && c <= 'C';
    if (turns && upper(text_of(word).front()) == 'P') {  // POS[B]=30, but not a loader of a lathe
      if (word.value != 0 && !lathe() && control_.unread_end == 0 && !turns_in_mode(c, word))
        return false;
      continue;
    }
    if (turns && control_.unread_end == 0 && UnreadModes(control_).tilts(word)) {
      reporter_.once(Severity::error, "not-supported",
                     "A3= B3= C3= and their kin lead the tool's axis (TRAORI, five axes), which is "
                     "not supported",
                     word, "direction");
      if (control_.unread_end == 0) return false;
      continue;
    }
    if (word.address == Address::data && c >= 'X' && c <= 'Z' && !machine_axes)
      return error("not-supported",
                   "a machine axis is named, which is supported only in G74 and G75", word);
  }
  if (const Word* word = take(Address::rndm)) {
    if (word->value < 0) return error("value-range", "RNDM must not be negative", *word);
    modal_.rndm = word->value * scale();
  }
  if (const Word* word = take(Address::meas)) {
    block_.motion_code = word;
    block_.motion = Code::probe;
  }
  if (const Word* word = take(Address::offn)) modal_.offn = word->value * scale();
  if (const Word* word = take(Address::frcm)) modal_.frcm = word->value * feed_scale();
  if (const Word* word = take(Address::disc)) {
    if (word->value < 0 || word->value > 100)
      return error("value-range", "DISC is 0 to 100", *word);
    modal_.disc = word->value;
  }
  return true;
}

// FZ needs the number of teeth, which is not in the tool table and has no effect on the part.
bool ValueWords::feed_per_tooth(const Word& word) {
  if (word.value <= 0) return error("feed-range", "FZ must be above 0 (alarm 14800)", word);
  modal_.feed_unit = FeedUnit::mm_per_rev;
  modal_.feed = word.value * feed_scale();
  note_once("feed-per-tooth", "FZ is a feed per tooth: times are those of a tool with one tooth",
            word, "teeth");
  return true;
}

bool ValueWords::feed() {
  if (const Word* tooth = take(Address::fz)) return feed_per_tooth(*tooth);
  const Word* word = block_.unused(letter('F')) ? take('F') : nullptr;  // F of G131 is no feed
  if (!word) return true;
  const bool cycle = modal_.drill.number != 0 || modal_.turn.number != 0 || block_.turn_cycle != 0;
  const bool thread = is_thread(current_motion()) && !cycle;
  if ((thread && !is(Dialect::sinumerik)) || modal_.turn.number == 92) {  // F is the lead
    keep_lead_as_feed(word->value * feed_scale());
    return true;
  }
  if (word->value < 0 || (word->value == 0 && is(Dialect::sinumerik)))
    return error("feed-range",
                 fmt::format("F{:g}: the feed must be above 0{}", word->value,
                             is(Dialect::sinumerik) ? " (alarm 14800)" : ""),
                 *word);
  if (thread && current_motion() != Code::tap_floating) return true;
  modal_.feed =
      modal_.feed_unit == FeedUnit::inverse_time ? word->value : word->value * feed_scale();
  modal_.feed_of_turn = modal_.feed_unit == FeedUnit::mm_per_rev;
  return true;
}

// M300 S440 P200 of routers' boards is a tone.
bool ValueWords::beeps() const { return block_.has_code('M', 300); }

// Whether D stands beside LinuxCNC's G96.
bool ValueWords::d_limits_speed() const {
  const bool speeds = block_.has_group(Group::speed);
  return is(Dialect::ngc) && speeds && modal_.surface_speed;
}

// S of G25 and G26 of SINUMERIK, S of G50 and G92, and D beside LinuxCNC's G96 limit the speed of
// the spindle. False: S is a speed. G25 is a lower limit, on which no time depends.
bool ValueWords::limits_speed(const Word* s) {
  const bool own = block_.frame_code && block_.frame_op == Code::speed_limit;
  if (d_limits_speed())
    if (const Word* most = take('D')) modal_.speed_limit = most->value;
  if (!own && !(block_.oneshot && block_.oneshot_code == Code::set_position)) return false;
  if (s && !(own && block_.frame_code->value == 25)) modal_.speed_limit = s->value;
  return true;
}

bool ValueWords::speed() {
  if (const Word* word = take(Address::lims)) {
    if (word->value <= 0) return error("value-range", "LIMS must be above 0", *word);
    modal_.speed_limit = word->value;
  }
  if (is(Dialect::ngc)) take('$');  // the number of the spindle
  const bool speeds = block_.has_group(Group::speed);
  if (is(Dialect::fanuc) && lathe() && speeds) take('P');  // the axis to which G96 refers
  const Word* word = take('S');
  if (word && beeps()) return true;
  if (word && word->value < 0) return error("speed-range", "S must not be negative", *word);
  if (limits_speed(word) || !word) return true;
  if (modal_.surface_speed)
    modal_.cutting_speed = word->value * (modal_.inch_feed ? 0.3048 : 1.0);
  else
    modal_.speed = word->value;
  return true;
}

// D is the number of a register or of a cutting edge.
bool ValueWords::edge() {
  const Word* word = block_.unused(letter('D')) ? take('D') : nullptr;  // D of G131 is a tolerance
  if (!word || d_limits_speed()) return true;
  if (modal_.comp_diameter) {  // D of G41.1 is the diameter; below 0 it means the other side
    modal_.edge_radius = word->value * length_unit(*word) / 2;
    return tip_of_diameter();
  }
  if (word->value < 0 || word->value != std::floor(word->value) || word->value > 1e6)
    return error("value-range", "D is a whole number", *word);
  modal_.edge = static_cast<int>(word->value);
  if (lathe() && is(Dialect::sinumerik) && !control_.tool.failed) control_.tool.index = -1;
  modal_.edge_given = true;
  control_.edge_word = *word;
  return true;
}

// L beside G41.1 and G42.1 is the orientation of a lathe's tip. Without it they lead the centre.
bool ValueWords::tip_of_diameter() {
  modal_.comp_tip = 0;
  const Word* word = block_.comp_word ? take('L') : nullptr;
  if (!word) return true;
  if (word->value < 0 || word->value > 9 || word->value != std::floor(word->value))
    return error("value-range", "L of G41.1 and G42.1 is the orientation of the tip, 0 to 9",
                 *word);
  if (modal_.plane != kPlaneZX)
    return error("comp-plane", "L of G41.1 and G42.1 is for lathes and needs G18", *word);
  modal_.comp_tip = tip_of_linuxcnc(static_cast<int>(word->value));
  return true;
}

// X Y Z of G43.1 and G43.2 are lengths of the tool, not places.
bool ValueWords::take_lengths(const Word* h) {
  const char* const name = modal_.length == Code::length_dynamic ? "G43.1" : "G43.2";
  if (block_.motion_code && block_.motion_code->address == letter('G'))
    return error("word-unexpected",
                 fmt::format("{} beside {}, whose axes are lengths: write it into another block",
                             text_of(*block_.motion_code), name),
                 *block_.motion_code);
  for (int i = 0; i < 3; ++i)
    if (const Word* word = take("XYZ"[i]))
      control_.lengths.set(
          {0, SetLengths::kDynamic}, i, std::nullopt,
          {word->value * length_unit(*word), false, fmt::format("{} of {}", text_of(*word), name),
           block_.motion_at(word->column), "XYZ"[i]});
  if (h && modal_.length == Code::length_add)
    control_.lengths.set_another(
        {0, SetLengths::kDynamic}, 2,
        {0, true, fmt::format("{} of {}", text_of(*h), name), block_.motion_at(h->column), 'Z'});
  return true;
}

// G43 of LinuxCNC puts the length in force that G10 L1 has set: of the tool H, or of the one in the
// spindle.
void ValueWords::meet_table(const Word* h) {
  modal_.length_number = h ? h->value : parse_number(control_.tool.current).value_or(0);
  for (int kind = 0; kind < 3; ++kind)
    if (const SetLengths::Setting* set =
            control_.lengths.find({SetLengths::kTable, modal_.length_number}, kind))
      control_.lengths.set({0, modal_.length_number}, kind, std::nullopt, *set);
}

bool ValueWords::length_register() {
  if (is(Dialect::sinumerik) || is(Dialect::codesys)) return true;
  const Word* word = take('H');
  if (!word && !block_.length_changed) return true;
  const bool chosen = block_.length_changed;
  block_.length_changed = false;
  if (modal_.length == Code::length_dynamic || modal_.length == Code::length_add) {
    if (chosen && !take_lengths(word)) return false;
    note_once("tool-length", "positions are read as those of the tool's tip, whatever its length",
              block_.words.front(), "length");
    return true;
  }
  if (modal_.length == Code::length_off) {
    const bool named = block_.has_group(Group::length);
    const bool work = block_.has_group(Group::work);
    if (is(Dialect::fanuc) && work && !named && word && word->value != 0)
      return error("not-supported",
                   "H beside a work offset and without G43 is a tool length of Okuma's OSP, which "
                   "is not supported: write G43",
                   *word);
    modal_.length_offset = 0;
    return true;
  }
  if (is(Dialect::ngc) && chosen) meet_table(word);
  const bool of_tool = is(Dialect::ngc) && chosen && !word;
  if (!word && !of_tool) return true;
  if (word) modal_.length_number = word->value;
  const std::string name = fmt::format("H{:g}", modal_.length_number);
  const OffsetRegister* reg = tools_.find_register(name);
  modal_.length_told = reg != nullptr;
  if (!reg && of_tool) return true;
  if (!reg && word->value != 0) {  // reported once where the table has no lengths at all
    const std::vector<OffsetRegister>& all = control_.registers;
    const bool lengths = std::any_of(all.begin(), all.end(),
                                     [](const auto& one) { return one.name.starts_with('H'); });
    note_once("register-missing", name + " is not in the tool table: 0 is used", *word,
              lengths ? name : "H");
  }
  const double sign = modal_.length == Code::length_minus ? -1 : 1;
  modal_.length_offset = reg ? sign * (reg->length + reg->wear) : 0;
  return true;
}

// E, S, FF and EF of CODESYS shape the speed, not the path.
void ValueWords::dynamics() {
  const Word* acceleration = take('E');
  if (const Word* more = take(Address::ef); !acceleration) acceleration = more;
  if (acceleration)
    note_once("dynamics-unread",
              "E and EF are accelerations: times are those of the machine's own (--machine-file)",
              *acceleration, "E");
  if (const Word* profile = take('S'))
    note_once("dynamics-unread", "S is the profile of the velocity, not a spindle: not in the time",
              *profile, "S");
  if (const Word* rapid = take(Address::ff))
    note_once("dynamics-unread",
              "FF is the speed of G0: times are those of the machine's own rapids (--machine-file)",
              *rapid, "FF");
}

// Words that only CODESYS has. H, L and O are switch points: they have no geometry, but are
// checked.
bool ValueWords::codesys() {
  if (!rotary_axes()) return false;
  auxiliary_axes();
  dynamics();
  int switches = 0, negative = 0, positive = 0;
  for (const Word& word : block_.words) {
    const auto c = static_cast<char>(word.address);
    if (c == 'H' && (word.value == 0 || word.value != std::floor(word.value)))
      return error("value-range", "H is a whole number, not 0: the switch and its state", word);
    if (c == 'H' && ++switches > 3)
      return error("value-range", "at most three switch points in a block", word);
    if (c == 'O' && (word.value < 0 || word.value > 1))
      return error("value-range", "O is a share of the path from 0 to 1", word);
    if (c == 'E') {
      int& count = word.value < 0 ? negative : positive;
      if (++count > 1) return error("address-twice", "E is given twice with the same sign", word);
    }
  }
  const Word* d = take('D');
  if (d) {
    if (d->value < 0) return error("value-range", "D is a radius and must not be negative", *d);
    // The radius is the tool's beside G41 and G42, and that of smoothing anywhere else.
    const bool named = block_.has_group(Group::comp);
    if (named && modal_.comp != Code::comp_off) modal_.edge_radius = d->value;
  }
  return true;
}

}  // namespace mrsim
