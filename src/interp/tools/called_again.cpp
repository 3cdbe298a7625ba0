#include "interp/tools/called_again.h"

#include "interp/comments/tool_hint.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Whether the comment has a kind of tool with a size, as a tool needs.
bool describes_tool(const ToolHint& hint) {
  const bool cone = hint.trade == ToolTrade::vee && hint.tip_angle + hint.taper_angle > 0;
  return (hint.type || hint.names_tool) && !hint.upkeep && !hint.size_of_work &&
         (!hint.diameters.empty() || hint.width || !hint.insert.empty() || cone);
}

// Whether its words name a tool, and not what it does: "GROOVE 4MM".
bool names_tool_surely(const ToolHint& hint) {
  return hint.firm || hint.names_tool || !hint.insert.empty();
}

// Whether the tool is for grooves or threads, which no other insert cuts.
bool is_blade(const ToolHint& hint) {
  return hint.type == ToolType::grooving || hint.type == ToolType::threading;
}

}  // namespace

void CalledAgain::add(const std::string& id, const ToolHint& hint) {
  const auto [at, fresh] = told_.try_emplace(id, hint);
  if (!fresh && at->second.text.find(hint.text) == std::string::npos) merge_hint(at->second, hint);
}

bool CalledAgain::differs(const ToolHint& known, const ToolHint& told) const {
  const bool turn = known.type && told.type && is_turning(*known.type) && is_turning(*told.type);
  if (turn && known.type != told.type && (is_blade(known) || is_blade(told))) return true;
  return contradict(known, told, unit_, lathe_);
}

// Whether the comments describe another tool than the one of the number. Words of the work beside a
// tool's number may be the work of this one.
bool CalledAgain::is_other(const ToolHint* known, const ToolHint& told) const {
  if (!describes_tool(told) || !(names_tool_surely(told) || told.at_call)) return false;
  return known == nullptr || differs(*known, told);
}

std::string CalledAgain::name(const std::string& id,
                              const std::map<std::string, ToolHint>& hints) const {
  std::string text = fmt::format("{} ({})", id, place_);
  for (int n = 2; hints.count(text) > 0; ++n) text = fmt::format("{} ({}, {})", id, place_, n);
  return text;
}

void CalledAgain::bring(const std::string& id, std::map<std::string, ToolHint>& hints) {
  const auto told = told_.find(id);
  if (told == told_.end()) return;
  const auto find = [&](const std::string& tool) {
    const auto at = hints.find(tool);
    return at == hints.end() ? nullptr : &at->second;
  };
  const ToolHint* const known = find(tool_of(id));
  if (!is_other(known, told->second)) return;
  std::vector<std::string>& tools = tools_.try_emplace(id, 1, id).first->second;
  const auto same = std::find_if(tools.begin(), tools.end(), [&](const std::string& tool) {
    const ToolHint* const hint = find(tool);
    return hint && describes_tool(*hint) && !is_other(hint, told->second);
  });
  if (same != tools.end()) {
    std::rotate(same, same + 1, tools.end());
  } else {
    ToolHint hint = told->second;
    if (!names_tool_surely(hint) && hint.doubt.empty())
      hint.doubt = known ? fmt::format("names another tool {} than \"{}\", or the work of that one",
                                       id, known->text)
                         : fmt::format("describes tool {}, which has cut before, or another", id);
    tools.push_back(name(id, hints));
    hints.emplace(tools.back(), std::move(hint));
  }
  told_.erase(told);
  brought_ = true;
}

void CalledAgain::cut(const std::string& id, const ToolHint* known) {
  cut_.insert(id);
  const auto told = told_.find(id);
  if (told == told_.end()) return;
  const ToolHint& hint = told->second;
  if (is_other(known, hint))
    other_ = hint.text;
  else if (known && hint.type && differs(*known, hint))
    kind_ = fmt::format("the comment \"{}\" does not agree with \"{}\"", hint.text, known->text);
  told_.erase(told);
}

const std::string& CalledAgain::tool_of(const std::string& id) const {
  const auto at = tools_.find(id);
  return at == tools_.end() ? id : at->second.back();
}

}  // namespace mrsim
