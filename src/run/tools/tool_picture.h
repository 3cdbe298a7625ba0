// What a tool looks like from the side, for pictures and for the page that plays a run.
#pragma once

#include <mrsim/play.h>

#include <vector>

namespace mrsim {

/// The cutter, then the pieces of shank and holder, or the insert. A cutter without a length is
/// drawn three times as high as it is wide. Throws Error "tool-invalid".
std::vector<ToolOutline> tool_outlines(const Tool& tool);

}  // namespace mrsim
