// What the values of CYCLE95 and CYCLE952 ask for: how a turning tool removes the stock down to a
// contour. Private to src/interp.
#pragma once

#include "interp/control/control.h"
#include "interp/sinumerik/contour_call.h"

#include <optional>
#include <vector>

namespace mrsim {

/// Passes follow one another in u and cut along v; 0 is X, 2 is Z. Lengths are in mm.
struct RemovalPlan {
  std::vector<Motion> contour;  ///< in the direction in which it is cut
  int u = 0, v = 2;
  double down = -1, run = -1;  ///< signs of the infeed in u and of the cut in v
  double clear = 1;
  double top = 0, start = 0;    ///< u, a pass above the first level; v where passes begin
  std::optional<double> blank;  ///< u of the surface of the blank, where the cycle has one
  Vec3 allowance;
  double parallel = 0;                         ///< allowance along the contour's normal
  double depth = 0;                            ///< depth of a pass
  double feed = 0, plunge = 0, last_feed = 0;  ///< roughing, into a relief cut, finishing
  bool rough = true, finish = true, reliefs = true;
};

class RemovalValues : public ControlPart {
 public:
  RemovalValues(Control& control, const ContourCall& call)
      : ControlPart(control),
        call_(call.values),
        where_(call.where),
        contours_(call.contours),
        contour_(call.contours.back()) {}

  /// The plan of the call. Nothing: an error was reported.
  std::optional<RemovalPlan> read();

 private:
  bool turn_modes(RemovalPlan& out);
  bool removal_modes(RemovalPlan& out);
  bool removal_values();
  bool removal_ways(RemovalPlan& out);
  void removal_allowances(RemovalPlan& out);
  void removal_blank(RemovalPlan& out);
  void orient(const RemovalPlan& r);
  void turn_contour();

  const CycleCall& call_;
  const Word& where_;
  const std::vector<std::vector<Motion>>& contours_;
  std::vector<Motion> contour_;
};

}  // namespace mrsim
