// CYCLE951 of SINUMERIK removes a corner: the rectangle between two points. Private to src/interp.
#pragma once

#include "interp/turning/turn_call.h"

namespace mrsim {

class CornerCycle : public TurnCall {
 public:
  CornerCycle(Control& control, Moves& moves, const CycleCall& call, const Word& where)
      : TurnCall(control, moves, call, where) {}

  /// Carries out the cycle. False: an error was reported.
  bool run();

 private:
  /// The rectangle between two corners. Passes follow one another in u and cut along v.
  struct Corner {
    Vec3 start, end, allowance;
    int u = 0, v = 2;
    double down = -1, along = -1;  ///< signs of the infeed and of the cut
    double clear = 0, depth = 0;
  };

  bool read(Corner& out);
  void rough(const Corner& c);
  void finish(const Corner& c);
};

}  // namespace mrsim
