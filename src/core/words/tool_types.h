// The types of tool by their names: in tools.toml, in --tool, and in what runs write.
#pragma once

#include <mrsim/types.h>

#include <optional>
#include <string_view>
#include <vector>

namespace mrsim {

/// By the names below, or by `flat`, `ball` and `bull` for these mills; nothing for another word.
std::optional<ToolType> tool_type(std::string_view name);
std::string_view tool_type_name(ToolType type);
const std::vector<std::string_view>& tool_type_names();

}  // namespace mrsim
