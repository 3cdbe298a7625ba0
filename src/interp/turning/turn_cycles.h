// SINUMERIK's turning cycles without a contour: CYCLE92 parts off, CYCLE93 cuts a groove, CYCLE951
// removes a corner, CYCLE97, CYCLE98 and CYCLE99 cut threads. docs/sinumerik_cycles.md says what is
// read and what is refused. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include "interp/moves/moves.h"
#include "interp/tools/tool_changer.h"

#include <string_view>

namespace mrsim {

class TurnCycles : public ControlPart {
 public:
  TurnCycles(Control& control, ToolChanger& tools, Moves& moves)
      : ControlPart(control), tools_(tools), moves_(moves) {}

  /// Whether run() knows the name.
  static bool knows(std::string_view name);
  /// Carries out the cycle. False: an error was reported.
  bool run(const CycleCall& call, const Word& where);

 private:
  ToolChanger& tools_;
  Moves& moves_;
};

}  // namespace mrsim
