// The code systems B and C of FANUC's lathes: their numbers are written anew as those of system A.
// Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <string_view>

namespace mrsim {

class CodeSystems : public ControlPart {
 public:
  explicit CodeSystems(Control& control) : ControlPart(control) {}

  /// Before the words are entered by address.
  void rewrite();

 private:
  bool has(std::string_view letters) const;
  void see_units();
  void rewrite_c(Word& code);
  void rename(Word& code, int number, int in_system_a);
};

}  // namespace mrsim
