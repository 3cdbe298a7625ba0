// Which tool a comment names by its number.
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Whether the word is "TOOL", "WERKZEUG" or the like: a number behind it is the tool's.
bool is_word_for_tool(const CommentView& view, std::size_t i);

/// Fills id, id_digits, several_ids and names_tool; kinds and insert are there.
void read_tool_id(CommentView& view, ToolFacts& facts);

}  // namespace mrsim
