// LinuxCNC's system parameters: numbers from #5001 on and names such as #<_feed>. Private to
// src/interp.
#pragma once

#include "interp/language/value.h"
#include "interp/statements/state_values.h"

#include <map>
#include <string>
#include <string_view>

namespace mrsim {

class LinuxcncValues : public StateValues {
 public:
  explicit LinuxcncValues(Control& control) : StateValues(control) {}

  /// False: `why` names the parameter and says that it is not read here.
  bool read(double number, Value& out, std::string& why) const;
  bool write(double number, const Value& value, std::string& why);
  /// The value of a named parameter. False: there is no such name.
  bool named(std::string_view name, double& out) const;
  /// The last subprogram has returned this value. `given`: it had one.
  void set_returned(double value, bool given) {
    returned_ = value;
    has_returned_ = given;
  }
  /// A subprogram begins (1) or ends (-1).
  void add_call_level(int more) { call_level_ += more; }

 private:
  bool numbered(int number, double& out) const;
  bool from_outside(int number) const;

  double returned_ = 0;
  bool has_returned_ = false;
  int call_level_ = 0;
  std::map<int, double> outside_;  ///< given with --set
};

}  // namespace mrsim
