// Codes of grooving and threading inserts by their makers: "MGMN 300", "N123G2-0300", "16ER AG60".
#pragma once

#include "interp/comments/comment_tokens.h"
#include <mrsim/types.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace mrsim {

struct BladeCode {
  ToolType type = ToolType::grooving;
  double width = 0;     ///< mm, of a grooving blade
  double nose = 0;      ///< mm, of its corners
  double angle = 0;     ///< degrees, of a thread
  bool inside = false;  ///< "16IR"
  bool left_hand = false;
  std::size_t first = 0, end = 0;  ///< tokens [first, end) are the code
};

/// The first such code among the tokens.
std::optional<BladeCode> find_blade_code(const std::vector<CommentToken>& tokens);

}  // namespace mrsim
