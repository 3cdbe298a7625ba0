// SINUMERIK's turning cycles without a contour: CYCLE92 parts off, CYCLE93 cuts a groove, CYCLE951
// removes a corner, CYCLE97, CYCLE98 and CYCLE99 cut threads. docs/sinumerik_cycles.md says what is
// read and what is refused. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include "interp/cycles/cycle_mover.h"
#include "interp/moves/moves.h"
#include "interp/tools/tool_changer.h"

#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

class TurnCycles : public ControlPart {
 public:
  TurnCycles(Control& control, ToolChanger& tools, Moves& moves)
      : ControlPart(control), tools_(tools), moves_(moves), mover_(control, moves) {}

  static bool knows(std::string_view name);
  /// False: an error was reported.
  bool run(const CycleCall& call, const Word& where);

 private:
  /// A thread through points, X as radius; pitch i leads from point i to the next. Lengths in mm.
  struct Thread {
    std::vector<Vec3> points;
    std::vector<double> pitches;
    double run_in = 0, run_out = 0, clear = 1, flank = 0;  ///< flank in degrees
    std::vector<double> depths;
    int starts = 1;
    bool inside = false;
  };
  /// CYCLE951: a rectangle between two corners; levels in u, cuts in v.
  struct Corner {
    Vec3 start, end, allowance;
    int u = 0, v = 2;
    double down = -1, run = -1;  ///< signs of the infeed and of the cut
    double clear = 0, depth = 0;
  };
  /// A flank of a groove; of its corners, what the blade's point keeps off them along each side:
  /// the radius of a rounding, with the blade's own, or the leg of a chamfer.
  struct Flank {
    double place = 0;             ///< of the tool along Z
    double edge = 0, corner = 0;  ///< at the groove's edge and at its bottom
    bool edge_round = false, corner_round = false;
  };
  /// CYCLE93: places of the blade along Z, X as radius.
  struct Groove {
    Flank flanks[2];  ///< the side of SPL first
    double side = 1;  ///< of the groove along Z, seen from there
    double top = 0, bottom = 0, clear = 0;
    double base_allowance = 0, flank_allowance = 0;
    double infeed = 0, retract = 1, step = 0;
    double nose = 0;   ///< of the blade's corners
    double dwell = 0;  ///< at the bottom of each plunge, s
  };

  bool fail(const char* code, const std::string& text) { return error(code, text, where_); }
  bool refuse(const char* what);
  void to(double x, double z, MotionKind kind, double lead = 0);
  bool corner();
  bool corner_values(Corner& out);
  void corner_rough(const Corner& c);
  void corner_finish(const Corner& c);
  bool groove();
  bool groove_values(Groove& out);
  bool blade(Groove& out, double low, double high);
  bool parting();
  bool parting_values(Groove& out);
  bool groove_corners(Groove& g, double width);
  void plunge(const Groove& g, double z, double bottom);
  void finish_flank(const Groove& g, const Flank& flank, double side, double middle);
  void quarter(double x, double z, double radius, double turn, bool from_top);
  bool thread_cycle();
  bool thread_list();
  bool thread_chain();
  bool thread_turning();
  bool thread_depths(Thread& out, std::size_t at, std::size_t cuts, int kind, bool rough,
                     bool finish);
  bool thread(const Thread& thread);

  ToolChanger& tools_;
  Moves& moves_;
  CycleMover mover_;
  CycleCall call_;
  Word where_;
};

}  // namespace mrsim
