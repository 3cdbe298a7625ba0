// What SINUMERIK's turning cycles without a contour have in common: the values of one call, and
// moves in X and Z. An object lives for one call. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include "interp/moves/moves.h"

#include <string>

namespace mrsim {

/// A cycle with more passes is refused, because its infeed is far too small for its depth.
inline constexpr double kMostTurningPasses = 1e5;

class TurnCall : public ControlPart {
 protected:
  TurnCall(Control& control, Moves& moves, const CycleCall& call, const Word& where)
      : ControlPart(control), moves_(moves), call_(call), where_(where) {}

  /// -1 below 0, else 1.
  static double sign_of(double v) { return v < 0 ? -1 : 1; }
  bool fail(const char* code, const std::string& text) { return error(code, text, where_); }
  bool refuse(const char* what);
  /// Moves to X (as radius) and Z in the program's coordinates, mm. `lead`: of a thread, mm.
  void to(double x, double z, MotionKind kind, double lead = 0);

  Moves& moves_;
  const CycleCall& call_;
  const Word& where_;
};

}  // namespace mrsim
