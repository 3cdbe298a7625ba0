#include "interp/statements/sinumerik_variables.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "interp/frames/frame_chain.h"
#include "interp/path/frame_parts.h"
#include "interp/text/characters.h"
#include "interp/tools/tool_changer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

// mm of a length of 1 in settable frames and tool data: G700 makes them inches, G70 does not.
double SinumerikVariables::data_scale() const { return feed_scale(); }

// Reads $P_TOOLNO, $P_TOOL, $P_TOOLR, $TC_DP3[t,d], $TC_DP6[t,d], $TC_DP15[t,d], and $P_AD[6] of
// the edge in force, which are all kinds of $TC_DP.
bool SinumerikVariables::tool_value(std::string_view name, std::span<const Value> indices,
                                    double& out) const {
  if (name == "$P_TOOLNO") {
    const auto id = parse_number(control_.tool.current);
    out = id.value_or(0);
    return id.has_value() || control_.tool.current.empty();
  }
  if (name == "$P_TOOL") {
    out = modal_.edge;
    return true;
  }
  if (name == "$P_TOOLR") {
    out = tool_radius() / data_scale();
    return true;
  }
  if (name == "$P_AD" && indices.size() == 1) {
    const Value edge[] = {Value::of(parse_number(control_.tool.current).value_or(0)),
                          Value::of(modal_.edge)};
    if (tool_value(fmt::format("$TC_DP{:g}", indices[0].number), edge, out)) return true;
    out = tool_radius() / data_scale();  // of a tool with a name
    return indices[0].number == 6 && out > 0;
  }
  if (indices.size() != 2) return false;
  const double kind = name.starts_with("$TC_DP") ? parse_number(name.substr(6)).value_or(0) : 0;
  if (const auto set =
          control_.lengths.find({indices[0].number, indices[1].number}, static_cast<int>(kind))) {
    out = set->mm / data_scale();
    return true;
  }
  if (name != "$TC_DP3" && name != "$TC_DP6" && name != "$TC_DP15") return false;
  const std::string id = fmt::format("{:g}", indices[0].number);
  const std::string wanted = fmt::format("T{}.D{:g}", id, indices[1].number);
  for (const OffsetRegister& reg : control_.registers)
    if (reg.name == wanted) {
      out = (kind == 3 ? reg.length : kind == 6 ? reg.radius : reg.wear) / data_scale();
      return true;
    }
  for (const Tool& tool : options_.table.tools)
    if (tool.id == id && name == "$TC_DP6") {
      out = (tool.diameter > 0 ? tool.diameter / 2 : tool.nose_radius) / data_scale();
      return true;
    }
  const double own =
      name == "$TC_DP6" && id == control_.tool.current && tools_ ? tools_->radius(-1) : 0;
  out = own / data_scale();
  return own > 0;
}

namespace {

// The counters of parts: 0 until a program sets them, as FANUC's #3901.
bool counts_parts(std::string_view key) {
  return key == "$AC_ACTUAL_PARTS" || key == "$AC_TOTAL_PARTS" || key == "$AC_REQUIRED_PARTS" ||
         key == "$AC_SPECIAL_PARTS";
}

// The name of a variable in which programs keep values, or of an output to the PLC: a value that
// was set is read back. Empty for others.
std::string kept_name(std::string_view key, std::span<const Value> indices) {
  static constexpr std::string_view kKept[] = {"$AC_MARKER", "$AC_PARAM", "$A_OUT", "$A_OUTA",
                                               "$A_DBB",     "$A_DBW",    "$A_DBD", "$A_DBR"};
  if (counts_parts(key) && indices.empty()) return std::string(key);
  if (indices.size() != 1 || !indices[0].is_number()) return {};
  if (std::find(std::begin(kKept), std::end(kKept), key) == std::end(kKept)) return {};
  return fmt::format("{}[{:g}]", key, indices[0].number);
}

// The name of a tool's type or tip, which are read back as they were set. Empty for others.
std::string kept_tool_data(std::string_view key, std::span<const Value> indices) {
  if ((key != "$TC_DP1" && key != "$TC_DP2") || indices.size() != 2) return {};
  return fmt::format("{}[{:g},{:g}]", key, indices[0].number, indices[1].number);
}

}  // namespace

bool SinumerikVariables::kept_value(std::string_view key, std::span<const Value> indices,
                                    double& out) const {
  const std::string name = kept_name(key, indices);
  const auto kept = control_.kept_values.find(name.empty() ? kept_tool_data(key, indices) : name);
  const bool set = kept != control_.kept_values.end();
  out = set ? kept->second : 0;
  return set || (counts_parts(key) && indices.empty());
}

bool SinumerikVariables::axis_value_of(std::string_view name, int axis, double& out) const {
  if (name == "$P_EP" || name == "$AA_IW" || name == "$AA_MW")
    out = work_position(axis);
  else if (name == "$AA_IM" || name == "$AA_IB" || name == "$P_APR")
    out = machine_position(axis);
  else
    return false;
  return true;
}

// Reads $P_UIFR[1], $P_IFRAME, $P_PFRAME, $P_ACTFRAME, or one component: $P_PFRAME[X,TR].
bool SinumerikVariables::frame_value(std::string_view name, std::span<const Value> indices,
                                     Value& out) const {
  Frame frame;
  const bool programmed = name == "$P_PFRAME" || name == "$P_ACTFRAME";
  const double unit = programmed ? scale() : data_scale();
  if (name == "$P_IFRAME") {
    frame =
        compose(shift_frame(frames_.work - active_zero()), rotation_frame(2, frames_.work_turn));
  } else if (name == "$P_PFRAME") {
    frame = frames_.program;
  } else if (name == "$P_ACTFRAME") {
    frame = frames_.total;
  } else if (name == "$P_UIFR" && !indices.empty() && indices[0].is_number()) {
    const double n = indices[0].number;
    const std::string wanted = fmt::format("G{:g}", n < 5 ? 53 + n : 500 + n);
    frame = compose(shift_frame(work_shift(wanted)), rotation_frame(2, work_turn(wanted)));
    indices = indices.subspan(1);
  } else {
    return false;
  }
  if (indices.empty()) {
    frame.shift = (1 / unit) * frame.shift;
    out = Value::of_frame(frame);
    return true;
  }
  if (indices.size() != 2) return false;
  const std::string& part = indices[1].text;
  const std::optional<double> value = frame_part(frame, axis_named(indices[0].text), part);
  if (value) out = Value::of(part == "TR" ? *value / unit : *value);
  return value.has_value();
}

// Sets tool data. The radius and its wear have an effect on compensation; for lengths see
// SetLengths.
bool SinumerikVariables::write_tool(std::string_view key, std::span<const Value> indices,
                                    const Value& value) {
  if (!value.is_number() || indices.size() != 2 || !indices[0].is_number() ||
      !indices[1].is_number())
    return false;
  if (!key.starts_with("$TC_DP")) return false;
  const double number = parse_number(key.substr(6)).value_or(0);
  if (number < 1 || number > 25 || number != std::floor(number)) return false;
  if (const std::string kept = kept_tool_data(key, indices); !kept.empty())
    control_.kept_values[kept] = value.number;
  if (number == 2 && lathe()) {  // the orientation of the tip
    const double tip = value.number;
    if (indices[1].number != 1 || tip < 1 || tip > 8 || tip != std::floor(tip)) return false;
    control_.told_tips[static_cast<long>(indices[0].number)] = static_cast<int>(tip);
    return true;
  }
  const std::string name = fmt::format("T{:g}.D{:g}", indices[0].number, indices[1].number);
  const double mm = value.number * data_scale();
  const auto at = std::find_if(control_.registers.begin(), control_.registers.end(),
                               [&](const OffsetRegister& reg) { return reg.name == name; });
  if (number == 15 && mm != 0 && at == control_.registers.end())
    return false;  // the radius to which the wear belongs is unknown
  const bool wear = number >= 12 && number <= 14;
  if (wear || (number >= 3 && number <= 5))
    control_.lengths.set({indices[0].number, indices[1].number}, static_cast<int>(number),
                         wear ? std::optional(0.0) : std::nullopt,
                         {mm, false, fmt::format("{} of {}", key, name), block_.motion_at(0),
                          (lathe() ? "XZY" : "ZYX")[static_cast<int>(number) % 3]});
  if (number == 6) control_.change_register(name).radius = mm;
  if (number == 15 && at != control_.registers.end()) control_.change_register(name).wear = mm;
  return true;
}

// Carries out $P_PFRAME = CTRANS(...) and $P_PFRAME[X,TR] = 5.
bool SinumerikVariables::write_program_frame(std::span<const Value> indices, const Value& value) {
  Frame frame = frames_.program;
  if (indices.empty() && value.kind == Value::Kind::frame) {
    frame = *value.frame;
    frame.shift = scale() * frame.shift;
  } else if (indices.size() == 2 && value.is_number()) {
    const std::string& part = indices[1].text;
    const double number = value.number * (part == "TR" ? scale() : 1);
    if (!set_frame_part(frame, axis_named(indices[0].text), part, number)) return false;
  } else {
    return false;
  }
  FrameChain frames(control_);
  frames.save();
  frames_.program = frame;
  if (indices.empty()) frames_.fine = Vec3{};
  frames.rebuild();
  return true;
}

namespace {

// Whether the frame only shifts and turns about Z. Gives the angle in degrees.
bool turned_about_z(const Frame& frame, double& angle) {
  const Vec3 x = turn(frame, {1, 0, 0});
  angle = degrees(atan2(x.y, x.x));
  const double whole = std::round(angle * 1e9) / 1e9;  // the angle as it was written
  angle = whole;
  const Frame same = rotation_frame(2, angle);
  for (int i = 0; i < 3; ++i) {
    Vec3 axis;
    component(axis, i) = 1;
    if (distance(turn(frame, axis), turn(same, axis)) > kTurnRounding) return false;
  }
  return true;
}

}  // namespace

// Changes shift and angle as = CTRANS(...):CROT(Z,...), [X,TR] = 5 or [Z,RT] = 30 of a settable
// frame say.
bool SinumerikVariables::take_settable(std::span<const Value> part, const Value& value, Vec3& shift,
                                       double& angle) const {
  if (part.empty()) {
    if (value.kind != Value::Kind::frame || !turned_about_z(*value.frame, angle)) return false;
    shift = data_scale() * value.frame->shift;
    return true;
  }
  const int axis = axis_named(part[0].text);
  if (part.size() != 2 || !value.is_number() || axis < 0) return false;
  if (part[1].text == "TR") {
    component(shift, axis) = value.number * data_scale();
    return true;
  }
  if (part[1].text != "RT" || (axis != 2 && value.number != 0)) return false;
  if (axis == 2) angle = value.number;
  return true;
}

// Carries out $P_UIFR[1] = CTRANS(...) and $P_UIFR[1,X,TR] = 5.
bool SinumerikVariables::write_work_frame(std::span<const Value> indices, const Value& value) {
  if (indices.empty() || !indices[0].is_number() || indices[0].number < 1 ||
      indices[0].number >= 100)
    return false;
  const double n = indices[0].number;
  const std::string wanted = fmt::format("G{:g}", n < 5 ? 53 + n : 500 + n);
  Vec3 shift = work_shift(wanted);
  double angle = work_turn(wanted);
  if (!take_settable(indices.subspan(1), value, shift, angle)) return false;
  control_.work_turns[wanted] = angle;
  set_work(wanted, shift);
  return true;
}

// What the settable frame in force counts from, as the others do: the machine's zero.
Vec3 SinumerikVariables::active_zero() const {
  return control_.machine_shift + (frames_.work_name.empty() ? Vec3{} : work_shift("EXT"));
}

// Carries out $P_IFRAME = $P_UIFR[2] and its kin: the settable frame in force has these values
// until one is chosen again.
bool SinumerikVariables::write_active_work(std::span<const Value> indices, const Value& value) {
  Vec3 shift = frames_.work - active_zero();
  double angle = frames_.work_turn;
  if (!take_settable(indices, value, shift, angle)) return false;
  FrameChain frames(control_);
  frames.save();
  frames_.work = shift + active_zero();
  frames_.work_turn = angle;
  frames_.work_given = true;
  frames.rebuild();
  return true;
}

bool SinumerikVariables::write(std::string_view name, std::span<const Value> indices,
                               const Value& value, std::string& why) {
  const std::string key = upper_case(name);
  if (key == "$P_PFRAME" && write_program_frame(indices, value)) return true;
  if (key == "$P_UIFR" && write_work_frame(indices, value)) return true;
  if (key == "$P_IFRAME" && write_active_work(indices, value)) return true;
  if (write_tool(key, indices, value)) return true;
  if (key == "$AC_TIMER") return true;
  if (const std::string kept = kept_name(key, indices); !kept.empty() && value.is_number()) {
    control_.kept_values[kept] = value.number;
    return true;
  }
  why = fmt::format("the system variable {} cannot be set here{}", to_utf8(name.substr(0, 60)),
                    key == "$P_UIFR" || key == "$P_IFRAME"
                        ? " (a settable frame shifts, and turns about Z)"
                        : "");
  return false;
}

// The settable frame in force: G500 is 0, G54 to G57 are 1 to 4, G505 to G599 are 5 to 99.
double SinumerikVariables::settable_frame() const {
  const double number = work_number();
  return number >= 505 ? number - 500 : number >= 54 && number <= 57 ? number - 53 : 0;
}

// $P_GG[n] says which code of group n is in force, counted from 1, as G[n] = m chooses it.
bool SinumerikVariables::modal_code(std::span<const Value> indices, double& out) const {
  if (indices.size() != 1 || !indices[0].is_number()) return false;
  const double group = indices[0].number;
  if (group == 1 && (modal_.motion == Code::line || motion_number(modal_.motion) != 1))
    out = motion_number(modal_.motion) + 1;  // G0 to G3
  else if (group == 6)
    out = modal_.plane + 1;
  else if (group == 7)
    out = comp_number(modal_.comp) - 39;
  else if (group == 8)
    out = settable_frame() + 1;
  else if (group == 14)
    out = modal_.incremental ? 2 : 1;
  else if (group == 18)
    out = modal_.corner == Code::corner_arc ? 1 : 2;
  else if (group == 29)
    out = modal_.diameter == Code::diameter_off ? 1 : modal_.diameter == Code::diameter_on ? 2 : 3;
  else
    return false;
  return out <= 99 && (group != 1 || out <= 4);
}

bool SinumerikVariables::read(std::string_view name, std::span<const Value> indices, Value& out,
                              std::string& why) const {
  const std::string key = upper_case(name);
  double value = 0;
  bool known = false;
  if (key[0] != '$') {
    out = Value::of_text(key);
    return true;
  } else if (frame_value(key, indices, out)) {
    return true;
  } else if (key == "$PI") {
    value = 3.14159265358979323846;
    known = true;
  } else if (key == "$P_GG") {
    known = modal_code(indices, value);
  } else if (key == "$P_UIFRNUM") {
    value = settable_frame();
    known = true;
  } else if (key == "$P_F" || key == "$P_S") {
    value = key == "$P_F" ? modal_.feed / feed_scale() : modal_.speed;
    known = true;
  } else if (key == "$P_SEARCH" || key == "$P_ISTEST" || key == "$P_SIM" || key == "$P_DRYRUN") {
    known = true;
  } else if (indices.size() == 1 && axis_named(indices[0].text) >= 0) {
    known = axis_value_of(key, axis_named(indices[0].text), value);
  } else {
    known = tool_value(key, indices, value) || kept_value(key, indices, value);
  }
  out = Value::of(value);
  if (!known)
    why = fmt::format("the system variable {} is not answered here: write its value in its place",
                      key.substr(0, 60));
  return known;
}

}  // namespace mrsim
