// SINUMERIK's threads on lathes: CYCLE97 cuts one, CYCLE98 a chain of up to three, CYCLE99 one with
// the newer list of values. Private to src/interp.
#pragma once

#include "interp/turning/turn_call.h"

#include <vector>

namespace mrsim {

class ThreadCycles : public TurnCall {
 public:
  ThreadCycles(Control& control, Moves& moves, const CycleCall& call, const Word& where)
      : TurnCall(control, moves, call, where) {}

  /// Carries out the cycle. False: an error was reported.
  bool run();

 private:
  /// A thread through points, X as radius. Pitch i holds from point i to the next. Lengths are in
  /// mm.
  struct Thread {
    std::vector<Vec3> points;
    std::vector<double> pitches;
    double run_in = 0, run_out = 0, clear = 1, flank = 0;  ///< flank in degrees
    std::vector<double> depths;
    int starts = 1;
    bool inside = false;
  };

  bool thread_list();
  bool thread_chain();
  bool thread_turning();
  bool old_thread(Thread& t, int kind);
  bool thread_depths(Thread& out, int kind, bool rough, bool finish);
  bool thread(const Thread& thread);
};

}  // namespace mrsim
