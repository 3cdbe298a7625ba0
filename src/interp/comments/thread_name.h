// Names of threads: "M8 X 1.25", "1/4-20 UNC", "#10-24", "G1/4". They are the diameter of a tap,
// and of nothing else: a thread mill or a tap drill is smaller.
#pragma once

#include "interp/comments/comment_view.h"

#include <cstddef>
#include <optional>

namespace mrsim {

struct ThreadName {
  ToolLength diameter;             ///< major diameter; none where the name does not have it
  bool enlarged = false;           ///< for a wire insert: its tap is larger than the thread
  std::size_t first = 0, end = 0;  ///< tokens [first, end) are its name
};

/// The first thread that is named. `threads`: the tool makes or precedes threads, so that "8-32"
/// and "M 8" name one, too.
std::optional<ThreadName> find_thread_name(const CommentView& view, bool threads);

}  // namespace mrsim
