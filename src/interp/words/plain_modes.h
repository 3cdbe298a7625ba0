// Modes that cannot fail and are no more than a value: units, feeds, centres, diameters, tool
// length. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class PlainModes : public ControlPart {
 public:
  explicit PlainModes(Control& control) : ControlPart(control) {}

  /// Sets the mode that the word names. False: the word names no such mode.
  bool apply(Code code, const Word& word);
  /// Words that say what F and S mean. False: it is another word.
  bool apply_feed(Code code, const Word& word);

 private:
  void turn_polar(bool on, const Word& word);
};

}  // namespace mrsim
