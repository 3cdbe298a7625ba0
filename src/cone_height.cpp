#include "cone_height.h"

#include "core/rounding.h"
#include "core/trig.h"
#include "part_findings.h"
#include "removal/forms/sweep_motion.h"
#include "removal/part/default_stock.h"

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

}  // namespace mrsim
