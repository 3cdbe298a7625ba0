// FANUC's numbered system variables: positions, offsets of tools, modal codes and addresses, and
// values that --set gives. Private to src/interp.
#pragma once

#include "interp/language/value.h"
#include "interp/statements/state_values.h"

#include <map>
#include <optional>
#include <string>

namespace mrsim {

class FanucValues : public StateValues {
 public:
  explicit FanucValues(Control& control) : StateValues(control) {}

  /// False: `why` names the variable and says that it is not read here.
  bool read(int number, Value& out, std::string& why) const;
  bool write(double number, const Value& value, std::string& why);
  /// The value to which the program has set #3000, which ends it.
  std::optional<double> alarm() const { return alarm_; }

 private:
  bool position(int number, double& out, std::string& why) const;
  bool read_register(int number, double& out, std::string& why) const;
  bool write_register(double number, const Value& value);
  bool modal(int number, double& out) const;
  bool address(int number, double& out) const;
  bool mill_group(int group, double& out) const;
  bool lathe_group(int group, double& out) const;

  std::optional<double> alarm_;
  std::map<int, double> outside_;  ///< given with --set, or kept for the program
};

}  // namespace mrsim
