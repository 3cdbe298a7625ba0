#include "removal/sweep/plan_foot.h"

#include "removal/simd/lane_scalar.h"

#include <cmath>

namespace mrsim {
namespace {

PlanFoot line_foot(const double* c, const Vec3& p) {
  const lane::PlanLineFoot f = lane::line_foot(c, p.x, p.y);
  return {c[0] + f.t * c[2], c[1] + f.t * c[3], std::sqrt(f.squared), 0};
}

PlanFoot arc_foot(const double* c, const Vec3& p, Half wanted) {
  const double dx = p.x - c[0], dy = p.y - c[1];
  const double a = dx * c[3] + dy * c[4], off = dy * c[3] - dx * c[4];
  PlanFoot f;
  f.rho = lane::arc_rho(c, p.x, p.y);
  f.half = wanted == Half::any ? (off > 0 ? 1 : 0) : wanted == Half::second ? 1 : 0;
  const bool within = c[5] * (off < 0 ? -off : off) - c[6] * a <= 0;
  const double n = std::sqrt(dx * dx + dy * dy);
  if (within && n > 0) {
    f.x = c[0] + c[2] / n * dx, f.y = c[1] + c[2] / n * dy;
    return f;
  }
  const double ea = c[2] * c[5], eb = c[2] * c[6] * (f.half == 1 ? 1 : -1);
  f.x = c[0] + ea * c[3] - eb * c[4], f.y = c[1] + ea * c[4] + eb * c[3];
  return f;
}

}  // namespace

LevelView level_view(const SweepColumns& c, const SweepRef& ref) {
  LevelView v;
  if (ref.kind == SweepKind::plane_line) {
    v.plan = c.plane_lines[ref.row].c;
    v.z = v.plan[4] - v.plan[6];
  } else if (ref.kind == SweepKind::plane_arc) {
    v.arc = true;
    v.plan = c.plane_arcs[ref.row].c;
    v.z = v.plan[7] - v.plan[9];
  } else {
    const ProfileRow& row = c.profiles[ref.row];
    v.arc = row.arc;
    v.plan = row.c;
    v.z = row.z;
  }
  return v;
}

PlanFoot plan_foot(const LevelView& v, const Vec3& p, Half half) {
  return v.arc ? arc_foot(v.plan, p, half) : line_foot(v.plan, p);
}

}  // namespace mrsim
