#include "interp/words/dwell_time.h"

#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLong = 50;        // s: from here on a number without a point is thousandths
constexpr double kComputed = 10;    // s: the same limit for a variable, as in other words of FANUC
constexpr double kSuspicious = 99;  // s: programs do not wait longer

}  // namespace

// On SINUMERIK F beside G4 is seconds, and S is turns of the spindle.
double DwellTime::of_sinumerik() {
  const Word *f = take('F'), *s = take('S'), *other = take(Address::data);
  for (const Word* unread : {take('P'), take('U'), other})
    if (unread)
      note_once("dwell-not-counted",
                fmt::format("{} beside G4 is not counted as time", text_of(*unread)), *unread,
                "word");
  return f ? f->value : s ? of_turns(s->value, *s) : 0;
}

double DwellTime::of_block() {
  if (is(Dialect::sinumerik)) return of_sinumerik();
  const Word *x = take('X'), *u = take('U'), *p = take('P'), *f = take('F');
  const Word* t = is(Dialect::codesys) ? take('T') : nullptr;
  const Word* k = is(Dialect::iso) ? take('K') : nullptr;
  for (const Word* word : {take('S'), take('E'), take(Address::data)})
    if (word)
      note_once("dwell-not-counted",
                fmt::format("{} beside G4 is not counted as time", text_of(*word)), *word, "word");
  if (p) return of_p(*p);
  if (k) return of_cycle(*k);
  if (x || u) return of_axis(x ? *x : *u);
  return t ? t->value : f ? f->value : 0;
}

double DwellTime::of_cycle(const Word& word) {
  if (word.address == letter('P')) return of_p(word);
  return word.point ? word.value : seconds(word, "Fagor's 8055 counts hundredths of them");
}

// P is milliseconds on FANUC, seconds on Haas with a decimal point, and seconds on LinuxCNC, its
// kin and CODESYS.
double DwellTime::of_p(const Word& word) {
  const bool computed = is_computed(word);
  if (is(Dialect::ngc) || is(Dialect::codesys))
    return word.value <= kSuspicious || !is(Dialect::ngc)
               ? word.value
               : seconds(word, "Mach may be set to milliseconds");
  if (is(Dialect::fanuc) && !computed) return word.point ? word.value : word.value / 1000;
  if (computed) return word.value < kComputed ? word.value : milliseconds(word);
  if (word.point) return word.value;
  return word.value < kLong ? seconds(word, "some controls count milliseconds")
                            : milliseconds(word);
}

// X and U are seconds. Without a decimal point FANUC counts least increments.
double DwellTime::of_axis(const Word& word) {
  if (!is(Dialect::fanuc) || word.point) return word.value;
  if (options_.least_increments) return word.value / 1000;
  return word.value < kLong ? word.value : milliseconds(word);
}

double DwellTime::milliseconds(const Word& word) {
  note_once("dwell-unit",
            fmt::format("{} = {:g} is read as milliseconds", text_of(word), word.value), word,
            "ms");
  return word.value / 1000;
}

double DwellTime::seconds(const Word& word, const char* others) {
  note_once("dwell-unit", fmt::format("{} is read as seconds; {}", text_of(word), others), word,
            "s");
  return word.value;
}

double DwellTime::of_turns(double turns, const Word& where) {
  if (turns == 0) return 0;
  if (!modal_.surface_speed && modal_.speed > 0) return 60 * turns / modal_.speed;
  note_once("dwell-not-counted",
            modal_.surface_speed
                ? "a dwell in turns under constant surface speed is not counted as time"
                : "a dwell in turns without a speed of the spindle is not counted as time",
            where, "turns");
  return 0;
}

}  // namespace mrsim
