// Finds words in the comment of a tool that are about what it cuts, or about another tool.
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_kind.h"

#include <cstddef>

namespace mrsim {

/// Whether the word names work that has a diameter of its own, or that another tool does:
/// "KREISTASCHE D30", "BOHREN D8".
bool is_other_work(const CommentView& view, std::size_t i);

/// Whether no table has the word, so that it may name a kind of tool.
bool is_unknown_word(const CommentView& view, std::size_t i);

/// Whether the comment names milled work that has a diameter of its own: "CIRCLE MILL 2.5 DIA",
/// "MILL BORE". `mill` is the word for the tool or the work.
bool mills_round_work(const CommentView& view, const ToolKind& mill);

/// Whether the comment is about the next tool: "NEXT TOOL - 6MM DRILL".
bool names_next_tool(const CommentView& view);

/// Whether the comment is about the tool before: "LAST TOOL WAS 6MM DRILL".
bool names_last_tool(const CommentView& view);

/// Whether the comment says when a tool is seen to, not which is at hand: "REPLACE 10MM ENDMILL
/// EVERY 20 PARTS", "CHECK DRILL IF WORN".
bool tells_upkeep(const CommentView& view);

/// Whether the comment names holes, pockets or bosses and no tool: "BORE D30".
bool names_hollow(const CommentView& view);

/// Whether the words at `first` and `next` give the diameter of the work: "30 DIA BORE", "HOLE DIA
/// 30". False for a drill, whose diameter is that of the hole.
bool is_diameter_of_work(const CommentView& view, const ToolKind* kind, std::size_t first,
                         std::size_t next);

}  // namespace mrsim
