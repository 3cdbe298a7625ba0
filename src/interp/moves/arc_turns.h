// How many turns an arc makes: P, TURN=, the pitch of a helix. Private to src/interp.
#pragma once

#include "interp/moves/point_arcs.h"

namespace mrsim {

class ArcTurns : public ControlPart {
 public:
  explicit ArcTurns(Control& control) : ControlPart(control) {}

  /// Adds the full turns that the block asks for. False: an error was reported.
  bool add(SolvedArc& arc);
  /// Whether the word of the centre along `normal` is the pitch of a helix to `to`.
  bool is_pitch(const Target& to, const Vec3& normal) const;

 private:
  bool add_p_turns(SolvedArc& arc);
  bool add_pitch_turns(SolvedArc& arc);
};

}  // namespace mrsim
