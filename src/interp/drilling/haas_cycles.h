// On Haas mills G12 and G13 mill a circular pocket, and G70 to G72 make holes of the drilling cycle
// in force on a circle, an arc or a line. G34 to G36 of Mitsubishi also do that, and G37.1 on a
// grid. Private to src/interp.
#pragma once

#include "interp/drilling/drill_words.h"

#include <string_view>
#include <vector>

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

  /// Whether the block has such a word.
  bool wants_block() const;
  /// False: an error was reported.
  bool run();

 private:
  /// A pocket. Radii are those of the tool's path, mm.
  struct Pocket {
    double first = 0, last = 0, step = 0;
    double depth = 0;  ///< level; in G91 how much deeper each time
    long times = 1;
  };

  /// `negative`: below 0, and its sign is left out.
  bool count(char letter, double most, long& out, bool negative = false);
  bool pocket();
  bool read_pocket(Pocket& out);
  bool circles(const Pocket& pocket);
  bool circle_of_mach();
  bool half_circle(Vec2 center, Vec2 to, bool whole);
  bool holes();
  bool needs(std::string_view letters);
  bool haas_holes(std::vector<Vec3>& points);
  bool mitsubishi_holes(std::vector<Vec3>& points);
  static void add_line(std::vector<Vec3>& points, double step, double angle, long number);
  static void add_arc(std::vector<Vec3>& points, double radius, double angle, double step,
                      long number);
  void to_level(double level);
  double length_of(char letter);
  double value_of(char letter);

  AxisWords& axes_;
  Moves& moves_;
  CompensationWords& compensation_;
  DrillWords& drilling_;
};

}  // namespace mrsim
