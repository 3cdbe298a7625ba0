#include "removal/columns/plan_foot.h"

#include "removal/simd/scalar_forms.h"

#include <cmath>

namespace mrsim {
namespace {

PlanFoot line_foot(const double* c, const Vec3& p) {
  const lane::PlanLineFoot f = lane::line_foot(c, p.x, p.y);
  return {c[LineSlot::x] + f.t * c[LineSlot::dx], c[LineSlot::y] + f.t * c[LineSlot::dy],
          std::sqrt(f.squared), 0};
}

PlanFoot arc_foot(const double* c, const Vec3& p, Half wanted) {
  const double dx = p.x - c[ArcSlot::x], dy = p.y - c[ArcSlot::y];
  const double a = dx * c[ArcSlot::mx] + dy * c[ArcSlot::my],
               off = dy * c[ArcSlot::mx] - dx * c[ArcSlot::my];
  PlanFoot f;
  f.rho = lane::arc_rho(c, p.x, p.y);
  f.half = wanted == Half::any ? (off > 0 ? 1 : 0) : wanted == Half::second ? 1 : 0;
  const bool within = c[ArcSlot::cosine] * (off < 0 ? -off : off) - c[ArcSlot::sine] * a <= 0;
  const double n = std::sqrt(dx * dx + dy * dy);
  if (within && n > 0) {
    f.x = c[ArcSlot::x] + c[ArcSlot::radius] / n * dx,
    f.y = c[ArcSlot::y] + c[ArcSlot::radius] / n * dy;
    return f;
  }
  const double ea = c[ArcSlot::radius] * c[ArcSlot::cosine],
               eb = c[ArcSlot::radius] * c[ArcSlot::sine] * (f.half == 1 ? 1 : -1);
  f.x = c[ArcSlot::x] + ea * c[ArcSlot::mx] - eb * c[ArcSlot::my],
  f.y = c[ArcSlot::y] + ea * c[ArcSlot::my] + eb * c[ArcSlot::mx];
  return f;
}

}  // namespace

HorizontalView horizontal_view(const SweepColumns& c, const SweepRef& ref) {
  HorizontalView v;
  if (ref.kind == SweepKind::plane_line) {
    v.plan = c.plane_lines[ref.row].c;
    v.z = v.plan[LineSlot::low] - v.plan[LineSlot::round];
  } else if (ref.kind == SweepKind::plane_arc) {
    v.arc = true;
    v.plan = c.plane_arcs[ref.row].c;
    v.z = v.plan[ArcSlot::low] - v.plan[ArcSlot::round];
  } else {
    const ProfileRow& row = c.profiles[ref.row];
    v.arc = row.arc;
    v.plan = row.c;
    v.z = row.z;
  }
  return v;
}

PlanFoot plan_foot(const HorizontalView& v, const Vec3& p, Half half) {
  return v.arc ? arc_foot(v.plan, p, half) : line_foot(v.plan, p);
}

}  // namespace mrsim
