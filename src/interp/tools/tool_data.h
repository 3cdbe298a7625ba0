// Finds the data of a tool: in the tool table, in comments, in its name.
// Private to src/interp.
#pragma once

#include "interp/control/control.h"
#include "interp/tools/tool_notes.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

namespace mrsim {

/// How Tool::origin begins where a turning tool is taken to be the usual one.
inline constexpr std::string_view kNoToolData = "no data:";

class ToolData : public ControlPart {
 public:
  ToolData(Control& control, const ToolNotes& notes);

  /// The tool of the table with this number or name, or null.
  const Tool* given(const std::string& id) const;
  /// The data of a tool, and where they came from. False: there are none. `why`: the reason, if
  /// anything is said of the tool. `said`: a warning where its shape is incomplete.
  bool resolve(const std::string& id, Tool& out, std::string& why, Severity& said) const;

 private:
  bool infer(const std::string& id, Tool& out, std::string& why, Severity& said) const;
  bool of_unknown_unit(const ToolHint& hint) const;
  bool repeats_name(const std::string& comment, const std::string& id) const;

  const ToolNotes& notes_;
  std::unordered_map<std::string, std::size_t> given_;  ///< id -> tool of the table, the first
};

}  // namespace mrsim
