#include "core/text/json_text.h"
#include "interp/show/motion_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

const char* kind_name(EventKind kind) {
  static constexpr const char* kNames[] = {"dwell",   "spindle", "tool_change",
                                           "coolant", "stop",    "path_mode"};
  return kNames[static_cast<int>(kind)];
}

// The state that an event sets, such as cw of a spindle; a dwell and a tool change have none.
const char* state_name(const Event& event) {
  static constexpr const char* kTurns[] = {"off", "cw", "ccw"};
  static constexpr const char* kCoolants[] = {"off", "mist", "flood", "through"};
  static constexpr const char* kStops[] = {"program", "optional", "end"};
  static constexpr const char* kPaths[] = {"continuous", "exact_path", "exact_stop", "exact_once"};
  switch (event.kind) {
    case EventKind::spindle:
      return kTurns[static_cast<int>(event.turn)];
    case EventKind::coolant:
      return kCoolants[static_cast<int>(event.coolant)];
    case EventKind::stop:
      return kStops[static_cast<int>(event.stop)];
    case EventKind::path_mode:
      return kPaths[static_cast<int>(event.path)];
    default:
      return nullptr;
  }
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

bool tells_speed(const Event& event) {
  return event.kind == EventKind::spindle && event.turn != SpindleTurn::off && event.speed > 0;
}

}  // namespace

std::string event_json(const Program& program, const Event& event) {
  std::string out = fmt::format("{{\"line\":{},\"kind\":\"{}\"", event.line, kind_name(event.kind));
  if (const char* state = state_name(event)) out += fmt::format(",\"state\":\"{}\"", state);
  if (event.kind == EventKind::dwell) out += ",\"seconds\":" + number_text(event.seconds);
  if (event.kind == EventKind::tool_change) out += ",\"next_tool\":" + json_string(event.name);
  if (tells_speed(event))
    out += fmt::format(",\"{}\":{}", event.surface_speed ? "surface_speed" : "speed",
                       number_text(event.speed));
  if (event.tool >= 0) out += ",\"tool\":" + json_string(tool_of(program, event.tool));
  return out + called_json(program, event.file, event.call) + "}";
}

std::string event_text(const Program& program, const Event& event) {
  std::string out = fmt::format("{:>5}     ", event.line);
  if (event.kind == EventKind::dwell)
    out += fmt::format("dwell  {} s", number_text(event.seconds));
  else if (event.kind == EventKind::tool_change)
    out += fmt::format("tool change  T{}", event.name);
  else
    out += fmt::format("{}  {}", spaced(kind_name(event.kind)), spaced(state_name(event)));
  if (tells_speed(event))
    out += fmt::format("  S {} {}", number_text(event.speed),
                       event.surface_speed ? "m/min" : "rev/min");
  const std::string tool = tool_of(program, event.tool);
  if (!tool.empty() && event.kind == EventKind::dwell) out += "  T" + tool;
  return out + called_text(program, event.file, event.call);
}

}  // namespace mrsim
