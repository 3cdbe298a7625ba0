/// mrsim: what a control does beside its motions. Standard library types only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mrsim {

enum class EventKind : std::uint8_t { dwell, spindle, tool_change, coolant, stop, path_mode };
enum class SpindleTurn : std::uint8_t { off, clockwise, counter_clockwise };
enum class Coolant : std::uint8_t { off, mist, flood, through };
enum class StopKind : std::uint8_t {
  program,   ///< M0: until the operator goes on
  optional,  ///< M1: a stop where the operator has switched it on
  end,       ///< M2 M30
};
enum class PathMode : std::uint8_t {
  continuous,  ///< corners are rounded
  exact_path,  ///< the path is kept: it stops at corners, and runs on where there are none
  exact_stop,  ///< each motion stops at its end
  exact_once,  ///< the motion before the event stops at its end
};

/// One step of the control between two motions. A field whose comment begins with a kind has a
/// meaning in events of that kind alone.
struct Event {
  EventKind kind = EventKind::dwell;
  SpindleTurn turn = SpindleTurn::off;   ///< spindle
  Coolant coolant = Coolant::off;        ///< coolant
  StopKind stop = StopKind::program;     ///< stop
  PathMode path = PathMode::continuous;  ///< path_mode
  bool surface_speed = false;            ///< spindle: `speed` is m/min (G96), else rev/min
  std::size_t before = 0;  ///< index into Program::motions of the one that it comes before
  double seconds = 0;      ///< dwell: above 0
  double speed = 0;        ///< spindle: in force from here on, 0 = none given
  std::string name;        ///< tool_change: id of the tool that comes
  int tool = -1;           ///< index into Program::tools of the one in force, -1 = none yet
  int file = 0;            ///< index into Program::files
  int line = 0;            ///< 1-based
  int call = -1;           ///< index into Program::calls, -1 = in the main program
};

}  // namespace mrsim
