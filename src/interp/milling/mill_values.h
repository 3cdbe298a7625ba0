// What the values of SINUMERIK's milling cycles mean: levels, feeds, allowances, the place of the
// pocket. Private to src/interp.
#pragma once

#include "interp/cycles/chamfering.h"
#include "interp/cycles/cycle_call.h"
#include "interp/milling/area_cutter.h"

#include <string>

namespace mrsim {

/// The place at this distance from the zero and this angle from the plane's first axis.
Vec2 polar(double radius, double degrees);

class MillValues : public ControlPart {
 protected:
  MillValues(Control& control, ToolChanger& tools, Moves& moves)
      : ControlPart(control), mover_(control, moves), tools_(tools), chamfering_(control, tools) {}

  /// Takes the call whose values the functions below read. False: an error was reported.
  bool begin(const CycleCall& call, const Word& where, bool at_position);
  double value(ValueName name) const { return call_->get(name); }
  /// Reports an error at the call; always false.
  bool fail(const char* code, const std::string& text) { return error(code, text, where_); }
  /// Warns at the call, the first time for each line of it.
  void warn_once(const char* code, const std::string& text);
  /// The planes and the depth. False: an error was reported.
  bool depth(MillPlan& out);
  /// All of the plan; with a chamfer the radius of the cut, too. False: an error was reported.
  bool read_plan(MillPlan& out);
  /// The reference point in the plane, mm. False: an error was reported.
  bool reference_point(Vec2& out);
  /// The centre of a shape whose reference point may be a corner or an end, mm. False: an error was
  /// reported.
  bool center(double length, double width, double degrees, Vec2& out);

  CycleMover mover_;
  const CycleCall* call_ = nullptr;
  double radius_ = 0;  ///< of the cutter, mm

 private:
  bool modes(MillPlan& out);
  bool chamfer(MillPlan& out);

  ToolChanger& tools_;
  Chamfering chamfering_;
  Word where_;
  bool at_position_ = false;
};

}  // namespace mrsim
