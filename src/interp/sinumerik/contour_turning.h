// CYCLE95 and CYCLE952 of SINUMERIK turn down to a contour: passes at equal levels, relief cuts,
// once along the contour. Private to src/interp.
#pragma once

#include "interp/moves/moves.h"
#include "interp/path/rough_contour.h"
#include "interp/sinumerik/removal_values.h"
#include "interp/tools/tool_changer.h"

#include <vector>

namespace mrsim {

/// An object lives for one call.
class ContourTurning : public ControlPart {
 public:
  ContourTurning(Control& control, ToolChanger& tools, Moves& moves, const ContourCall& call)
      : ControlPart(control),
        tools_(tools),
        moves_(moves),
        contour_call_(call),
        call_(call.values),
        where_(call.where),
        modal_before_(control.modal) {}

  /// Carries out the cycle. False: an error was reported.
  bool run();

 private:
  bool beside(const RemovalPlan& r, double allowance);
  double before_contour(const RemovalPlan& r) const;
  bool roughing(RemovalPlan& r);
  bool levels(const RemovalPlan& r, const RoughContour& shape, double whole, int n);
  void level(const RemovalPlan& r, double at, double from, double to);
  void follow_contour(const Vec3& shift);
  void go(const Vec3& physical, MotionKind kind, double feed);

  ToolChanger& tools_;
  Moves& moves_;
  const ContourCall& contour_call_;
  const CycleCall& call_;
  const Word& where_;
  const Modal modal_before_;
  std::vector<Motion> contour_;  ///< the contour of the RemovalPlan
  std::vector<Motion> path_;     ///< the path of the tool's point along contour_
};

}  // namespace mrsim
