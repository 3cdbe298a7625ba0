#include "setup/tools_file.h"

#include "core/numbers/units.h"
#include "core/words/suggest.h"
#include "core/words/tool_number.h"
#include "core/words/tool_types.h"
#include "setup/toml_text.h"
#include "setup/tool_keys.h"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

namespace mrsim {
namespace {

using Words = std::vector<std::string_view>;

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : text_(text), name_(name) {}
  ToolTable read();

 private:
  [[noreturn]] void fail(const toml::source_position& at, const char* code,
                         const std::string& what) const {
    fail_at(at, text_, name_, code, what);
  }
  [[noreturn]] void fail_value(std::string_view key, const toml::node& node,
                               const std::string& what) const {
    fail(node.source().begin, "tools-value", fmt::format("{} {}", key, what));
  }
  [[noreturn]] void fail_key(const toml::key& key, const std::string& where,
                             const Words& known) const;
  void require_word(const toml::key& key, const char* example) const {
    if (!is_program_word(key.str()))
      fail(key.source().begin, "tools-key",
           fmt::format("\"{}\" is no word of a program; write it in capitals, like {}", key.str(),
                       example));
  }

  double number(std::string_view key, const toml::node& node) const;
  double length(std::string_view key, const toml::node& node, double low) const;
  std::string word(std::string_view key, const toml::node& node) const;
  const toml::array& array(std::string_view key, const toml::node& node) const;
  std::vector<double> row(std::string_view key, const toml::node& node, std::size_t least,
                          std::size_t most) const;
  const toml::table& table(std::string_view key, const toml::node& node) const;

  void read_units(const toml::table& root);
  void read_tools(const toml::node& node);
  Tool read_tool(const toml::table& entry) const;
  void read_tool_key(Tool& tool, const toml::key& key, const toml::node& node) const;
  std::string read_id(const toml::node& node) const;
  int read_tip(const toml::node& node) const;
  void read_offsets(const toml::node& node);
  void read_work(const toml::node& node);

  std::string_view text_;
  const std::string& name_;
  double scale_ = 1;  ///< mm per unit of the file
  ToolTable table_;
};

void Reader::fail_key(const toml::key& key, const std::string& where, const Words& known) const {
  std::string hint = suggestion(key.str(), known);
  if (hint.empty()) hint = fmt::format("; known here: {}", fmt::join(known, " "));
  fail(key.source().begin, "tools-key",
       fmt::format("unknown key \"{}\" in {}{}", key.str(), where, hint));
}

double Reader::number(std::string_view key, const toml::node& node) const {
  const std::optional<double> value = finite_number(node);
  if (!value) fail_value(key, node, "must be a number");
  return *value;
}

double Reader::length(std::string_view key, const toml::node& node, double low) const {
  const double value = scale_ * number(key, node);
  if (value < low || value > kLargestLength)
    fail_value(key, node, fmt::format("must be between {:g} and {:g} mm", low, kLargestLength));
  return value;
}

std::string Reader::word(std::string_view key, const toml::node& node) const {
  const auto* value = node.as_string();
  if (value == nullptr || value->get().empty()) fail_value(key, node, "must be a text");
  return value->get();
}

const toml::array& Reader::array(std::string_view key, const toml::node& node) const {
  if (node.as_array() == nullptr) fail_value(key, node, "must be a list");
  return *node.as_array();
}

const toml::table& Reader::table(std::string_view key, const toml::node& node) const {
  if (node.as_table() == nullptr) fail_value(key, node, "must be a table");
  return *node.as_table();
}

std::vector<double> Reader::row(std::string_view key, const toml::node& node, std::size_t least,
                                std::size_t most) const {
  const toml::array& list = array(key, node);
  if (list.size() < least || list.size() > most)
    fail_value(key, node,
               least == most ? fmt::format("needs {} numbers in each row", least)
                             : fmt::format("needs {} or {} numbers in each row", least, most));
  std::vector<double> numbers;
  for (const toml::node& item : list) numbers.push_back(number(key, item));
  for (const double value : numbers)
    if (std::fabs(value * scale_) > kLargestLength) fail_value(key, node, "is beyond 100 m");
  return numbers;
}

void Reader::read_units(const toml::table& root) {
  const toml::node* node = root.get("units");
  if (node == nullptr) return;
  const std::string units = word("units", *node);
  if (units == "inch")
    scale_ = kMmPerInch;
  else if (units != "mm")
    fail_value("units", *node, "must be \"mm\" or \"inch\"");
}

std::string Reader::read_id(const toml::node& node) const {
  if (const auto whole = node.as_integer()) {
    if (whole->get() < 0) fail_value("id", node, "must not be negative");
    return std::to_string(whole->get());
  }
  return word("id", node);
}

int Reader::read_tip(const toml::node& node) const {
  const auto* tip = node.as_integer();
  if (tip == nullptr || tip->get() < 1 || tip->get() > 9)
    fail_value("tip", node, "must be a whole number from 1 to 9");
  return static_cast<int>(tip->get());
}

void Reader::read_tool_key(Tool& tool, const toml::key& key, const toml::node& node) const {
  const std::string_view name = key.str();
  const bool turning = is_turning(tool.type);
  if (name == "shank") {
    for (const toml::node& item : array(name, node)) {
      const std::vector<double> n = row(name, item, 2, 2);
      tool.shank.push_back({n[0] * scale_, n[0] * scale_, n[1] * scale_});
    }
  } else if (name == "holder") {
    for (const toml::node& item : array(name, node)) {
      const std::vector<double> n = row(name, item, 3, 3);
      tool.holder.push_back({n[0] * scale_, n[1] * scale_, n[2] * scale_});
    }
  } else if (name == "profile" && tool.type == ToolType::form) {
    for (const toml::node& item : array(name, node)) {
      const std::vector<double> n = row(name, item, 2, 3);
      tool.profile.push_back({n[0] * scale_, n[1] * scale_, n.size() > 2 ? n[2] : 0});
    }
  } else if (name == "insert" && turning) {
    tool.insert = word(name, node);
  } else if (name == "hand" && turning) {
    const std::string hand = word(name, node);
    if (hand != "left" && hand != "right") fail_value(name, node, "must be \"left\" or \"right\"");
    tool.left_hand = hand == "left";
  } else if (name == "tip" && turning) {
    tool.tip = read_tip(node);
    tool.tip_is_nose_centre = tool.tip == 9;
  } else {
    const ToolKey* known = find_tool_key(name, tool.type);
    if (known == nullptr || known->name != name) {
      Words words = key_names(tool.type);
      words.insert(words.end(), {"id", "type", "shank", "holder"});
      if (turning) words.insert(words.end(), {"insert", "hand", "tip"});
      if (tool.type == ToolType::form) words.push_back("profile");
      fail_key(key, fmt::format("a tool of type {}", tool_type_name(tool.type)), words);
    }
    const std::string wrong = set_number(tool, *known, number(name, node), scale_);
    if (!wrong.empty()) fail_value(name, node, wrong);
  }
}

Tool Reader::read_tool(const toml::table& entry) const {
  Tool tool;
  const toml::node* type = entry.get("type");
  if (type == nullptr)
    fail(entry.source().begin, "tools-value", "this tool has no type, such as \"endmill\"");
  const std::string type_name = word("type", *type);
  const std::optional<ToolType> known = tool_type(type_name);
  if (!known)
    fail_value(
        "type", *type,
        fmt::format("\"{}\" is unknown{} (types: {})", type_name,
                    suggestion(type_name, tool_type_names()), fmt::join(tool_type_names(), " ")));
  tool.type = *known;
  for (const auto& [key, node] : entry) {
    if (key == "id")
      tool.id = read_id(node);
    else if (key != "type")
      read_tool_key(tool, key, node);
  }
  const std::string wrong = check_tool(tool);
  if (!wrong.empty()) fail(entry.source().begin, "tools-value", wrong);
  tool.origin = fmt::format("{}:{}", name_, entry.source().begin.line);
  return tool;
}

void Reader::read_tools(const toml::node& node) {
  std::map<std::string, std::string> ids;  // as written, by number
  if (node.is_table())
    fail_value("tool", node, "must be a list: begin each tool with [[tool]], its number is id");
  for (const toml::node& item : array("tool", node)) {
    Tool tool = read_tool(table("tool", item));
    const auto [same, is_new] = ids.emplace(tool_number(tool.id), tool.id);
    if (!is_new && same->second == tool.id)
      fail(item.source().begin, "tools-duplicate",
           fmt::format("tool \"{}\" is given twice", tool.id));
    if (!is_new)
      fail(item.source().begin, "tools-duplicate",
           fmt::format("tool \"{}\" and tool \"{}\" have one number", same->second, tool.id));
    table_.tools.push_back(std::move(tool));
  }
}

void Reader::read_offsets(const toml::node& node) {
  for (const auto& [name, entry] : table("offsets", node)) {
    require_word(name, "D1");
    OffsetRegister offset;
    offset.name = name.str();
    for (const auto& [key, value] : table(name.str(), entry)) {
      if (key == "radius")
        offset.radius = length(key.str(), value, -kLargestLength);
      else if (key == "wear")
        offset.wear = length(key.str(), value, -kLargestLength);
      else if (key == "length")
        offset.length = length(key.str(), value, -kLargestLength);
      else
        fail_key(key, fmt::format("[offsets.{}]", offset.name), {"radius", "wear", "length"});
    }
    table_.offsets.push_back(offset);
  }
}

void Reader::read_work(const toml::node& node) {
  for (const auto& [name, entry] : table("work", node)) {
    if (!is_work_offset(name.str())) fail(name.source().begin, "tools-key", no_offset(name.str()));
    WorkOffset work;
    work.name = name.str();
    for (const auto& [key, value] : table(name.str(), entry)) {
      if (key != "x" && key != "y" && key != "z")
        fail_key(key, fmt::format("[work.{}]", work.name), {"x", "y", "z"});
      double& axis = key == "x" ? work.shift.x : key == "y" ? work.shift.y : work.shift.z;
      axis = length(key.str(), value, -kLargestLength);
    }
    table_.work.push_back(work);
  }
}

ToolTable Reader::read() {
  toml::table root;
  try {
    root = parse_toml(text_);
  } catch (const toml::parse_error& error) {
    fail(error.source().begin, "tools-syntax", std::string(error.description()));
  }
  read_units(root);
  for (const auto& [key, node] : root) {
    if (key == "tool")
      read_tools(node);
    else if (key == "offsets")
      read_offsets(node);
    else if (key == "work")
      read_work(node);
    else if (key != "units")
      fail_key(key, "the tool table", {"units", "tool", "offsets", "work"});
  }
  return std::move(table_);
}

}  // namespace

ToolTable parse_tools(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

}  // namespace mrsim
