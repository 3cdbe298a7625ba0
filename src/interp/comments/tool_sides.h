// The side of the work that lathe words name: "ID GROOVE", "OD TURN", "BORE".
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

#include <cstddef>

namespace mrsim {

/// Sets what a lathe's words tell: inside, bores, turned_side, face_groove, full_radius,
/// blade_point, orientation, flat_thread, whitworth and back_turn; takes no tokens.
void read_side_words(const CommentView& view, ToolFacts& facts);

/// Whether the word at `i` says that the tool is a left-hand one.
bool is_left_hand(const CommentView& view, std::size_t i);

}  // namespace mrsim
