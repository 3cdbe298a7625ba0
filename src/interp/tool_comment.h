// What comments say about tools: "Steblasto frezalo Ø5", "END MILL D5",
// "T1 D=6. CR=0. - FLAT END MILL", "@MKR|TOOL|number=1|type=Flat End|diameter=3".
#pragma once

#include <mrsim/types.h>

#include <optional>
#include <string>
#include <string_view>

namespace mrsim {

struct ToolHint {
  std::string id;  ///< when the comment names the tool itself
  std::optional<ToolType> type;
  double diameter = 0, corner_radius = 0, taper_angle = 0, nose_radius = 0;
  bool has_corner = false;
  std::string text;  ///< the comment, UTF-8, for the report
  explicit operator bool() const { return type || diameter > 0; }
};

/// `bytes` in whatever encoding they came. Lengths as written, without unit.
ToolHint read_tool_comment(std::string_view bytes);

/// What a hint leaves open, filled in by the documented defaults: a turning tool without data is a
/// sharp 35 degree finishing insert, lead angle 93 degrees, edge 16 mm.
void complete_turning_tool(Tool& tool);

}  // namespace mrsim
