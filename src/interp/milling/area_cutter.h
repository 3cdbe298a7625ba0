// Cuts the areas of milling cycles level by level: in loops that end at the wall, or in lines from
// outside. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_mover.h"

#include <functional>
#include <utility>
#include <vector>

namespace mrsim {

/// How a milling cycle goes down to the next level.
enum class MillEntry { rapid, feed, helix, swing };

/// What a milling cycle cuts, and how.
struct MillPlan {
  double top = 0, reference = 0, safe = 0, bottom = 0;  ///< along the normal, mm
  double infeed = 0, finish_infeed = 0;                 ///< the most depth of one cut; 0: all of it
  double side = 0, floor = 0;                           ///< allowances for finishing
  double feed = 0, plunge = 0;
  double width = 0;  ///< between two loops
  bool rough = true, finish = true;
  MillEntry entry = MillEntry::feed;
  double helix_radius = 0, helix_lead = 0;  ///< mm; a lead of 0: one turn
  double swing_angle = 0;                   ///< how steep swinging may be, degrees; 0: not told
  bool clockwise = false;
};

/// An area by its loops: all of them, the last one at the wall, `aside` from it.
struct MillArea {
  std::function<std::vector<Loop>(double aside)> loops;
  Vec2 entry;                  ///< where the tool goes down
  double helix_room = 0;       ///< the largest radius of a helix there, mm
  double swing_room = 0;       ///< the largest distance from there at which swinging turns, mm
  double swing_direction = 0;  ///< degrees, in the plane
};

class AreaCutter : public ControlPart {
 public:
  AreaCutter(Control& control, CycleMover& mover) : ControlPart(control), mover_(mover) {}

  /// Clears the area. Roughing leaves the allowances; finishing cuts the wall, then the floor.
  /// False: that would take more than kMostLoops loops, so no loop was cut.
  bool clear(const MillPlan& plan, const MillArea& area);
  /// Cuts lines at each level; the tool goes down at the beginning of the first. `one_way`: all in
  /// one direction, else to and fro. Requires: at least one line.
  void tracks(const MillPlan& plan, const std::vector<std::pair<Vec2, Vec2>>& lines, bool one_way);

  static constexpr int kMostLoops = 100'000;

 private:
  void cut(const MillPlan& plan, const MillArea& area, const std::vector<Loop>& loops,
           double infeed, double bottom);
  void descend(const MillPlan& plan, const MillArea& area, double from, double to);
  void swing_down(const MillPlan& plan, const MillArea& area, double from, double to);

  CycleMover& mover_;
};

}  // namespace mrsim
