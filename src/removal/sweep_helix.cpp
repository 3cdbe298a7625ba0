// Seen from p, a position is turned by `delta` from the one that looks at p. Up to half a turn the
// lateral distance grows and the tool falls: a stretch. Behind it both fall up to the end of the
// path, or to the next position that looks at p.
#include "removal/sweep_helix.h"

#include "core/trig.h"
#include "core/units.h"
#include "removal/sweep_falling.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kShort = 1.0 / 16;  // radians
// Newton's method squares the step, and the distance changes by the square of what is left.
constexpr double kLastStep = 1e-6;

// A position by its parameter and the direction from the helix's axis, in (u, v).
struct Turned {
  double t = 0, sin = 0, cos = 1;
};

// p in cylindrical coordinates about the helix.
class Helix {
 public:
  Helix(const Profile& tool, const ToolPath& path, const Vec3& p)
      : core(tool.core()), fall(-path.rise.z), low_(path.center.z + tool.round() - p.z) {
    const double x = p.x - path.center.x, y = p.y - path.center.y;
    const double rho = std::sqrt(x * x + y * y);
    off = rho - path.radius;
    area = rho * path.radius;
    along_u_ = x * path.u.x + y * path.u.y, along_v_ = x * path.v.x + y * path.v.y;
  }

  double dz(double t) const { return low_ - t * fall; }
  /// The position on the first turn that looks at p.
  double facing() const {
    const double a = mrsim::atan2(along_v_, along_u_);
    return a < 0 ? a + kTwoPi : a;
  }

  /// The tool turned by `delta` from there, at t.
  Place place(double t, double delta, double sine, double cosine) const {
    // rho^2 + R^2 - 2 area cos, without cancellation.
    const double rise = cosine > 0 ? sine * sine / (1 + cosine) : 1 - cosine;
    const double lateral = std::sqrt(off * off + 2 * area * rise);
    return {delta, lateral - core, dz(t), lateral > 0 ? area * sine / lateral : 0,
            -fall, {cosine, sine}};
  }
  Place place(const Turned& at, double delta) const {
    if (area == 0) return place(at.t, delta, 0, 1);
    return place(at.t, delta, (at.sin * along_u_ - at.cos * along_v_) / area,
                 (at.cos * along_u_ + at.sin * along_v_) / area);
  }

  double core, fall;
  double off, area;  ///< how far p lies beyond the helix's circle; the product of both radii

 private:
  double low_, along_u_, along_v_;
};

// Half a turn from the position that looks at p, the parameter being the angle from it.
class FallingTurn {
 public:
  FallingTurn(const Helix& helix, double facing, const Place& first, const Place& last)
      : h_(helix), facing_(facing), first_(first), last_(last) {}

  const Place& first() const { return first_; }
  const Place& last() const { return last_; }

  Place at(double delta) const {
    const SinCos sc = sincos(delta);
    return h_.place(facing_ + delta, delta, sc.sin, sc.cos);
  }
  Place at(double delta, const Place& x) const {
    const double step = delta - x.t, square = step * step;
    if (square > kShort * kShort) return at(delta);
    // Taylor series: what is left out is below 1e-16.
    constexpr double k3 = 1.0 / 6, k4 = 1.0 / 12, k5 = 1.0 / 20, k6 = 1.0 / 30, k7 = 1.0 / 42;
    const double sine = step * (1 - k3 * square * (1 - k5 * square * (1 - k7 * square)));
    const double less = 0.5 * square * (1 - k4 * square * (1 - k6 * square));  // 1 - cosine
    return h_.place(facing_ + delta, delta, x.w.y - x.w.y * less + x.w.x * sine,
                    x.w.x - x.w.x * less - x.w.y * sine);
  }

  // lateral = core: the law of cosines.
  Place rim(const Place& a, const Place& b) const {
    const double lift = h_.core * h_.core - h_.off * h_.off;  // 2 area (1 - cos)
    const double cosine = 1 - lift / (2 * h_.area);
    const double sine = std::sqrt(std::max(0.0, lift * (4 * h_.area - lift))) / (2 * h_.area);
    const double delta = mrsim::atan2(sine, cosine);
    if (!(delta > a.t)) return a;
    if (!(delta < b.t)) return b;
    Place x = h_.place(facing_ + delta, delta, sine, cosine);
    x.dr = 0;
    return x;
  }

  Place ground(const Place& a, const Place& b) const {
    return h_.fall > 0 ? at(std::clamp(a.t + a.dz / h_.fall, a.t, b.t)) : b;
  }

  // The slope of (dr^2 + dz^2) / 2, area sin (1 - core / lateral) - fall dz, grows up to a quarter
  // turn and is concave behind it: there is one minimum at most besides the end.
  Place corner(const Place& a, const Place& b) const {
    const Place x = stationary(a, b);
    return x.dr * x.dr + x.dz * x.dz <= b.dr * b.dr + b.dz * b.dz ? x : b;
  }

 private:
  double slope(const Place& x) const { return x.dr * x.dr_slope - h_.fall * x.dz; }
  double bend(const Place& x) const {
    const double lateral = x.dr + h_.core;
    // area cos, from lateral^2.
    const double along = 0.5 * (h_.off * h_.off - lateral * lateral) + h_.area;
    const double second = lateral > 0 ? (along - x.dr_slope * x.dr_slope) / lateral : 0;
    return x.dr_slope * x.dr_slope + x.dr * second + h_.fall * h_.fall;
  }

  // First zero of the slope at or behind a; b if there is none.
  Place stationary(const Place& a, const Place& b) const {
    if (slope(a) >= 0) return a;
    if (a.t >= kPi / 2) return behind(a, b);
    Place x = a;
    double low = a.t, high = std::min(b.t, kPi / 2);
    bool known = false;  // slope(high) > 0
    for (int k = 0; k < 60; ++k) {
      const double v = slope(x), s = bend(x);
      if (v < 0)
        low = x.t;
      else
        high = x.t, known = true;
      double t = s > 0 ? x.t - v / s : high;
      if (!(t < high) && !known) {
        const Place end = high == b.t ? b : at(high);
        if (slope(end) < 0) return high == b.t ? b : behind(end, b);
        known = true;
      }
      const bool newton = t > low && t < high;
      if (!newton) t = 0.5 * (low + high);
      if (!(t > low && t < high)) break;
      const double step = t - x.t;
      x = at(t, x);
      if (newton && step * step < kLastStep * kLastStep) break;
    }
    return x;
  }

  // Behind a quarter turn Newton's method climbs a concave slope towards its first zero.
  Place behind(Place x, const Place& b) const {
    for (int k = 0; k < 60; ++k) {
      const double v = slope(x), s = bend(x);
      if (!(v < 0)) break;
      if (!(s > 0) || !(x.t - v / s < b.t)) return b;
      const double step = v / s;
      x = at(x.t - step, x);
      if (step * step < kLastStep * kLastStep) break;
    }
    return x;
  }

  const Helix& h_;
  const double facing_;
  const Place first_, last_;
};

PathSample minimum(const Profile& tool, const ToolPath& path, const Vec3& p, const Turned& begin,
                   const Turned& end) {
  const Helix helix(tool, path, p);
  const double round = tool.round(), near = std::fabs(helix.off) - helix.core;
  // No position is lower than the last one.
  const Place last = helix.place(end, 0);
  PathSample best{last.value(round), end.t};
  if (last.is_floor() || lane::slab(near, last.dz, round) >= best.distance) return best;
  const double facing = helix.facing();
  for (const double look : {facing, facing - kTwoPi}) {
    const double from = std::max(begin.t - look, 0.0), to = std::min(end.t - look, kPi);
    if (from > to || lane::slab(near, helix.dz(look + to), round) >= best.distance) continue;
    const Place first = from > 0 ? helix.place(begin, from) : helix.place(look, 0, 0, 1);
    const Place stop = to < kPi ? helix.place(end, to) : helix.place(look + kPi, kPi, 0, -1);
    const Place x = best_place(FallingTurn(helix, look, first, stop));
    if (const double value = x.value(round); value < best.distance) best = {value, look + x.t};
  }
  return best;
}

}  // namespace

PathSample helix_minimum(const Profile& tool, const ToolPath& path, const Vec3& p) {
  if (path.bored)
    if (const lane::Bore wall = lane::bore(path.bore.c, p.x, p.y, p.z); wall.decided)
      return {wall.distance, Helix(tool, path, p).facing()};
  return minimum(tool, path, p, {}, {path.sweep, path.last.y, path.last.x});
}

PathSample helix_branch_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                int branch) {
  // Quarter turns end on u and v.
  const auto turned = [&path](int k) {
    constexpr double kSine[4] = {0, 1, 0, -1};
    const Turned at{k * (kPi / 2), kSine[k % 4], kSine[(k + 1) % 4]};
    return at.t < path.sweep ? at : Turned{path.sweep, path.last.y, path.last.x};
  };
  return minimum(tool, path, p, turned(branch), turned(branch + 1));
}

}  // namespace mrsim
