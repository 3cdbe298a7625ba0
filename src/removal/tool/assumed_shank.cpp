#include "removal/tool/assumed_shank.h"

#include "core/process/error.h"
#include "core/words/tool_types.h"
#include "removal/tool/tool.h"

#include <optional>

namespace mrsim {
namespace {

// Necks are ground thinner than their cutters. So an assumed shank stays clear of the walls that
// its cutter has just cut, and what it meets is solid.
constexpr double kShareOfCutter = 0.95;

// By the diameter of the cutter: a roof over the flutes begins right above them.
constexpr double kShankLength = 10;

// The outline of a mill whose cutter ends below, and that has neither shank nor holder.
std::optional<Profile> bare_cutter(const Tool& tool) {
  if (is_turning(tool.type) || !tool.shank.empty() || !tool.holder.empty()) return {};
  try {
    Profile cutter = make_cutter(tool);
    if (cutter.open_top()) return {};
    return cutter;
  } catch (const Error&) {  // a tool that moves in rapids only; the search tells it
    return {};
  }
}

double shank_of(const Tool& tool, const Profile& cutter) {
  const ProfileEdge& top = cutter.edges().back();
  if (tool.type == ToolType::lollipop) return top.is_arc() ? 0 : 2 * top.a.x;  // the ball's neck
  if (ends_in_head(tool)) return tool.neck_diameter;
  return 2 * kShareOfCutter * top.a.x;
}

}  // namespace

double assumed_shank(const Tool& tool) {
  const std::optional<Profile> cutter = bare_cutter(tool);
  return cutter ? shank_of(tool, *cutter) : 0;
}

bool has_unknown_neck(const Tool& tool) {
  const std::optional<Profile> cutter = bare_cutter(tool);
  return cutter && shank_of(tool, *cutter) <= 0;
}

std::vector<Tool> with_shanks(std::span<const Tool> tools) {
  std::vector<Tool> out(tools.begin(), tools.end());
  for (Tool& tool : out) {
    const std::optional<Profile> cutter = bare_cutter(tool);
    const double shank = cutter ? shank_of(tool, *cutter) : 0;
    if (shank > 0) tool.shank.push_back({shank, shank, kShankLength * 2 * cutter->max_radius()});
  }
  return out;
}

}  // namespace mrsim
