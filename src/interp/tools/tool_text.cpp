#include "interp/tools/tool_text.h"

#include "core/numbers/units.h"
#include "core/words/tool_types.h"

#include <fmt/format.h>

namespace mrsim {

std::string tool_summary(const Tool& tool) {
  std::string text(tool_type_text(tool.type));
  if (tool.diameter > 0) text += fmt::format(" {:g} mm", tool.diameter);
  if (tool.corner_radius > 0) text += fmt::format(", corner radius {:g} mm", tool.corner_radius);
  if (tool.tip_angle > 0) text += fmt::format(", point {:.4g} degrees", degrees(tool.tip_angle));
  if (tool.taper_angle > 0)
    text += fmt::format(", {:.4g} degrees a side", degrees(tool.taper_angle));
  if (tool.tip_diameter > 0) text += fmt::format(", tip {:.4g} mm", tool.tip_diameter);
  if (tool.type == ToolType::tslot) text += fmt::format(", head {:.4g} mm", tool.width);
  return text;
}

std::string tool_example(const Tool& read, bool lathe) {
  if (read.type == ToolType::grooving && lathe)
    return "grooving:w=3 (with tip=7 the blade stands along Z, its middle the point)";
  if (read.type == ToolType::threading && lathe)
    return "threading:insert_angle=30,r=0.3 (r: of its tip)";
  if (read.insert == "R" && lathe) return "turning:insert=R,d=8 (d: of the insert)";
  if (read.type == ToolType::tslot && read.diameter > 0)
    return fmt::format("tslot:d={:.6g},w=4 (w: the height of its head)", read.diameter);
  if (read.type == ToolType::taper && read.diameter > 0 && read.taper_angle > 0)
    return fmt::format("taper:d={:.6g},r={:.6g},a={:.6g},l=20 (l: its flutes)", read.diameter,
                       read.corner_radius, degrees(read.taper_angle));
  const auto known = [](double value, double otherwise) { return value > 0 ? value : otherwise; };
  if (read.type == ToolType::chamfer)
    return fmt::format("chamfer:d={:.6g},tip_angle={:.6g},t={:.6g} (t: its tip)",
                       known(read.diameter, 6),
                       degrees(known(read.tip_angle, known(2 * read.taper_angle, radians(60)))),
                       known(read.tip_diameter, 0.2));
  if (read.type == ToolType::drill) return fmt::format("drill:d={:.6g}", known(read.diameter, 10));
  if (read.type == ToolType::ballmill)
    return fmt::format("ballmill:d={:.6g}", known(read.diameter, 10));
  if (read.type == ToolType::bullmill)
    return fmt::format("bullmill:d={:.6g},r={:.6g} (r: its corner)", known(read.diameter, 10),
                       known(read.corner_radius, 1));
  return lathe ? "turning:insert=CNMG,r=0.8"
               : fmt::format("endmill:d={:.6g}", known(read.diameter, 10));
}

}  // namespace mrsim
