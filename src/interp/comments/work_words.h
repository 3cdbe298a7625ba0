// Words of a tool's comment that are, or may be, about what it cuts or about another tool.
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_kind.h"

#include <cstddef>

namespace mrsim {

/// A word for work that has a diameter of its own, or that another tool does: "KREISTASCHE D30",
/// "BOHREN D8".
bool is_other_work(const CommentView& view, std::size_t i);

/// A word that no table has: it may name a kind of tool.
bool is_unknown_word(const CommentView& view, std::size_t i);

/// "CIRCLE MILL 2.5 DIA", "MILL BORE": work that has a diameter of its own; `mill` is the word for
/// the tool or the work.
bool mills_round_work(const CommentView& view, const ToolKind& mill);

/// "NEXT TOOL - 6MM DRILL".
bool names_next_tool(const CommentView& view);

/// "LAST TOOL WAS 6MM DRILL".
bool names_last_tool(const CommentView& view);

/// The words at `first` and behind it give the diameter of the work: "30 DIA BORE", "HOLE DIA 30".
/// That of a hole is the drill's, too.
bool is_diameter_of_work(const CommentView& view, const ToolKind* kind, std::size_t first,
                         std::size_t next);

}  // namespace mrsim
