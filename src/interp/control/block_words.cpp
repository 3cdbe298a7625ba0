#include "interp/control/block_words.h"

namespace mrsim {

void BlockWords::begin() {
  ++epoch_;
  groups = 0;
  motion_code = oneshot = frame_code = ends_cycle = call_word = m98 = home = set_tool = comp_word =
      pause = nullptr;
  motion = Code::unknown;
  turn_cycle = 0;
  suppress_frames = comp_selected = comp_moved = length_changed = false;
  tool_change = stop_after = return_after = loops = home_guessed = false;
}

void BlockWords::forget_words() {
  words.clear();
  ++epoch_;
}

}  // namespace mrsim
