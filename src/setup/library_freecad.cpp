// FreeCAD's tool bits {"shape": "endmill.fcstd", "parameter": {"Diameter": "5.0000 mm"}} and its
// libraries {"tools": [{"nr": 1, "path": "5mm_Endmill.fctb"}]}.
#include "core/numbers/units.h"
#include "core/process/error.h"
#include "core/text/ascii.h"
#include "core/text/text_io.h"
#include "setup/library_formats.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

constexpr std::size_t kBitLimit = std::size_t(1) << 20;

struct Kind {
  std::string_view name;
  ToolType type;
};
constexpr Kind kKinds[] = {{"endmill", ToolType::endmill},   {"ballend", ToolType::ballmill},
                           {"bullnose", ToolType::bullmill}, {"torus", ToolType::bullmill},
                           {"chamfer", ToolType::chamfer},   {"vbit", ToolType::chamfer},
                           {"drill", ToolType::drill},       {"reamer", ToolType::endmill},
                           {"tap", ToolType::endmill}};

// "v-bit.fcstd" and "VBit" are "vbit".
std::string plain_name(const std::string& text) {
  std::string out;
  for (const char c : std::filesystem::path(text).stem().string()) {
    const char letter = lower_case(c);
    if (letter >= 'a' && letter <= 'z') out += letter;
  }
  return out;
}

// "5.0000 mm", "1/8 in", "60 deg" in mm or degrees; a bare number is in mm or degrees. 0: none.
double quantity(const Json& parameters, const char* key) {
  if (const auto number = json_number(parameters, key)) return *number;
  std::string text = json_text(parameters, key);
  std::replace(text.begin(), text.end(), ',', '.');
  const std::size_t end = std::min(text.find_first_not_of("0123456789./"), text.size());
  const std::size_t slash = text.find('/');
  double value = parse_number(text.substr(0, std::min(end, slash))).value_or(0);
  if (slash < end) {
    const double below = parse_number(text.substr(slash + 1, end - slash - 1)).value_or(0);
    value = below > 0 ? value / below : 0;
  }
  const std::size_t at = text.find_first_not_of(' ', end);
  const std::string unit = at == text.npos ? "" : text.substr(at);
  if (unit.starts_with("in") || unit.starts_with("\"")) return value * kMmPerInch;
  if (unit.starts_with("cm")) return value * 10;
  if (unit == "m") return value * 1000;
  if (unit.starts_with("\xC2\xB5m") || unit.starts_with("um")) return value / 1000;
  return value;
}

double first_of(const Json& parameters, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (const double value = quantity(parameters, key); value > 0) return value;
  return 0;
}

void read_shape(const Json& p, Tool& tool) {
  tool.diameter = quantity(p, "Diameter");
  tool.flute_length = quantity(p, "CuttingEdgeHeight");
  if (tool.type == ToolType::bullmill)
    tool.corner_radius = first_of(p, {"CornerRadius", "FlatRadius", "TorusRadius"});
  if (tool.type == ToolType::drill) tool.tip_angle = radians(quantity(p, "TipAngle"));
  if (tool.type == ToolType::chamfer) {
    tool.tip_angle = radians(quantity(p, "CuttingEdgeAngle"));
    tool.tip_diameter = quantity(p, "TipDiameter");
  }
  const double shank = quantity(p, "ShankDiameter"), length = quantity(p, "Length");
  if (shank > 0 && tool.flute_length > 0 && length > tool.flute_length)
    tool.shank.push_back({shank, shank, length - tool.flute_length});
}

// The bit of a library: beside it, or in FreeCAD's folder Bit. Only the file's name counts.
std::string find_bit(const std::string& library, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(library).parent_path();
  const std::filesystem::path file = std::filesystem::path(path).filename();
  for (const char* place : {".", "Bit", "../Bit", "../../Bit"}) {
    std::error_code failed;
    const std::filesystem::path candidate = folder / place / file;
    if (std::filesystem::is_regular_file(candidate, failed)) return candidate.string();
  }
  return "";
}

}  // namespace

void read_freecad_bit(const Json& root, const std::string& id, const std::string& name,
                      ToolLibrary& out) {
  std::string shape = plain_name(json_text(root, "shape-type"));
  if (shape.empty()) shape = plain_name(json_text(root, "shape"));
  LibraryTool made;
  made.remark = json_text(root, "name");
  made.tool.id = id;
  made.tool.origin = name;
  const auto* kind = std::find_if(std::begin(kKinds), std::end(kKinds),
                                  [&](const Kind& k) { return k.name == shape; });
  if (kind == std::end(kKinds))
    return skip_library_tool(out, id, fmt::format("the shape \"{}\" is not known", shape));
  made.tool.type = kind->type;
  read_shape(json_at(root, "parameter"), made.tool);
  if (made.tool.tip_diameter > made.tool.diameter) made.tool.tip_diameter = 0;
  add_library_tool(out, std::move(made), name);
}

void read_freecad_library(const Json& root, const std::string& name, ToolLibrary& out) {
  out.format = LibraryFormat::freecad;
  std::size_t files = 0;
  for (const Json& entry : json_at(root, "tools")) {
    const std::string id = json_id(json_at(entry, "nr"));
    const std::string path = json_text(entry, "path");
    const std::string bit = path.empty() || ++files > 2000 ? "" : find_bit(name, path);
    if (bit.empty()) {
      skip_library_tool(out, id, fmt::format("its bit \"{}\" is not beside the library", path));
      continue;
    }
    read_freecad_bit(parse_json(read_file(bit, kBitLimit), bit), id, bit, out);
  }
}

}  // namespace mrsim
