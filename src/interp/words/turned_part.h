// A part that the operator turns over while the program waits: what is cut then is another side,
// which this simulation cuts from the first one. Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <cstddef>
#include <string>

namespace mrsim {

class TurnedPart : public ControlPart {
 public:
  explicit TurnedPart(Control& control) : ControlPart(control) {}
  /// The texts of a block for the operator, before it runs.
  void read_texts();
  /// The block has run; `cuts`: of the program so far. Warns at the first cut of the other side.
  void end_block(std::size_t cuts);

 private:
  void read(std::string_view text, bool stops);
  bool stops() const;

  std::string text_;  ///< what says that the part is turned; empty: nothing has since the last cut
  int line_ = 0;      ///< of it
  bool stopped_ = false;  ///< M0 or M1 since the last cut
  bool told_ = false;
  std::size_t cuts_ = 0;
};

}  // namespace mrsim
