#include "interp/control/system_values.h"

#include "core/text_io.h"
#include "interp/control/frame_words.h"
#include "interp/control/tool_changer.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

double motion_number(Code motion) {
  switch (motion) {
    case Code::rapid:
      return 0;
    case Code::arc_cw:
      return 2;
    case Code::arc_ccw:
      return 3;
    case Code::thread:
      return 33;
    default:
      return 1;
  }
}

double comp_number(Code comp) {
  return comp == Code::comp_left ? 41 : comp == Code::comp_right ? 42 : 40;
}

double feed_number(FeedUnit unit) {
  return unit == FeedUnit::inverse_time ? 93 : unit == FeedUnit::mm_per_min ? 94 : 95;
}

constexpr int kWorkOffsets = 9;

// G54 to G59, then G59.1 to G59.3.
std::string work_name(int n) {
  return n <= 6 ? fmt::format("G{}", 53 + n) : fmt::format("G59.{}", n - 6);
}

constexpr std::string_view kFrameParts[] = {"TR", "FI", "RT", "SC", "MI"};

}  // namespace

int SystemValues::axis_named(std::string_view name) {
  return name.size() == 1 && upper(name[0]) >= 'X' && upper(name[0]) <= 'Z' ? upper(name[0]) - 'X'
                                                                            : -1;
}

double SystemValues::work_position(int axis) const {
  const double mm = component(position_.programmed, axis);
  const bool diameter = axis == 0 && modal_.diameter == Code::diameter_on;
  return (diameter ? 2 * mm : mm) / scale();
}

double SystemValues::machine_position(int axis) const {
  return component(position_.physical - control_.machine_shift, axis) / scale();
}

// 54 of "G54", 0 where none is in force.
double SystemValues::work_number() const {
  const std::string& name = frames_.work_name;
  return name.size() > 1 ? parse_number(std::string_view(name).substr(1)).value_or(0) : 0;
}

// #5221 and the numbers behind it: 20 for each of G54 to G59 (LinuxCNC: to G59.3).
bool SystemValues::work_cell(int number, std::string& name, int& axis) const {
  const int n = (number - 5221) / 20 + 1;
  axis = (number - 5221) % 20;
  if (number < 5221 || n > (is(Dialect::ngc) ? kWorkOffsets : 6) || axis > 2) return false;
  name = work_name(n);
  return true;
}

Vec3 SystemValues::work_shift(const std::string& name) const {
  for (const WorkOffset& work : control_.work)
    if (work.name == name) return work.shift - control_.machine_shift;
  return {};
}

void SystemValues::set_work(const std::string& name, const Vec3& shift) {
  auto at = std::find_if(control_.work.begin(), control_.work.end(),
                         [&](const WorkOffset& work) { return work.name == name; });
  if (at == control_.work.end()) at = control_.work.insert(at, WorkOffset{name, {}});
  at->shift = shift + control_.machine_shift;
  FrameWords(control_).renew_work();
}

double SystemValues::tool_radius() const {
  return tools_ ? tools_->radius(is(Dialect::sinumerik) ? modal_.edge : -1) : 0;
}

// FANUC #4001 to #4130: the modal code of a group, and the last value of an address.
bool SystemValues::read_modal(int number, double& out) const {
  if (number > 4200) number -= 200;  // of the block before: the same here
  switch (number) {
    case 4001:
      out = motion_number(modal_.motion);
      return true;
    case 4002:
      out = 17 + std::min(modal_.plane, 2);
      return true;
    case 4003:
      out = modal_.incremental ? 91 : 90;
      return true;
    case 4005:
      out = feed_number(modal_.feed_unit);
      return true;
    case 4006:
      out = modal_.inch ? 20 : 21;
      return true;
    case 4007:
      out = comp_number(modal_.comp);
      return true;
    case 4014:
      out = work_number();
      return true;
    case 4107:
      out = modal_.edge;
      return true;
    case 4109:
      out = modal_.feed / feed_scale();
      return true;
    case 4119:
      out = modal_.speed;
      return true;
    case 4120: {
      const auto id = parse_number(control_.tool.current);
      out = id.value_or(0);
      return id.has_value();
    }
    default:
      return false;
  }
}

bool SystemValues::read_fanuc(int number, double& out) const {
  if (number >= 4000 && number < 4400) return read_modal(number, out);
  const int axis = number % 20 - 1;
  if (number > 5000 && number < 5100 && axis >= 0 && axis < 3) {
    const int kind = (number - 5000) / 20;  // 0 end of the block before, 1 machine, 2 actual
    if (kind > 2) return false;
    out = kind == 1 ? machine_position(axis) : work_position(axis);
    return true;
  }
  return false;
}

bool SystemValues::read_linuxcnc(int number, double& out) const {
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
  } else {
    return false;
  }
  return true;
}

// Where a probe touched and whether it did; what M66 has read.
bool SystemValues::from_outside(int number) const {
  return is(Dialect::ngc) && ((number >= 5061 && number <= 5070) || number == 5399);
}

bool SystemValues::read(double number, Value& out, std::string& why) {
  const int n = number < 1e6 ? static_cast<int>(number) : 0;
  double value = 0;
  std::string name;
  int axis = 0;
  if (work_cell(n, name, axis)) {
    out = Value::of(component(work_shift(name), axis) / scale());
    return true;
  }
  if (is(Dialect::ngc) ? read_linuxcnc(n, value) : read_fanuc(n, value)) {
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

bool SystemValues::write(double number, const Value& value, std::string& why) {
  if (is(Dialect::fanuc) && number == 3000) {
    why = fmt::format("the program stops with its own alarm #3000 = {:g}", value.number);
    return false;
  }
  if (is(Dialect::fanuc) && number >= 3001 && number <= 3007)
    return true;  // clock, stops, messages
  std::string name;
  int axis = 0;
  if (number < 6000 && value.is_number() && work_cell(static_cast<int>(number), name, axis)) {
    Vec3 shift = work_shift(name);
    component(shift, axis) = value.number * scale();
    set_work(name, shift);
    return true;
  }
  if (number < 6000 && value.is_number() && from_outside(static_cast<int>(number))) {
    outside_[static_cast<int>(number)] = value.number;
    return true;
  }
  why = fmt::format("the system variable #{:.0f} cannot be set here", number);
  return false;
}

bool SystemValues::named_linuxcnc(std::string_view name, double& out) const {
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
    out = static_cast<double>(call_level_);
  else if (key == "_METRIC" || key == "_IMPERIAL")
    out = modal_.inch == (key == "_IMPERIAL");
  else if (key == "_ABSOLUTE" || key == "_INCREMENTAL")
    out = modal_.incremental == (key == "_INCREMENTAL");
  else if (key == "_INVERSE_TIME" || key == "_UNITS_PER_MINUTE" || key == "_UNITS_PER_REV")
    out = feed_number(modal_.feed_unit) == (key == "_INVERSE_TIME"       ? 93
                                            : key == "_UNITS_PER_MINUTE" ? 94
                                                                         : 95);
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

bool SystemValues::knows(std::string_view name) {
  double ignored = 0;
  if (is(Dialect::ngc)) return named_linuxcnc(name, ignored);
  if (axis_named(name) >= 0) return true;
  const std::string key = upper_case(name);
  for (const std::string_view part : kFrameParts)
    if (key == part) return true;
  return false;
}

bool SystemValues::read(std::string_view name, std::span<const Value> indices, Value& out,
                        std::string& why) {
  const std::string key = upper_case(name);
  double value = 0;
  bool known = false;
  if (is(Dialect::ngc)) {
    known = named_linuxcnc(name, value);
  } else if (key[0] != '$') {
    out = Value::of_text(key);
    return true;
  } else if (frame_value(key, indices, out)) {
    return true;
  } else if (key == "$PI") {
    value = 3.14159265358979323846;
    known = true;
  } else if (key == "$P_UIFRNUM") {
    value = std::max(0.0, work_number() - 53);
    known = true;
  } else if (key == "$P_F" || key == "$P_S") {
    value = key == "$P_F" ? modal_.feed / feed_scale() : modal_.speed;
    known = true;
  } else if (key == "$P_SEARCH" || key == "$P_ISTEST" || key == "$P_SIM") {
    known = true;
  } else if (indices.size() == 1 && axis_named(indices[0].text) >= 0) {
    known = axis_value_of(key, axis_named(indices[0].text), value);
  } else {
    known = tool_value(key, indices, value);
  }
  out = Value::of(value);
  if (!known) why = fmt::format("the system variable {} is not answered here", key.substr(0, 60));
  return known;
}

}  // namespace mrsim
