// Takes apart names of tools that are written with hyphens: "EM-10.0-4FL".
#pragma once

#include "interp/comments/comment_tokens.h"

#include <vector>

namespace mrsim {

/// Makes blanks of the hyphens in a name that begins with a kind of tool, a hyphen and a size:
/// "EM-10-R1" becomes "EM 10 R1". "ENDMILL-2" and "DRILL-05" stay: their numbers are no sizes.
void part_hyphenated_name(std::vector<CommentToken>& tokens);

}  // namespace mrsim
