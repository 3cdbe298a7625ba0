#include "interp/statements/state_values.h"

#include "core/text/text_io.h"
#include "interp/frames/frame_words.h"
#include "interp/tools/tool_changer.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace mrsim {

std::string work_name(int n) {
  return n <= 6 ? fmt::format("G{}", 53 + n) : fmt::format("G59.{}", n - 6);
}

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

double StateValues::work_position(int axis) const {
  return shown(axis, component(position_.programmed, axis));
}

double StateValues::machine_position(int axis) const {
  return shown(axis, component(position_.physical - control_.machine_shift, axis));
}

// The number of the work offset in force, 54 for "G54"; 0 if there is none.
double StateValues::work_number() const {
  const std::string& name = frames_.work_name;
  return name.size() > 1 ? parse_number(std::string_view(name).substr(1)).value_or(0) : 0;
}

// Axes are counted X Y Z; on FANUC's lathes X Z, and the third is also Z, for lathes that count a Y
// between them (Haas).
int StateValues::axis_numbered(int number) const {
  if (number < 0 || number > 2) return -1;
  return number > 0 && lathe() && is(Dialect::fanuc) ? 2 : number;
}

// A value of X is a diameter where words of X are.
double StateValues::shown(int axis, double mm) const {
  return (axis == 0 && modal_.diameter == Code::diameter_on ? 2 * mm : mm) / scale();
}

Vec3 StateValues::work_shift(const std::string& name) const {
  for (const WorkOffset& work : control_.work)
    if (work.name == name) return name == "EXT" ? work.shift : work.shift - control_.machine_shift;
  return {};
}

void StateValues::set_work(const std::string& name, const Vec3& shift) {
  auto at = std::find_if(control_.work.begin(), control_.work.end(),
                         [&](const WorkOffset& work) { return work.name == name; });
  if (at == control_.work.end()) at = control_.work.insert(at, WorkOffset{name, {}});
  at->shift = name == "EXT" ? shift : shift + control_.machine_shift;
  if (is(Dialect::ngc) || is(Dialect::sinumerik))
    return;  // the new values hold from the next word of the offset on
  FrameWords(control_).renew_work();
}

double StateValues::tool_radius() const {
  return tools_ ? tools_->radius(is(Dialect::sinumerik) ? modal_.edge : -1) : 0;
}

// The places to which G28 and G30 lead, in machine coordinates.
bool StateValues::stored_place(int which, int axis, double& out) const {
  const std::optional<Vec3>& second = options_.places.second;
  std::optional<Vec3> place;
  if (control_.stored_places[which])
    place = *control_.stored_places[which] - control_.machine_shift;
  else if (control_.machine_known)
    place = which == 0 ? std::optional<Vec3>(options_.places.reference) : second;
  if (place) out = component(*place, axis) / scale();
  return place.has_value();
}

double StateValues::work_turn(const std::string& name) const {
  const auto turn = control_.work_turns.find(name);
  return turn == control_.work_turns.end() ? 0 : turn->second;
}

}  // namespace mrsim
