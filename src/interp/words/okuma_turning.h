// Writes the cycles of Okuma's lathes anew as FANUC's cycles of the same motions, since their
// numbers mean other things than FANUC's. Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <initializer_list>
#include <string_view>

namespace mrsim {

class OkumaTurning : public ControlPart {
 public:
  explicit OkumaTurning(Control& control) : ControlPart(control) {}

  /// Called before the words are entered by address. False: an error was reported.
  bool rewrite();

 private:
  void drop(std::string_view letters);
  void move_to(char from, char to, double factor);
  bool moves_other_axis();
  bool has_taper(Word& code);
  bool thread(Word& code);
  bool compound_thread(Word& code);
  void grooves(Word& code);
  void deep_hole();
  void share_lead();
  bool refuse(const Word& code, std::string_view what);
};

}  // namespace mrsim
