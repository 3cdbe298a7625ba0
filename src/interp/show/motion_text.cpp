#include "interp/show/motion_text.h"

#include "core/numbers/units.h"
#include "core/text/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

const char* kind_name(MotionKind kind) {
  return kind == MotionKind::rapid ? "rapid" : kind == MotionKind::line ? "line" : "arc";
}

const char* unit_name(FeedUnit unit) {
  return unit == FeedUnit::mm_per_min   ? "mm/min"
         : unit == FeedUnit::mm_per_rev ? "mm/rev"
                                        : "1/min";
}

const char* severity_name(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

std::string calls_text(const Program& program, int call) {
  std::string out = "[";
  for (int i = call; i >= 0; i = program.calls[static_cast<std::size_t>(i)].outer) {
    const CallSite& site = program.calls[static_cast<std::size_t>(i)];
    out += fmt::format("{}[{},{}]", out.size() > 1 ? "," : "",
                       json_string(program.files[static_cast<std::size_t>(site.file)]), site.line);
  }
  return out + "]";
}

}  // namespace

std::string tool_of(const Program& program, int tool) {
  return tool < 0 ? "" : program.tools[static_cast<std::size_t>(tool)].id;
}

std::string called_json(const Program& program, int file, int call) {
  if (call < 0) return "";
  return fmt::format(",\"file\":{},\"called_from\":{}",
                     json_string(program.files[static_cast<std::size_t>(file)]),
                     calls_text(program, call));
}

std::string called_text(const Program& program, int file, int call) {
  if (call < 0) return "";
  std::string out = "  in " + program.files[static_cast<std::size_t>(file)];
  for (int i = call; i >= 0; i = program.calls[static_cast<std::size_t>(i)].outer)
    out += fmt::format(", called from line {}", program.calls[static_cast<std::size_t>(i)].line);
  return out;
}

std::string number_text(double value) {
  if (!std::isfinite(value)) return "null";
  const double magnitude = std::abs(value);
  int decimals = 9;
  for (double limit = 1000; limit <= magnitude && decimals > 0; limit *= 10) --decimals;
  char buffer[64];
  const auto [end, error] =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
  if (error != std::errc()) return "null";
  std::string text(buffer, end);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string vector_text(const Vec3& v) {
  return fmt::format("[{},{},{}]", number_text(v.x), number_text(v.y), number_text(v.z));
}

std::string motion_json(const Program& program, const Motion& motion) {
  std::string out = fmt::format(
      "{{\"line\":{},\"column\":{},\"kind\":\"{}\",\"start\":{},\"end\":{}", motion.line,
      motion.column, kind_name(motion.kind), vector_text(motion.start), vector_text(motion.end));
  if (motion.kind == MotionKind::arc)
    out += fmt::format(",\"center\":{},\"axis\":{},\"radius\":{},\"sweep\":{},\"rise\":{}",
                       vector_text(motion.center), vector_text(motion.axis),
                       number_text(motion.radius), number_text(degrees(motion.sweep)),
                       number_text(motion.rise));
  if (motion.tool >= 0) out += ",\"tool\":" + json_string(tool_of(program, motion.tool));
  if (motion.kind != MotionKind::rapid)
    out += fmt::format(",\"feed\":{},\"feed_unit\":\"{}\"", number_text(motion.feed),
                       unit_name(motion.feed_unit));
  if (motion.lead != 0) out += ",\"lead\":" + number_text(motion.lead);
  out += fmt::format(",\"{}\":{}", motion.constant_surface_speed ? "surface_speed" : "spindle",
                     number_text(motion.speed));
  if (motion.assumed_start) out += ",\"assumed_start\":true";
  return out + called_json(program, motion.file, motion.call) + "}";
}

std::string diagnostic_json(const Diagnostic& diagnostic) {
  std::string out = fmt::format(
      "{{\"line\":{},\"column\":{},\"kind\":\"{}\",\"code\":{},\"text\":{}", diagnostic.place.line,
      diagnostic.place.column, severity_name(diagnostic.severity), json_string(diagnostic.code),
      json_string(diagnostic.text));
  if (!diagnostic.called_from.empty()) {
    out += ",\"file\":" + json_string(diagnostic.place.file) + ",\"called_from\":[";
    for (std::size_t i = 0; i < diagnostic.called_from.size(); ++i)
      out += fmt::format("{}[{},{}]", i > 0 ? "," : "", json_string(diagnostic.called_from[i].file),
                         diagnostic.called_from[i].line);
    out += "]";
  }
  return out + "}";
}

std::string motion_text(const Program& program, const Motion& motion) {
  const auto point = [](const Vec3& p) {
    return fmt::format("{} {} {}", number_text(p.x), number_text(p.y), number_text(p.z));
  };
  std::string out = fmt::format("{:>5}:{:<3} {:5}  {} -> {}", motion.line, motion.column,
                                kind_name(motion.kind), point(motion.start), point(motion.end));
  if (motion.kind == MotionKind::arc)
    out += fmt::format("  centre {}  radius {}  sweep {} deg", point(motion.center),
                       number_text(motion.radius), number_text(degrees(motion.sweep)));
  if (motion.kind == MotionKind::arc && motion.rise != 0)
    out += "  rise " + number_text(motion.rise);
  if (const std::string tool = tool_of(program, motion.tool); !tool.empty()) out += "  T" + tool;
  if (motion.lead != 0)  // the feed follows from the spindle
    out += fmt::format("  lead {} mm", number_text(motion.lead));
  else if (motion.kind != MotionKind::rapid && motion.feed > 0)
    out += fmt::format("  F {} {}", number_text(motion.feed), unit_name(motion.feed_unit));
  if (motion.assumed_start) out += "  (start assumed)";
  return out + called_text(program, motion.file, motion.call);
}

namespace {

const char* kind_name(EventKind kind) {
  static constexpr const char* kNames[] = {"dwell",   "spindle", "tool_change",
                                           "coolant", "stop",    "path_mode"};
  return kNames[static_cast<int>(kind)];
}

// The name of the state that an event sets, such as cw of a spindle. A dwell and a tool change set
// none.
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
