// CYCLE63 of SINUMERIK clears a pocket with islands, or the surroundings of spigots. Private to
// src/interp.
#pragma once

#include "interp/cycles/chamfering.h"
#include "interp/milling/region_cutter.h"
#include "interp/sinumerik/contour_call.h"

#include <vector>

namespace mrsim {

/// An object lives for one call.
class ContourPocket : public ControlPart {
 public:
  ContourPocket(Control& control, ToolChanger& tools, Moves& moves, const ContourCall& call)
      : ControlPart(control),
        tools_(tools),
        cutter_(control, moves),
        chamfering_(control, tools),
        call_(call.values),
        where_(call.where),
        contours_(call.contours) {}

  /// Carries out the cycle. False: an error was reported.
  bool run();

 private:
  bool read(RegionCutter::Levels& out);
  bool surroundings(double radius, const Loop& blank, Loop& out);

  ToolChanger& tools_;
  RegionCutter cutter_;
  Chamfering chamfering_;
  const CycleCall& call_;
  const Word& where_;
  const std::vector<std::vector<Motion>>& contours_;
};

}  // namespace mrsim
