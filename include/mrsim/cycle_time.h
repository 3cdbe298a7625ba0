/// mrsim: how long a program takes on a machine.
///
/// Feeds in all modes (mm/min, mm/rev, inverse time, constant surface speed), rapids by axis,
/// acceleration with look-ahead over corners, exact stops, dwells, tool changes. The path is not
/// changed: a corner is passed at the speed at which the control may round it by
/// MachineData::corner_tolerance. Standard library types only.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace mrsim {

/// What of a machine decides how long a program takes. Every value is above 0, but for those that
/// say otherwise.
struct MachineData {
  Vec3 rapid{15000, 15000, 10000};            ///< mm/min, by axis
  Vec3 acceleration{2000, 2000, 1500};        ///< mm/s^2, by axis
  double tool_change = 6;                     ///< s; may be 0
  double spindle_acceleration = 2000;         ///< rev/min per second
  double max_spindle = 6000;                  ///< rev/min: G96 turns no faster
  double corner_tolerance = 0.01;             ///< mm; 0 = the machine stops at every corner
  MachinePlaces places;                       ///< for the moves in machine coordinates
  MachineKind kind = MachineKind::automatic;  ///< automatic: not said
  std::string origin;                         ///< where the data came from; empty: the values above
};

/// Seconds that one tool works.
struct ToolTime {
  int tool = -1;  ///< index into Program::tools, -1 = before the first tool
  double cutting = 0, rapid = 0, dwell = 0;
};

struct CycleTime {
  double total = 0;        ///< s, all of the following together
  double cutting = 0;      ///< s of lines and arcs
  double rapid = 0;        ///< s of rapids
  double dwell = 0;        ///< s in which the tool stays where it is: G4, holes
  double tool_change = 0;  ///< s
  double spindle = 0;      ///< s in which the spindle runs up or changes its speed
  std::size_t tool_changes = 0;
  std::size_t stops = 0, optional_stops = 0;  ///< M0, M1: the operator's time is not counted
  std::size_t without_feed = 0;  ///< cuts for which no feed is known: counted at no time
  std::vector<ToolTime> tools;   ///< in the order of their first motions
  std::vector<double> seconds;   ///< #motions: of each motion alone
};

/// Moves with an assumed start count as no time. Requires: values of `machine` above 0, as said
/// there. Throws nothing. Cost: one pass over the motions forward and one back.
MRSIM_API CycleTime cycle_time(const Program& program, const MachineData& machine);

}  // namespace mrsim
