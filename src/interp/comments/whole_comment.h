// Tells what a comment is as a whole: one line of several about a tool, or a tool's name alone.
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Fills corner_line, diameter_line, bare_id, bare_kind, round_insert and bare. Requires: the other
/// readers have taken the tokens that they explain.
void read_whole_comment(const CommentView& view, ToolFacts& facts);

}  // namespace mrsim
