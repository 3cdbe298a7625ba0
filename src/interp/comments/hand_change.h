// Comments that tell the operator to change the tool by hand: "CHANGE TO 1/8 BALL ENDMILL".
#pragma once

#include <string_view>

namespace mrsim {

/// `bytes` in whatever encoding they came.
bool says_tool_is_changed(std::string_view bytes);

}  // namespace mrsim
