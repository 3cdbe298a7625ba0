// Cycles that chamfer an edge with a cutter that ends in a cone: how deep its tip goes, and how far
// from the wall its axis runs. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include "interp/tools/tool_changer.h"

#include <optional>

namespace mrsim {

/// Half the angle of the cone at the end of the tool, radians; 0: it has no cone there.
double cone_of(const Tool& tool);

class Chamfering : public ControlPart {
 public:
  struct Cut {
    double aside = 0;   ///< distance of the tool's axis from the wall, mm
    double bottom = 0;  ///< level of the tool's tip
  };

  Chamfering(Control& control, ToolChanger& tools) : ControlPart(control), tools_(tools) {}

  /// `call` has FS, the width of the chamfer on the face, and ZFS, the place of the tip. The
  /// hundreds of AMODE say whether ZFS is a level (0) or counts from the edge, whose level is
  /// `edge`. `down` is the sign of the way into the part. Nothing: an error was reported.
  std::optional<Cut> cut(const CycleCall& call, double edge, double down, const Word& where);

 private:
  ToolChanger& tools_;
};

}  // namespace mrsim
