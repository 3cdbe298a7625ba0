// Tools of CAMotics, by number: {"1": {"units": "metric", "shape": "cylindrical", "diameter": 6,
// "length": 20}}.
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "setup/library_formats.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

// The kind of tool; a sentence where it is not known.
std::string shape_tool(const std::string& shape, double length, double snub, Tool& tool) {
  if (!(tool.diameter > 0)) return "no diameter";
  tool.flute_length = length;
  if (shape.empty() || shape == "cylindrical") return "";
  if (shape == "ballnose") {
    tool.type = ToolType::ballmill;
    return "";
  }
  if (shape == "spheroid") {
    tool.type = ToolType::ballmill;
    tool.flute_length = 0;
    return std::abs(length - tool.diameter) < kRounding ? "" : "a spheroid that is no ball";
  }
  if (shape != "conical" && shape != "snubnose") return "the shape \"" + shape + "\" is unknown";
  if (!(length > 0)) return "no length";
  tool.type = ToolType::chamfer;
  tool.tip_diameter = shape == "snubnose" ? snub : 0;
  if (tool.tip_diameter >= tool.diameter) return "its end is wider than its shank";
  tool.taper_angle = atan2((tool.diameter - tool.tip_diameter) / 2, length);
  return "";
}

}  // namespace

void read_camotics_tools(const Json& table, const std::string& name, ToolLibrary& out) {
  out.format = LibraryFormat::camotics;
  for (const auto& [key, value] : table.items()) {
    LibraryTool entry;
    entry.tool.id = key;
    entry.tool.origin = name;
    entry.remark = json_text(value, "description");
    const std::string units = json_text(value, "units");
    const double scale = units == "imperial" || units == "inch" ? kMmPerInch : 1;
    entry.tool.diameter = scale * json_number(value, "diameter").value_or(0);
    const double length = scale * json_number(value, "length").value_or(0);
    const double snub = scale * json_number(value, "snub_diameter").value_or(0);
    const std::string wrong = shape_tool(json_text(value, "shape"), length, snub, entry.tool);
    if (wrong.empty())
      add_library_tool(out, std::move(entry), name);
    else
      skip_library_tool(out, key, wrong);
  }
}

}  // namespace mrsim
