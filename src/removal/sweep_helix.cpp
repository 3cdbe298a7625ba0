// The tool at rest is the set dr < 0, dz < 0 rounded by `round`, with dr = lateral distance - core
// and dz = round - height above the tip; its distance V(dr, dz) falls with neither. Along the path,
// from the position that looks at p to the opposite one, dr grows and dz falls, so the minimum of V
// is where dr = dz (inside), where dr = 0 or dz = 0, at an end, or the one zero of the slope of
// dr^2 + dz^2 between them.
#include "removal/sweep_helix.h"

#include "core/trig.h"
#include "core/units.h"
#include "removal/sweep_lane_scalar.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

struct Place {
  double t = 0, dr = 0, dz = 0;
  double slope = 0;  ///< d dr / dt
};

class FallingTurn {
 public:
  FallingTurn(const Profile& tool, const ToolPath& path, const Vec3& p)
      : tool_(tool), path_(path), p_(p), fall_(-path.rise.z) {}

  double facing() const {
    const Vec3 w = p_ - path_.center;
    const double a = mrsim::atan2(dot(w, path_.v), dot(w, path_.u));
    return a < 0 ? a + kTwoPi : a;
  }

  Place at(double t) const {
    const SinCos sc = sincos(t);
    const double cx = sc.cos * path_.u.x + sc.sin * path_.v.x,
                 cy = sc.cos * path_.u.y + sc.sin * path_.v.y;
    const double x = p_.x - path_.center.x - cx, y = p_.y - path_.center.y - cy;
    const double lateral = std::sqrt(x * x + y * y);
    const double dx = sc.cos * path_.v.x - sc.sin * path_.u.x,
                 dy = sc.cos * path_.v.y - sc.sin * path_.u.y;
    const double height = p_.z - path_.center.z + t * fall_;
    return {t, lateral - tool_.core(), tool_.round() - height,
            lateral > 0 ? -(x * dx + y * dy) / lateral : 0};
  }

  /// The same at a t that looks at p, without a sine.
  Place at_facing(double t) const {
    const double x = p_.x - path_.center.x, y = p_.y - path_.center.y;
    const double off = std::sqrt(x * x + y * y) - path_.radius;
    const double height = p_.z - path_.center.z + t * fall_;
    return {t, (off < 0 ? -off : off) - tool_.core(), tool_.round() - height, 0};
  }

  static bool wall_decides(const Place& x) { return x.dr >= x.dz && !is_corner(x); }
  static bool floor_decides(const Place& x) { return x.dz >= x.dr && !is_corner(x); }

  double value(const Place& at) const {
    return lane::rounded_slab(at.dr + tool_.core(), tool_.round() - at.dz, tool_.round(),
                              tool_.core(), tool_.round(), tool_.top());
  }

  /// The place in [a, b] where f(place) = 0; f grows from f(a) <= 0 to f(b) >= 0.
  template <class F, class Slope>
  Place zero(Place a, Place b, F f, Slope slope) const {
    Place x = f(b) < -f(a) ? b : a;
    for (int k = 0; k < 60 && b.t - a.t > 1e-15 * kTwoPi; ++k) {
      const double v = f(x), s = slope(x);
      if (v == 0) return x;
      (v < 0 ? a : b) = x;
      double t = s > 0 ? x.t - v / s : a.t;
      if (!(t > a.t && t < b.t)) t = 0.5 * (a.t + b.t);
      if (!(t > a.t && t < b.t)) break;
      const double step = t - x.t;
      x = at(t);
      if (step * step < 1e-26) break;
    }
    return x;
  }

  /// The best place between a and b, at most half a turn from the facing position at or before a.
  std::optional<Place> best(const Place& a, const Place& b, double facing) const {
    if (wall_decides(a)) return a;
    if (floor_decides(b)) return b;
    const auto gap = [](const Place& x) { return x.dr - x.dz; };
    const auto gap_slope = [this](const Place& x) { return x.slope + fall_; };
    Place from = a;
    if (!is_corner(a)) {  // under the tool: dr <= 0
      if (b.dr <= 0) return zero(a, b, gap, gap_slope);
      from = zero(
          a, b, [](const Place& x) { return x.dr; }, [](const Place& x) { return x.slope; });
      if (from.dz <= 0) return zero(a, from, gap, gap_slope);
    }
    Place to = b;
    if (to.dz < 0 && fall_ > 0) to = at(std::clamp(from.t + from.dz / fall_, from.t, b.t));
    if (to.t - facing > kPi / 2) return std::nullopt;
    const auto slope = [this](const Place& x) { return x.dr * x.slope - fall_ * x.dz; };
    if (slope(from) >= 0) return from;
    if (slope(to) <= 0) return to;
    return zero(from, to, slope, [this](const Place& x) { return bend(x); });
  }

 private:
  static bool is_corner(const Place& x) { return x.dr > 0 && x.dz > 0; }

  /// Slope of dr dr' - fall dz.
  double bend(const Place& x) const {
    const double lateral = x.dr + tool_.core();
    const Vec3 w = p_ - path_.center;
    const SinCos sc = sincos(x.t);
    const double along = sc.cos * dot(w, path_.u) + sc.sin * dot(w, path_.v);
    const double second = lateral > 0 ? (along - x.slope * x.slope) / lateral : 0;
    return x.slope * x.slope + x.dr * second + fall_ * fall_;
  }

  const Profile& tool_;
  const ToolPath& path_;
  const Vec3 p_;
  const double fall_;  ///< mm per radian
};

}  // namespace

std::optional<PathSample> helix_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                        double begin, double end) {
  if (!path.lowest_turn || !tool.is_rounded()) return std::nullopt;
  const FallingTurn turn(tool, path, p);
  // V is at least dr and at least dz everywhere: no position has a smaller dr than the one that
  // looks at p, none a smaller dz than the last.
  const double facing = turn.facing();
  const bool faces = begin <= facing && facing <= end;
  if (const Place at = turn.at_facing(facing); faces && FallingTurn::wall_decides(at))
    return PathSample{turn.value(at), facing};
  const Place last = turn.at(end);
  PathSample result{turn.value(last), end};
  if (FallingTurn::floor_decides(last)) return result;
  for (const double f : {facing - kTwoPi, facing}) {
    const double lo = std::max(begin, f), hi = std::min(end, f + kPi);
    if (lo > hi) continue;
    const Place a = lo == facing ? turn.at_facing(lo) : turn.at(lo);
    const Place b = hi == end ? last : turn.at(hi);
    const std::optional<Place> found = turn.best(a, b, f);
    if (!found) return std::nullopt;
    const double value = turn.value(*found);
    if (value < result.distance) result = {value, found->t};
  }
  return result;
}

}  // namespace mrsim
