// The state in force as numbers that programs read: positions, work offsets, the tool's radius. The
// system variables of all controls are made of them. Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <string>

namespace mrsim {

class ToolChanger;

/// How many work offsets there are from G54 to G59.3.
inline constexpr int kWorkOffsets = 9;
/// The name of the n-th of them, from 1.
std::string work_name(int n);

/// The G numbers of modes.
double motion_number(Code motion);
double comp_number(Code comp);
double feed_number(FeedUnit unit);

class StateValues : public ControlPart {
 public:
  explicit StateValues(Control& control) : ControlPart(control) {}

  /// Sets who knows the data of the tool in the spindle. Before this call no program runs.
  void set_tools(ToolChanger& tools) { tools_ = &tools; }

 protected:
  /// 0 to 2 of "X" to "Z", else -1.
  int axis_numbered(int number) const;
  double shown(int axis, double mm) const;
  double work_position(int axis) const;
  double machine_position(int axis) const;
  bool stored_place(int which, int axis, double& out) const;
  double tool_radius() const;
  double work_number() const;
  Vec3 work_shift(const std::string& name) const;
  double work_turn(const std::string& name) const;  ///< turn about Z, degrees
  void set_work(const std::string& name, const Vec3& shift);

  ToolChanger* tools_ = nullptr;
};

}  // namespace mrsim
