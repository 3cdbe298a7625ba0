// How long a word makes the tool stay: the units of each control. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class DwellTime : public ControlPart {
 public:
  explicit DwellTime(Control& control) : ControlPart(control) {}

  /// The seconds that the words of G4 say; 0 where they say none.
  double of_block();
  /// The seconds that P or K of a cycle says.
  double of_cycle(const Word& word);
  /// The seconds of so many turns of the spindle; 0, with a note, where its speed is not known.
  double of_turns(double turns, const Word& where);

 private:
  double of_sinumerik();
  double of_p(const Word& word);
  double of_axis(const Word& word);
  double milliseconds(const Word& word);
  double seconds(const Word& word, const char* others);
};

}  // namespace mrsim
