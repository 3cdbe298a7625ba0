// The words that describe a tool, in one table for tools.toml and for --tool: name, short name,
// unit, range, and the types of tool that have it.
#pragma once

#include <mrsim/types.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// mm: a hundred metres is a slip of the keyboard, in tools, offsets and stocks.
inline constexpr double kLargestLength = 1e5;

enum class Quantity : std::uint8_t { length, angle };

struct ToolKey {
  std::string_view name;
  std::string_view short_name;  ///< on the command line; may be empty
  Quantity quantity;
  double Tool::*member;
  double low, high;     ///< mm or degrees; `low` itself is allowed
  std::uint32_t types;  ///< bit n: ToolType(n) has it
};

/// All keys that are one number.
const std::vector<ToolKey>& tool_keys();
/// By name, or by short name among those that `type` has; nullptr for another word.
const ToolKey* find_tool_key(std::string_view name, ToolType type);
/// The keys that `type` has, for suggestions.
std::vector<std::string_view> key_names(ToolType type);

/// Sets one number, given in mm (or in units of `scale` mm) or degrees. Returns what is wrong with
/// it ("must be between 0 and 180"), or the empty string.
std::string set_number(Tool& tool, const ToolKey& key, double value, double scale);

/// What is wrong with the tool as a whole ("an endmill needs a diameter"), or the empty string.
/// The shape itself is checked when it is made.
std::string check_tool(const Tool& tool);

}  // namespace mrsim
