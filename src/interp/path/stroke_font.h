// Text as strokes of a tool that engraves, in a plain font (Hershey's simplex), because the fonts
// of controls are not published. Only ASCII.
#pragma once

#include "core/numbers/vec.h"

#include <string_view>
#include <vector>

namespace mrsim {

inline constexpr int kStrokeFontSize = 95;
/// Glyphs of ASCII 32 to 126: pairs of characters, each less 'R' a coordinate, y downwards; the
/// left and right edge first, " R" lifts the pen. Capitals are 21 high.
extern const std::string_view kStrokeFont[kStrokeFontSize];

struct TextStrokes {
  std::vector<std::vector<Vec2>> strokes;  ///< each in one go
  double width = 0;                        ///< to the beginning of the next letter
};

inline bool font_has(char c) { return c >= ' ' && c <= '~'; }

/// `text` on the line y = 0 from {0, 0}; capitals have the height 1. Other characters than ASCII
/// are left out.
TextStrokes text_strokes(std::string_view text);

/// One letter without the space on its sides: its strokes begin at x = 0. A blank is as wide as it
/// is in a text.
TextStrokes letter_strokes(char c);

}  // namespace mrsim
