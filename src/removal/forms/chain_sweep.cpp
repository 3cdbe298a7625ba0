#include "removal/forms/chain_sweep.h"

#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr std::size_t kMostEdges = 12;

bool is_half_turn(const ProfileEdge& e) {
  return e.radius > 0 && !(cross(e.a - e.center, e.b - e.center) > 0);
}

// The lower end of the profile, from its first edge on: a disc or none, then a ball, a rounded nose
// or none.
void set_tip(const std::vector<ProfileEdge>& edges, ChainTool& c) {
  std::size_t k = 0;
  c.tip = edges[0].a.y;
  if (edges[0].radius == 0 && edges[0].direction.y == 0) c.core = edges[k++].b.x;
  if (k == edges.size()) return;
  const ProfileEdge& e = edges[k];
  c.tipped = true;
  if (e.radius > 0 && e.center.x == c.core) {
    c.tip = e.center.y, c.ball = e.radius, c.last = e.b - e.center;
    // A lollipop's ball goes on above its equator.
    const auto goes_on = [&](const ProfileEdge& next) {
      return next.radius == e.radius && next.center.x == 0 && next.center.y == e.center.y;
    };
    while (++k < edges.size() && goes_on(edges[k])) c.last = edges[k].b - e.center;
  } else {
    c.tipped = e.radius == 0;
    c.last = {e.direction.y, -e.direction.x};
  }
}

// Where on the move an edge of the tool touches p.
struct EdgeContact {
  double t = 0, across = 0, up = 0, distance = 0;  // place, outward normal, signed distance
  bool fits = false;                               // p is seen from within the edge's ends
};

EdgeContact flank_contact(const ChainTool& tool, const ChainLine& line, const lane::ChainView& at,
                          std::size_t i) {
  const ChainTool::Flank& flank = tool.flanks[i];
  const ProfileEdge& e = tool.edges[flank.edge];
  const lane::FlankPlace x = lane::flank_place(tool, lane::OneChain{line}, at, i);
  const double along = dot(e.direction, Vec2{x.rho, x.z} - e.a);
  return {x.t, flank.across, flank.up, x.f, along >= 0 && along <= e.length};
}

// Where the ball at the tip touches, about the axis.
EdgeContact ball_contact(const ChainTool& tool, const ChainLine& line, const lane::ChainView& at) {
  const double h = at.w - tool.tip;
  const double t = std::clamp((at.u * line.plan + h * line.rise) * line.per_way, 0.0, 1.0);
  const double along = at.u - t * line.plan, up = h - t * line.rise;
  const double aside = std::sqrt(along * along + at.v * at.v);
  const double off = std::sqrt(aside * aside + up * up);
  if (!(off > 0)) return {t, 1, 0, -tool.ball, true};
  return {t, aside / off, up / off, off - tool.ball, up * tool.last.x <= aside * tool.last.y};
}

}  // namespace

ChainTool chain_tool(const Profile& tool) {
  ChainTool c;
  const std::vector<ProfileEdge>& edges = tool.edges();
  if (!tool.is_convex() || edges.size() > kMostEdges || (tool.is_end_mill() && tool.is_rising()) ||
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
    const double left = across * across - slope * slope;
    line.tilt[i] = left > 0 ? -slope / std::sqrt(left) : std::numeric_limits<double>::infinity();
  }
  return line;
}

PathSample chain_minimum(const ChainTool& tool, const ChainLine& line, const Vec3& p,
                         double limit) {
  const lane::ChainObjective F{tool, line, lane::chain_view(lane::OneChain{line}, p.x, p.y, p.z)};
  const lane::ChainPlace least = lane::chain_least(F, limit, true);
  return {least.f, least.t};
}

std::optional<FacePlane> chain_face(const ChainTool& tool, const ChainLine& line, const Vec3& p,
                                    std::int32_t patch) {
  const lane::ChainView at = lane::chain_view(lane::OneChain{line}, p.x, p.y, p.z);
  EdgeContact found;
  int edges = 0, closed = 0, fitting = 0;
  const auto take = [&](const EdgeContact& contact) {
    ++closed;
    if (contact.fits) ++fitting;
    if (contact.fits || closed == 1) found = contact;
  };
  for (std::size_t k = 0; k < tool.count; ++k) edges += tool.edges[k].patch == patch ? 1 : 0;
  for (std::size_t i = 0; i < tool.flank_count; ++i)
    if (tool.edges[tool.flanks[i].edge].patch == patch) take(flank_contact(tool, line, at, i));
  if (tool.core == 0 && tool.ball > 0 && tool.edges[0].patch == patch)
    take(ball_contact(tool, line, at));
  const bool alone = edges == 1 && closed == 1;
  const bool sure = fitting == 1 && (closed == edges || found.distance >= 0);
  if (!alone && !sure) return std::nullopt;
  const double x = p.x - line.x - found.t * line.plan * line.ux;
  const double y = p.y - line.y - found.t * line.plan * line.uy;
  const double rho = std::sqrt(x * x + y * y);
  const Vec2 out = rho > 0 ? Vec2{x / rho, y / rho} : Vec2{1, 0};
  return FacePlane{{found.across * out.x, found.across * out.y, found.up}, found.distance};
}

}  // namespace mrsim
