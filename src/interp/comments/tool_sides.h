// The side of the work that lathe words name: "ID GROOVE", "OD TURN", "BORE".
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

#include <cstddef>

namespace mrsim {

/// Drops ROUGHER as a name of a mill where the comment tells an insert: "80 DEG ROUGHER", "CNMG 432
/// ROUGHER", "OD ROUGHER". A size before it makes it a mill: "1/2 ROUGHER". Requires: kinds and
/// insert are read, and no token is taken.
void drop_rougher(const CommentView& view, ToolFacts& facts);

/// Sets inside, bores, turned_side, face_groove and full_radius; takes no tokens.
void read_side_words(const CommentView& view, ToolFacts& facts);

/// Sets blade_point, orientation, flat_thread, whitworth and back_turn, which only comments about a
/// lathe's tool have; takes no tokens. Requires: kinds, insert and blade are read.
void read_turning_words(const CommentView& view, ToolFacts& facts);

/// Whether the word at `i` says that a mill is for slots, which is a disc if it has a width:
/// "NUTENFRAESER", "FRESA PER CAVE".
bool names_slot_mill(const CommentView& view, std::size_t i);

/// Whether the word at `i` says that the tool is a left-hand one.
bool is_left_hand(const CommentView& view, std::size_t i);

}  // namespace mrsim
