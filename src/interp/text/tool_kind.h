// Which kind of tool the words of a comment name, in Slovenian, English, German, Spanish, French
// and Italian. Whole words only: GLOBALLY names no ball mill.
#pragma once

#include "interp/text/comment_tokens.h"
#include <mrsim/types.h>

#include <cstddef>
#include <optional>

namespace mrsim {

struct ToolKind {
  ToolType type = ToolType::endmill;
  /// The words name a tool and nothing else ("END MILL"); false: they may name an operation
  /// ("CHAMFER", "DRILL") and count only beside data of a tool.
  bool firm = false;
  bool indescribable = false;      ///< "DOVETAIL": a comment can not give its shape
  double tip_angle = 0;            ///< degrees, where the kind implies it (spot drill)
  bool plain_teeth = false;        ///< a thread mill: a comment gives its cylinder alone
  bool needs_angle = false;        ///< a V-bit: nothing is known without it
  std::size_t first = 0, end = 0;  ///< tokens [first, end) are its name
};

std::optional<ToolKind> find_tool_kind(const std::vector<CommentToken>& tokens);

}  // namespace mrsim
