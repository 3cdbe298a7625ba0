// Cycles that chamfer an edge with a cutter that ends in a cone: how deep its tip goes, and how far
// from the wall its axis runs. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include "interp/tools/tool_changer.h"

#include <optional>

namespace mrsim {

/// Half the angle of the cone that the tool ends in, radians, as its shape has it; 0: it does not.
double cone_of(const Tool& tool);

class Chamfering : public ControlPart {
 public:
  struct Cut {
    double aside = 0;   ///< of the tool's axis from the wall, mm
    double bottom = 0;  ///< level of its tip
  };

  Chamfering(Control& control, ToolChanger& tools) : ControlPart(control), tools_(tools) {}

  /// `call` has FS, the chamfer's width on the face, and ZFS, where the tip goes; the hundreds of
  /// AMODE say whether ZFS is a level (0) or counts from the edge at `edge`. `down`: the sign of
  /// the way into the part. None: an error was reported.
  std::optional<Cut> cut(const CycleCall& call, double edge, double down, const Word& where);

 private:
  ToolChanger& tools_;
};

}  // namespace mrsim
