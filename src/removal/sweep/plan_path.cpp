#include "removal/sweep/plan_path.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/columns/plan_foot.h"
#include "removal/columns/sweep_columns.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// A path and the heights of the tool's origin on it.
struct Seen {
  PlanPath path;
  double low = 0, high = 0;
};

Seen seen_line(const Vec3& start, const Vec3& travel) {
  Seen line;
  std::array<double, ArcSlot::low>& plan = line.path.plan;
  plan[LineSlot::x] = start.x, plan[LineSlot::y] = start.y;
  plan[LineSlot::dx] = travel.x, plan[LineSlot::dy] = travel.y;
  line.low = start.z + std::min(travel.z, 0.0), line.high = start.z + std::max(travel.z, 0.0);
  return line;
}

Seen seen_level(const HorizontalView& view) {
  Seen level;
  level.path.arc = view.arc;
  std::copy_n(view.plan, level.path.plan.size(), level.path.plan.begin());
  level.low = level.high = view.z;
  return level;
}

// About Z. A path of more than a turn is a whole one.
Seen seen_helix(const ToolPath& arc) {
  Seen helix;
  helix.path.arc = true;
  const SinCos half = sincos(std::min(arc.sweep, kTwoPi) / 2);
  const Vec3 middle = (1 / arc.radius) * (half.cos * arc.u + half.sin * arc.v);
  std::array<double, ArcSlot::low>& plan = helix.path.plan;
  plan[ArcSlot::x] = arc.center.x, plan[ArcSlot::y] = arc.center.y;
  plan[ArcSlot::radius] = arc.radius;
  plan[ArcSlot::mx] = middle.x, plan[ArcSlot::my] = middle.y;
  plan[ArcSlot::cosine] = half.cos, plan[ArcSlot::sine] = half.sin;
  const double rise = arc.sweep * arc.rise.z;
  helix.low = arc.center.z + std::min(rise, 0.0), helix.high = arc.center.z + std::max(rise, 0.0);
  return helix;
}

std::optional<Seen> seen(const SweepColumns& c, const SweepRef& ref) {
  if (ref.frame != 0) return {};
  switch (ref.kind) {
    case SweepKind::plane_line:
    case SweepKind::plane_arc:
    case SweepKind::profile:
      return seen_level(horizontal_view(c, ref));
    case SweepKind::ball_line: {
      const double* line = c.ball_lines[ref.row].c;
      return seen_line(
          {line[BallSlot::x], line[BallSlot::y], line[BallSlot::z] - line[BallSlot::radius]},
          line[BallSlot::length] *
              Vec3{line[BallSlot::ux], line[BallSlot::uy], line[BallSlot::slope]});
    }
    case SweepKind::path:
      if (c.paths.is_line(ref.row))
        return seen_line(c.paths.line(ref.row).start, c.paths.line(ref.row).travel);
      if (c.paths.arc(ref.row).horizontal) return seen_helix(c.paths.arc(ref.row));
      return {};
    default:
      return {};
  }
}

// Up to where the tool's widest place is a straight wall.
double wall_end(const Profile& tool) {
  double end = tool.widest();
  for (const ProfileEdge& edge : tool.edges())
    if (!edge.is_arc() && edge.a.y <= end + kRounding && edge.b.y > end &&
        std::min(edge.a.x, edge.b.x) >= tool.max_radius() - kRounding)
      end = edge.b.y;
  return end;
}

// Both outlines are the same up to their widest places.
bool have_one_nose(const Profile& a, const Profile& b) {
  if (a.max_radius() != b.max_radius() || a.widest() != b.widest()) return false;
  const std::size_t count = std::min(a.edges().size(), b.edges().size());
  for (std::size_t k = 0; k < count; ++k) {
    const ProfileEdge &e = a.edges()[k], &f = b.edges()[k];
    if (e.a.y >= a.widest()) return true;
    if (!(e.a == f.a && e.b == f.b && e.radius == f.radius && e.convex == f.convex)) return false;
  }
  return true;
}

}  // namespace

bool PlanPath::is_upright() const {
  return !arc && plan[LineSlot::dx] == 0 && plan[LineSlot::dy] == 0;
}

bool holds_nose(const PlanPath& cut, const PlanPath& mover) {
  return cut.is_upright() && mover.is_upright() && mover.tool->is_unimodal() &&
         cut.plan[LineSlot::x] == mover.plan[LineSlot::x] &&
         cut.plan[LineSlot::y] == mover.plan[LineSlot::y] && cut.low <= mover.low &&
         mover.low + mover.tool->widest() <= cut.to && have_one_nose(*cut.tool, *mover.tool);
}

double PlanPath::distance(const Vec3& p) const {
  return (arc ? lane::arc_rho(plan.data(), p.x, p.y) : lane::line_rho(plan.data(), p.x, p.y)) -
         radius;
}

Vec3 PlanPath::out(const Vec3& p) const {
  const PlanFoot foot = plan_foot({arc, plan.data(), 0}, p, Half::any);
  if (!(foot.rho > 0)) return {1, 0, 0};
  return {(p.x - foot.x) / foot.rho, (p.y - foot.y) / foot.rho, 0};
}

std::optional<PlanPath> plan_path(const SweepTable& sweeps, std::uint32_t i) {
  const SweepColumns& c = sweeps.columns();
  const SweepRef& ref = c.refs[i];
  const std::optional<Seen> found = seen(c, ref);
  if (!found) return {};
  PlanPath path = found->path;
  const Profile& tool = c.cutter(ref);
  path.tool = &tool;
  path.low = found->low;
  path.radius = tool.max_radius();
  path.round = tool.is_end_mill() ? tool.round() : 0;
  path.from = found->high + (tool.is_end_mill() ? 0 : tool.widest());
  path.to = found->low + wall_end(tool);
  return path;
}

}  // namespace mrsim
