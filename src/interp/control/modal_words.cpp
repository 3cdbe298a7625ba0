// G words that last, values that last (F S D H ...) and M words.
#include "core/units.h"
#include "interp/characters.h"
#include "interp/engine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

// M words that control spindle, coolant, chuck and the like: no geometry, no note.
constexpr std::array<int, 34> kKnownM = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11,
                                         13, 14, 17, 19, 29, 30, 36, 37, 38, 40, 41, 42,
                                         43, 44, 45, 46, 48, 49, 70, 98, 99, 97};
constexpr int kMostM = 5;  // in a block of SINUMERIK

}  // namespace

bool Engine::apply_modal_code(const Word& word, const CodeEntry& entry) {
  if (apply_mode(entry.code, word) || apply_comp_code(entry.code, word)) return true;
  switch (entry.code) {
    case Code::plane_xy:
    case Code::plane_2d:
      return select_plane(0, word);
    case Code::plane_zx:
      return select_plane(1, word);
    case Code::plane_yz:
      return select_plane(2, word);
    case Code::plane_normal:
      return select_normal(word);
    case Code::absolute:
    case Code::incremental:
      return select_distance(entry.code, word);
    case Code::work_off:
    case Code::work_offset:
    case Code::work_extended:
      return select_work(entry, word);
    case Code::tap_floating:
      motion_code_ = &word;
      block_motion_ = entry.code;
      return true;
    case Code::dwell:
    case Code::reference:
    case Code::reference_second:
    case Code::reference_approach:
    case Code::fixed_point:
    case Code::set_position:
    case Code::position_jump:
    case Code::decoder_length:
      oneshot_ = &word;
      oneshot_code_ = entry.code;
      return true;
    default:
      frame_code_ = &word;
      frame_op_ = entry.code;
      return true;
  }
}

// Units, feeds and other modes that cannot fail. False: not one of them.
bool Engine::apply_mode(Code code, const Word& word) {
  if (apply_feed_mode(code, word)) return true;
  Modal& m = modal_;
  if (code == Code::inch || code == Code::metric) {
    m.inch = code == Code::inch;
  } else if (code == Code::inch_feed || code == Code::metric_feed) {
    m.inch = m.inch_feed = code == Code::inch_feed;
  } else if (code == Code::center_absolute || code == Code::center_relative) {
    m.center_absolute = code == Code::center_absolute;
  } else if (code == Code::polar_on || code == Code::polar_off) {
    m.polar = code == Code::polar_on;
  } else if (code == Code::diameter_on || code == Code::diameter_off ||
             code == Code::diameter_absolute) {
    m.diameter = code;
  } else if (code == Code::length_plus || code == Code::length_minus || code == Code::length_off) {
    m.length = code;
    length_changed_ = true;
  } else if (code == Code::path_smoothing) {
    if (word.value > 50)
      warning("path-smoothing", "the path is read without the smoothing that the PLC adds", word);
    if (word.value > 50) take('D');
  } else if (code == Code::suppress_frames) {
    suppress_ = true;
    if (options_.table.work.empty())
      note_once("machine-coordinates",
                "no machine zero is known: machine coordinates are read as those of the stock",
                word, "g53");
  } else if (code == Code::program_return) {
    return_after_ = true;
  } else if (code != Code::header && code != Code::diameter_cycles_off) {
    return false;
  }
  return true;
}

// What F and S mean. False: another word.
bool Engine::apply_feed_mode(Code code, const Word& word) {
  Modal& m = modal_;
  if (code == Code::inverse_time || code == Code::per_minute || code == Code::per_revolution) {
    m.feed_unit = code == Code::inverse_time ? FeedUnit::inverse_time
                  : code == Code::per_minute ? FeedUnit::mm_per_min
                                             : FeedUnit::mm_per_rev;
    if (is(Dialect::sinumerik)) m.surface_speed = false;
  } else if (code == Code::surface_speed || code == Code::surface_speed_off) {
    m.surface_speed = code == Code::surface_speed;
    if (word.value == 961 || word.value == 971)
      m.feed_unit = FeedUnit::mm_per_min;
    else if (m.surface_speed && is(Dialect::sinumerik) && word.value != 962)
      m.feed_unit = FeedUnit::mm_per_rev;
  } else {
    return false;
  }
  return true;
}

// Words about radius compensation. False: not one of them.
bool Engine::apply_comp_code(Code code, const Word& word) {
  Modal& m = modal_;
  if (code == Code::comp_off || code == Code::comp_left || code == Code::comp_right) {
    comp_selected_ = code != m.comp;
    m.comp = code;
    comp_word_ = word;
  } else if (code == Code::comp_suspend || code == Code::comp_resume) {
    m.comp_suspended = code == Code::comp_suspend;
  } else if (code == Code::corner_arc || code == Code::corner_intersection) {
    m.corner = code;
  } else if (code == Code::approach_normal || code == Code::approach_contour) {
    m.approach = code;
  } else {
    return false;
  }
  return true;
}

// On FANUC lathes G90 is a turning cycle in code system A. Beside a motion word of the same group
// it cannot be one, and G91 exists only in systems B and C.
bool Engine::select_distance(Code code, const Word& word) {
  if (is(Dialect::fanuc) && lathe() && (peek('X') || peek('Z') || peek('U') || peek('W'))) {
    const bool moves = std::any_of(block_.words.begin(), block_.words.end(), [&](const Word& w) {
      return w.address == letter('G') && lookup(w).group == Group::motion;
    });
    if (!moves && code == Code::absolute) {
      in_cycle_ = true;
      return error("not-supported",
                   "G90 with axes is a turning cycle of code system A, which is not supported yet; "
                   "neither are its points in the blocks behind it",
                   word);
    }
    note_once("code-system", "G90 and G91 are read as absolute and incremental (code systems B, C)",
              word, "code-system");
  }
  modal_.incremental = code == Code::incremental;
  return true;
}

bool Engine::select_plane(int plane, const Word& word) {
  if (plane != modal_.plane && modal_.comp != Code::comp_off && comp_started_)
    return error("comp-plane",
                 fmt::format("the plane must not change under radius compensation{}",
                             is(Dialect::sinumerik) ? " (alarm 10757)"
                             : is(Dialect::fanuc)   ? " (alarm 037)"
                                                    : ""),
                 word);
  if (plane != modal_.plane) position_.has_polar_angle = false;
  modal_.plane = plane;
  return true;
}

// CODESYS G16 I J K: the plane by its normal.
bool Engine::select_normal(const Word& word) {
  Vec3 normal;
  for (int i = 0; i < 3; ++i)
    if (const Word* w = take("IJK"[i])) component(normal, i) = w->value;
  if (length(normal) < 1e-9)
    return error("value-missing", "G16 needs the normal vector I J K of the plane", word);
  modal_.normal = normalized(normal);
  modal_.plane = 3;
  return true;
}

bool Engine::apply_values() {
  if (is(Dialect::codesys)) {
    if (!apply_codesys_values()) return false;
  } else {
    for (const char c : {'A', 'B', 'C'}) {
      const Word* word = take(c);
      if (!word) continue;
      if (word->value != 0)
        return error("not-supported",
                     fmt::format("{} is a rotary axis, which is not supported yet", c), *word);
      note_once("rotary-axis", fmt::format("rotary axis {} stays at 0", c), *word,
                std::string(1, c));
    }
    if (!apply_speed() || !apply_edge()) return false;
  }
  if (!apply_feed() || !apply_tool() || !apply_length()) return false;
  if (!is(Dialect::sinumerik)) return true;
  take('H');
  const bool machine_axes =
      oneshot_ && (oneshot_code_ == Code::reference_approach || oneshot_code_ == Code::fixed_point);
  for (const Word& word : block_.words) {
    const auto c = static_cast<char>(word.code);
    if (word.address == Address::data && c >= 'X' && c <= 'Z' && !machine_axes)
      return error("not-supported",
                   "a machine axis is named, which is supported only in G74 and G75", word);
  }
  if (const Word* word = take(Address::rndm)) {
    if (word->value < 0) return error("value-range", "RNDM must not be negative", *word);
    modal_.rndm = word->value * scale();
  }
  if (const Word* word = take(Address::frcm)) modal_.frcm = word->value * feed_scale();
  if (const Word* word = take(Address::disc)) {
    if (word->value < 0 || word->value > 100)
      return error("value-range", "DISC is 0 to 100", *word);
    modal_.disc = word->value;
  }
  return true;
}

bool Engine::apply_feed() {
  const Word* word = take('F');
  if (!word) return true;
  if (is_thread(current_motion()) && !is(Dialect::sinumerik)) return true;  // the lead, see below
  if (word->value < 0 || (word->value == 0 && is(Dialect::sinumerik)))
    return error("feed-range",
                 fmt::format("F{:g}: the feed must be above 0{}", word->value,
                             is(Dialect::sinumerik) ? " (alarm 14800)" : ""),
                 *word);
  if (is_thread(current_motion()) && current_motion() != Code::tap_floating) return true;
  modal_.feed =
      modal_.feed_unit == FeedUnit::inverse_time ? word->value : word->value * feed_scale();
  return true;
}

bool Engine::apply_speed() {
  if (const Word* word = take(Address::lims)) {
    if (word->value <= 0) return error("value-range", "LIMS must be above 0", *word);
  }
  const Word* word = take('S');
  if (!word) return true;
  if (word->value < 0) return error("speed-range", "S must not be negative", *word);
  if (frame_code_ && frame_op_ == Code::speed_limit) return true;
  if (oneshot_ && oneshot_code_ == Code::set_position) return true;  // G50 S: a limit
  if (modal_.surface_speed)
    modal_.cutting_speed = word->value * (modal_.inch_feed ? 0.3048 : 1.0);
  else
    modal_.speed = word->value;
  return true;
}

// D: number of a register or of a cutting edge.
bool Engine::apply_edge() {
  const Word* word = take('D');
  if (!word) return true;
  if (word->value < 0 || word->value != std::floor(word->value) || word->value > 1e6)
    return error("value-range", "D is a whole number", *word);
  modal_.edge = static_cast<int>(word->value);
  modal_.edge_given = true;
  edge_word_ = *word;
  return true;
}

bool Engine::apply_length() {
  if (is(Dialect::sinumerik) || is(Dialect::codesys)) return true;
  const Word* word = take('H');
  if (!word && !length_changed_) return true;
  length_changed_ = false;
  if (modal_.length == Code::length_off) {
    modal_.length_offset = 0;
    return true;
  }
  if (!word) return true;
  const std::string name = fmt::format("H{:g}", word->value);
  const OffsetRegister* reg = find_register(name);
  if (!reg && word->value != 0)
    note_once("register-missing", name + " is not in the tool table: 0 is used", *word, name);
  const double sign = modal_.length == Code::length_minus ? -1 : 1;
  modal_.length_offset = reg ? sign * (reg->length + reg->wear) : 0;
  return true;
}

// E H L O S: dynamics and switch points, without geometry, but checked.
bool Engine::apply_codesys_values() {
  for (const char c : {'A', 'B', 'C', 'P', 'Q', 'U', 'V', 'W', 'E', 'S'}) take(c);
  take(Address::ff);
  take(Address::ef);
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
    // Beside G41 and G42 the tool's radius, anywhere else that of smoothing.
    const bool named = (groups_ >> static_cast<unsigned>(Group::comp) & 1U) != 0;
    if (named && modal_.comp != Code::comp_off) modal_.edge_radius = d->value;
  }
  return true;
}

bool Engine::apply_m_words() {
  bool ok = true;
  int count = 0;
  for (const Word& word : block_.words) {
    if (word.address != letter('M')) continue;
    if (is(Dialect::sinumerik) && ++count == kMostM + 1)
      ok = error("m-words", fmt::format("at most {} M words in a block", kMostM), word);
    if (!apply_m_word(word)) ok = false;
  }
  return ok;
}

bool Engine::apply_m_word(const Word& word) {
  const double v = word.value;
  if (v < 0 || v != std::floor(v) || v > 1e8)
    return error("value-range", "an M number is a whole number", word);
  const int m = static_cast<int>(v);
  if (m == 6) tool_change_ = true;
  if (m == 2 || m == 30)  // in a subprogram of SINUMERIK the same as M17
    (is(Dialect::sinumerik) && stack_.size() > 1 ? return_after_ : stop_after_) = true;
  if (m == 17 && !is(Dialect::fanuc)) return_after_ = true;
  if (m == 99 && !is(Dialect::sinumerik)) {
    if (peek('P'))
      return error("not-supported", "M99 P (return to a block number) is not supported yet", word);
    return_after_ = true;
    m99_ = true;
  }
  if (m == 98 && !is(Dialect::sinumerik)) m98_ = &word;
  if (std::find(kKnownM.begin(), kKnownM.end(), m) == kKnownM.end())
    note_once("m-unknown",
              fmt::format("M{} is not known: taken to be without effect on the part", m), word,
              fmt::format("M{}", m));
  return true;
}

}  // namespace mrsim
