#include "interp/statements/system_values.h"

#include "interp/path/frame_parts.h"
#include "interp/text/characters.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

/// Variables of work offsets, 20 numbers for each offset.
struct WorkNumbers {
  int first, count;
  const char* name;    ///< name of all of them; null: G54 to G59
  bool basic = false;  ///< LinuxCNC has them, too
};

constexpr WorkNumbers kWorkNumbers[] = {
    {5201, 1, "EXT"}, {5221, 6, nullptr, true}, {7001, 48, "G54.1P"}, {14001, 300, "G54.1P"}};

constexpr std::string_view kFrameParts[] = {"TR", "FI", "RT", "SC", "MI"};

}  // namespace

// Finds the work offset and the axis of a variable: #5221 and the numbers behind it (on LinuxCNC up
// to G59.3), those of the external offset, and those of G54.1 P.
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

// The work offset of LinuxCNC whose turn is #5230 or a 20th number behind it.
std::string SystemValues::turned_work(int number) const {
  const int behind = number - 5221;
  const bool turn =
      is(Dialect::ngc) && behind >= 0 && behind < 20 * kWorkOffsets && behind % 20 == 9;
  return turn ? work_name(behind / 20 + 1) : std::string();
}

void SystemValues::set_tools(ToolChanger& tools) {
  fanuc_.set_tools(tools);
  linuxcnc_.set_tools(tools);
  sinumerik_.set_tools(tools);
}

bool SystemValues::knows(std::string_view name) {
  double ignored = 0;
  if (is(Dialect::ngc)) return linuxcnc_.named(name, ignored);
  if (axis_named(name) >= 0) return true;
  const std::string key = upper_case(name);
  for (const std::string_view part : kFrameParts)
    if (key == part) return true;
  return false;
}

bool SystemValues::read(double number, Value& out, std::string& why) {
  const int n = number < 1e6 ? static_cast<int>(number) : 0;
  std::string name;
  int axis = 0;
  if (work_cell(n, name, axis)) {
    out = Value::of(shown(axis, component(work_shift(name), axis)));
    return true;
  }
  if (const std::string turned = turned_work(n); !turned.empty()) {
    out = Value::of(work_turn(turned));
    return true;
  }
  return is(Dialect::fanuc) ? fanuc_.read(n, out, why) : linuxcnc_.read(number, out, why);
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
  return is(Dialect::fanuc) ? fanuc_.write(number, value, why)
                            : linuxcnc_.write(number, value, why);
}

bool SystemValues::read(std::string_view name, std::span<const Value> indices, Value& out,
                        std::string& why) {
  if (!is(Dialect::ngc)) return sinumerik_.read(name, indices, out, why);
  double value = 0;
  const bool known = linuxcnc_.named(name, value);
  out = Value::of(value);
  if (!known)
    why =
        fmt::format("the system variable {} is not answered here", upper_case(name).substr(0, 60));
  return known;
}

bool SystemValues::write(std::string_view name, std::span<const Value> indices, const Value& value,
                         std::string& why) {
  return sinumerik_.write(name, indices, value, why);
}

}  // namespace mrsim
