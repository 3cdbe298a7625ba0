// Several offsets of one turning tool: edges with their own data, and a second offset of a blade,
// which may be that of its other corner. Private to src/interp.
#pragma once

#include "interp/tools/tool_data.h"

#include <string>
#include <unordered_map>

namespace mrsim {

class ToolEdges : public ControlPart {
 public:
  ToolEdges(Control& control, const ToolData& data)
      : ControlPart(control), tool_(control.tool), data_(data) {}

  /// The id of the tool in the spindle, with its edge where the table has data for that.
  std::string id_at_edge() const;
  /// Warns of a second offset in the T word that has called the tool; `used`: the tool of the
  /// program, null where it has not cut yet.
  void compare_offset(const Word& word, const Tool* used);
  /// Warns of a second edge of the tool in the spindle.
  void compare_edge(const Tool& tool, const Word& where);
  /// Warns where the program gives the tool in the spindle another nose.
  void compare_nose(const Tool& tool, const Word& where);
  /// Gives a tool the tip orientation that the program tells, or warns where its data differ.
  void settle_tip(Tool& tool, const Word& where);

 private:
  void tell_second(const std::string& offset, const std::string& id, const Tool& tool,
                   const Word& where);

  const ToolState& tool_;
  const ToolData& data_;
  std::unordered_map<std::string, long> offsets_;  ///< id -> the first offset of that tool
};

}  // namespace mrsim
