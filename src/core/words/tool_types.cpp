#include "core/words/tool_types.h"

#include <algorithm>

namespace mrsim {
namespace {

// In the order of ToolType.
const std::vector<std::string_view> kTypeNames = {
    "endmill",  "ballmill", "bullmill", "chamfer", "taper",    "drill",  "tslot",
    "lollipop", "barrel",   "form",     "turning", "grooving", "boring", "threading"};

}  // namespace

std::optional<ToolType> tool_type(std::string_view name) {
  if (name == "flat") return ToolType::endmill;
  if (name == "ball") return ToolType::ballmill;
  if (name == "bull") return ToolType::bullmill;
  const auto at = std::find(kTypeNames.begin(), kTypeNames.end(), name);
  if (at == kTypeNames.end()) return std::nullopt;
  return static_cast<ToolType>(at - kTypeNames.begin());
}

std::string_view tool_type_name(ToolType type) {
  return kTypeNames[static_cast<std::size_t>(type)];
}

const std::vector<std::string_view>& tool_type_names() { return kTypeNames; }

}  // namespace mrsim
