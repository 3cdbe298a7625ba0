#include "interp/words/plain_modes.h"

#include "core/numbers/rounding.h"

#include <cmath>

namespace mrsim {

bool PlainModes::apply(Code code, const Word& word) {
  if (apply_feed(code, word)) return true;
  Modal& m = modal_;
  m.units_given |= code == Code::inch || code == Code::metric || code == Code::inch_feed ||
                   code == Code::metric_feed;
  if (code == Code::inch || code == Code::metric) {
    m.inch = code == Code::inch;
    m.inch_feed = false;  // G70 is in one group with G700 and G710
  } else if (code == Code::inch_feed || code == Code::metric_feed) {
    m.inch = m.inch_feed = code == Code::inch_feed;
  } else if (code == Code::center_absolute || code == Code::center_relative) {
    m.center_absolute = code == Code::center_absolute;
    m.center_told = true;
  } else if (code == Code::polar_on || code == Code::polar_off) {
    turn_polar(code == Code::polar_on, word);
  } else if (code == Code::diameter_on || code == Code::diameter_off ||
             code == Code::diameter_absolute) {
    m.diameter = code;
    m.diameter_told = true;
  } else if (code == Code::length_plus || code == Code::length_minus || code == Code::length_off ||
             code == Code::length_dynamic || code == Code::length_add) {
    m.length = code;
    block_.length_changed = true;
  } else if (code == Code::path_smoothing) {
    if (word.value > 50)
      warning("path-smoothing", "the path is read without the smoothing that the PLC adds", word);
    if (word.value > 50) take('D');
  } else if (code == Code::suppress_frames) {
    block_.suppress_frames = true;
  } else if (code == Code::program_return) {
    block_.return_after = true;
  } else if (code != Code::header && code != Code::diameter_cycles_off) {
    return false;
  }
  return true;
}

// G16 and G15: the values of the last polar block no longer count.
void PlainModes::turn_polar(bool on, const Word& word) {
  if (on == modal_.polar) return;
  modal_.polar = on;
  position_.has_polar_angle = position_.has_polar_radius = false;
  const bool increments =
      block_.has_code('G', 91) || (modal_.incremental && !block_.has_code('G', 90));
  if (on && increments)
    reporter_.once(Severity::warning, "polar-pole",
                   "G16 in G91: a radius in G91 is read about the tool's place, all else about the "
                   "zero; a control may keep the present place as the pole, so write G16 in G90",
                   word, "pole");
  const Basis b = basis();
  const Vec3& at = position_.programmed;
  if (on && is(Dialect::iso) &&
      (std::abs(dot(at, b.u)) > kRounding || std::abs(dot(at, b.v)) > kRounding))
    reporter_.once(Severity::warning, "polar-pole",
                   "G16 is read about the zero, as FANUC has it; Mach turns about the place where "
                   "the tool is: write G16 at the zero, or places with X and Y",
                   word, "pole");
}

bool PlainModes::apply_feed(Code code, const Word& word) {
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

}  // namespace mrsim
