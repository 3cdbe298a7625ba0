#include "setup/tool_spec.h"

#include "core/text/text_io.h"
#include "core/words/suggest.h"
#include "core/words/tool_types.h"
#include "setup/spec_text.h"
#include "setup/tool_keys.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mrsim {
namespace {

[[noreturn]] void fail_spec(const std::string& spec, const std::string& what) {
  throw Error("tool-spec", fmt::format("tool \"{}\": {}; write it like 4=endmill:d=5", spec, what),
              Error::Kind::usage);
}

// Cuts `rest` at the next separator and returns what stood before it.
std::string_view next_part(std::string_view& rest, char separator) {
  const std::size_t at = rest.find(separator);
  const std::string_view part = rest.substr(0, at);
  rest = at == rest.npos ? std::string_view() : rest.substr(at + 1);
  return trimmed(part);
}

void set_word(Tool& tool, std::string_view key, std::string_view value, const std::string& spec) {
  if (key == "insert") {
    tool.insert = std::string(value);
  } else if (key == "hand") {
    if (value != "left" && value != "right") fail_spec(spec, "hand is left or right");
    tool.left_hand = value == "left";
  } else {  // tip
    const std::optional<double> tip = parse_number(value);
    if (!tip || *tip < 1 || *tip > 9 || *tip != static_cast<int>(*tip))
      fail_spec(spec, "tip is a whole number from 1 to 9");
    tool.tip = static_cast<int>(*tip);
    tool.tip_is_nose_centre = tool.tip == 9;
  }
}

// "d or diameter", "tip_angle", ...
std::vector<std::string> keys_of(ToolType type) {
  std::vector<std::string> keys;
  for (const std::string_view name : key_names(type)) {
    const std::string_view small = find_tool_key(name, type)->short_name;
    const bool is_short = !small.empty() && find_tool_key(small, type)->name == name;
    keys.push_back(is_short ? fmt::format("{} or {}", small, name) : std::string(name));
  }
  return keys;
}

void set_key(Tool& tool, std::string_view assignment, const std::string& spec) {
  std::string_view value = assignment;
  const std::string_view key = next_part(value, '=');
  value = trimmed(value);
  if (assignment.find('=') == assignment.npos)
    fail_spec(spec, fmt::format("\"{}\" is not of the form key=value", assignment));
  if (is_turning(tool.type) && (key == "insert" || key == "hand" || key == "tip"))
    return set_word(tool, key, value, spec);
  const ToolKey* known = find_tool_key(key, tool.type);
  if (known == nullptr)
    fail_spec(spec, fmt::format("unknown key \"{}\"{} (a tool of type {} has: {})", key,
                                suggestion(key, key_names(tool.type)), tool_type_name(tool.type),
                                fmt::join(keys_of(tool.type), ", ")));
  const std::optional<double> number =
      known->quantity == Quantity::length ? parse_length(value) : parse_number(value, true);
  if (!number) fail_spec(spec, fmt::format("{} = \"{}\" is not a number", key, value));
  const std::string wrong = set_number(tool, *known, *number, 1.0);
  if (!wrong.empty()) fail_spec(spec, fmt::format("{} = {}: {}", known->name, value, wrong));
}

}  // namespace

Tool parse_tool_spec(const std::string& spec) {
  Tool tool;
  std::string_view keys = spec;
  std::string_view head = next_part(keys, ':');
  const std::size_t equal = head.find('=');
  if (equal != head.npos) {
    tool.id = std::string(trimmed(head.substr(0, equal)));
    if (tool.id.empty()) fail_spec(spec, "the tool's number or name is missing before \"=\"");
    head = trimmed(head.substr(equal + 1));
  }
  // T4 is how the program says it; 4 is its id. "T3.D2" is edge 2 of tool 3.
  const std::string number = tool.id.substr(0, tool.id.find(".D"));
  if (number.size() > 1 && (number[0] == 'T' || number[0] == 't') &&
      number.find_first_not_of("0123456789", 1) == std::string::npos)
    tool.id.erase(0, 1);
  const std::optional<ToolType> type = tool_type(head);
  if (!type)
    fail_spec(spec,
              fmt::format("unknown type \"{}\"{} (types: {})", head,
                          suggestion(head, tool_type_names()), fmt::join(tool_type_names(), " ")));
  tool.type = *type;
  keys = trimmed(keys);
  while (!keys.empty()) set_key(tool, next_part(keys, ','), spec);
  const std::string wrong = check_tool(tool);
  if (!wrong.empty()) fail_spec(spec, wrong);
  tool.origin = "--tool";
  return tool;
}

}  // namespace mrsim
