#include "insert_size.h"

#include "core/tip_orientation.h"
#include "removal/part/default_stock.h"
#include "removal/tool/tool.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mrsim {
namespace {

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

void complete_inserts(Program& program) {
  const std::vector<InsertReach> cuts = reaches(program);
  for (std::size_t i = 0; i < cuts.size(); ++i)
    if (is_turning(program.tools[i].type)) complete_insert(program.tools[i], cuts[i]);
}

}  // namespace mrsim
