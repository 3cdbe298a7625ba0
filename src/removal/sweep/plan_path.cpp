#include "removal/sweep/plan_path.h"

#include "removal/columns/plan_foot.h"
#include "removal/columns/sweep_columns.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>

namespace mrsim {
namespace {

PlanPath line_path(const Vec3& start, const Vec3& travel) {
  PlanPath path;
  path.plan[LineSlot::x] = start.x, path.plan[LineSlot::y] = start.y;
  path.plan[LineSlot::dx] = travel.x, path.plan[LineSlot::dy] = travel.y;
  return path;
}

PlanPath level_path(const SweepColumns& c, const SweepRef& ref) {
  const HorizontalView view = horizontal_view(c, ref);
  PlanPath path;
  path.arc = view.arc;
  std::copy_n(view.plan, path.plan.size(), path.plan.begin());
  path.is_level = c.cutter(ref).is_end_mill();
  path.tip = view.z, path.top = view.z + c.cutter(ref).top();
  return path;
}

std::optional<PlanPath> path_of(const SweepColumns& c, const SweepRef& ref) {
  if (ref.frame != 0) return {};
  switch (ref.kind) {
    case SweepKind::plane_line:
    case SweepKind::plane_arc:
    case SweepKind::profile:
      return level_path(c, ref);
    case SweepKind::ball_line: {
      const double* line = c.ball_lines[ref.row].c;
      return line_path({line[BallSlot::x], line[BallSlot::y], 0},
                       line[BallSlot::length] * Vec3{line[BallSlot::ux], line[BallSlot::uy], 0});
    }
    case SweepKind::path:
      if (!c.paths.is_line(ref.row)) return {};
      return line_path(c.paths.line(ref.row).start, c.paths.line(ref.row).travel);
    default:
      return {};
  }
}

}  // namespace

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
  std::optional<PlanPath> path = path_of(c, ref);
  if (!path) return path;
  const Profile& tool = c.cutter(ref);
  path->shape = ref.shape;
  path->radius = tool.max_radius();
  path->round = tool.is_end_mill() ? tool.round() : 0;
  return path;
}

}  // namespace mrsim
