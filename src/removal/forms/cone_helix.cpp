// The profile's straight edges, continued, are cones about the axis. Each has a signed distance
// f(t) <= F(t), the tool's distance, as a convex tool lies within all of them. With rho(t) the
// distance of p in plan, f = a rho + c (z_p - z(t)) - offset for the edge's outward normal (a, c).
// So the least f of an edge is a bound below the least F, and where F is as small at that place it
// is the least F itself.
//
// f'(t) = 0 is rho' = k with k = c z' / a. For a circle of radius R about an axis that p is D away
// from, seen at the angle phi from the direction towards p, rho^2 = D^2 + R^2 - 2 D R x with
// x = cos(phi) and rho' = D R sin(phi) / rho, so D^2 R^2 (1 - x^2) = k^2 rho^2: a quadratic
// equation for x, whose larger root is the minimum.
#include "removal/forms/cone_helix.h"

#include "core/trig.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr double kSame = 1e-13;  // of the size: F and f are equal

class ConeHelix {
 public:
  ConeHelix(const ToolPath& path, const Vec3& p, double begin, double end)
      : path_(path),
        away_(p - path.center),
        d_(std::sqrt(away_.x * away_.x + away_.y * away_.y)),
        r_(path.radius),
        ends_{at(begin), at(end)} {
    if (!(d_ * r_ > 0)) return;
    facing_ = mrsim::atan2(dot(away_, path.v), dot(away_, path.u));
    while (facing_ < begin) facing_ += kTwoPi;
    while (facing_ - kTwoPi >= begin) facing_ -= kTwoPi;
  }

  // Seen from the tool's tip at t.
  struct Place {
    double t, rho, z;
  };
  struct Least {
    double f = -std::numeric_limits<double>::infinity();
    Place at{};
  };

  // The least f of the cone with the outward normal (a, c).
  Least least(double a, double c, double offset) const {
    const auto f = [&](const Place& x) { return a * x.rho + c * x.z - offset; };
    Least best{f(ends_[0]), ends_[0]};
    const auto take = [&](const Place& x) {
      if (const double value = f(x); value < best.f) best = {value, x};
    };
    take(ends_[1]);
    if (!(d_ * r_ > 0) || !(a > 0)) return best;
    const double k = c * path_.rise.z / a, kk = k * k;
    const double left = (d_ * d_ - kk) * (r_ * r_ - kk);
    if (left < 0 || kk > d_ * d_) return best;
    const double x = std::min((kk + std::sqrt(left)) / (d_ * r_), 1.0);
    const double turn = k == 0 ? 0 : mrsim::atan2(std::sqrt(1 - x * x), x);
    double t = facing_ + (k < 0 ? -turn : turn);
    if (t >= ends_[0].t + kTwoPi) t -= kTwoPi;
    if (t < ends_[0].t) t += kTwoPi;
    if (t <= ends_[1].t) take(at(t));
    return best;
  }

 private:
  Place at(double t) const {
    const Vec3 q = away_ - (path_point(path_, t).position - path_.center);
    return {t, std::sqrt(q.x * q.x + q.y * q.y), q.z};
  }

  const ToolPath& path_;
  const Vec3 away_;     // p from the centre
  const double d_, r_;  // of p and of the path, from the axis
  double facing_ = 0;   // the angle of p, within a turn behind the beginning
  const Place ends_[2];
};

}  // namespace

std::optional<PathSample> cone_helix_minimum(const Profile& tool, const ToolPath& path,
                                             const Vec3& p, double begin, double end) {
  const ConeHelix cones(path, p, begin, end);
  ConeHelix::Least best;
  for (const ProfileEdge& e : tool.edges()) {
    const double a = e.direction.y, c = -e.direction.x;
    if (e.radius > 0 || a < 0) continue;
    const ConeHelix::Least found = cones.least(a, c, a * e.a.x + c * e.a.y);
    if (found.f > best.f) best = found;
  }
  if (!std::isfinite(best.f)) return std::nullopt;
  const double there = tool_distance(tool, best.at.rho, best.at.z);
  if (there - best.f > kSame * (1 + std::fabs(there) + best.at.rho + std::fabs(best.at.z)))
    return std::nullopt;
  return PathSample{there, best.at.t};
}

}  // namespace mrsim
