// System variables of SINUMERIK, by name: data of tools, positions, frames. Private to src/interp.
#pragma once

#include "interp/language/value.h"
#include "interp/statements/state_values.h"

#include <span>
#include <string>
#include <string_view>

namespace mrsim {

class SinumerikVariables : public StateValues {
 public:
  explicit SinumerikVariables(Control& control) : StateValues(control) {}

  /// False: `why` names the variable and says that it is not read here.
  bool read(std::string_view name, std::span<const Value> indices, Value& out,
            std::string& why) const;
  bool write(std::string_view name, std::span<const Value> indices, const Value& value,
             std::string& why);

 private:
  double data_scale() const;
  bool tool_value(std::string_view name, std::span<const Value> indices, double& out) const;
  bool kept_value(std::string_view key, std::span<const Value> indices, double& out) const;
  bool axis_value_of(std::string_view name, int axis, double& out) const;
  double settable_frame() const;
  bool modal_code(std::span<const Value> indices, double& out) const;
  bool frame_value(std::string_view name, std::span<const Value> indices, Value& out) const;
  bool write_tool(std::string_view key, std::span<const Value> indices, const Value& value);
  bool write_program_frame(std::span<const Value> indices, const Value& value);
  bool take_settable(std::span<const Value> part, const Value& value, Vec3& shift,
                     double& angle) const;
  bool write_work_frame(std::span<const Value> indices, const Value& value);
  Vec3 active_zero() const;
  bool write_active_work(std::span<const Value> indices, const Value& value);
};

}  // namespace mrsim
