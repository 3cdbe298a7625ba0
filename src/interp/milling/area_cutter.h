// Cuts the areas of milling cycles level by level: in loops that end at the wall, or in lines from
// outside. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_mover.h"

#include <functional>
#include <utility>
#include <vector>

namespace mrsim {

/// The levels of a milling cycle, and how it cuts.
struct MillLevels {
  double top = 0, reference = 0, safe = 0, bottom = 0;  ///< along the normal, mm
  double infeed = 0, finish_infeed = 0;                 ///< the most depth of one cut; 0: all of it
  double side = 0, floor = 0;                           ///< allowances for finishing
  double feed = 0, plunge = 0;
  double width = 0;  ///< between two loops
  bool rough = true, finish = true;
  int entry = 1;                     ///< 0 rapid, 1 feed, 2 helix, 3 swinging
  double helix = 0, helix_lead = 0;  ///< radius and lead; `helix` of swinging is its angle
  bool clockwise = false;
};

/// An area by its loops: all of them, the last one at the wall, `aside` from it.
struct MillArea {
  std::function<std::vector<Loop>(double aside)> loops;
  Vec2 entry;        ///< where the tool goes down
  double swing = 0;  ///< half the length of swinging, in the direction `degrees`
  double degrees = 0;
  double helix = 0;  ///< the largest radius of a helix at the entry
};

class AreaCutter : public ControlPart {
 public:
  AreaCutter(Control& control, CycleMover& mover) : ControlPart(control), mover_(mover) {}

  /// Clears the area. Roughing leaves the allowances; finishing cuts the wall, then the floor.
  /// False: that would take more than kMostLoops loops, so no loop was cut.
  bool clear(const MillLevels& levels, const MillArea& area);
  /// Cuts lines at each level; the tool goes down at the beginning of the first. `one_way`: all in
  /// one direction, else to and fro. Requires: at least one line.
  void tracks(const MillLevels& levels, const std::vector<std::pair<Vec2, Vec2>>& lines,
              bool one_way);

  static constexpr int kMostLoops = 100'000;

 private:
  void cut(const MillLevels& levels, const MillArea& area, const std::vector<Loop>& loops,
           double infeed, double bottom);
  void descend(const MillLevels& levels, const MillArea& area, double from, double to);
  void swing_down(const MillLevels& levels, const MillArea& area, double from, double to);

  CycleMover& mover_;
};

}  // namespace mrsim
