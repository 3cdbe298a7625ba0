// Makes the values of SINUMERIK's drilling cycles CYCLE81 to CYCLE89 and CYCLE840 the description
// of a hole. Private to src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include "interp/cycles/hole_maker.h"
#include "interp/tools/tool_changer.h"
#include "interp/words/dwell_time.h"

#include <string_view>

namespace mrsim {

/// An object lives for one call.
class HoleValues : public ControlPart {
 public:
  HoleValues(Control& control, ToolChanger& tools, const CycleCall& call, const Word& where)
      : ControlPart(control), tools_(tools), dwell_(control), call_(call), where_(where) {}

  /// Whether read() knows the cycle of this name.
  static bool knows(std::string_view name);
  /// Puts the plane in force that the call asks for. False: an error was reported.
  bool choose_plane();
  /// Fills `out`, with levels in the plane in force. False: an error was reported.
  bool read(Hole& out);

 private:
  bool depth(double reference, double down, double& bottom);
  bool to_diameter(double reference, double down, double& bottom);
  double point_length();
  bool first_stroke(double reference, const Hole& hole, double& stroke);
  bool strokes(double reference, Hole& hole);
  double pause(ValueName value, int mode_digit);
  void dwells(Hole& hole);
  double pitch() const;
  void tapping(Hole& hole);

  ToolChanger& tools_;
  DwellTime dwell_;
  const CycleCall& call_;
  const Word& where_;
};

}  // namespace mrsim
