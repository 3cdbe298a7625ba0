// Outlines of the form mills that a few sizes describe: dovetails, centre drills and corner
// rounding mills.
#pragma once

#include "interp/comments/tool_comment.h"

#include <string>
#include <vector>

namespace mrsim {

/// A dovetail mill: flat base, flanks that lean inwards by `angle` (radians) from the base. Empty
/// if the flanks meet below `height`. Requires: sizes above 0, angle below a quarter turn.
std::vector<ProfilePoint> dovetail_outline(double diameter, double angle, double height);

/// A centre drill: a pilot of 118 degrees that is `length` long, then a cone of `angle` up to the
/// body. Lengths in mm, diameters of pilot and body, radians.
std::vector<ProfilePoint> centre_drill_outline(double pilot, double body, double length,
                                               double angle);

/// An outline to show in an error: "profile = [[0, 0], [6, 0], [3.69, 4]]", made of what `hint`
/// says in a program whose unit is `unit` mm. The text tells which of the sizes are examples. Empty
/// if the kind of tool has no such outline.
std::string outline_example(const ToolHint& hint, double unit);

}  // namespace mrsim
