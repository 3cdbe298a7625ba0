#include "run/tools/tool_outlines.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/tool/tool.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

using Points = std::vector<std::array<double, 2>>;

void add_edge(const ProfileEdge& e, double top, Points& out) {
  if (e.radius > 0) {
    constexpr int kSteps = 24;
    const double from = atan2(e.a.y - e.center.y, e.a.x - e.center.x);
    double turn = atan2(e.b.y - e.center.y, e.b.x - e.center.x) - from;
    if (e.convex && turn < 0) turn += kTwoPi;
    if (!e.convex && turn > 0) turn -= kTwoPi;
    for (int i = 1; i < kSteps; ++i) {
      const SinCos sc = sincos(from + turn * i / kSteps);
      out.push_back({e.center.x + e.radius * sc.cos, e.center.y + e.radius * sc.sin});
    }
  }
  out.push_back({e.b.x, std::isinf(e.b.y) ? top : e.b.y});
}

double stack(const std::vector<ToolSegment>& segments, double z, const char* part,
             std::vector<ToolOutline>& out) {
  for (const ToolSegment& s : segments) {
    const double top = z + s.length;
    out.push_back({part, {{s.diameter_low / 2, z}, {s.diameter_high / 2, top}}, 0, false});
    z = top;
  }
  return z;
}

double drawn_top(const Profile& cutter) {
  if (!std::isinf(cutter.top())) return cutter.top();
  double top = 3 * cutter.max_radius();
  for (const ProfileEdge& e : cutter.edges())
    if (!std::isinf(e.b.y)) top = std::max(top, e.b.y * 1.2);
  return top;
}

}  // namespace

std::vector<ToolOutline> tool_outlines(const Tool& tool) {
  const ToolShape shape = make_tool_shape(tool);
  if (shape.turning) {
    ToolOutline insert{"insert", {}, shape.insert.round, true};
    for (const Vec2 p : shape.insert.core) insert.points.push_back({p.x, p.y});
    return {insert};
  }
  const double top = drawn_top(shape.cutter);
  const Vec2 tip = shape.cutter.edges().front().a;
  ToolOutline cutter{"cutter", {{tip.x, tip.y}}, 0, false};
  for (const ProfileEdge& e : shape.cutter.edges()) add_edge(e, top, cutter.points);
  std::vector<ToolOutline> out{cutter};
  stack(tool.holder, stack(tool.shank, top, "shank", out), "holder", out);
  return out;
}

}  // namespace mrsim
