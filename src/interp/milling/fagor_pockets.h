// G87 and G88 of Fagor's 8055 are pockets about the place of their block and of the blocks that
// follow. They have the shape of POCKET3 and POCKET4 and are cut like these. Private to src/interp.
#pragma once

#include "interp/frames/axis_words.h"
#include "interp/milling/mill_cycles.h"

namespace mrsim {

class FagorPockets : public ControlPart {
 public:
  FagorPockets(Control& control, AxisWords& axes, ToolChanger& tools, Moves& moves)
      : ControlPart(control), axes_(axes), mover_(control, moves), mills_(control, tools, moves) {}

  /// Whether a pocket is in force, and the block is its first one or goes to another place.
  bool wants_block() const;
  /// Cuts the pocket. False: an error was reported.
  bool run();

 private:
  CycleCall call(const FagorPocket& pocket) const;

  AxisWords& axes_;
  CycleMover mover_;
  MillCycles mills_;
};

}  // namespace mrsim
