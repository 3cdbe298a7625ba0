// Types of tools by their names: in tools.toml, in --tool, and in what runs write; which way the
// tip of a turning tool looks where its data do not say it; and which cutters end in a head.
#pragma once

#include <mrsim/types.h>

#include <optional>
#include <string_view>
#include <vector>

namespace mrsim {

/// The type of that name (tool_type_names()), or of `flat`, `ball` or `bull` for these mills;
/// nothing for another word.
std::optional<ToolType> tool_type(std::string_view name);
std::string_view tool_type_name(ToolType type);
/// What a reader calls it: "tapered mill", "turning tool".
std::string_view tool_type_text(ToolType type);
const std::vector<std::string_view>& tool_type_names();

/// 1 to 9 as on the control: Tool::tip, else that of a threading tool (8), a boring bar (2,
/// left-hand 1) or any other (3, left-hand 4). The insert and radius compensation must agree on it.
inline int tip_orientation(const Tool& tool) {
  if (tool.tip >= 1 && tool.tip <= 9) return tool.tip;
  if (tool.type == ToolType::threading) return 8;
  if (tool.type == ToolType::boring) return tool.left_hand ? 1 : 2;
  return tool.left_hand ? 4 : 3;
}

/// The orientation that LinuxCNC calls `number`, 0 to 9: it counts them with X turned over, so that
/// its 2 is the tip towards -X and -Z, which all others call 3.
inline int tip_of_linuxcnc(int number) {
  constexpr int kTips[] = {0, 4, 3, 2, 1, 5, 8, 7, 6, 9};
  return kTips[number];
}

/// mm: the radius of a turning tool's nose; that of a round insert follows from its size where it
/// is not given. The insert and radius compensation must agree on it.
inline double nose_radius(const Tool& tool) {
  const bool round = tool.type != ToolType::grooving && !tool.insert.empty() &&
                     (tool.insert.front() == 'R' || tool.insert.front() == 'r');
  if (tool.nose_radius > 0 || !round) return tool.nose_radius;
  return (tool.diameter > 0 ? tool.diameter : tool.edge_length) / 2;
}

/// Whether the tool works towards +X, inside of the part.
inline bool is_inside_tool(const Tool& tool) {
  const int tip = tip_orientation(tool);
  return tip == 1 || tip == 2 || tip == 6;
}

/// Whether the cutter is a head that ends below its neck, whatever its flute length: that of a
/// T-slot or lollipop mill, or a form whose profile ends on the axis.
inline bool ends_in_head(const Tool& tool) {
  return tool.type == ToolType::tslot || tool.type == ToolType::lollipop ||
         (tool.type == ToolType::form && !tool.profile.empty() && tool.profile.back().r == 0);
}

}  // namespace mrsim
