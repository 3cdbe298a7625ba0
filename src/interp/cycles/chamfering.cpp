#include "interp/cycles/chamfering.h"

#include "core/numbers/tool_point.h"
#include "core/numbers/trig.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kNearestAxis = 1e-3;  // mm from the wall, because no path may run on the contour

}  // namespace

double cone_of(const Tool& tool) {
  if (tool.type != ToolType::chamfer && tool.type != ToolType::drill) return 0;
  return point_half_angle(tool);
}

// The cone meets the wall at the foot of the chamfer. The wider it is at the edge, the farther its
// axis is from the wall.
std::optional<Chamfering::Cut> Chamfering::cut(const CycleCall& call, double edge, double down,
                                               const Word& where) {
  tools_.require(where, true);
  const Tool* tool = tools_.current();
  const double half = tool ? cone_of(*tool) : 0, size = std::abs(call.get("FS")) * scale();
  if (half <= 0) {
    error("tool-unknown",
          fmt::format("{} chamfers: it needs a cutter with a cone, a chamfer mill or a spot drill",
                      call.shown()),
          where);
    return std::nullopt;
  }
  const double given = call.get("ZFS") * scale();
  const double depth = call.digit("AMODE", 2) == 1 ? std::abs(given) : (given - edge) * down;
  const SinCos cone = sincos(half);
  Cut out;
  out.bottom = edge + down * depth;
  out.aside = tool->tip_diameter / 2 + depth * cone.sin / cone.cos - size;
  if (size <= 0 || depth <= 0 || out.aside < 0) {
    error("value-range",
          fmt::format("{}: the chamfer FS is {:g} mm wide, and with its tip {:g} mm deep (ZFS) the "
                      "tool does not reach its foot",
                      call.shown(), size, depth),
          where);
    return std::nullopt;
  }
  out.aside = std::max(out.aside, kNearestAxis);
  return out;
}

}  // namespace mrsim
