// Haas mills: G12 and G13 mill a circular pocket, G70 to G72 set holes of the drilling cycle in
// force on a circle, an arc or a line. Private to src/interp.
#pragma once

#include "interp/control/drill_words.h"

namespace mrsim {

class HaasCycles : public ControlPart {
 public:
  HaasCycles(Control& control, AxisWords& axes, Moves& moves, CompensationWords& compensation,
             DrillWords& drilling)
      : ControlPart(control),
        axes_(axes),
        moves_(moves),
        compensation_(compensation),
        drilling_(drilling) {}

  /// The block holds such a word.
  bool wants_block() const;
  /// False: an error was reported.
  bool run();

 private:
  /// A pocket; radii are of the tool's path, mm.
  struct Pocket {
    double first = 0, last = 0, step = 0;
    double depth = 0;  ///< level, or in G91 how much deeper each time
    long times = 1;
  };

  bool count(char letter, double most, long& out);
  bool pocket();
  bool read_pocket(Pocket& out);
  bool circles(const Pocket& pocket);
  bool half_circle(Vec2 center, Vec2 to, bool whole);
  bool holes();
  void to_level(double level);
  double length_of(char letter);

  AxisWords& axes_;
  Moves& moves_;
  CompensationWords& compensation_;
  DrillWords& drilling_;
};

}  // namespace mrsim
