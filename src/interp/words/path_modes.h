// How exactly the control follows a path: G9 G60 G61 G64 and their values, and look-ahead, G5 P,
// G5.1 Q and G8 P. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class PathModes : public ControlPart {
 public:
  explicit PathModes(Control& control) : ControlPart(control) {}

  /// Sets the path mode of the block. False: an error was reported.
  bool select(const Word& word, Code code);
  /// Takes the values of a word that switches look-ahead. False: an error was reported.
  bool look_ahead(const Word& word);

 private:
  bool values_of(const Word& word);
  bool orients_spindle() const;
};

}  // namespace mrsim
