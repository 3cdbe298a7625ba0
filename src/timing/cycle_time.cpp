// Look-ahead as controls do it: the speed at which each motion may begin is limited by its corner,
// by what is left to brake in, and by what there was to speed up in.
#include "core/numbers/vec.h"
#include "timing/motion_speed.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mrsim {
namespace {

constexpr double kStraight = 1.25e-7;  // 1 - cosine of half a turn of a milliradian

// The speed at a corner between two directions: that of an arc which touches both and cuts the
// corner off by `tolerance` mm.
double corner_speed(const MotionSpeed& before, const MotionSpeed& after, double tolerance) {
  const double cosine = std::clamp(dot(before.end, after.begin), -1.0, 1.0);
  const double slowest = std::min(before.speed, after.speed);
  const double half = std::sqrt(0.5 * (1 + cosine));  // cosine of half the turn
  if (half >= 1 - kStraight) return slowest;
  const double radius = tolerance * half / (1 - half);
  return std::min(slowest, std::sqrt(std::min(before.acceleration, after.acceleration) * radius));
}

// Seconds over `length` mm from speed v0 to v1, at most v, with acceleration a.
double trapezoid(double length, double v0, double v1, double v, double a) {
  const double top = std::min(v, std::sqrt(a * length + 0.5 * (v0 * v0 + v1 * v1)));
  const double ramps = (2 * top * top - v0 * v0 - v1 * v1) / (2 * a);
  return (2 * top - v0 - v1) / a + std::max(0.0, length - ramps) / top;
}

// Rapids stop where cuts begin, and everything stops at a tool change.
bool stops_between(const Motion& before, const Motion& after) {
  return before.tool != after.tool ||
         (before.kind == MotionKind::rapid) != (after.kind == MotionKind::rapid);
}

// Tells from the events whether the tool stops between two motions. To be asked in the order of
// the motions.
class EventStops {
 public:
  enum class Corner : std::uint8_t { rounded, exact, stop };
  explicit EventStops(const std::vector<Event>& events) : events_(events) {}

  // How the tool passes the corner at which motion i begins. The mode in which the motion before it
  // ran decides, not one that an event between both sets.
  Corner before(std::size_t i) {
    while (next_ < events_.size() && events_[next_].before < i) take(events_[next_++]);
    bool stops = mode_ == PathMode::exact_stop;
    const Corner corner = mode_ == PathMode::exact_path ? Corner::exact : Corner::rounded;
    while (next_ < events_.size() && events_[next_].before == i)
      if (take(events_[next_++])) stops = true;
    return stops ? Corner::stop : corner;
  }

 private:
  // Carries out the event. True: the tool stops at it.
  bool take(const Event& event) {
    switch (event.kind) {
      case EventKind::path_mode:
        if (event.path == PathMode::exact_once) return true;
        mode_ = event.path;
        return false;
      case EventKind::spindle:
        return std::exchange(turn_, event.turn) != event.turn;
      case EventKind::coolant:
        return false;
      default:
        return true;
    }
  }

  const std::vector<Event>& events_;
  std::size_t next_ = 0;
  PathMode mode_ = PathMode::continuous;
  SpindleTurn turn_ = SpindleTurn::off;
};

// begin[i]: the speed at which motion i begins; one more for the end of the last.
std::vector<double> begin_speeds(const Program& program, const std::vector<MotionSpeed>& speeds,
                                 double tolerance) {
  const std::vector<Motion>& motions = program.motions;
  const std::size_t n = motions.size();
  std::vector<double> begin(n + 1, 0.0);
  EventStops stops(program.events);
  for (std::size_t i = 1; i < n; ++i) {
    const EventStops::Corner corner = stops.before(i);
    if (speeds[i - 1].speed > 0 && speeds[i].speed > 0 && corner != EventStops::Corner::stop &&
        !stops_between(motions[i - 1], motions[i]))
      begin[i] = corner_speed(speeds[i - 1], speeds[i],
                              corner == EventStops::Corner::exact ? 0 : tolerance);
  }
  const auto reachable = [&](double from, std::size_t i) {
    return std::sqrt(from * from + 2 * speeds[i].acceleration * speeds[i].length);
  };
  for (std::size_t i = n; i-- > 0;)
    if (begin[i] > 0) begin[i] = std::min(begin[i], reachable(begin[i + 1], i));
  for (std::size_t i = 0; i < n; ++i)
    if (begin[i + 1] > 0) begin[i + 1] = std::min(begin[i + 1], reachable(begin[i], i));
  return begin;
}

class Sums {
 public:
  explicit Sums(CycleTime& time) : time_(time) {}
  void add(const Motion& m, double seconds) {
    const bool rapid = m.kind == MotionKind::rapid;
    (rapid ? time_.rapid : time_.cutting) += seconds;
    ToolTime& tool = of(m.tool);
    (rapid ? tool.rapid : tool.cutting) += seconds;
  }
  void add_dwell(double seconds, int tool) {
    time_.dwell += seconds;
    of(tool).dwell += seconds;
  }

 private:
  ToolTime& of(int tool) {
    if (last_ < time_.tools.size() && time_.tools[last_].tool == tool) return time_.tools[last_];
    for (last_ = 0; last_ < time_.tools.size(); ++last_)
      if (time_.tools[last_].tool == tool) return time_.tools[last_];
    return time_.tools.emplace_back(ToolTime{tool, 0, 0, 0});
  }
  CycleTime& time_;
  std::size_t last_ = 0;
};

// A dwell between a tool change and the first cut is that of the tool that cuts next.
void add_dwells(const Program& program, Sums& sums) {
  int next = -1;
  std::size_t left = program.events.size();
  for (std::size_t i = program.motions.size() + 1; i-- > 0;) {
    for (; left > 0 && program.events[left - 1].before >= i; --left) {
      const Event& event = program.events[left - 1];
      if (event.kind == EventKind::dwell)
        sums.add_dwell(event.seconds, event.tool >= 0 ? event.tool : next);
    }
    if (i > 0 && program.motions[i - 1].tool >= 0) next = program.motions[i - 1].tool;
  }
}

double turning(SpindleTurn turn) {
  return turn == SpindleTurn::off ? 0 : turn == SpindleTurn::clockwise ? 1 : -1;
}

// The spindle starts after each tool change and after each stop, and runs at another speed or in
// another direction where the program says so. Without a word about it, it turns. Constant surface
// speed changes it while the tool moves, which takes no time of its own.
void add_changes(const Program& program, const MachineData& machine, CycleTime& time) {
  int tool = -1;
  double speed = 0, direction = 1;
  bool follows = false;  // the speed follows the radius
  auto event = program.events.begin();
  for (std::size_t i = 0; i < program.motions.size(); ++i) {
    const Motion& m = program.motions[i];
    for (; event != program.events.end() && event->before <= i; ++event) {
      if (event->kind != EventKind::spindle) continue;
      direction = turning(event->turn);
      if (direction == 0) speed = 0;
    }
    if (m.tool != tool && m.tool >= 0) {
      if (tool >= 0) ++time.tool_changes, speed = 0;
      tool = m.tool;
    }
    if (m.kind == MotionKind::rapid || !(m.speed > 0)) continue;
    const double wanted = direction * spindle_speed(m, m.start.x, machine);
    if (!follows || !m.constant_surface_speed || !(wanted * speed > 0))
      time.spindle += std::fabs(wanted - speed) / machine.spindle_acceleration;
    follows = m.constant_surface_speed;
    speed = direction * spindle_speed(m, m.end.x, machine);
  }
  for (const Event& stop : program.events)
    if (stop.kind == EventKind::stop) {
      time.stops += stop.stop == StopKind::program;
      time.optional_stops += stop.stop == StopKind::optional;
    }
  time.tool_change = static_cast<double>(time.tool_changes) * machine.tool_change;
}

}  // namespace

CycleTime cycle_time(const Program& program, const MachineData& machine) {
  const std::vector<Motion>& motions = program.motions;
  CycleTime time;
  std::vector<MotionSpeed> speeds(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (!motions[i].assumed_start) speeds[i] = motion_speed(motions[i], machine);
  const std::vector<double> begin = begin_speeds(program, speeds, machine.corner_tolerance);
  time.seconds.resize(motions.size());
  Sums sums(time);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const MotionSpeed& s = speeds[i];
    if (s.speed > 0)
      time.seconds[i] = trapezoid(s.length, begin[i], begin[i + 1], s.speed, s.acceleration);
    else if (s.length > 0)
      ++time.without_feed;
    sums.add(motions[i], time.seconds[i]);
  }
  add_dwells(program, sums);
  add_changes(program, machine, time);
  time.total = time.cutting + time.rapid + time.dwell + time.tool_change + time.spindle;
  return time;
}

}  // namespace mrsim
