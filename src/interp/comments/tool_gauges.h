// Sizes that comments name by a number: "#7 DRILL", "LETTER Q", "WOODRUFF #404", "CENTER DRILL #3".
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Fills gauge, gauge_name, pilot, disputed_gauge, and the sizes of a keyseat cutter; the kinds are
/// there.
void read_gauges(CommentView& view, ToolFacts& facts);

}  // namespace mrsim
