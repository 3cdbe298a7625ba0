// The strokes in which a hole is drilled: Q, or I J K of Haas. Private to src/interp.
#pragma once

#include "interp/cycles/hole_maker.h"

namespace mrsim {

class PeckWords : public ControlPart {
 public:
  explicit PeckWords(Control& control) : ControlPart(control) {}

  /// Reads Q, which stays in force. False: an error was reported.
  bool read(const Word& q);
  /// Fills in the strokes of the cycle in force, between the levels of `hole`. `haas_words`: I J K
  /// may give them. False: an error was reported.
  bool fill(Hole& hole, bool haas_words);

 private:
  void read_haas_strokes();
  bool read_haas_depth();
  bool haas_pecks(Hole& hole);
};

}  // namespace mrsim
