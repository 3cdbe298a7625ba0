// The profile's straight edges, continued, are cones about the axis. Each has a signed distance
// f(t) <= F(t), the tool's distance, as a convex tool lies within all of them. With rho(t) the
// distance of p in plan, f = a rho + c (z_p - z(t)) - offset for the edge's outward normal (a, c).
// So the least f of an edge is a bound below the least F, and where F is as small at that place it
// is the least F itself.
//
// f'(t) = 0 is rho' = k with k = c z' / a. For a circle of radius R about an axis that p is D away
// from, seen at the angle phi from the direction towards p, rho^2 = D^2 + R^2 - 2 D R x with
// x = cos(phi) and rho' = D R sin(phi) / rho, so D^2 R^2 (1 - x^2) = k^2 rho^2: a quadratic
// equation for x, whose larger root is the minimum. Most edges need no root: some f of theirs, at
// an end or where the path is nearest in plan, is no greater than the least f of another edge.
#include "removal/forms/cone_helix.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/forms/tool_at_rest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr double kSameValue = 1e-13;  // of the size: F and f are equal

}  // namespace

ConeHelix::ConeHelix(const ToolPath& path, const Vec3& p, double begin, double end)
    : path_(path),
      away_(p - path.center),
      facing_{dot(away_, path.u) / path.radius, dot(away_, path.v) / path.radius},
      d_(std::sqrt(dot(facing_, facing_))),
      ends_{end_at(begin), end_at(end)} {
  if (d_ > 0) nearest_ = inner((1 / d_) * facing_);
}

// The least f of the cone with the outward normal (a, c). Where that is not above `wanted`, any f
// that is not above it either.
ConeHelix::Least ConeHelix::least(double a, double c, double offset, double wanted) const {
  const auto f = [&](const Place& x) { return a * x.rho + c * x.z - offset; };
  Least best{f(ends_[0]), ends_[0]};
  const auto take = [&](const Place& x) {
    if (const double value = f(x); value < best.f) best = {value, x};
  };
  take(ends_[1]);
  if (nearest_) take(*nearest_);
  if (!(best.f > wanted)) return best;
  const double r = path_.radius;
  const double k = c * path_.rise.z / a, kk = k * k;
  if (!(d_ > 0) || !(a > 0) || k == 0) return best;
  const double left = (d_ * d_ - kk) * (r * r - kk);
  if (left < 0 || kk > d_ * d_) return best;
  const double x = std::min((kk + std::sqrt(left)) / (d_ * r), 1.0);
  const double y = (k < 0 ? -1 : 1) * std::sqrt(1 - x * x);
  const Vec2 w = (1 / d_) * Vec2{facing_.x * x - facing_.y * y, facing_.y * x + facing_.x * y};
  if (const auto place = inner(w)) take(*place);
  return best;
}

ConeHelix::Place ConeHelix::end_at(double t) const {
  if (t == 0) return at(t, {1, 0});
  if (t == path_.sweep) return at(t, path_.last);
  const SinCos sc = sincos(t);
  return at(t, {sc.cos, sc.sin});
}

// The first position with the direction w between the ends.
std::optional<ConeHelix::Place> ConeHelix::inner(const Vec2& w) const {
  double t = mrsim::atan2(w.y, w.x);
  const double begin = ends_[0].t;
  if (t < begin) t = std::max(t + kTwoPi * std::ceil((begin - t) / kTwoPi), begin);
  if (t > ends_[1].t) return std::nullopt;
  return at(t, w);
}

// The position with the direction w from the centre, in (u, v).
ConeHelix::Place ConeHelix::at(double t, const Vec2& w) const {
  const double x = away_.x - w.x * path_.u.x - w.y * path_.v.x;
  const double y = away_.y - w.x * path_.u.y - w.y * path_.v.y;
  return {t, std::sqrt(x * x + y * y), away_.z - t * path_.rise.z};
}

ConeHelix::Minimum ConeHelix::minimum(const Profile& tool, double limit) const {
  Least best;
  for (const ProfileEdge& e : tool.edges()) {
    const double a = e.direction.y, c = -e.direction.x;
    if (e.radius > 0 || a < 0) continue;
    const Least found = least(a, c, a * e.a.x + c * e.a.y, best.f);
    if (found.f > best.f) best = found;
    if (best.f >= limit) return {{best.f, best.at.t}, true};
  }
  if (!std::isfinite(best.f)) return {{best.f, ends_[0].t}, false};
  const double there = tool_distance(tool, best.at.rho, best.at.z);
  const double size = 1 + std::fabs(there) + best.at.rho + std::fabs(best.at.z);
  if (there - best.f > kSameValue * size) return {{best.f, best.at.t}, false};
  return {{there, best.at.t}, true};
}

}  // namespace mrsim
