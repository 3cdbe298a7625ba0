// What a comment is as a whole: a line of a list, the name of a tool and nothing else.
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// "TOOL", "WERKZEUG" ...: a number behind it is the tool's.
bool is_word_for_tool(const CommentView& view, std::size_t i);

/// Fills corner_line, diameter_line, bare_id, bare_kind, round_insert and bare. Last of all: what
/// the others have taken is explained.
void read_whole_comment(const CommentView& view, ToolFacts& facts);

}  // namespace mrsim
