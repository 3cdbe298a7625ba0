// The side of the work that lathe words name: "ID GROOVE", "OD TURN", "BORE".
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

#include <cstddef>

namespace mrsim {

/// Sets inside, bores, turned_side, face_groove and full_radius; takes no tokens.
void read_side_words(const CommentView& view, ToolFacts& facts);

/// What else a comment about a lathe's tool says: blade_point, orientation, flat_thread, whitworth
/// and back_turn. Behind the kinds, inserts and blades; takes no tokens.
void read_turning_words(const CommentView& view, ToolFacts& facts);

/// Whether the word at `i` says that the tool is a left-hand one.
bool is_left_hand(const CommentView& view, std::size_t i);

}  // namespace mrsim
