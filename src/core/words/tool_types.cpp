#include "core/words/tool_types.h"

#include <algorithm>

namespace mrsim {
namespace {

// In the order of ToolType.
const std::vector<std::string_view> kTypeNames = {
    "endmill",  "ballmill", "bullmill", "chamfer", "taper",    "drill",  "tslot",
    "lollipop", "barrel",   "form",     "turning", "grooving", "boring", "threading"};

constexpr std::string_view kTypeTexts[] = {
    "end mill",     "ball mill",     "bull-nose mill", "chamfer mill",  "tapered mill",
    "drill",        "T-slot mill",   "lollipop mill",  "barrel mill",   "form mill",
    "turning tool", "grooving tool", "boring bar",     "threading tool"};

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

std::string_view tool_type_text(ToolType type) {
  return kTypeTexts[static_cast<std::size_t>(type)];
}

const std::vector<std::string_view>& tool_type_names() { return kTypeNames; }

}  // namespace mrsim
