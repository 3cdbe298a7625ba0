// The M words of the controls: number -> meaning. Private to src/interp.
#pragma once

#include "interp/text/codes.h"
#include <mrsim/types.h>

#include <string_view>

namespace mrsim {

enum class MCode : std::uint8_t {
  unknown,
  no_effect,  ///< gears, chucks, chip conveyors: no event
  flow,       ///< calls and returns
  stop,
  optional_stop,
  end,
  clockwise,
  counter_clockwise,
  spindle_off,  ///< M5; M19, which holds the spindle at an angle
  clockwise_flood,
  counter_clockwise_flood,
  tool_change,
  mist,
  flood,
  through,
  coolant_off,
};

/// The meaning of "M<number>".
MCode find_m_code(Dialect dialect, MachineKind machine, int number);

/// What the word does, in a few words; empty where there is no event.
std::string_view m_code_text(MCode code);

}  // namespace mrsim
