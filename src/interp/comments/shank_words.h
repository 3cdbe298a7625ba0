// Which size is the shank's and which one cuts: "D6 SHANK D3 CUT". Private to src/interp.
#pragma once

#include "interp/comments/comment_view.h"

#include <cstddef>

namespace mrsim {

/// Whether the word at `i` names the shank.
bool is_shank(const CommentView& view, std::size_t i);

/// Whether the word at `i` says that the size before it is the one that cuts: "D3 CUT". In "6 CUT
/// LENGTH 13" it does not.
bool is_cut(const CommentView& view, std::size_t i);

/// The place of the number behind the word for the shank at `i`, past D or DIA; kNone: there is
/// none.
std::size_t size_of_shank(const CommentView& view, std::size_t i);

/// Whether the number at `number` stands behind the word for the shank at `i` and is the size that
/// cuts, as the shank's own one stands before it: "6MM SHANK 3MM CUT", not "SHANK 6 CUT 3".
bool cuts_behind_shank(const CommentView& view, std::size_t i, std::size_t number);

/// Whether the size at `number` is the shank's, whose word stands behind it. The shank has no other
/// size there, "6 SHANK ENDMILL", or the one that follows cuts, "6 SHANK 3 CUT".
bool is_size_of_shank(const CommentView& view, std::size_t number);

}  // namespace mrsim
