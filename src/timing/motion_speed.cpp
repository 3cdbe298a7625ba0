#include "timing/motion_speed.h"

#include "core/numbers/motions.h"
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kSecondsPerMinute = 60;

// The largest value along `direction` that keeps each axis within its limit.
double along(const Vec3& direction, const Vec3& limits) {
  double most = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double share = std::fabs(component(direction, axis));
    if (share > 0) most = std::min(most, component(limits, axis) / share);
  }
  return most;
}

// Unit tangent of an arc `angle` radians after its start.
Vec3 arc_tangent(const Motion& m, double angle) {
  const Vec3 radial = normalized(m.start - m.center), side = cross(m.axis, radial);
  const SinCos turn = sincos(angle);
  const double direction = m.sweep < 0 ? -1 : 1;
  const Vec3 round = direction * (turn.cos * side - turn.sin * radial);
  const double length = length_of(m);
  if (!(length > 0)) return round;
  return normalized((std::fabs(m.sweep) * m.radius / length) * round + (m.rise / length) * m.axis);
}

// Somewhere on its way an arc runs along each axis that it moves, so the axis with the lowest limit
// bounds the whole arc.
double along_arc(const Motion& m, const Vec3& limits) {
  constexpr double kAlongAxis = 1 - 1e-12;  // cosine: the arc lies in a plane across this axis
  double most = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const bool stands = m.rise == 0 && std::fabs(component(m.axis, axis)) > kAlongAxis;
    if (!stands) most = std::min(most, component(limits, axis));
  }
  return most;
}

// rev/min that the machine and the program allow.
double fastest_spindle(const Motion& m, const MachineData& machine) {
  return m.speed_limit > 0 ? std::min(m.speed_limit, machine.max_spindle) : machine.max_spindle;
}

// Minutes that a mm of travel at one mm a turn takes on the way between two radii of one sign:
// the mean of 1 / n, with n = 1000 S / (2 pi r), but not above the limit.
double mean_turn(double r0, double r1, double speed, double limit) {
  const double low = std::min(r0, r1), high = std::max(r0, r1);
  const double capped_at = 1000 * speed / (2 * kPi * limit);  // radius below which n = limit
  const double split = std::clamp(capped_at, low, high);
  const double share = high > low ? (split - low) / (high - low) : (capped_at > low ? 1.0 : 0.0);
  return share / limit + (1 - share) * (2 * kPi / (1000 * speed)) * 0.5 * (split + high);
}

// The same between two places across the axis: a facing cut may go on beyond it, where the radius
// grows again.
double mean_turn_across(double x0, double x1, double speed, double limit) {
  const double r0 = std::fabs(x0), r1 = std::fabs(x1);
  if (!(x0 * x1 < 0)) return mean_turn(r0, r1, speed, limit);
  return (r0 * mean_turn(r0, 0, speed, limit) + r1 * mean_turn(0, r1, speed, limit)) / (r0 + r1);
}

// The same along an arc, by chords of a third of a degree or less: 3e-6 of its radius.
double mean_turn_of_arc(const Motion& m, double limit) {
  constexpr double kChord = 2 * kPi / 1080;
  const Vec3 radial = m.start - m.center, side = cross(m.axis, radial);
  const int chords = std::max(1, static_cast<int>(std::ceil(std::fabs(m.sweep) / kChord)));
  double sum = 0, x0 = m.start.x;
  for (int k = 1; k <= chords; ++k) {
    const double share = double(k) / chords;
    const SinCos turn = sincos(share * m.sweep);
    const double x =
        m.center.x + turn.cos * radial.x + turn.sin * side.x + share * m.rise * m.axis.x;
    sum += mean_turn_across(x0, x, m.speed, limit);
    x0 = x;
  }
  return sum / chords;
}

// Seconds of a move of `length` mm under constant surface speed at a feed of `per_turn` mm: dt = 60
// ds / (per_turn n(r)).
double surface_speed_seconds(const Motion& m, double length, double per_turn,
                             const MachineData& machine) {
  const double limit = fastest_spindle(m, machine);
  const double turn = m.kind == MotionKind::arc
                          ? mean_turn_of_arc(m, limit)
                          : mean_turn_across(m.start.x, m.end.x, m.speed, limit);
  return kSecondsPerMinute / per_turn * length * turn;
}

// The travel of the axis that travels farthest, mm: a thread's lead is measured along that axis.
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
  if (per_turn > 0)
    return per_turn * std::min(m.speed, fastest_spindle(m, machine)) / kSecondsPerMinute;
  if (m.lead != 0 || !(m.feed > 0)) return 0;
  if (m.feed_unit == FeedUnit::mm_per_min) return m.feed / kSecondsPerMinute;
  return m.feed_unit == FeedUnit::inverse_time ? length * m.feed / kSecondsPerMinute : 0;
}

}  // namespace

double spindle_speed(const Motion& m, double radius, const MachineData& machine) {
  const double limit = fastest_spindle(m, machine);
  if (!m.constant_surface_speed) return std::min(m.speed, limit);
  const double turn = 2 * kPi * std::fabs(radius);
  return turn > 0 ? std::min(1000 * m.speed / turn, limit) : limit;
}

MotionSpeed motion_speed(const Motion& m, const MachineData& machine) {
  MotionSpeed s;
  if (m.kind == MotionKind::arc) {
    s.length = length_of(m);
    s.begin = arc_tangent(m, 0), s.end = arc_tangent(m, m.sweep);
    s.acceleration = along_arc(m, machine.acceleration);
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
  s.speed = feed_speed(m, s.length, machine);
  if (m.kind != MotionKind::arc) {
    s.speed = std::min(s.speed, along(s.begin, fastest));
    return s;
  }
  // On an arc the acceleration towards the centre is speed^2 / radius.
  s.speed = std::min({s.speed, along_arc(m, fastest), std::sqrt(s.acceleration * m.radius)});
  return s;
}

}  // namespace mrsim
