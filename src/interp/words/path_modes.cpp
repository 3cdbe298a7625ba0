#include "interp/words/path_modes.h"

#include <fmt/format.h>

namespace mrsim {

bool PathModes::select(const Word& word, Code code) {
  block_.path_mode = code == Code::path_continuous ? PathMode::continuous
                     : code == Code::path_exact    ? PathMode::exact_path
                     : code == Code::path_stops    ? PathMode::exact_stop
                                                   : PathMode::exact_once;
  return code == Code::path_stops_once || values_of(word);
}

// G64 P Q of Mach and LinuxCNC. An R belongs to it where no motion of the block can use R.
bool PathModes::values_of(const Word& word) {
  if (is(Dialect::sinumerik) || (word.value != 61 && word.value != 64)) return true;
  if (word.value == 64)
    for (const char c : {'P', 'Q'}) take(c);
  const Word* r = is(Dialect::ngc) ? peek('R') : nullptr;
  if (!r || peek('X') || peek('Y') || peek('Z')) return true;
  if (word.value == 61) return error("word-unexpected", "R with no word that uses it", *r);
  if (orients_spindle())
    return error("word-unexpected", "R is G64's or M19's: write them on two lines", *r);
  take('R');
  return true;
}

bool PathModes::orients_spindle() const { return block_.has_code('M', 19); }

// G5 P10000, G5.1 Q1 and G8 P1 switch look-ahead. The same G words with axes are splines.
bool PathModes::look_ahead(const Word& word) {
  for (const char c : {'X', 'Y', 'Z', 'I', 'J', 'K'})
    if (peek(c))
      return error(
          "not-supported",
          fmt::format("{} with axes is a spline, which is not supported yet", text_of(word)), word);
  for (const char c : {'P', 'Q', 'R'}) take(c);
  return true;
}

}  // namespace mrsim
