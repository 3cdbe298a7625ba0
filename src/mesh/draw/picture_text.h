// A font of straight strokes on a grid 4 wide and 6 high (descenders reach -2), drawn with the same
// anti-aliased lines as the edges of the part, so that it is sharp at any size.
#pragma once

#include "mesh/draw/picture.h"

#include <string_view>

namespace mrsim {

/// Letters of strokes, `height` pixels from base line to capitals' top; `at` is the left end of the
/// base line. Printable ASCII; other characters show as a box. Returns the width.
double draw_text(Picture& picture, Vec2 at, double height, std::string_view text,
                 const Color& color);
/// What draw_text() returns.
double text_width(std::string_view text, double height);

}  // namespace mrsim
