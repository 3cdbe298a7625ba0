// The distance of a place from a tool as a function F of the tool's position on its path, with
// lower bounds of F about a position (path_search.cpp derives them).
#pragma once

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/forms/path_search.h"
#include "removal/forms/tool_at_rest.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mrsim {

/// F, F', F'', and what the tangent plane there says about the curvature of F: I and |n h| of
/// path_search.cpp.
struct PathValue {
  double f = 0, slope = 0, bend = 0;
  double inward = 0, advance = 0;
};

class PathObjective {
 public:
  PathObjective(const Profile& tool, const ToolPath& path, const Vec3& p)
      : tool_(tool), path_(path), p_(p) {}

  PathValue operator()(double t) const { return value(t, path_point(path_, t), nullptr); }

  /// F at the position `at` of t. `plane`: the same of the plane that touches the tool in the
  /// direction of its nearest place; of a tool that is not convex, too, no place is nearer.
  PathValue beside_plane(double t, const PathPoint& at, PathValue& plane) const {
    return value(t, at, &plane);
  }

  /// Lower bound over t +- half for a path about Z: no position there is nearer in plan than
  /// `near`, and heights differ by at most the rise, against which a convex tool's distance is
  /// convex. Ends the search among the turns of a helix early.
  double horizontal_bound(double t, double half, double near) const {
    const double z = p_.z - path_.center.z - t * path_.rise.z;
    const double rise = (path_.rise.z < 0 ? -path_.rise.z : path_.rise.z) * half;
    const ProfileSample s = tool_sample(tool_, near, z);
    const double slope = s.gradient.y < 0 ? -s.gradient.y : s.gradient.y;
    return s.distance - (tool_.is_convex() ? slope : 1) * rise;
  }

  /// horizontal_bound() over all from `begin` to `end`.
  double range_bound(double begin, double end) const {
    return horizontal_bound(0.5 * (begin + end), 0.5 * (end - begin), to_circle());
  }

  /// On a horizontal path the lateral distance of p, sqrt(D^2 + R^2 - 2 D R cos(angle)), is convex
  /// up to the angle of cosine D / R or R / D on both sides of the position that looks at p, and
  /// then has no minimum before that of the next turn. This angle is up to a tenth smaller:
  /// cos(x) >= 1 - x^2 / 2.
  struct Convex {
    double reach = 0;
    double beyond = 0;  ///< mm: no position farther away than `reach` is nearer in plan
  };
  Convex convex_part() const {
    const double dx = p_.x - path_.center.x, dy = p_.y - path_.center.y;
    const double d = std::sqrt(dx * dx + dy * dy), r = path_.radius;
    const double square = 2 * (1 - std::min(d, r) / std::max(d, r));
    // cos(x) <= 1 - x^2 / 2 + x^4 / 24
    return {std::sqrt(square), std::sqrt((d - r) * (d - r) + d * r * square * (1 - square / 12))};
  }

  /// The distance of the position that looks at p, `near` in plan, where it is the least one: the
  /// tool's wall is upright at all heights of the path.
  std::optional<double> upright_wall(double near, double begin, double end) const {
    const ProfileSample low = tool_sample(tool_, near, height(begin));
    if (low.gradient.y != 0 || tool_sample(tool_, near, height(end)).gradient.y != 0) return {};
    return low.distance;
  }

  double to_circle() const {
    const double dx = p_.x - path_.center.x, dy = p_.y - path_.center.y;
    const double off = std::sqrt(dx * dx + dy * dy) - path_.radius;
    return off < 0 ? -off : off;
  }
  double height(double t) const { return p_.z - path_.center.z - t * path_.rise.z; }
  double lateral(double t) const {
    const Vec3 q = p_ - path_point(path_, t).position;
    return std::sqrt(q.x * q.x + q.y * q.y);
  }
  double at_rest(double rho, double z) const { return tool_distance(tool_, rho, z); }

  /// The best position on each turn of an arc lies, seen along its axis, towards p; of a line,
  /// where p is nearest.
  double towards() const {
    if (!path_.arc) return dot(p_ - path_.start, path_.travel) / dot(path_.travel, path_.travel);
    const Vec3 w = p_ - path_.center;
    double a = mrsim::atan2(dot(w, path_.v), dot(w, path_.u));
    return a < 0 ? a + kTwoPi : a;
  }

 private:
  PathValue value(double t, const PathPoint& at, PathValue* plane) const {
    const Vec3 q = p_ - at.position, d = at.direction;
    const double rho = std::sqrt(q.x * q.x + q.y * q.y);
    const ProfileSample s = tool_sample(tool_, rho, q.z);
    const double lateral = rho > 0 ? s.gradient.x / rho : 0;
    const Vec3 n{lateral * q.x, lateral * q.y, s.gradient.y};
    const Vec3 out = path_.arc ? at.position - path_.center - t * path_.rise : Vec3{};
    const double inward = dot(n, out);
    const PathValue found{s.distance, -dot(n, d), bend(s, q, d, rho) + inward, inward,
                          std::fabs(dot(n, path_.rise))};
    if (plane) {
      *plane = found;
      plane->f =
          dot(s.gradient, Vec2{rho, q.z}) - tool_.support({std::fabs(s.gradient.x), s.gradient.y});
    }
    return found;
  }

  // F'' but for the path's own bend. On the axis, where F may have a kink: 0.
  static double bend(const ProfileSample& s, const Vec3& q, const Vec3& d, double rho) {
    if (!(rho > 0)) return 0;
    const double outward = -(q.x * d.x + q.y * d.y) / rho;  // of the place, per unit of t
    const double across2 = d.x * d.x + d.y * d.y - outward * outward;
    const double along = s.gradient.x * d.z + s.gradient.y * outward;  // the line of equal distance
    return s.gradient.x * across2 / rho + s.curvature * along * along;
  }

  const Profile& tool_;
  const ToolPath& path_;
  const Vec3 p_;
};

/// Two places between which a local minimum lies; equal at an end of the range.
struct Bracket {
  double lo, hi;
  PathValue a, b;  ///< F there

  PathSample least() const { return a.f < b.f ? PathSample{a.f, lo} : PathSample{b.f, hi}; }
};

/// About the minimum of a convex F on [lo, hi], or a local one; of a convex F no longer than it may
/// be below `limit`. The search begins at `guess`.
Bracket bracket(const PathObjective& F, double lo, double hi, double guess,
                double limit = kInfinity);
PathSample descend(const PathObjective& F, double lo, double hi, double guess,
                   double limit = kInfinity);

/// How far from t, on the side where F does not fall, F is at least F(t): less than half a turn.
double clear_reach(const PathValue& at);
/// How far F may be below its tangent at t within `wide`, mm.
double below_tangent(const PathValue& at, double wide);
/// Lower bound of F over t +- half by the tangent plane at t.
double plane_bound(const PathValue& at, double half);

}  // namespace mrsim
