// Engraves letters as strokes at one depth, with the tool lifted in between. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_mover.h"

#include <vector>

namespace mrsim {

class LetterCutter : public ControlPart {
 public:
  /// Heights along the normal of the plane, mm. A feed of 0 is the one in force.
  struct Levels {
    double safe = 0, depth = 0;
    double plunge = 0, feed = 0;
  };

  LetterCutter(Control& control, Moves& moves) : ControlPart(control), mover_(control, moves) {}

  CycleMover& mover() { return mover_; }
  /// Sets the word whose place in the text the motions have.
  void begin(const Word& where);
  /// Cuts strokes in the plane, mm. Warns once that the control's own letters differ.
  void cut(const std::vector<std::vector<Vec2>>& strokes, const Levels& levels);

 private:
  CycleMover mover_;
  Word where_;
};

}  // namespace mrsim
