#include "setup/tool_keys.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/words/tool_types.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kLeastLength = 1e-3;  // mm: least value of a size that the tool must have

constexpr std::uint32_t bits() { return 0; }
template <class... Rest>
constexpr std::uint32_t bits(ToolType first, Rest... rest) {
  return (1u << static_cast<unsigned>(first)) | bits(rest...);
}

constexpr std::uint32_t kTurning =
    bits(ToolType::turning, ToolType::grooving, ToolType::boring, ToolType::threading);
constexpr std::uint32_t kMilling = bits(ToolType::turning) - 1;
constexpr std::uint32_t kRound = kMilling & ~bits(ToolType::form);

using enum ToolType;
const std::vector<ToolKey> kKeys = {
    {"diameter", "d", Quantity::length, &Tool::diameter, kLeastLength, kLargestLength,
     kRound | bits(turning, boring)},
    {"corner_radius", "r", Quantity::length, &Tool::corner_radius, 0, kLargestLength,
     bits(endmill, bullmill, chamfer, taper, tslot, barrel)},
    {"flute_length", "l", Quantity::length, &Tool::flute_length, 0, kLargestLength, kMilling},
    {"taper_angle", "a", Quantity::angle, &Tool::taper_angle, 0, 89, bits(taper, chamfer, barrel)},
    {"tip_angle", "a", Quantity::angle, &Tool::tip_angle, 1, 180, bits(drill, chamfer)},
    {"tip_diameter", "t", Quantity::length, &Tool::tip_diameter, 0, kLargestLength,
     bits(chamfer, taper, barrel)},
    {"neck_diameter", "n", Quantity::length, &Tool::neck_diameter, 0, kLargestLength,
     bits(tslot, lollipop)},
    {"profile_radius", "p", Quantity::length, &Tool::profile_radius, kLeastLength, kLargestLength,
     bits(barrel)},
    {"insert_angle", "", Quantity::angle, &Tool::insert_angle, 1, 179, kTurning},
    {"nose_radius", "r", Quantity::length, &Tool::nose_radius, 0, kLargestLength, kTurning},
    {"lead_angle", "a", Quantity::angle, &Tool::lead_angle, 1, 179, kTurning},
    {"edge_length", "l", Quantity::length, &Tool::edge_length, kLeastLength, kLargestLength,
     kTurning},
    {"width", "w", Quantity::length, &Tool::width, kLeastLength, kLargestLength,
     bits(grooving, tslot, threading)},
};

bool has(const ToolKey& key, ToolType type) { return (key.types & bits(type)) != 0; }

// The diameter of a tapered mill without a tip diameter is that in the plane of its tip, which cuts
// a ball below its equator; it comes rounded to the last digit of a library.
double largest_corner(const Tool& tool) {
  const double radius = tool.diameter / 2;
  if (tool.type != ToolType::taper || tool.tip_diameter > 0) return radius;
  constexpr double kRounded = 0.01;  // mm
  const SinCos lean = sincos(tool.taper_angle);
  return radius * lean.cos / (1 - lean.sin) + kRounded;
}

}  // namespace

const std::vector<ToolKey>& tool_keys() { return kKeys; }

const ToolKey* find_tool_key(std::string_view name, ToolType type) {
  // A chamfer mill has two angles: "a" is the first that fits, the one per side being a tapered
  // mill's.
  for (const ToolKey& key : kKeys)
    if (has(key, type) && name == key.short_name && !name.empty() &&
        !(type == chamfer && key.name == "taper_angle"))
      return &key;
  for (const ToolKey& key : kKeys)
    if (name == key.name) return &key;
  return nullptr;
}

std::vector<std::string_view> key_names(ToolType type) {
  std::vector<std::string_view> names;
  for (const ToolKey& key : kKeys)
    if (has(key, type)) names.push_back(key.name);
  return names;
}

std::string set_number(Tool& tool, const ToolKey& key, double value, double scale) {
  if (!has(key, tool.type))
    return fmt::format("a tool of type {} has none", tool_type_name(tool.type));
  if (key.quantity == Quantity::length) value *= scale;
  if (!std::isfinite(value) || value < key.low || value > key.high)
    return fmt::format("must be between {:g} and {:g}{}", key.low, key.high,
                       key.quantity == Quantity::length ? " mm" : " degrees");
  if (tool.type == taper && key.member == &Tool::tip_diameter && value == 0)
    return "a taper that comes to a point is of type chamfer, with diameter and taper_angle";
  tool.*key.member = key.quantity == Quantity::length ? value : radians(value);
  return "";
}

std::string check_tool(const Tool& tool) {
  const std::string_view name = tool_type_name(tool.type);
  const double radius = tool.diameter / 2;
  if ((bits(tool.type) & kRound) != 0 && tool.diameter <= 0)
    return fmt::format("a tool of type {} needs a diameter", name);
  if (tool.type == form && tool.profile.size() < 2)
    return "a tool of type form needs a profile of two points or more";
  if (tool.type == bullmill && tool.corner_radius <= 0)
    return "a tool of type bullmill needs a corner_radius";
  if ((bits(tool.type) & kRound) != 0 && tool.corner_radius > largest_corner(tool))
    return fmt::format("corner_radius {:g} mm is larger than the tool's radius {:g} mm",
                       tool.corner_radius, radius);
  const bool round_insert =
      !tool.insert.empty() && (tool.insert.front() == 'R' || tool.insert.front() == 'r');
  if (is_turning(tool.type) && tool.diameter > 0 && !round_insert)
    return "a diameter describes a round insert: give insert = \"R\", or leave it out";
  if (tool.type == grooving && tool.width <= 0) return "a tool of type grooving needs a width";
  if (tool.tip_diameter > tool.diameter)
    return fmt::format("tip_diameter {:g} mm is larger than the diameter {:g} mm",
                       tool.tip_diameter, tool.diameter);
  return "";
}

}  // namespace mrsim
