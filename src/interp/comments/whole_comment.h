// What a comment is as a whole: a line of a list, the name of a tool and nothing else.
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Fills corner_line, diameter_line, bare_id, bare_kind, round_insert and bare. Last of all: what
/// the others have taken is explained.
void read_whole_comment(const CommentView& view, ToolFacts& facts);

}  // namespace mrsim
