#include "run/findings/assumed_sizes.h"

#include "core/numbers/motions.h"
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/words/tool_types.h"
#include "removal/forms/sweep_motion.h"
#include "removal/tool/tool.h"
#include "run/findings/part_findings.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

// For each tool from its lowest cut up to the top, or to where the highest cut begins or ends.
std::vector<double> heights_of_cuts(const Program& program, std::optional<double> stock_top) {
  std::vector<double> heights(program.tools.size(), kInfinity);
  double top = program.zero_height;
  for (const Motion& m : program.motions) {
    if (!is_cut(m) || m.tool < 0) continue;
    const Box3 path = path_bounds(localized(m, nullptr));
    double& lowest = heights[static_cast<std::size_t>(m.tool)];
    lowest = std::min(lowest, path.lo.z);
    top = std::max(top, path.hi.z);
  }
  for (double& height : heights) height = height < kInfinity ? stock_top.value_or(top) - height : 0;
  return heights;
}

// What a tool cuts, in mm.
struct InsertReach {
  double lead = 0, radius = 0;  // largest ones
};

std::vector<InsertReach> reaches(const Program& program) {
  std::vector<InsertReach> reaches(program.tools.size());
  for (const Motion& m : program.motions) {
    if (!is_cut(m) || m.tool < 0) continue;
    InsertReach& reach = reaches[static_cast<std::size_t>(m.tool)];
    reach.lead = std::max(reach.lead, std::fabs(m.lead));
    reach.radius = std::max({reach.radius, std::fabs(m.start.x), std::fabs(m.end.x)});
  }
  return reaches;
}

void complete_insert(Tool& tool, const InsertReach& reach) {
  constexpr double kEdge = 16, kLeastEdge = 1;  // mm
  constexpr double kWidthPerNose = 4;           // a flank is left beside the rounding of 60 degrees
  if (tool.edge_length > 0) return;
  const bool tooth =
      tool.type == ToolType::threading && tool.lead_angle <= 0 && tool.insert.empty();
  if (tooth && tool.width <= 0 && reach.lead > 0)
    tool.width = std::max(reach.lead, kWidthPerNose * tool.nose_radius);
  if (!is_inside_tool(tool) || reach.radius <= 0) return;
  const double least = std::max({kLeastEdge, tool.width, 4 * tool.nose_radius});
  tool.edge_length = std::clamp(reach.radius, least, std::max(kEdge, least));
}

}  // namespace

bool is_open_cone(const Tool& tool) {
  return (tool.type == ToolType::taper && !(tool.flute_length > 0) && !(tool.tip_diameter > 0)) ||
         (tool.type == ToolType::chamfer && !(tool.diameter > 0));
}

void close_cone(Tool& tool, double height) {
  constexpr double kLeast = 1;  // mm
  height = std::max(height, tool.corner_radius + kLeast);
  if (tool.type == ToolType::taper) {
    tool.flute_length = height;
    return;
  }
  const SinCos half = sincos(tool.tip_angle > 0 ? tool.tip_angle / 2 : tool.taper_angle);
  tool.diameter = tool.tip_diameter + 2 * height * half.sin / half.cos;
}

void complete_cones(JobResult& result, std::optional<double> top) {
  Program& program = result.program;
  if (std::none_of(program.tools.begin(), program.tools.end(), is_open_cone)) return;
  const std::vector<double> heights = heights_of_cuts(program, top);
  for (std::size_t i = 0; i < program.tools.size(); ++i) {
    Tool& tool = program.tools[i];
    if (!is_open_cone(tool)) continue;
    const double height = std::ceil(10 * heights[i]) / 10;
    close_cone(tool, height);
    report(
        result, Severity::note, "cone-assumed",
        fmt::format("tool {}: how far its cone reaches is not told: it is taken to be as high as "
                    "the program cuts, {:.4g} mm; --tool {}={} says what it is",
                    tool.id, height, tool.id,
                    tool.type == ToolType::taper ? "taper:...,l=" : "chamfer:...,d="));
  }
}

void complete_inserts(Program& program) {
  const std::vector<InsertReach> cuts = reaches(program);
  for (std::size_t i = 0; i < cuts.size(); ++i)
    if (is_turning(program.tools[i].type)) complete_insert(program.tools[i], cuts[i]);
}

}  // namespace mrsim
