// Blocks between a turning cycle and the contour that it names: the control goes on behind the
// contour, so that they are never run. Private to src/interp.
#pragma once

#include "interp/language/program_outline.h"

#include <string>
#include <vector>

namespace mrsim {

/// A block that would move, change the tool, call, jump or end the program.
struct ActiveBlock {
  int line = 0;
  std::string text;  ///< UTF-8, shortened
};

/// The active blocks between two places of a file, in the first 1000 lines.
std::vector<ActiveBlock> active_blocks(const std::string& file, const Place& from, const Place& to);

/// "lines 9 to 11 (G70 P10 Q20; G0 X100.; M30)" for at least one block.
std::string lines_text(const std::vector<ActiveBlock>& blocks);

}  // namespace mrsim
