// Independent, slow answers for the sweep tests: tools at rest by dense samples of their outline,
// sweeps by dense samples of their path; a deterministic random source.
#pragma once

#include "core/numbers/units.h"
#include "removal/forms/path_sweep.h"
#include "removal/sweep/sweep_table.h"
#include "removal/tool/tool.h"
#include "support/moves.h"
#include "support/random.h"
#include "support/tools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <vector>

namespace mrsim::testing {

inline Vec3 at(const Motion& m, double t) {
  if (m.kind == MotionKind::line) return m.start + t * (m.end - m.start);
  return m.center + turned(m.start - m.center, m.axis, t * m.sweep) + (t * m.rise) * m.axis;
}

inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Least value over t in [0, 1]: dense samples, then ever finer ones about the best few.
inline double least(const std::function<double(double)>& f, int samples = 4000) {
  std::vector<std::pair<double, double>> all;
  for (int i = 0; i <= samples; ++i) all.push_back({f(i / double(samples)), i / double(samples)});
  double best = 1e300;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && all[i - 1].first < all[i].first) continue;
    if (i + 1 < all.size() && all[i + 1].first < all[i].first) continue;
    double lo = std::max(0.0, all[i].second - 1.0 / samples);
    double hi = std::min(1.0, all[i].second + 1.0 / samples);
    for (int k = 0; k < 90; ++k) {  // golden section
      const double a = lo + 0.382 * (hi - lo), b = lo + 0.618 * (hi - lo);
      (f(a) < f(b) ? hi : lo) = f(a) < f(b) ? b : a;
    }
    best = std::min({best, all[i].first, f(0.5 * (lo + hi))});
  }
  return best;
}

/// A move between two places at most `wide` mm from the Z axis in x and in y: 0 a level line, 1 a
/// plunge, 2 a slanted line, 3 an arc, 4 a helix, 5 an arc in G18, 6 a helix about a leaning axis.
inline Motion move_of_kind(Random& r, int kind, double wide = 10) {
  const Vec3 a = {r(-wide, wide), r(-wide, wide), r(-5, 5)};
  const Vec3 b = {r(-wide, wide), r(-wide, wide), r(-5, 5)};
  switch (kind) {
    case 0:
      return line(a, {b.x, b.y, a.z});
    case 1:
      return line(a, {a.x, a.y, b.z});
    case 2:
      return line(a, b);
    case 3:
      return arc(a, {b.x, b.y, a.z}, {0, 0, 1}, r(-7, 7));
    case 4:
      return arc(a, {a.x + r(-6, 6), a.y + r(-6, 6), a.z}, {0, 0, 1}, r(-20, 20), r(-9, 9));
    case 5:
      return arc(a, {b.x, a.y, b.z}, {0, 1, 0}, r(-6, 6));
    default: {
      const Vec3 n = normalized(Vec3{r(-1, 1), r(-1, 1), r(0.1, 1)});
      const Vec3 w = b - a;
      return arc(a, a + (w - dot(w, n) * n), n, r(-6, 6), r(-12, 12));
    }
  }
}

/// An arc in an upright plane, of any radius; some end on an axis of their plane.
inline Motion upright_arc(Random& r) {
  const double turned = r.pick(3) == 0 ? 0 : r(0, kTwoPi), radius = r(0.3, 12);
  const Vec3 along = {std::cos(turned), std::sin(turned), 0};
  const Vec3 axis = {along.y, -along.x, 0}, center = {r(-3, 3), r(-3, 3), r(-3, 3)};
  const double from = r.pick(2) == 0 ? kPi / 2 * r.pick(4) : r(0, kTwoPi);
  const Vec3 start = center + radius * (std::cos(from) * along + Vec3{0, 0, std::sin(from)});
  const double sweeps[] = {kPi / 2, kPi, kTwoPi, r(0.05, 7), r(0.05, 2)};
  return arc(start, center, axis, (r.pick(2) ? -1 : 1) * sweeps[r.pick(5)]);
}

/// The path of an arc without rise, as far as every tool has it.
inline ToolPath path_of(const Motion& m) {
  ToolPath path;
  path.arc = true;
  path.center = m.center, path.u = m.start - m.center;
  path.v = (m.sweep < 0 ? -1.0 : 1.0) * cross(m.axis, path.u);
  path.radius = path.speed = length(path.u);
  path.sweep = std::fabs(m.sweep);
  return path;
}

/// A point near a motion, also on the axis of its circle and in its plane, where positions are
/// equally near.
inline Vec3 point_near(Random& r, const Motion& m, double reach) {
  const int kind = r.pick(8);
  Vec3 p = at(m, r(0, 1)) + Vec3{r(-reach, reach), r(-reach, reach), r(-reach, reach)};
  if (kind == 0) p.x = m.center.x, p.y = m.center.y;
  if (kind == 1) p.x = at(m, 0).x, p.y = at(m, 0).y;
  if (kind == 2) p.y = m.center.y;
  return p;
}

/// Flat, bull-nose or ball mill that reaches up, at rest with its tip at the origin.
inline double mill_at_rest(double radius, double corner, const Vec3& q) {
  const double a = std::hypot(q.x, q.y) - (radius - corner), b = corner - q.z;
  const double outside = std::hypot(std::max(a, 0.0), std::max(b, 0.0));
  return outside + std::min(std::max(a, b), 0.0) - corner;
}

/// Central differences of the distance.
inline Vec3 numeric_gradient(const SweepTable& s, std::size_t i, const Vec3& p, double h = 1e-5) {
  const auto d = [&](Vec3 o) { return s.distance(i, p + o) - s.distance(i, p - o); };
  return (0.5 / h) * Vec3{d({h, 0, 0}), d({0, h, 0}), d({0, 0, h})};
}

}  // namespace mrsim::testing
