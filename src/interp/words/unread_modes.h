// Modes that are refused by name, such as polar interpolation or tool centre point control. What
// stands in them has the meaning that the mode gives it, so until the word that ends the mode no
// move is run and nothing else is reported: one cause, one error. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class UnreadModes : public ControlPart {
 public:
  explicit UnreadModes(Control& control) : ControlPart(control) {}

  /// Looks at a G word or a name before it is read. True: there is nothing more to do about it.
  bool begins_or_ends(const Word& word);
  /// A block behind G291 of SINUMERIK: none of its words has a meaning before G290.
  bool skips_iso_mode();
  /// CYCLE800 with a tilt, up to the next CYCLE800: true in its block.
  void begin_swivel();
  bool ends_swivel();
  /// A block in such a mode: its words are passed over, and the axes that it names are unknown.
  void pass_over();

 private:
  bool ends(int g);
  bool is_untilted() const;
  void note_name(const Word& word);
  bool begins_iso_mode(const Word& word);
};

}  // namespace mrsim
