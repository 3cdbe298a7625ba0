#include "run/findings/feed_sides.h"

#include "core/numbers/motions.h"
#include "core/words/tool_types.h"
#include "removal/part/bar_signs.h"
#include "removal/part/stock_margin.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

// What a tool's cuts say of its direction.
struct FeedSide {
  bool to_minus = false;         // of any cut
  bool enters_to_minus = false;  // of straight ones that a rapid leads to
  const Motion* enters_to_plus = nullptr;
};

std::vector<FeedSide> feed_sides(const Program& program) {
  std::vector<FeedSide> sides(program.tools.size());
  const double air = air_radius(program.motions) - kSameHeight;
  bool after_cut = false;
  for (const Motion& m : program.motions) {
    const bool from_rapid = !after_cut;
    after_cut = is_cut(m);
    if (!after_cut || m.tool < 0 || m.lead != 0) continue;
    FeedSide& side = sides[static_cast<std::size_t>(m.tool)];
    const double rise = m.end.z - m.start.z;
    if (rise < 0) side.to_minus = true;
    if (!is_upright_line(m) || !from_rapid) continue;
    if (rise < 0) side.enters_to_minus = true;
    const bool enters = rise > 0 && std::fabs(m.start.x) < air;  // not a way back
    if (enters && !side.enters_to_plus) side.enters_to_plus = &m;
  }
  return sides;
}

// Whether the insert would cut another shape as a left-hand one.
bool has_right_hand(const Tool& tool) {
  const int tip = tip_orientation(tool);
  const bool is_insert = tool.type == ToolType::turning || tool.type == ToolType::boring;
  const bool is_round = tool.diameter > 0 || tool.insert.starts_with('R');
  return is_insert && !is_round && !tool.tip_is_nose_centre && (tip == 2 || tip == 3);
}

// Blades that stand along Z have orientation 5 or 7.
bool stands_along_x(const Tool& tool) {
  const int tip = tip_orientation(tool);
  return tool.type == ToolType::grooving && tip != 5 && tip != 7;
}

// What is there beside a blade outside: the radius of its last pass along Z, and how deep it went.
struct Layer {
  double radius = 0, low = 0;
};

// Whether the blade's edge takes all that lies outside of the pass, as in turning.
bool turns_layer(const Motion& m, const Tool& tool, const Layer& layer) {
  const double height = layer.radius - std::fabs(m.start.x);
  return !is_inside_tool(tool) && height > -kSameHeight && height < tool.width + kSameHeight &&
         layer.low < m.end.z + kSameHeight;
}

void warn(Program& program, const Motion& m, const char* code, std::string text) {
  Diagnostic& d = program.diagnostics.emplace_back();
  d.severity = Severity::warning;
  d.code = code;
  d.text = std::move(text);
  d.place = source_place(program, m);
}

}  // namespace

void turn_drills_round(Program& program) {
  if (program.machine != MachineKind::lathe) return;
  const std::vector<FeedSide> sides = feed_sides(program);
  std::vector<bool> turned(sides.size(), false);
  for (std::size_t i = 0; i < sides.size(); ++i)
    turned[i] = !is_turning(program.tools[i].type) && sides[i].enters_to_plus != nullptr &&
                !sides[i].enters_to_minus;
  for (Motion& m : program.motions)
    if (m.tool >= 0 && turned[static_cast<std::size_t>(m.tool)]) m.tool_axis = {0, 0, -1};
}

void warn_of_hands(JobResult& result) {
  Program& program = result.program;
  if (program.machine != MachineKind::lathe) return;
  const std::vector<FeedSide> sides = feed_sides(program);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Tool& tool = program.tools[i];
    const Motion* first = sides[i].enters_to_plus;
    if (first == nullptr || sides[i].to_minus || !has_right_hand(tool)) continue;
    warn(program, *first, "insert-hand",
         fmt::format(
             "tool {} cuts towards +Z alone and is read as a right-hand insert, whose trailing "
             "edge cuts there; of a left-hand one say hand = \"left\", or LEFT HAND in its comment",
             tool.id));
  }
}

void warn_of_blades(JobResult& result) {
  Program& program = result.program;
  if (program.machine != MachineKind::lathe) return;
  const Box3& stock = result.stock.box;
  const Layer bar{std::max(stock.hi.x, -stock.lo.x), kNoHeight};
  std::vector<bool> told(program.tools.size(), false);
  std::vector<Layer> layers(program.tools.size(), bar);
  for (std::size_t i = 1; i + 1 < program.motions.size(); ++i) {
    const Motion &m = program.motions[i], &next = program.motions[i + 1];
    const bool plunges = is_cut(m) && !is_cut(program.motions[i - 1]) && is_upright_line(m) &&
                         m.end.z < m.start.z && m.tool >= 0;
    if (!plunges) continue;
    const auto index = static_cast<std::size_t>(m.tool);
    const Tool& tool = program.tools[index];
    const bool turns = turns_layer(m, tool, bar) || turns_layer(m, tool, layers[index]);
    layers[index] = {std::fabs(m.start.x), m.end.z};
    const bool goes_back = is_upright_line(next) && next.end.z > next.start.z;
    if (!goes_back || turns || told[index] || !stands_along_x(tool)) continue;
    told[index] = true;
    warn(program, m, "blade-direction",
         fmt::format("tool {0} goes straight in and out along Z, as the blade of a face groove "
                     "does, and is read as a blade that stands along X; --tool "
                     "{0}=grooving:w={1:g},tip=7 stands along Z, its middle the programmed point",
                     tool.id, tool.width));
  }
}

}  // namespace mrsim
