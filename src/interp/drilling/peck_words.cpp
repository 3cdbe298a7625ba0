#include "interp/drilling/peck_words.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLongPeck = 50;  // from here on a number is thousandths: Q5000

}  // namespace

// FANUC ignores the sign of Q. Without a point a long Q counts least increments, and so does a long
// one that is computed: no stroke is that deep.
bool PeckWords::read(const Word& q) {
  if (q.value <= 0 && is(Dialect::ngc))
    return error("value-range", "Q, the depth of a stroke, must be above 0", q);
  modal_.drill.peck = std::abs(q.value) * length_unit(q);
  modal_.drill.first = 0;
  if (!read_haas_depth()) return false;
  const bool length = !is_computed(q) && (q.point || options_.least_increments);
  if (length || std::abs(q.value) < kLongPeck || !is(Dialect::fanuc)) return true;
  modal_.drill.peck *= modal_.least_increment();
  note_increments(q);
  return true;
}

// K of Haas beside Q of G73: the tool comes out to R whenever it is K deeper. K of FANUC is how
// often the block is run, and has no point.
bool PeckWords::read_haas_depth() {
  const Word* k = peek('K');
  if (modal_.drill.number != 73 || !is(Dialect::fanuc) || !k || !k->point) return true;
  take('K');
  if (is_computed(*k) && modal_.incremental && k->value > 1 && k->value == std::floor(k->value))
    return error(
        "value-range",
        fmt::format("{} beside G73 and Q can be read as {:g} holes (FANUC), or as the depth "
                    "between the ways out to R (Haas): write the number, with a point for "
                    "a depth and without one for holes",
                    text_of(*k), k->value),
        *k);
  modal_.drill.out_every = std::abs(k->value) * length_unit(*k);
  note_once("cycle-level",
            fmt::format("{} beside G73 and Q is read as Haas', the depth between the ways out to "
                        "R: repeats (FANUC's K) are written without a point",
                        text_of(*k)),
            *k, "G73 K");
  return true;
}

bool PeckWords::fill(Hole& hole, bool haas_words) {
  const double depth = std::abs(hole.safe - hole.bottom);
  const double along = hole.bottom < hole.safe ? -1 : 1;
  if (modal_.okuma)
    for (const char c : {'I', 'J'}) take(c);  // how far the tool goes back
  else if (haas_words && !modal_.drill.fagor && peek('I'))
    read_haas_strokes();
  if (modal_.drill.first != 0) return haas_pecks(hole);
  hole.out_every = modal_.drill.out_every;
  const double q = modal_.drill.peck;
  const Word& where = block_.motion_code ? *block_.motion_code : block_.words.front();
  if (q <= 0) {
    if (is(Dialect::ngc))
      return error("value-missing", fmt::format("G{} needs Q", modal_.drill.number), where);
    reporter_.once(Severity::warning, "value-missing", "no Q: the hole is drilled in one stroke",
                   where, "Q");
    return true;
  }
  if (depth / q > static_cast<double>(kMostStrokes))
    return error("value-range", fmt::format("Q{:g} makes more than {} strokes", q, kMostStrokes),
                 where);
  for (std::size_t i = 1; static_cast<double>(i) * q < depth - kRounding; ++i)
    hole.strokes.push_back(hole.safe + along * static_cast<double>(i) * q);
  return true;
}

// Haas: I is the first stroke, each next one is shorter by J, and K is the shortest. They stay in
// force for the points that follow.
void PeckWords::read_haas_strokes() {
  DrillCycle& cycle = modal_.drill;
  const auto value = [&](char c, double otherwise) {
    const Word* word = take(c);
    return word ? word->value * length_unit(*word) : otherwise;
  };
  cycle.first = value('I', 0);
  cycle.less = value('J', 0);
  cycle.least = value('K', cycle.first);
}

bool PeckWords::haas_pecks(Hole& hole) {
  const DrillCycle& cycle = modal_.drill;
  const Word& where = block_.motion_code ? *block_.motion_code : block_.words.front();
  const double depth = std::abs(hole.safe - hole.bottom);
  const double along = hole.bottom < hole.safe ? -1 : 1;
  double stroke = cycle.first;
  if (stroke <= 0 || cycle.least <= 0 || cycle.less < 0 ||
      depth / std::min(stroke, cycle.least) > static_cast<double>(kMostStrokes))
    return error("value-range", "I J K: the strokes of the cycle must be above 0", where);
  for (double at = stroke; at < depth - kRounding; at += stroke) {
    hole.strokes.push_back(hole.safe + along * at);
    stroke = std::max(stroke - cycle.less, cycle.least);
  }
  return true;
}

}  // namespace mrsim
