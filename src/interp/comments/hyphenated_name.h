// Names of tools whose parts stand between hyphens: "EM-10.0-4FL".
#pragma once

#include "interp/comments/comment_tokens.h"

#include <vector>

namespace mrsim {

/// Behind a kind of tool with a hyphen and a size, the hyphens of the name become blanks:
/// "EM-10-R1" is "EM 10 R1". "ENDMILL-2" and "DRILL-05" are numbered.
void part_hyphenated_name(std::vector<CommentToken>& tokens);

}  // namespace mrsim
