// Variables that are the control's state. Those that geometry depends on are read from the state in
// force, by the rules of the program's control; any other is refused by name. Private to
// src/interp.
#pragma once

#include "interp/language/variables.h"
#include "interp/statements/fanuc_values.h"
#include "interp/statements/linuxcnc_values.h"
#include "interp/statements/sinumerik_variables.h"

#include <span>
#include <string>
#include <string_view>

namespace mrsim {

class SystemValues : public StateValues, public SystemVariables {
 public:
  explicit SystemValues(Control& control)
      : StateValues(control), fanuc_(control), linuxcnc_(control), sinumerik_(control) {}

  bool read(double number, Value& out, std::string& why) override;
  bool read(std::string_view name, std::span<const Value> indices, Value& out,
            std::string& why) override;
  bool write(double number, const Value& value, std::string& why) override;
  bool write(std::string_view name, std::span<const Value> indices, const Value& value,
             std::string& why) override;
  bool knows(std::string_view name) override;
  /// Sets who knows the data of the tool in the spindle.
  void set_tools(ToolChanger& tools);
  LinuxcncValues& linuxcnc() { return linuxcnc_; }
  const FanucValues& fanuc() const { return fanuc_; }

 private:
  bool work_cell(int number, std::string& name, int& axis) const;
  std::string turned_work(int number) const;

  FanucValues fanuc_;
  LinuxcncValues linuxcnc_;
  SinumerikVariables sinumerik_;
};

}  // namespace mrsim
