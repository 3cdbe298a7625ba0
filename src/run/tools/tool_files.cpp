// Tools from files of any format; what remarks say of LinuxCNC's tools, whose table has no kinds.
#include "core/numbers/units.h"
#include "interp/comments/tool_comment.h"
#include "interp/comments/tool_hint.h"
#include "interp/comments/turning_hint.h"
#include "setup/tool_library.h"
#include <mrsim/mrsim.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

// The unit of a LinuxCNC table is the machine's; a remark such as "1/4 end mill" beside D0.25 shows
// it.
double table_unit(const std::vector<LibraryTool>& tools, bool& told) {
  int inches = 0, millimetres = 0;
  for (const LibraryTool& entry : tools) {
    const ToolHint hint = read_tool_comment(entry.remark);
    const auto weigh = [&](const ToolLength& said, double listed) {
      if (said.unit == 0 && !said.fraction) return;
      const double mm = said.value * (said.unit > 0 ? said.unit : kMmPerInch);
      if (std::abs(listed - mm) < 0.05) ++millimetres;
      if (std::abs(listed * kMmPerInch - mm) < 0.05) ++inches;
    };
    for (const ToolLength& said : hint.diameters) weigh(said, entry.tool.diameter);
    if (hint.nose) weigh(hint.nose, entry.tool.nose_radius);
  }
  told = inches != millimetres;
  return inches > millimetres ? kMmPerInch : 1;
}

// A mill of the table's diameter: that shows the unit of a remark as "1/4 V-bit 60 deg", too.
bool tells_mill(const ToolHint& hint, double unit, double diameter, Tool& said) {
  for (const double other : {unit, unit > 1 ? 1 : kMmPerInch}) {
    said = {};
    std::string why;
    if (fill_tool(hint, other, false, said, why) && !is_turning(said.type) &&
        std::abs(said.diameter - diameter) < 0.1)
      return true;
  }
  return false;
}

// A remark without a size, as "drill", is about a tool of the table's diameter.
ToolHint read_remark(const std::string& remark, double diameter) {
  ToolHint hint = read_tool_comment(remark);
  if (!hint.diameters.empty() || remark.empty() || !(diameter > 0)) return hint;
  return read_tool_comment(fmt::format("{} D{:.6g} mm", remark, diameter));
}

// The table's diameter, where the remark is of another size: a tool that was ground again keeps its
// kind, but "6mm ball nose" beside Ø152 says that one of the two is wrong.
std::string keep_kind(const ToolHint& hint, const Tool& said, Tool& tool) {
  constexpr double kGround = 0.1;  // of its diameter
  if (std::abs(said.diameter - tool.diameter) > kGround * tool.diameter)
    return fmt::format("gives the diameter {:.6g} mm, and the table {:.6g} mm", said.diameter,
                       tool.diameter);
  if (hint.type == ToolType::endmill) return "";
  tool.type = said.type;
  tool.corner_radius = std::min(said.corner_radius, tool.diameter / 2);
  tool.tip_angle = said.tip_angle;
  return "";
}

// "corner radius 0.5" and no kind.
void take_corner(const std::string& remark, double unit, Tool& tool) {
  Tool said;
  std::string why;
  const std::string text = fmt::format("END MILL D{:.6g} mm {}", tool.diameter, remark);
  if (!fill_tool(read_tool_comment(text), unit, false, said, why) || !(said.corner_radius > 0))
    return;
  tool.type = said.type;
  tool.corner_radius = said.corner_radius;
}

// Makes a turning tool of a table's row. What the remark says of its shape counts, before the row.
void complete_linuxcnc_turning(Tool& tool, const ToolHint& hint, double unit) {
  const Tool listed = tool;
  Tool said;
  std::string why;
  if (fill_tool(hint, unit, true, said, why) && is_turning(said.type)) {
    said.id = tool.id;
    said.tip = tool.tip;
    said.tip_is_nose_centre = tool.tip_is_nose_centre;
    said.origin = tool.origin;
    tool = said;
    if (hint.insert.empty() && hint.insert_angle == 0 && listed.insert_angle > 0) {
      tool.insert_angle = listed.insert_angle;
      tool.lead_angle = listed.lead_angle;
    }
  }
  if (listed.nose_radius > 0) tool.nose_radius = listed.nose_radius;
  complete_turning_tool(tool);
}

// Why no tool can be made of a table's row; empty: it is made. A remark that names a kind whose
// shape it does not give is no end mill.
std::string complete_linuxcnc(LibraryTool& entry, double unit) {
  Tool& tool = entry.tool;
  tool.diameter *= unit;
  tool.nose_radius *= unit;
  tool.origin += unit > 1 ? ", in inches" : ", in mm";
  const ToolHint hint = read_remark(entry.remark, tool.diameter);
  Tool said;
  if (is_turning(tool.type)) {
    complete_linuxcnc_turning(tool, hint, unit);
    return "";
  }
  if (tells_mill(hint, unit, tool.diameter, said)) {
    tool.type = said.type;
    tool.corner_radius = said.corner_radius;
    tool.tip_angle = said.tip_angle;
    tool.taper_angle = said.taper_angle;
    tool.tip_diameter = said.tip_diameter;
    tool.width = said.width;
    if (said.flute_length > 0) tool.flute_length = said.flute_length;
    tool.profile = said.profile;
    if (!hint.type) tool.origin += ", taken to be an end mill";
    return "";
  }
  std::string why;
  fill_tool(hint, unit, false, said, why);
  const bool plain = hint.type == ToolType::endmill || hint.type == ToolType::bullmill ||
                     hint.type == ToolType::ballmill || hint.type == ToolType::drill;
  const bool is_sized = !read_tool_comment(entry.remark).diameters.empty();  // perhaps otherwise
  if (!hint.doubt.empty() || hint.trade == ToolTrade::dovetail ||
      (hint.type && !(plain && is_sized)))
    return fmt::format("the remark \"{}\" {}", entry.remark, why);
  if (hint.type) {
    why = keep_kind(hint, said, tool);
    return why.empty() ? "" : fmt::format("the remark \"{}\" {}", entry.remark, why);
  }
  take_corner(entry.remark, unit, tool);
  tool.origin += tool.corner_radius > 0 ? ", taken to be a mill" : ", taken to be an end mill";
  return "";
}

}  // namespace

ToolTable load_tools(const std::string& path, std::vector<std::string>* notes) {
  ToolLibrary library = load_library(path);
  if (library.format == LibraryFormat::toml) return std::move(library.table);
  if (library.format == LibraryFormat::linuxcnc) {
    bool told = false;
    const double unit = table_unit(library.tools, told);
    if (!told && !library.tools.empty() && notes != nullptr)
      notes->push_back(fmt::format(
          "{}: no remark tells the table's unit: its numbers are read as mm (\";1/4 end mill\" "
          "beside D0.25 would say inches)",
          path));
    std::vector<LibraryTool> made;
    for (LibraryTool& entry : library.tools) {
      const std::string why = complete_linuxcnc(entry, unit);
      if (why.empty())
        made.push_back(std::move(entry));
      else
        library.skipped.push_back(fmt::format("tool {}: {}", entry.tool.id, why));
    }
    library.tools = std::move(made);
  }
  if (notes != nullptr) {
    notes->push_back(
        fmt::format("{}: {}, {} tools", path, library_name(library.format), library.tools.size()));
    for (const std::string& text : library.skipped)
      notes->push_back(fmt::format("{}: {}; left out", path, text));
  }
  ToolTable table;
  for (LibraryTool& entry : library.tools) {
    if (!entry.remark.empty()) entry.tool.origin += fmt::format(" \"{}\"", entry.remark);
    table.tools.push_back(std::move(entry.tool));
  }
  return table;
}

}  // namespace mrsim
