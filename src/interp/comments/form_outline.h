// Outlines of the form mills that a few sizes describe: dovetails and corner rounding mills.
#pragma once

#include "interp/comments/tool_comment.h"

#include <string>
#include <vector>

namespace mrsim {

/// The diameter, flanks that lean inwards by `angle` (radians) from the base, and the height.
/// Empty: they would meet below it. Requires: sizes above 0, angle below a quarter turn.
std::vector<ProfilePoint> dovetail_outline(double diameter, double angle, double height);

/// For the reader of an error: "profile = [[0, 0], [6, 0], [3.69, 4]]" with what `hint` says in a
/// program whose unit is `unit` mm, and what is only an example in it. Empty: its kind has no such
/// outline.
std::string outline_example(const ToolHint& hint, double unit);

}  // namespace mrsim
