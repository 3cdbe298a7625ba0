#include "removal/sweep/line_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

// p and the path seen along and across the path in plan, from its start.
struct PlanView {
  double u = 0, v = 0, w = 0;  // of p; w is its height
  double length = 0, rise = 0;

  PlanView(const ToolPath& path, const Vec3& p) {
    const Vec3 q = p - path.start, t = path.travel;
    length = std::sqrt(t.x * t.x + t.y * t.y), rise = t.z;
    const double ux = length > 0 ? t.x / length : 1, uy = length > 0 ? t.y / length : 0;
    u = q.x * ux + q.y * uy, v = std::fabs(q.y * ux - q.x * uy), w = q.z;
  }
  // The least product of the normal with p less a position: at an end of the path.
  double along(double nu, double nv, double nz) const {
    const double start = nu * u + nv * v + nz * w;
    return std::min(start, start - nu * length - nz * rise);
  }
};

// The tangent plane of a flank with normal (across, up), turned to where the flank touches.
double flank_bound(const PlanView& at, double across, double up) {
  const double tilt = at.length > 0 ? -up * at.rise / (across * at.length) : 2;
  double s = at.rise * up > 0 ? at.length : 0;  // the end that the tool reaches p with
  if (std::fabs(tilt) < 1) s = at.u - at.v * tilt / std::sqrt(1 - tilt * tilt);
  const double away = at.u - std::clamp(s, 0.0, at.length);
  const double rho = std::sqrt(away * away + at.v * at.v);
  if (rho <= 0) return -std::numeric_limits<double>::infinity();
  return at.along(across * away / rho, across * at.v / rho, up);
}

// The tangent plane of a ball about the axis, towards p, as far as the ball shows.
double tip_bound(const PlanView& at, const ProfileEdge& ball) {
  const double w = at.w - ball.center.y, size = at.length * at.length + at.rise * at.rise;
  const double t = std::clamp((at.u * at.length + w * at.rise) / size, 0.0, 1.0);
  const double u = at.u - t * at.length, dz = w - t * at.rise;
  const double rho = std::sqrt(u * u + at.v * at.v), d = std::sqrt(rho * rho + dz * dz);
  const Vec2 end = ball.b - ball.center;
  if (d <= 0 || dz >= 0 || rho * end.y < dz * end.x)
    return -std::numeric_limits<double>::infinity();
  return at.along(u / d, at.v / d, dz / d) - ball.center.y * dz / d - ball.radius;
}

}  // namespace

double line_bound(const Profile& tool, const ToolPath& path, const Vec3& p) {
  const PlanView at(path, p);
  double bound = at.along(0, 0, -1);  // the tip's plane
  for (const ProfileEdge& e : tool.edges()) {
    if (e.radius > 0) {
      if (e.center.x == 0 && e.a.x == 0) bound = std::max(bound, tip_bound(at, e));
      continue;
    }
    const double across = e.direction.y, up = -e.direction.x;  // outward
    if (across <= 0 || up > 0) continue;
    bound = std::max(bound, flank_bound(at, across, up) - across * e.a.x - up * e.a.y);
  }
  return bound;
}

}  // namespace mrsim
