// CYCLE72 of SINUMERIK mills along a contour, level by level, on it or beside it. Private to
// src/interp.
#pragma once

#include "interp/cycles/chamfering.h"
#include "interp/cycles/cycle_mover.h"
#include "interp/sinumerik/contour_call.h"

#include <vector>

namespace mrsim {

/// Lives for one call.
class ContourMilling : public ControlPart {
 public:
  ContourMilling(Control& control, ToolChanger& tools, Moves& moves, const ContourCall& call)
      : ControlPart(control),
        tools_(tools),
        moves_(moves),
        mover_(control, moves),
        chamfering_(control, tools),
        call_(call.values),
        where_(call.where),
        contour_(in_direction(call)),
        modal_before_(control.modal) {
    mover_.begin(where_);
  }

  /// False: an error was reported.
  bool run();

 private:
  /// Where the cuts are, in the plane and along its normal.
  struct Along {
    double top = 0, reference = 0, safe = 0, bottom = 0, infeed = 0;
    double side = 0;  ///< 1 the cutter is to the left, -1 right, 0 on the contour
    double aside = 0, allowance = 0;
    double feed = 0, plunge = 0;
  };

  static std::vector<Motion> in_direction(const ContourCall& call);
  bool read(Along& out);
  bool read_side(Along& out);
  void pass_along(const Along& along, double from, double level);
  void approach(const Along& along, double level, double from, bool leaving);

  ToolChanger& tools_;
  Moves& moves_;
  CycleMover mover_;
  Chamfering chamfering_;
  const CycleCall& call_;
  const Word& where_;
  const std::vector<Motion> contour_;
  const Modal modal_before_;
};

}  // namespace mrsim
