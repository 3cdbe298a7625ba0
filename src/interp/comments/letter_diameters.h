// Reads the diameters behind the sign Ø and the letter D, which may also be a register: "Ø5",
// "D=6.", "D10", "D10 H1 D1".
#pragma once

#include "interp/comments/comment_view.h"
#include "interp/comments/tool_facts.h"

namespace mrsim {

/// Fills named, letter_d, second_d, tip and pair. Requires: the kinds and the tool's number are
/// read.
void read_letter_diameters(CommentView& view, ToolFacts& facts);

}  // namespace mrsim
