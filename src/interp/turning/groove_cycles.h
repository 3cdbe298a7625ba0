// CYCLE93 of SINUMERIK cuts a groove and CYCLE92 parts off, both with a grooving tool that plunges
// along X. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_mover.h"
#include "interp/tools/tool_changer.h"
#include "interp/turning/turn_call.h"

namespace mrsim {

class GrooveCycles : public TurnCall {
 public:
  GrooveCycles(Control& control, ToolChanger& tools, Moves& moves, const CycleCall& call,
               const Word& where)
      : TurnCall(control, moves, call, where), tools_(tools), mover_(control, moves) {}

  /// Carries out the cycle. False: an error was reported.
  bool run() { return call_.name == "CYCLE92" ? parting() : groove(); }

 private:
  /// A flank of a groove. `edge` and `corner` are how far the blade's point stays from these
  /// corners along each side: the radius of a rounding and the blade's own, or the leg of a
  /// chamfer.
  struct Flank {
    double z = 0;                 ///< of the tool
    double edge = 0, corner = 0;  ///< at the groove's edge and at its bottom
    bool edge_round = false, corner_round = false;
  };
  /// The groove of CYCLE93: places of the blade along Z, X as radius.
  struct Groove {
    Flank flanks[2];  ///< the side of SPL first
    double side = 1;  ///< direction along Z in which the groove lies from there
    double top = 0, bottom = 0, clear = 0;
    double base_allowance = 0, flank_allowance = 0;
    double infeed = 0, retract = 1, step = 0;
    double nose = 0;   ///< of the blade's corners
    double dwell = 0;  ///< at the bottom of each plunge, s
  };

  bool groove();
  bool groove_values(Groove& out);
  bool groove_corners(Groove& g, double width);
  bool blade(Groove& out, double low, double high);
  void plunge(const Groove& g, double z, double bottom);
  void finish_flank(const Groove& g, const Flank& flank, double side, double middle);
  void quarter(double x, double z, double radius, double turn, bool from_top);
  bool parting();
  bool parting_values(Groove& out);

  ToolChanger& tools_;
  CycleMover mover_;
};

}  // namespace mrsim
