// How fast one motion may be, without regard to its neighbours.
#pragma once

#include <mrsim/cycle_time.h>
#include <mrsim/types.h>

namespace mrsim {

struct MotionSpeed {
  double length = 0;        ///< mm along the path
  double acceleration = 0;  ///< mm/s^2 along the path
  double speed = 0;         ///< mm/s, the mean where it changes along the path; 0 = no feed known
  Vec3 begin, end;          ///< unit tangents
};

/// Speed of a motion that the machine could begin and end at full speed.
MotionSpeed motion_speed(const Motion& motion, const MachineData& machine);

/// The spindle's speed at `radius` mm from the axis, rev/min.
double spindle_speed(const Motion& motion, double radius, const MachineData& machine);

}  // namespace mrsim
