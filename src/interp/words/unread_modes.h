// Modes that are refused by name, such as polar interpolation or tool centre point control. Words
// in such a mode have the meaning that the mode gives them. So until the word that ends the mode no
// move is run and nothing else is reported: one cause gives one error. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class UnreadModes : public ControlPart {
 public:
  explicit UnreadModes(Control& control) : ControlPart(control) {}

  /// Looks at a G word or a name before it is read. True: the word is done with.
  bool begins_or_ends(const Word& word);
  /// Whether the block stands behind G291 of SINUMERIK: its words have no meaning before G290.
  bool skips_iso_mode();
  /// Begins the mode of CYCLE800 with a tilt, which the next CYCLE800 ends.
  void begin_swivel();
  bool ends_swivel();
  /// Passes over the words of a block in such a mode; the axes that it names become unknown.
  void pass_over();

 private:
  bool ends(int g);
  bool is_untilted() const;
  void note_name(const Word& word);
  bool begins_iso_mode(const Word& word);
};

}  // namespace mrsim
