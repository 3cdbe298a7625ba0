// Variables that are the control's state: positions, modal codes, tool data, frames. What geometry
// needs is answered from the state in force; anything else is refused by name. Private to
// src/interp.
#pragma once

#include "interp/control/control.h"
#include "interp/language/variables.h"

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace mrsim {

class ToolChanger;

/// G numbers of the modes in force.
double motion_number(Code motion);
double comp_number(Code comp);
double feed_number(FeedUnit unit);

class SystemValues : public ControlPart, public SystemVariables {
 public:
  explicit SystemValues(Control& control) : ControlPart(control) {}

  bool read(double number, Value& out, std::string& why) override;
  bool read(std::string_view name, std::span<const Value> indices, Value& out,
            std::string& why) override;
  bool write(double number, const Value& value, std::string& why) override;
  bool write(std::string_view name, std::span<const Value> indices, const Value& value,
             std::string& why) override;
  bool knows(std::string_view name) override;
  /// Who knows the data of the tool in the spindle.
  void set_tools(ToolChanger& tools) { tools_ = &tools; }

  /// LinuxCNC: what the last subprogram returned.
  void set_returned(double value, bool given) {
    returned_ = value;
    has_returned_ = given;
  }
  /// LinuxCNC: a subprogram begins (1) or ends (-1).
  void add_call_level(int more) { call_level_ += more; }

 private:
  bool read_fanuc(int number, Value& out, std::string& why) const;
  bool write_fanuc(double number, const Value& value, std::string& why);
  bool fanuc_position(int number, double& out, std::string& why) const;
  bool fanuc_register(int number, double& out, std::string& why) const;
  bool write_fanuc_register(double number, const Value& value);
  bool fanuc_modal(int number, double& out) const;
  bool fanuc_address(int number, double& out) const;
  bool mill_group(int group, double& out) const;
  bool lathe_group(int group, double& out) const;
  bool stored_place(int which, int axis, double& out) const;
  bool read_linuxcnc(int number, double& out) const;
  bool named_linuxcnc(std::string_view name, double& out) const;
  double data_scale() const;
  bool tool_value(std::string_view name, std::span<const Value> indices, double& out) const;
  bool kept_value(std::string_view key, std::span<const Value> indices, double& out) const;
  bool axis_value_of(std::string_view name, int axis, double& out) const;
  bool frame_value(std::string_view name, std::span<const Value> indices, Value& out) const;
  bool write_tool(std::string_view key, std::span<const Value> indices, const Value& value);
  bool write_program_frame(std::span<const Value> indices, const Value& value);
  bool write_work_frame(std::span<const Value> indices, const Value& value);
  /// 0 to 2 of "X" to "Z", else -1.
  int axis_numbered(int number) const;
  double shown(int axis, double mm) const;
  double work_position(int axis) const;
  double machine_position(int axis) const;
  double tool_radius() const;
  double work_number() const;
  bool work_cell(int number, std::string& name, int& axis) const;
  std::string turned_work(int number) const;
  bool from_outside(int number) const;
  Vec3 work_shift(const std::string& name) const;
  double work_turn(const std::string& name) const;  ///< about Z, degrees
  void set_work(const std::string& name, const Vec3& shift);

  ToolChanger* tools_ = nullptr;
  double returned_ = 0;
  bool has_returned_ = false;
  int call_level_ = 0;
  std::map<int, double> outside_;  ///< given with --set
};

}  // namespace mrsim
