// The numbers that words of a comment name: "DIA. - 10.", "CR=2", "LOC 1.0", "4 FLUTE".
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Takes the tokens it explains, but not those of the kind or the insert, which are taken before.
void read_tool_labels(CommentView& view, ToolFacts& facts);

}  // namespace mrsim
