// Clears a region of the plane level by level: pockets and spigots of any contour. The final shape
// is that of the contours. docs/interp.md describes the loops by which the cutter gets there.
// Private to src/interp.
#pragma once

#include "interp/cycles/cycle_mover.h"
#include "interp/path/region.h"

#include <vector>

namespace mrsim {

class RegionCutter : public ControlPart {
 public:
  /// Levels along the normal of the plane, and how the cutter moves. Lengths are in mm.
  struct Levels {
    double top = 0, safe = 0, reference = 0, bottom = 0;
    double infeed = 0;            ///< the most of one cut; 0 = all at once
    double feed = 0, plunge = 0;  ///< 0: the one in force
    bool clockwise = false;       ///< conventional milling, the other way round
  };

  RegionCutter(Control& control, Moves& moves) : ControlPart(control), mover_(control, moves) {}

  /// Makes the motions of a contour, from the one numbered `first` on, pieces in the program's
  /// plane. False: the contour is not closed, which was reported.
  bool closed_loop(const std::vector<Motion>& contour, std::size_t first, Loop& out);

  /// Clears all of it with a cutter of `radius` (mm) that leaves `aside` at the contours. False: an
  /// error was reported.
  bool clear(const Region& region, double radius, double aside, double step, const Levels& levels,
             const Word& where);
  /// Cuts only along the contours.
  bool follow(const Region& region, double radius, double aside, const Levels& levels,
              const Word& where);

 private:
  bool cut(const Region& region, const std::vector<Loop>& loops, double distance,
           const Levels& levels, const Word& where);
  void level(const Region& region, const std::vector<Loop>& loops, double distance, double from,
             double to, const Levels& levels);

  CycleMover mover_;
};

}  // namespace mrsim
