// Fusion's tool library: {"data": [{"type": "flat end mill", "unit": "millimeters", "geometry":
// {"DC": 6, ...}, "post-process": {"number": 1}, "holder": {"segments": [...]}}]}.
#include "core/numbers/units.h"
#include "setup/library_formats.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

struct FusionKind {
  std::string_view name;
  ToolType type;
};
constexpr FusionKind kFusionKinds[] = {{"flat end mill", ToolType::endmill},
                                       {"ball end mill", ToolType::ballmill},
                                       {"bull nose end mill", ToolType::bullmill},
                                       {"face mill", ToolType::endmill},
                                       {"slot mill", ToolType::tslot},
                                       {"chamfer mill", ToolType::chamfer},
                                       {"tapered mill", ToolType::taper},
                                       {"lollipop mill", ToolType::lollipop},
                                       {"drill", ToolType::drill},
                                       {"spot drill", ToolType::drill},
                                       {"center drill", ToolType::drill},
                                       {"counter sink", ToolType::chamfer},
                                       {"counter bore", ToolType::endmill},
                                       {"reamer", ToolType::endmill},
                                       {"tap right hand", ToolType::endmill},
                                       {"tap left hand", ToolType::endmill},
                                       {"boring bar", ToolType::endmill},
                                       {"boring head", ToolType::endmill}};

// In mm; 0 where there is none.
double length_at(const Json& object, const char* key, double scale) {
  return scale * json_number(object, key).value_or(0);
}

void read_angles(const Json& geometry, const std::string& kind, Tool& tool) {
  const double point = json_number(geometry, "SIG").value_or(0);
  const double taper = json_number(geometry, "TA").value_or(0);
  const bool pointed = tool.type == ToolType::drill || kind == "counter sink";
  if (pointed && point > 0 && point <= 180) tool.tip_angle = radians(point);
  if (!pointed && taper > 0 && taper < 90) tool.taper_angle = radians(taper);
}

void read_holder(const Json& entry, double scale, Tool& tool) {
  const Json& segments = json_at(json_at(entry, "holder"), "segments");
  if (!segments.is_array()) return;
  for (const Json& segment : segments) {
    const double low = length_at(segment, "lower-diameter", scale);
    const double high = length_at(segment, "upper-diameter", scale);
    const double height = length_at(segment, "height", scale);
    if (low > 0 && high > 0 && height > 0 && tool.holder.size() < 100)
      tool.holder.push_back({low, high, height});
  }
}

// A neck up to the shoulder, where it is thinner or thicker than the shank, then the shank.
void read_shank(const Json& geometry, double scale, Tool& tool) {
  const auto length = [&](const char* key) { return length_at(geometry, key, scale); };
  const double shank = length("SFDM"), body = length("LB");
  const double neck = length("shoulder-diameter"), shoulder = length("shoulder-length");
  if (!(tool.flute_length > 0)) return;
  double from = tool.flute_length;
  if (neck > 0 && shoulder > from) {
    tool.shank.push_back({neck, neck, shoulder - from});
    from = shoulder;
  }
  if (shank > 0 && body > from) tool.shank.push_back({shank, shank, body - from});
}

double unit_of(const Json& entry) {
  return json_text(entry, "unit").starts_with("inch") ? kMmPerInch : 1;
}

void read_tool(const Json& entry, const std::string& name, ToolLibrary& out) {
  const std::string type = json_text(entry, "type");
  if (type == "holder" || type.empty()) return;
  LibraryTool made;
  Tool& tool = made.tool;
  tool.id = json_id(json_at(json_at(entry, "post-process"), "number"));
  made.remark = json_text(entry, "description");
  tool.origin = name;
  const auto* kind = std::find_if(std::begin(kFusionKinds), std::end(kFusionKinds),
                                  [&](const FusionKind& k) { return k.name == type; });
  if (kind == std::end(kFusionKinds))
    return skip_library_tool(out, tool.id, fmt::format("a {} can not be read from Fusion", type));
  tool.type = kind->type;
  const double scale = unit_of(entry);
  const Json& geometry = json_at(entry, "geometry");
  const auto length = [&](const char* key) { return length_at(geometry, key, scale); };
  tool.diameter = length("DC");
  if (tool.type != ToolType::ballmill && tool.type != ToolType::drill)
    tool.corner_radius = length("RE");
  if (tool.type == ToolType::lollipop) tool.corner_radius = 0;
  tool.tip_diameter =
      tool.type == ToolType::chamfer || tool.type == ToolType::taper ? length("tip-diameter") : 0;
  tool.flute_length = length("LCF");
  read_angles(geometry, type, tool);
  read_shank(geometry, scale, tool);
  // DC is the diameter at the tip, from where the flank leans out.
  if (type == "face mill" && tool.taper_angle > 0) tool.type = ToolType::taper;
  read_holder(entry, unit_of(json_at(entry, "holder")), tool);
  add_library_tool(out, std::move(made), name);
}

}  // namespace

void read_fusion_tools(const Json& root, const std::string& name, ToolLibrary& out) {
  out.format = LibraryFormat::fusion;
  for (const Json& entry : json_at(root, "data")) read_tool(entry, name, out);
}

}  // namespace mrsim
