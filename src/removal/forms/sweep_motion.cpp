#include "removal/forms/sweep_motion.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/simd/sweep_kernels.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// Extent of c + u cos t + v sin t + rise t for t in [0, sweep] along one axis.
void arc_extent(double c, double u, double v, double rise, double sweep, double& lo, double& hi) {
  const auto add = [&](double x) { lo = std::min(lo, x), hi = std::max(hi, x); };
  const SinCos e = sincos(sweep);
  add(c + u);
  add(c + u * e.cos + v * e.sin + rise * sweep);
  const double swing = std::sqrt(u * u + v * v);
  if (swing == 0) return;
  if (rise != 0 || sweep >= kTwoPi) {
    add(c - swing + std::min(0.0, rise * sweep));
    add(c + swing + std::max(0.0, rise * sweep));
    return;
  }
  double t = mrsim::atan2(v, u);
  if (t < 0) t += kTwoPi;
  if (t <= sweep) add(c + swing);
  t = t >= kPi ? t - kPi : t + kPi;
  if (t <= sweep) add(c - swing);
}

}  // namespace

bool runs_on_axis(const Motion& m) {
  const auto has_no_plan = [](const Vec3& v) { return v.x == 0 && v.y == 0; };
  return m.kind != MotionKind::arc && has_no_plan(m.start) && has_no_plan(m.end) &&
         has_no_plan(m.tool_axis);
}

Box3 path_bounds(const LocalMotion& l) {
  Box3 b;
  extend(b, l.start);
  if (!l.arc) {
    extend(b, l.end);
    return b;
  }
  for (int i = 0; i < 3; ++i) {
    double lo = component(b.lo, i), hi = component(b.hi, i);
    arc_extent(component(l.center, i), component(l.u, i), component(l.v, i), component(l.rise, i),
               l.sweep, lo, hi);
    component(b.lo, i) = lo;
    component(b.hi, i) = hi;
  }
  return b;
}

LocalMotion localized(const Motion& m, const ToolFrame* frame) {
  const auto in = [frame](const Vec3& p) { return frame != nullptr ? frame->in(p) : p; };
  LocalMotion l;
  l.arc = m.kind == MotionKind::arc;
  l.start = in(m.start);
  l.end = in(m.end);
  if (!l.arc) return l;
  const double way = m.sweep < 0 ? -1 : 1;
  l.sweep = way * m.sweep;
  l.center = in(m.center);
  const Vec3 axis = in(m.axis);
  l.u = l.start - l.center;
  l.u = l.u - dot(l.u, axis) * axis;
  l.v = way * cross(axis, l.u);
  l.rise = (m.rise / l.sweep) * axis;
  return l;
}

double lowest_tip(const LocalMotion& l) { return path_bounds(l).lo.z; }

Box3 sweep_bounds(const Profile& tool, const LocalMotion& l, const ToolFrame* frame) {
  return sweep_bounds(tool, path_bounds(l), frame);
}

Box3 sweep_bounds(const Profile& tool, Box3 b, const ToolFrame* frame) {
  const double r = tool.max_radius();
  b.lo = b.lo + Vec3{-r, -r, tool.bottom()};
  b.hi = b.hi + Vec3{r, r, tool.open_top() ? 0 : tool.top()};
  if (frame == nullptr) {
    if (tool.open_top()) b.hi.z = kInfinity;
    return b;
  }
  if (tool.open_top()) b.hi.z = b.hi.z < b.lo.z ? b.lo.z : b.hi.z;
  Box3 world;
  for (int k = 0; k < 8; ++k)
    extend(world,
           frame->out({k & 1 ? b.hi.x : b.lo.x, k & 2 ? b.hi.y : b.lo.y, k & 4 ? b.hi.z : b.lo.z}));
  // The tool's axis has a share of a world axis: there the open tool has no end.
  constexpr double kNoShare = 1e-12;
  for (int i = 0; tool.open_top() && i < 3; ++i) {
    const double way = component(frame->z, i);
    if (way > kNoShare) component(world.hi, i) = kInfinity;
    if (way < -kNoShare) component(world.lo, i) = -kInfinity;
  }
  return world;
}

void line_in_plan(const Vec3& a, const Vec3& b, double* c) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const bool moves = dx * dx + dy * dy > kNoTravel * kNoTravel;
  c[LineSlot::x] = a.x, c[LineSlot::y] = a.y;
  c[LineSlot::dx] = moves ? dx : 0, c[LineSlot::dy] = moves ? dy : 0;
}

void arc_in_plan(const LocalMotion& l, double* c) {
  const double r = std::sqrt(l.u.x * l.u.x + l.u.y * l.u.y);
  c[ArcSlot::x] = l.center.x, c[ArcSlot::y] = l.center.y, c[ArcSlot::radius] = r;
  const double turn = std::min(l.sweep, kTwoPi);
  const SinCos mid = sincos(turn / 2);
  const double inverse = r > 0 ? 1 / r : 0;
  c[ArcSlot::mx] = inverse * (mid.cos * l.u.x + mid.sin * l.v.x);
  c[ArcSlot::my] = inverse * (mid.cos * l.u.y + mid.sin * l.v.y);
  // Half the sweep is measured from the middle, so its sine and cosine are those of turn / 2.
  c[ArcSlot::cosine] = turn < kTwoPi ? mid.cos : -1;
  c[ArcSlot::sine] = turn < kTwoPi ? mid.sin : 0;
}

void keep_lowest_turn(LocalMotion& l) {
  const auto start_at = [&l](double t, double way) {
    const SinCos sc = sincos(t);
    const Vec3 u = l.u, v = l.v;
    l.u = sc.cos * u + sc.sin * v;
    l.v = way * (sc.cos * v - sc.sin * u);
    l.center = l.center + t * l.rise;
    l.rise = way * l.rise;
  };
  if (l.rise.z > 0) start_at(l.sweep, -1);
  if (l.sweep <= kTwoPi) return;
  start_at(l.sweep - kTwoPi, 1);
  l.sweep = kTwoPi;
}

}  // namespace mrsim
