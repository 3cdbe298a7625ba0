#include "interp/moves/arc_turns.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kPitchApart = 0.01;  // turns: how far the pitch of a helix may miss its end

}  // namespace

// On Fagor K of a helix in G17 is its pitch (I in G19, J in G18).
bool ArcTurns::is_pitch(const Target& to, const Vec3& normal) const {
  return is(Dialect::iso) && named_along(to, normal);
}

// P is the number of all turns, with the programmed one. On Mitsubishi and Mazak P full turns are
// added to an arc that is no full turn itself.
bool ArcTurns::add_p_turns(SolvedArc& arc) {
  if (const Word* l = block_.unused(letter('L')) ? peek('L') : nullptr; l && !is(Dialect::ngc))
    return error(
        "not-supported",
        fmt::format("{} beside an arc (its turns on some controls) is not supported: write "
                    "a block for each turn",
                    text_of(*l)),
        *l);
  if (is(Dialect::iso) && !add_pitch_turns(arc)) return false;
  const Word* word = block_.unused(letter('P')) ? take('P') : nullptr;  // not that of G54.1
  if (!word) return true;
  const bool beside = is(Dialect::fanuc) && std::abs(arc.sweep) < kTwoPi - kTurnRounding;
  const double least = beside ? 0 : 1;
  if (word->value < least || word->value > 999 || word->value != std::floor(word->value))
    return error("arc-turns", "P is the number of turns, a whole number from 1 to 999", *word);
  arc.sweep += (arc.sweep < 0 ? -kTwoPi : kTwoPi) * (word->value - least);
  if (beside && word->value > 0)
    reporter_.once(Severity::warning, "arc-turns",
                   fmt::format("{} is read as full turns besides the arc, as on Mitsubishi and "
                               "Mazak; LinuxCNC counts the arc as one of them",
                               text_of(*word)),
                   *word, "turns");
  else if (is(Dialect::fanuc) && word->value > 1)
    note_once("arc-turns", "P is read as the number of turns", *word, "turns");
  return true;
}

// Adds as many full turns as lead to the end with the pitch of the block.
bool ArcTurns::add_pitch_turns(SolvedArc& arc) {
  const Vec3 normal = cross(arc.u, arc.v);
  const int along = normal.z != 0 ? 2 : normal.y != 0 ? 1 : 0;
  const Word* word = is_pitch(arc.to, basis().w) ? peek("IJK"[along]) : nullptr;
  if (!word || word->value == 0) return true;
  const double pitch = std::abs(word->value * length_unit(*word));
  const double rise = std::abs(dot(arc.to.programmed - position_.programmed, normal));
  const double more = rise / pitch - std::abs(arc.sweep) / kTwoPi, turns = std::round(more);
  if (turns < 0 || turns > 999 || std::abs(more - turns) > kPitchApart)
    return error("arc-turns",
                 fmt::format("{} is the pitch of the helix: in {:.6g} turns it does not lead to "
                             "the end of the arc",
                             text_of(*word), rise / pitch),
                 *word);
  arc.sweep += (arc.sweep < 0 ? -kTwoPi : kTwoPi) * turns;
  return true;
}

// TURN= is the number of full circles before the programmed arc.
bool ArcTurns::add(SolvedArc& arc) {
  if (!is(Dialect::sinumerik) && !is(Dialect::codesys)) return add_p_turns(arc);
  const Word* word = take(Address::turn);
  if (!word) return true;
  if (word->value < 0 || word->value > 999 || word->value != std::floor(word->value))
    return error("arc-turns", "TURN is a whole number from 0 to 999 (alarm 14048)", *word);
  arc.sweep += (arc.sweep < 0 ? -kTwoPi : kTwoPi) * word->value;
  return true;
}

}  // namespace mrsim
