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
  /// The number * 10 of a G word, or that of the word that is the same while the tool stands along
  /// Z: G43 for G43.4.
  int read_as(int number) const;
  /// Whether A3= B3= C3= and their kin lead the tool away from Z. If so, turn() is done.
  bool tilts(const Word& word);
  /// A rotary axis leaves 0: what is read as with a tool along Z is not read any more.
  void turn();
  /// Passes over the words of a block in such a mode; the axes that it names become unknown.
  void pass_over();

 private:
  bool ends(int g);
  bool is_untilted() const;
  bool note_name(const Word& word);
  bool begins_upright(int g, const Word& word);
  void begin_upright(int end, const Word& word);
  bool begins_iso_mode(const Word& word);
};

}  // namespace mrsim
