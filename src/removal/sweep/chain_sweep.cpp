#include "removal/sweep/chain_sweep.h"

#include "removal/simd/lane_scalar.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr std::size_t kMostEdges = 12;

bool is_half_turn(const ProfileEdge& e) {
  return e.radius > 0 && !(cross(e.a - e.center, e.b - e.center) > 0);
}

// [disc] [ball or nose], from pointing down.
void set_tip(const std::vector<ProfileEdge>& edges, ChainTool& c) {
  std::size_t k = 0;
  c.tip = edges[0].a.y;
  if (edges[0].radius == 0 && edges[0].direction.y == 0) c.core = edges[k++].b.x;
  if (k == edges.size()) return;
  const ProfileEdge& e = edges[k];
  c.tipped = true;
  if (e.radius > 0 && e.center.x == c.core) {
    c.tip = e.center.y, c.ball = e.radius, c.last = e.b - e.center;
  } else {
    c.tipped = e.radius == 0;
    c.last = {e.direction.y, -e.direction.x};
  }
}

}  // namespace

ChainTool chain_tool(const Profile& tool) {
  ChainTool c;
  const std::vector<ProfileEdge>& edges = tool.edges();
  if (!tool.is_convex() || edges.size() > kMostEdges || (tool.is_rounded() && tool.is_rising()) ||
      std::any_of(edges.begin(), edges.end(), is_half_turn))
    return c;
  c.edges = edges.data(), c.count = edges.size();
  set_tip(edges, c);
  c.radius = tool.max_radius(), c.bottom = tool.bottom(), c.top = tool.top();
  for (std::size_t i = 0; i < edges.size() && c.flank_count < kMostFlanks; ++i) {
    const double across = edges[i].direction.y, up = -edges[i].direction.x;
    if (edges[i].radius > 0 || across <= 0) continue;
    c.flanks[c.flank_count++] = {i, across, up, across * edges[i].a.x + up * edges[i].a.y};
  }
  return c;
}

ChainLine chain_line(const ChainTool& tool, const ToolPath& path) {
  ChainLine line;
  const Vec3& way = path.travel;
  line.x = path.start.x, line.y = path.start.y, line.z = path.start.z;
  line.plan = std::sqrt(way.x * way.x + way.y * way.y), line.rise = way.z;
  if (line.plan == 0) return line;
  line.ux = way.x / line.plan, line.uy = way.y / line.plan;
  line.per_plan = 1 / line.plan;
  line.per_way = 1 / (line.plan * line.plan + line.rise * line.rise);
  for (std::size_t i = 0; i < tool.flank_count; ++i) {
    // Across the move: along * plan + up * rise = 0.
    const double slope = tool.flanks[i].up * line.rise / line.plan, across = tool.flanks[i].across;
    line.steep[i] = !(across * across > slope * slope);
    if (!line.steep[i]) line.tilt[i] = -slope / std::sqrt(across * across - slope * slope);
  }
  return line;
}

double chain_bound(const ChainTool& tool, const ChainLine& line, const Vec3& p, double limit) {
  const lane::ChainView at = lane::chain_view(line, p.x, p.y, p.z);
  double bound = lane::ends_bound(tool, line, at);
  if (bound <= limit && tool.tipped) bound = std::max(bound, lane::tip_bound(tool, line, at));
  for (std::size_t i = 0; i < tool.flank_count && bound <= limit; ++i)
    bound = std::max(bound, lane::flank_place(tool, line, at, i).f);
  return bound;
}

PathSample chain_minimum(const ChainTool& tool, const ChainLine& line, const Vec3& p,
                         double limit) {
  const lane::ChainObjective F{tool, line, lane::chain_view(line, p.x, p.y, p.z)};
  const lane::ChainPlace least = lane::chain_least(F, limit, true);
  return {least.f, least.t};
}

}  // namespace mrsim
