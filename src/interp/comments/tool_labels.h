// Reads the numbers that have a name in a comment: "DIA. - 10.", "CR=2", "LOC 1.0", "4 FLUTE".
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Fills in the named sizes and angles, and takes their tokens. Requires: the tokens of the kind
/// and of the insert are taken.
void read_tool_labels(CommentView& view, ToolFacts& facts);

}  // namespace mrsim
