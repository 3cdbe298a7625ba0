#include "interp/statements/fanuc_values.h"

#include "core/text/text_io.h"
#include "interp/tools/tool_changer.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {

// #4001 to #4130 are the code in force of a modal group, and the last value of an address. Those of
// the block before (numbers higher by 200 and 400) are the same here.
bool FanucValues::modal(int number, double& out) const {
  const int n = (number - 4000) % 200;
  if (n > 100) return address(n - 100, out);
  switch (n) {
    case 1:
      out = motion_number(modal_.motion);
      if (modal_.turn.number != 0) out = modal_.turn.number;
      if (lathe() && modal_.motion == Code::thread) out = 32;
      return true;
    case 6:
      out = modal_.inch ? 20 : 21;
      return true;
    case 7:
      out = comp_number(modal_.comp);
      return true;
    case 12:
      reporter_.once(
          Severity::warning, "modal-group",
          "#4012 is read as the work offset, as Haas and Mitsubishi have it; on FANUC it "
          "is G66 or G67, and #4014 the work offset",
          Word{}, "4012");
      [[fallthrough]];
    case 14:
      out = frames_.work_name.starts_with("G54.1P") ? 54.1 : work_number();
      return true;
    default:
      return lathe() ? lathe_group(n, out) : mill_group(n, out);
  }
}

bool FanucValues::mill_group(int group, double& out) const {
  const auto choose = [&](bool first, double yes, double no) {
    out = first ? yes : no;
    return true;
  };
  switch (group) {
    case 2:
      out = 17 + std::min(modal_.plane, 2);
      return true;
    case 3:
      return choose(modal_.incremental, 91, 90);
    case 5:
      out = feed_number(modal_.feed_unit);
      return true;
    case 8:
      return choose(modal_.length == Code::length_off, 49,
                    modal_.length == Code::length_minus ? 44 : 43);
    case 9:
      return choose(modal_.drill.number != 0, modal_.drill.number, 80);
    case 10:
      return choose(modal_.hole_return == HoleReturn::initial, 98, 99);
    case 11:
      return choose(frames_.scaling == Frame{}, 50, 51);
    case 13:
      return choose(modal_.surface_speed, 96, 97);
    case 16:
      return choose(frames_.rotation == Frame{}, 69, 68);
    case 17:
      return choose(modal_.polar, 16, 15);
    default:
      return false;
  }
}

// The code in force of a group in code system A.
bool FanucValues::lathe_group(int group, double& out) const {
  switch (group) {
    case 2:
      out = modal_.surface_speed ? 96 : 97;
      return true;
    case 5:
      out = modal_.feed_unit == FeedUnit::mm_per_min ? 98 : 99;
      return true;
    case 16:
      out = 17 + std::min(modal_.plane, 2);
      return true;
    default:
      return false;
  }
}

bool FanucValues::address(int number, double& out) const {
  switch (number) {
    case 7:  // D
      out = modal_.edge_given ? modal_.edge : 0;
      return true;
    case 9:
      out = modal_.feed / feed_scale();
      return true;
    case 11:  // H
      out = modal_.length_number;
      return true;
    case 19:
      out = modal_.surface_speed ? modal_.cutting_speed / (modal_.inch_feed ? 0.3048 : 1.0)
                                 : modal_.speed;
      return true;
    case 20:
      out = control_.tool.written;
      return out >= 0;
    case 30: {  // P of G54.1
      const std::string_view name = frames_.work_name;
      out = name.starts_with("G54.1P") ? parse_number(name.substr(6)).value_or(0) : 0;
      return true;
    }
    default:
      return false;
  }
}

// #5001 is the end of the block before, #5021 the position in machine coordinates, #5041 the
// current position, #5081 the length offset of the tool.
bool FanucValues::position(int number, double& out, std::string& why) const {
  const int kind = (number - 5001) / 20, axis = axis_numbered((number - 5001) % 20);
  if (axis < 0 || kind == 3 || kind > 4) return false;
  if (kind == 4) {
    out = axis == 2 && !lathe() ? modal_.length_offset / scale() : 0;
    return !lathe();
  }
  if (kind == 1 && !control_.machine_known) {
    why = fmt::format("#{} is a place of the machine: say where its zero is ([machine] of a job)",
                      number);
    return false;
  }
  if (!position_.known.has(axis)) {
    why =
        fmt::format("#{}: where {} is, is not known here: say --start X,Y,Z", number, "XYZ"[axis]);
    return false;
  }
  const bool length = axis == 2 && modal_.length != Code::length_off;
  if (kind != 0 && !lathe() && (length || modal_.comp != Code::comp_off)) {
    why = fmt::format(
        "#{} under {}: controls differ in whether it counts the tool's {}; #{} has "
        "the programmed position",
        number, length ? "G43 or G44" : "G41 or G42", length ? "length" : "radius", 5001 + axis);
    return false;
  }
  out = kind == 1 ? machine_position(axis) : work_position(axis);
  return true;
}

// Offset memory C of mills: #10001 is the wear and #11001 the length of H, #12001 the wear and
// #13001 the radius of D.
bool FanucValues::read_register(int number, double& out, std::string& why) const {
  const int kind = number / 1000;
  if (lathe() || kind < 10 || kind > 13 || number % 1000 == 0 || !tools_) return false;
  const std::string name = fmt::format("{}{}", kind < 12 ? 'H' : 'D', number % 1000);
  if (kind < 12) {
    const SetLengths::Setting* set = control_.lengths.find({0, number % 1000}, kind == 10);
    if (set && !set->relative) {
      out = set->mm / scale();
      return true;
    }
  }
  const OffsetRegister* reg = tools_->find_register(name);
  if (!reg && kind == 12 && control_.bare_wears.contains(name)) {
    out = control_.bare_wear(name) / scale();
    return true;
  }
  if (!reg) {
    why = fmt::format("#{}: {} is not in the tool table", number, name);
    return false;
  }
  out = (kind % 2 == 0 ? reg->wear : kind == 11 ? reg->length : reg->radius) / scale();
  return true;
}

// Lengths (#10001 and #11001) move nothing here, see SetLengths.
bool FanucValues::write_register(double number, const Value& value) {
  const int kind = static_cast<int>(number / 1000), index = static_cast<int>(number) % 1000;
  if (lathe() || kind < 10 || kind > 13 || index == 0 || !value.is_number()) return false;
  const double mm = value.number * scale();
  if (kind < 12) {
    const bool wear = kind == 10;
    control_.lengths.set({0, index}, wear, wear ? std::optional(0.0) : std::nullopt,
                         {mm, false, fmt::format("#{:.0f}", number), block_.motion_at(0)});
    return true;
  }
  const std::string name = fmt::format("D{}", index);
  (kind == 12 ? control_.change_wear(name) : control_.change_register(name).radius) = mm;
  return true;
}

namespace {

constexpr int kPartsMade = 3901, kPartsWanted = 3902;

// Whether it is a timer, a counter of parts or an output: setting it moves nothing.
bool is_kept(double number) {
  return number == 3001 || number == 3002 || number == kPartsMade || number == kPartsWanted ||
         (number >= 1100 && number <= 1135);
}

}  // namespace

bool FanucValues::read(int number, Value& out, std::string& why) const {
  double value = 0;
  bool known = number == kPartsMade;  // none yet
  if (const auto given = outside_.find(number); given != outside_.end()) {
    value = given->second;
    known = true;
  } else if (number >= 4000 && number < 4600) {
    known = modal(number, value);
  } else if (number > 5000 && number < 5101) {
    known = position(number, value, why);
  } else if (!known) {
    known = read_register(number, value, why);
  }
  out = Value::of(value);
  if (!known && why.empty())
    why = fmt::format("the system variable #{0} is not answered here: say --set '#{0}=1'", number);
  return known;
}

bool FanucValues::write(double number, const Value& value, std::string& why) {
  if (!tools_ && value.is_number()) {  // the program does not run yet: --set
    outside_[static_cast<int>(number)] = value.number;
    return true;
  }
  if (is_kept(number) && value.is_number()) {
    outside_[static_cast<int>(number)] = value.number;
    return true;
  }
  if (number >= 3001 && number <= 3007) return true;  // clock, stops, messages
  if (write_register(number, value)) return true;
  if (number == 3000) alarm_ = value.number;
  why = fmt::format("the system variable #{:.0f} cannot be set here", number);
  return number == 3000;
}

}  // namespace mrsim
