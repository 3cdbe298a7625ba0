#include "timing/motion_speed.h"

#include "core/trig.h"
#include "core/units.h"
#include "core/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr double kSecondsPerMinute = 60;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The largest value along `direction` that keeps each axis within its limit.
double along(const Vec3& direction, const Vec3& limits) {
  double most = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double share = std::fabs(component(direction, axis));
    if (share > 0) most = std::min(most, component(limits, axis) / share);
  }
  return most;
}

double arc_length(const Motion& m) {
  const double turned = std::fabs(m.sweep) * m.radius;
  return std::sqrt(turned * turned + m.rise * m.rise);
}

// Unit tangent of an arc `angle` radians after its start.
Vec3 arc_tangent(const Motion& m, double angle) {
  const Vec3 radial = normalized(m.start - m.center), side = cross(m.axis, radial);
  const SinCos turn = sincos(angle);
  const double direction = m.sweep < 0 ? -1 : 1;
  const Vec3 round = direction * (turn.cos * side - turn.sin * radial);
  const double length = arc_length(m);
  if (!(length > 0)) return round;
  return normalized((std::fabs(m.sweep) * m.radius / length) * round + (m.rise / length) * m.axis);
}

// Every axis takes part in an arc sooner or later, so the weakest one limits it.
double arc_acceleration(const Vec3& limits) { return std::min({limits.x, limits.y, limits.z}); }

// Seconds of a move of `length` mm between two radii under constant surface speed at a feed of
// `per_turn` mm: dt = 60 ds / (per_turn n(r)), with n = 1000 S / (2 pi r), but not above the limit.
double surface_speed_seconds(const Motion& m, double length, double per_turn,
                             const MachineData& machine) {
  const double r0 = std::fabs(m.start.x), r1 = std::fabs(m.end.x);
  const double low = std::min(r0, r1), high = std::max(r0, r1);
  const double limit = machine.max_spindle;
  const double capped_at = 1000 * m.speed / (2 * kPi * limit);  // radius below which n = limit
  const double per_mm = kSecondsPerMinute / per_turn;           // times 1 / n
  const double split = std::clamp(capped_at, low, high);
  const double share = high > low ? (split - low) / (high - low) : (capped_at > low ? 1.0 : 0.0);
  const double capped = share * length / limit;
  const double free = (1 - share) * length * (2 * kPi / (1000 * m.speed)) * 0.5 * (split + high);
  return per_mm * (capped + free);
}

// Of the axis that travels farthest, mm: a thread's lead is measured along it.
double longest_travel(const Motion& m) {
  const Vec3 d = m.end - m.start;
  return std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
}

// mm of path in one revolution of the spindle; 0 where the feed does not depend on it.
double feed_per_turn(const Motion& m, double length) {
  const double travel = longest_travel(m);
  if (m.lead != 0) return travel > 0 ? std::fabs(m.lead) * length / travel : 0;
  return m.feed_unit == FeedUnit::mm_per_rev ? m.feed : 0;
}

// mm/s, 0 where no feed is known.
double feed_speed(const Motion& m, double length, const MachineData& machine) {
  const double per_turn = feed_per_turn(m, length);
  if (per_turn > 0 && m.speed > 0 && m.constant_surface_speed)
    return length / surface_speed_seconds(m, length, per_turn, machine);
  if (per_turn > 0) return per_turn * std::min(m.speed, machine.max_spindle) / kSecondsPerMinute;
  if (m.lead != 0 || !(m.feed > 0)) return 0;
  if (m.feed_unit == FeedUnit::mm_per_min) return m.feed / kSecondsPerMinute;
  return m.feed_unit == FeedUnit::inverse_time ? length * m.feed / kSecondsPerMinute : 0;
}

}  // namespace

double spindle_speed(const Motion& m, double radius, const MachineData& machine) {
  if (!m.constant_surface_speed) return std::min(m.speed, machine.max_spindle);
  const double turn = 2 * kPi * std::fabs(radius);
  return turn > 0 ? std::min(1000 * m.speed / turn, machine.max_spindle) : machine.max_spindle;
}

MotionSpeed motion_speed(const Motion& m, const MachineData& machine) {
  MotionSpeed s;
  if (m.kind == MotionKind::arc) {
    s.length = arc_length(m);
    s.begin = arc_tangent(m, 0), s.end = arc_tangent(m, m.sweep);
    s.acceleration = arc_acceleration(machine.acceleration);
  } else {
    s.length = distance(m.start, m.end);
    s.begin = s.end = normalized(m.end - m.start);
    s.acceleration = along(s.begin, machine.acceleration);
  }
  if (!(s.length > 0)) return s;
  const Vec3 fastest = (1 / kSecondsPerMinute) * machine.rapid;
  if (m.kind == MotionKind::rapid) {
    s.speed = along(s.begin, fastest);
    return s;
  }
  s.speed = std::min(feed_speed(m, s.length, machine), std::min({fastest.x, fastest.y, fastest.z}));
  // On an arc the acceleration towards the centre is speed^2 / radius.
  if (m.kind == MotionKind::arc) s.speed = std::min(s.speed, std::sqrt(s.acceleration * m.radius));
  return s;
}

}  // namespace mrsim
