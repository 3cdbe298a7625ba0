// The side of the work that lathe words name: "ID GROOVE", "OD TURN", "BORE".
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Sets inside, bores, turned_side, face_groove and full_radius; takes no tokens.
void read_side_words(const CommentView& view, ToolFacts& facts);

}  // namespace mrsim
