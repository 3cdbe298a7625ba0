// Drilling, tapping and boring cycles G73, G74, G76, G81 to G89 of FANUC, ISO and LinuxCNC: what
// their words say, and at which points they run. HoleMaker makes the motions. Private to
// src/interp.
#pragma once

#include "interp/cycles/hole_maker.h"
#include "interp/drilling/peck_words.h"
#include "interp/words/dwell_time.h"

namespace mrsim {

class DrillWords : public ControlPart {
 public:
  DrillWords(Control& control, AxisWords& axes, HoleMaker& holes)
      : ControlPart(control), axes_(axes), holes_(holes), dwell_(control), pecks_(control) {}

  /// Whether a cycle is in force and the block has words for it.
  bool wants_block() const;
  /// Makes holes at the points of the block. False: an error was reported.
  bool run();
  /// Makes holes of the cycle in force at `points`, from the current level. `own_p`: the P of the
  /// block belongs to the pattern and is no dwell. False: an error was reported.
  bool at_points(const std::vector<Vec3>& points, const Word& where, bool own_p = false);

 private:
  bool drill();
  bool bores_down() const;
  bool refuses(const Word& where);
  void read_level(const Word* word, CycleLevel& out);
  bool depth_in_i() const;
  bool read_fagor(const Basis& b);
  bool read_words(const Basis& b);
  bool read_tap();
  bool repeats(long& count);
  double level_aside(const Hole& hole) const;
  void meet_level(const Hole& hole, AxisSet& named, const Word& where);
  bool fill(Hole& hole, bool haas_words = true);
  bool fill_levels(Hole& hole, const Word& where);
  void fill_dwells(int g, Hole& hole) const;
  double end_level(double safe, bool up) const;
  double tapping_lead() const;
  static bool is_no_lead(double lead);

  AxisWords& axes_;
  HoleMaker& holes_;
  DwellTime dwell_;
  PeckWords pecks_;
};

}  // namespace mrsim
