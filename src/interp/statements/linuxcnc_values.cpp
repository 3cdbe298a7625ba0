#include "interp/statements/linuxcnc_values.h"

#include "core/text/text_io.h"
#include "interp/path/frame_parts.h"
#include "interp/text/characters.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {

bool LinuxcncValues::numbered(int number, double& out) const {
  if (number >= 5420 && number <= 5428) {
    out = number < 5423 ? work_position(number - 5420) : 0;
  } else if (number >= 5021 && number <= 5029) {
    out = number < 5024 ? machine_position(number - 5021) : 0;
  } else if (number == 5220) {
    out = 1;
    for (int n = 1; n <= kWorkOffsets; ++n)
      if (work_name(n) == frames_.work_name) out = n;
  } else if (number == 5400) {
    out = parse_number(control_.tool.current).value_or(0);
  } else if (number == 5403) {
    out = modal_.length_offset / scale();
  } else if (number == 5410) {
    out = 2 * tool_radius() / scale();
  } else if (number >= 5211 && number <= 5213) {
    out = component(frames_.position_shift, number - 5211) / scale();
  } else if (number >= 5401 && number <= 5409) {
    out = 0;
  } else if (number % 20 >= 1 && number % 20 <= 3 && (number / 20 == 258 || number / 20 == 259)) {
    return stored_place(number / 20 - 258, number % 20 - 1, out);  // #5161, #5181
  } else {
    return false;
  }
  return true;
}

// Whether the value comes from outside: where a probe touched, whether it did, what M66 has read.
bool LinuxcncValues::from_outside(int number) const {
  return is(Dialect::ngc) && ((number >= 5061 && number <= 5070) || number == 5399);
}

bool LinuxcncValues::read(double number, Value& out, std::string& why) const {
  const int n = number < 1e6 ? static_cast<int>(number) : 0;
  double value = 0;
  if (numbered(n, value)) {
    out = Value::of(value);
    return true;
  }
  if (from_outside(n)) {
    const auto given = outside_.find(n);
    out = Value::of(given == outside_.end() ? 0 : given->second);
    why = fmt::format("what a probe or an input said (#{0}) is not known here: say --set '#{0}=1'",
                      n);
    return given != outside_.end();
  }
  why = fmt::format("the system variable #{:.0f} is not answered here", number);
  return false;
}

bool LinuxcncValues::write(double number, const Value& value, std::string& why) {
  if (number < 6000 && value.is_number() && from_outside(static_cast<int>(number))) {
    outside_[static_cast<int>(number)] = value.number;
    return true;
  }
  why = fmt::format("the system variable #{:.0f} cannot be set here", number);
  return false;
}

bool LinuxcncValues::named(std::string_view name, double& out) const {
  const std::string key = upper_case(name);
  const auto axis = [&](std::string_view prefix) {
    return key.starts_with(prefix) ? axis_named(std::string_view(key).substr(prefix.size())) : -1;
  };
  if (const int i = axis("_"); i >= 0)
    out = work_position(i);
  else if (const int j = axis("_ABS_"); j >= 0)
    out = machine_position(j);
  else if (key == "_LINE")
    out = block_.line_number;
  else if (key == "_VALUE")
    out = returned_;
  else if (key == "_VALUE_RETURNED")
    out = has_returned_;
  else if (key == "_CALL_LEVEL")
    out = call_level_;
  else if (key == "_METRIC" || key == "_IMPERIAL")
    out = modal_.inch == (key == "_IMPERIAL");
  else if (key == "_ABSOLUTE" || key == "_INCREMENTAL")
    out = modal_.incremental == (key == "_INCREMENTAL");
  else if (key == "_INVERSE_TIME" || key == "_UNITS_PER_MINUTE" || key == "_UNITS_PER_REV")
    out = feed_number(modal_.feed_unit) == (key == "_INVERSE_TIME"       ? 93
                                            : key == "_UNITS_PER_MINUTE" ? 94
                                                                         : 95);
  else if (key == "_RETRACT_R_PLANE" || key == "_RETRACT_OLD_Z")
    out = (modal_.hole_return == HoleReturn::initial) == (key == "_RETRACT_OLD_Z");
  else if (key == "_SPINDLE_RPM_MODE" || key == "_SPINDLE_CSS_MODE")
    out = modal_.surface_speed == (key == "_SPINDLE_CSS_MODE");
  else if (key == "_LATHE_DIAMETER_MODE" || key == "_LATHE_RADIUS_MODE")
    out = (modal_.diameter == Code::diameter_on) == (key == "_LATHE_DIAMETER_MODE");
  else if (key == "_IJK_ABSOLUTE_MODE")
    out = modal_.center_absolute;
  else if (key == "_FEED")
    out = modal_.feed / feed_scale();
  else if (key == "_RPM")
    out = modal_.speed;
  else if (key == "_MOTION_MODE")
    out = motion_number(modal_.motion) * 10;
  else if (key == "_PLANE")
    out = (17 + std::min(modal_.plane, 2)) * 10;
  else if (key == "_CCOMP")
    out = comp_number(modal_.comp) * 10;
  else if (key == "_COORD_SYSTEM")
    out = work_number() * 10;
  else if (key == "_CURRENT_TOOL" || key == "_SELECTED_TOOL")
    out = parse_number(control_.tool.current).value_or(0);
  else if (key == "_TOOL_OFFSET")
    out = modal_.length != Code::length_off;
  else if (key == "_TASK" || key == "_CURRENT_POCKET" || key == "_SELECTED_POCKET")
    out = 0;
  else
    return false;
  return true;
}

}  // namespace mrsim
