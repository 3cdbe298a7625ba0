#include "interp/statements/system_values.h"

#include "core/text_io.h"
#include "interp/frames/frame_words.h"
#include "interp/path/frame_parts.h"
#include "interp/text/characters.h"
#include "interp/tools/tool_changer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kWorkOffsets = 9;

// G54 to G59, then G59.1 to G59.3.
std::string work_name(int n) {
  return n <= 6 ? fmt::format("G{}", 53 + n) : fmt::format("G59.{}", n - 6);
}

/// Numbers of work offsets, 20 for each; of FANUC unless `basic`.
struct WorkNumbers {
  int first, count;
  const char* name;  ///< of all; null: G54 to G59
  bool basic = false;
};

constexpr WorkNumbers kWorkNumbers[] = {
    {5201, 1, "EXT"}, {5221, 6, nullptr, true}, {7001, 48, "G54.1P"}, {14001, 300, "G54.1P"}};

constexpr std::string_view kFrameParts[] = {"TR", "FI", "RT", "SC", "MI"};

}  // namespace

double SystemValues::work_position(int axis) const {
  return shown(axis, component(position_.programmed, axis));
}

double SystemValues::machine_position(int axis) const {
  return shown(axis, component(position_.physical - control_.machine_shift, axis));
}

// 54 of "G54", 0 where none is in force.
double SystemValues::work_number() const {
  const std::string& name = frames_.work_name;
  return name.size() > 1 ? parse_number(std::string_view(name).substr(1)).value_or(0) : 0;
}

// #5221 and the numbers behind it (LinuxCNC: to G59.3), the external offset, G54.1 P.
bool SystemValues::work_cell(int number, std::string& name, int& axis) const {
  const bool ngc = is(Dialect::ngc);
  for (const WorkNumbers& row : kWorkNumbers) {
    const int count = ngc ? kWorkOffsets : row.count;
    if ((ngc && !row.basic) || number < row.first || number >= row.first + 20 * count) continue;
    const int n = (number - row.first) / 20 + 1;
    axis = axis_numbered((number - row.first) % 20);
    name = row.basic ? work_name(n) : row.count == 1 ? row.name : fmt::format("{}{}", row.name, n);
    return axis >= 0;
  }
  return false;
}

// X Y Z; of FANUC's lathes X Z, and Z again for those that count a Y between them (Haas).
int SystemValues::axis_numbered(int number) const {
  if (number < 0 || number > 2) return -1;
  return number > 0 && lathe() && is(Dialect::fanuc) ? 2 : number;
}

// Numbers of X are diameters where its words are.
double SystemValues::shown(int axis, double mm) const {
  return (axis == 0 && modal_.diameter == Code::diameter_on ? 2 * mm : mm) / scale();
}

Vec3 SystemValues::work_shift(const std::string& name) const {
  for (const WorkOffset& work : control_.work)
    if (work.name == name) return name == "EXT" ? work.shift : work.shift - control_.machine_shift;
  return {};
}

void SystemValues::set_work(const std::string& name, const Vec3& shift) {
  auto at = std::find_if(control_.work.begin(), control_.work.end(),
                         [&](const WorkOffset& work) { return work.name == name; });
  if (at == control_.work.end()) at = control_.work.insert(at, WorkOffset{name, {}});
  at->shift = name == "EXT" ? shift : shift + control_.machine_shift;
  if (is(Dialect::ngc) || is(Dialect::sinumerik)) return;  // in force from its next word on
  FrameWords(control_).renew_work();
}

// #5230 and every 20th behind it: the turn of a work offset of LinuxCNC.
std::string SystemValues::turned_work(int number) const {
  const int behind = number - 5221;
  const bool turn =
      is(Dialect::ngc) && behind >= 0 && behind < 20 * kWorkOffsets && behind % 20 == 9;
  return turn ? work_name(behind / 20 + 1) : std::string();
}

double SystemValues::tool_radius() const {
  return tools_ ? tools_->radius(is(Dialect::sinumerik) ? modal_.edge : -1) : 0;
}

// Where G28 and G30 lead, in the machine's coordinates.
bool SystemValues::stored_place(int which, int axis, double& out) const {
  const std::optional<Vec3>& second = options_.places.second;
  std::optional<Vec3> place;
  if (control_.stored_places[which])
    place = *control_.stored_places[which] - control_.machine_shift;
  else if (control_.machine_known)
    place = which == 0 ? std::optional<Vec3>(options_.places.reference) : second;
  if (place) out = component(*place, axis) / scale();
  return place.has_value();
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
  } else if (number % 20 >= 1 && number % 20 <= 3 && (number / 20 == 258 || number / 20 == 259)) {
    return stored_place(number / 20 - 258, number % 20 - 1, out);  // #5161, #5181
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
    out = Value::of(shown(axis, component(work_shift(name), axis)));
    return true;
  }
  if (const std::string turned = turned_work(n); !turned.empty()) {
    const auto turn = control_.work_turns.find(turned);
    out = Value::of(turn == control_.work_turns.end() ? 0 : turn->second);
    return true;
  }
  if (is(Dialect::fanuc)) return read_fanuc(n, out, why);
  if (read_linuxcnc(n, value)) {
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
  std::string name;
  int axis = 0;
  if (number < 1e6 && value.is_number() && work_cell(static_cast<int>(number), name, axis)) {
    Vec3 shift = work_shift(name);
    component(shift, axis) = value.number / shown(axis, 1);
    set_work(name, shift);
    return true;
  }
  const std::string turned = number < 6000 ? turned_work(static_cast<int>(number)) : "";
  if (!turned.empty() && value.is_number()) {
    control_.work_turns[turned] = value.number;
    return true;
  }
  if (is(Dialect::fanuc)) return write_fanuc(number, value, why);
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
    known = tool_value(key, indices, value) || kept_value(key, indices, value);
  }
  out = Value::of(value);
  if (!known) why = fmt::format("the system variable {} is not answered here", key.substr(0, 60));
  return known;
}

}  // namespace mrsim
