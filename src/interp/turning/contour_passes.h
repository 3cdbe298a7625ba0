// The passes that cut a turned contour after it was read: G71 and G72 rough down to it in levels,
// G73 repeats it from farther out. Private to src/interp.
#pragma once

#include "interp/moves/moves.h"
#include "interp/path/rough_contour.h"

#include <vector>

namespace mrsim {

/// How the block of a cycle wants its contour to be cut.
struct ContourCut {
  int number = 0;    ///< 71: levels along Z, 72: along X, 73: the contour again and again
  Word where;        ///< of the cycle
  Vec3 allowance;    ///< what is left for finishing, mm, X as radius
  Vec3 semi_finish;  ///< I and K: what the passes leave for the cut along the contour, mm
  /// The cycle is Okuma's LAP: allowances have no sign and are left on the side from which the
  /// passes come, and the passes begin where the tool stands.
  bool lap = false;
  bool pockets = false;  ///< G71, G72: the contour may fall and rise (type II)
};

class ContourPasses : public ControlPart {
 public:
  /// `contour`: its motions in order; the first leads to it.
  ContourPasses(Control& control, Moves& moves, const ContourCut& cut, std::vector<Motion>& contour)
      : ControlPart(control), moves_(moves), cut_(cut), contour_(contour) {}

  /// All passes, and back to where the tool was. False: an error was reported.
  bool run() { return cut_.number == 73 ? repeat() : rough(); }
  /// To a place in the stock's coordinates, unless the tool is there.
  void go(const Vec3& to, MotionKind kind);

 private:
  /// Levels in u, strokes in v; see RoughContour.
  struct Rough {
    int u = 0, v = 2;           ///< axes
    double top = 0, start = 0;  ///< where the passes begin, u and v
    double down = 1;            ///< from the start to the contour, in u
    double along = -1;          ///< from the start to the contour's end, in v
  };

  bool repeat();
  bool rough();
  Rough directions(const Vec3& top, const Vec3& shift) const;
  void refuse_way_back(std::size_t motion);
  void tell_of_pocket(const Rough& rough, const RoughContour& shape);
  void leave_out_return();
  void orient_allowance();
  bool levels(const Rough& rough, const RoughContour& shape);
  void pass(const Rough& rough, double at, double end);
  void pocket_pass(const Rough& rough, double at, const FreeStretch& stretch);
  void stroke(const Rough& rough, double at, double begin, double end);

  Moves& moves_;
  ContourCut cut_;
  std::vector<Motion>& contour_;
};

}  // namespace mrsim
