// In the arc's plane x lies on the ground and z up, both about the centre. A quarter of the circle,
// mirrored to x >= 0, is a stretch from the position nearest to p in plan towards its lower end:
// the other way the tool moves off and rises. Positions are unit vectors, by the tangent of half an
// angle: no sines.
#include "removal/forms/upright_sweep.h"

#include "core/trig.h"
#include "core/units.h"
#include "removal/simd/lane_scalar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

using lane::Place;

constexpr double kAtEnd = 1e-12;  // radians: nearer to an end of the path is the end
constexpr Vec2 kAxes[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

int quadrant(Vec2 w) {
  if (w.y >= 0) return w.x > 0 ? 0 : 1;
  return w.x < 0 ? 2 : 3;
}

// A piece of the arc within a quarter of the circle, in the plane mirrored to x >= 0.
struct Quarter {
  Vec2 high, low;      // its ends, unit vectors
  bool below = false;  // the lower half of the circle
  bool mirrored = false;
  bool rising = false;  // the motion goes from low to high
};

Quarter quarter(const ToolPath& path, int branch) {
  const int k = (path.first_quarter + branch) % 4;
  const Vec2 begin = branch == 0 ? path.begin : kAxes[k];
  const Vec2 end = branch == path.quarters - 1 ? path.end : kAxes[(k + 1) % 4];
  Quarter q;
  q.below = k >= 2, q.mirrored = k == 1 || k == 2, q.rising = !q.mirrored;
  const auto folded = [&q](Vec2 w) { return Vec2{std::max(0.0, q.mirrored ? -w.x : w.x), w.y}; };
  q.high = folded(q.rising ? end : begin);
  q.low = folded(q.rising ? begin : end);
  return q;
}

struct Local {
  double x = 0, beside = 0, z = 0;  // of p; z of the plane that bounds the flat core
};

class FallingQuarter {
 public:
  FallingQuarter(const Quarter& quarter, double radius, double core, const Local& p)
      : q_(quarter), radius_(radius), core_(core), p_(p), x_(quarter.mirrored ? -p.x : p.x) {
    first_ = place(facing());
    last_ = place(q_.low);
  }

  const Place& first() const { return first_; }
  const Place& last() const { return last_; }
  Place at(double t, const Place&, bool) const { return place(t); }

  Place rim(const Place& a, const Place& b, bool) const {
    const double half = std::sqrt(std::max(0.0, core_ * core_ - p_.beside * p_.beside));
    return between(a, b, on_circle(q_.below ? x_ - half : x_ + half));
  }
  Place level(const Place& a, const Place& b, bool wanted) const {
    return crossing(*this, a, b, wanted);
  }

  Place ground(const Place& a, const Place& b, bool) const {
    const double z = p_.z / radius_;
    return between(a, b, {std::sqrt(std::max(0.0, 1 - z * z)), z});
  }
  Place corner(const Place& a, const Place& b, bool) const {
    const Place x = q_.below ? stationary_below(a, b) : stationary_above(a, b);
    const auto squared = [](const Place& at) { return at.dr * at.dr + at.dz * at.dz; };
    const Place& end = squared(a) < squared(b) ? a : b;
    return squared(x) < squared(end) ? x : end;
  }

 private:
  // Grows on the way down: the tangent of half the angle from the highest place, or, below, less
  // that of half the angle from the lowest one.
  double parameter(Vec2 w) const { return q_.below ? -w.x / (1 - w.y) : w.x / (1 + w.y); }
  Vec2 unit(double t) const {
    const double inverse = 1 / (1 + t * t), cosine = (1 - t * t) * inverse;
    return q_.below ? Vec2{-2 * t * inverse, -cosine} : Vec2{2 * t * inverse, cosine};
  }
  Place place(Vec2 w, double t, double turning) const {
    const double x = radius_ * w.x, z = radius_ * w.y, away = x - x_;
    const double lateral = std::sqrt(away * away + p_.beside * p_.beside);
    Place at{t, lateral - core_, z - p_.z, 0, -turning * x, w.x, w.y};
    if (lateral > 0) at.dr_slope = turning * z * away / lateral;
    return at;
  }
  Place place(Vec2 w) const {
    const double t = parameter(w);
    return place(w, t, 2 / (1 + t * t));
  }
  Place place(double t) const { return place(unit(t), t, 2 / (1 + t * t)); }
  Place between(const Place& a, const Place& b, Vec2 w) const {
    const double t = parameter(w);
    return !(t > a.t) ? a : !(t < b.t) ? b : place(w);
  }
  Vec2 on_circle(double x) const {
    const double u = std::clamp(x / radius_, 0.0, 1.0), z = std::sqrt(1 - u * u);
    return {u, q_.below ? -z : z};
  }
  Vec2 facing() const {
    const double x = x_ / radius_;
    if (q_.below ? x >= q_.high.x : x <= q_.high.x) return q_.high;
    if (q_.below ? x <= q_.low.x : x >= q_.low.x) return q_.low;
    return on_circle(x_);
  }

  // How the corner leans: away / lateral, and its slope in x.
  struct Lean {
    double value = 0, slope = 0;
  };
  Lean lean(double away) const {
    const double lateral = std::sqrt(away * away + p_.beside * p_.beside);
    if (!(lateral > 0)) return {};
    const double inverse = 1 / lateral, across = p_.beside * inverse;
    return {away * inverse, across * across * inverse};
  }

  // Above: half the slope of dr^2 + dz^2 by x is G = z T - x - core lean, with T the tangent of the
  // angle from the highest place. For p above the centre it is convex in T, and its last zero is
  // the minimum; Newton's method falls on it from above. Below the centre there is none.
  Place stationary_above(const Place& a, const Place& b) const {
    if (!(p_.z > 0)) return a;
    const Vec2 end = {b.wx, b.wy};
    double tangent = (x_ + core_ * lean(radius_ * end.x - x_).value) / p_.z;
    if (!(tangent > 0)) return a;
    if (tangent * end.y >= end.x) return b;
    for (int k = 0; k < 60; ++k) {
      const double cosine = 1 / std::sqrt(1 + tangent * tangent);
      const Lean l = lean(radius_ * tangent * cosine - x_);
      const double slope = p_.z - core_ * l.slope * radius_ * cosine * cosine * cosine;
      const double value = p_.z * tangent - x_ - core_ * l.value;
      if (!(value > 0 && slope > 0)) break;
      const double step = value / slope;
      tangent -= step;
      if (!(tangent > 0)) return a;
      if (step < 3e-9 * (1 + tangent)) break;
    }
    const double cosine = 1 / std::sqrt(1 + tangent * tangent);
    const double t = tangent * cosine / (1 + cosine);
    return t > a.t ? place(t) : a;
  }

  // Below, dr and dz are convex in x, and so is dr^2 + dz^2 where both are positive: one zero.
  Place stationary_below(const Place& a, const Place& b) const {
    const auto value = [this](double h, double away_lean) {
      return -2 * p_.z * h - (1 - h * h) * (x_ + core_ * away_lean);
    };
    const auto lean_at = [this](double h) { return lean(radius_ * 2 * h / (1 + h * h) - x_); };
    double low = -b.t, high = -a.t;  // h falls on the way down
    if (value(high, lean_at(high).value) <= 0) return a;
    if (value(low, lean_at(low).value) >= 0) return b;
    double h = 0.5 * (low + high);
    for (int k = 0; k < 60; ++k) {
      const Lean l = lean_at(h);
      const double v = value(h, l.value);
      (v > 0 ? high : low) = h;
      const double size = 1 / (1 + h * h), run = 2 * radius_ * (1 - h * h) * size * size;
      const double slope =
          -2 * p_.z + 2 * h * (x_ + core_ * l.value) - (1 - h * h) * core_ * l.slope * run;
      double next = slope > 0 ? h - v / slope : low;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (!(next > low && next < high)) break;
      const double step = next - h;
      h = next;
      if (step * step < 1e-17) break;
    }
    return place(-h);
  }

  const Quarter& q_;
  const double radius_, core_;
  const Local p_;
  const double x_;
  Place first_, last_;
};

Local local(const ToolPath& path, double round, const Vec3& p) {
  const Vec3 w = p - path.center;
  return {w.x * path.along.x + w.y * path.along.y,
          std::fabs(w.y * path.along.x - w.x * path.along.y), w.z - round};
}

struct Found {
  double distance = std::numeric_limits<double>::infinity();
  int branch = 0;
  Vec2 w;  // place on the quarter, mirrored
};

Found least(double core, double round, const ToolPath& path, const Vec3& p, int from, int to) {
  const Local at = local(path, round, p);
  Found best;
  for (int branch = from; branch < to; ++branch) {
    const Quarter q = quarter(path, branch);
    const FallingQuarter stretch(q, path.radius, core, at);
    if (lane::lower_bound(stretch.first(), stretch.last(), round) >= best.distance) continue;
    const Place x = lane::best_place(stretch, true);
    const double value = lane::value_of(x, round);
    if (value < best.distance) best = {value, branch, {x.wx, x.wy}};
  }
  return best;
}

Found least(const Profile& tool, const ToolPath& path, const Vec3& p, int from, int to) {
  return least(tool.core(), tool.round(), path, p, from, to);
}

Vec2 direction(const ToolPath& path, const Found& found) {
  return {quarter(path, found.branch).mirrored ? -found.w.x : found.w.x, found.w.y};
}

// The path's parameter; exact at its ends.
double parameter(const ToolPath& path, const Found& found) {
  const Vec2 w = direction(path, found);
  const bool again = path.quarters > 4 && found.branch == path.quarters - 1;  // the first quarter
  double t = mrsim::atan2(cross(path.begin, w), dot(path.begin, w));
  if (t < (again ? kAtEnd : -kAtEnd)) t += kTwoPi;
  return t < kAtEnd ? 0 : t > path.sweep - kAtEnd ? path.sweep : t;
}

}  // namespace

void set_upright_plane(ToolPath& path) {
  path.sweep = std::min(path.sweep, kTwoPi);
  const Vec3 axis = cross(path.u, path.v);
  const double plan = std::sqrt(axis.x * axis.x + axis.y * axis.y);
  // Turned so that the motion goes from x to z.
  path.along = {-axis.y / plan, axis.x / plan};
  const auto in_plane = [&path](const Vec3& w) {
    const Vec2 at = {w.x * path.along.x + w.y * path.along.y, w.z};
    return (1 / length(at)) * at;
  };
  if (const Vec2 u = in_plane(path.u), v = in_plane(path.v); cross(u, v) < 0)
    path.along = -1.0 * path.along;
  path.begin = in_plane(path.u);
  path.end = in_plane(path_point(path, path.sweep).position - path.center);
  set_quarters(path);
}

void set_quarters(ToolPath& path) {
  path.first_quarter = quadrant(path.begin);
  path.quarters = (quadrant(path.end) - path.first_quarter + 4) % 4 + 1;
  while (path.sweep > path.quarters * (kPi / 2) + 1e-9) path.quarters += 4;
}

Vec2 upright_place(double core, double round, const ToolPath& path, const Vec3& p) {
  return direction(path, least(core, round, path, p, 0, path.quarters));
}

double upright_value(const Profile& tool, const ToolPath& path, const Vec3& p) {
  return least(tool, path, p, 0, path.quarters).distance;
}

PathSample upright_minimum(const Profile& tool, const ToolPath& path, const Vec3& p) {
  const Found found = least(tool, path, p, 0, path.quarters);
  return {found.distance, parameter(path, found)};
}

int upright_branch(const ToolPath& path, double t) {
  const SinCos sc = sincos(t);
  const Vec2 u = path.begin;
  const int k = quadrant({sc.cos * u.x - sc.sin * u.y, sc.cos * u.y + sc.sin * u.x});
  const int branch = (k - path.first_quarter + 4) % 4;
  // The quarter of the start comes again after a whole turn; rounding may step over an end.
  if (branch == 0 && t > kPi) return path.quarters - 1;
  return std::min(branch, path.quarters - 1);
}

PathSample upright_branch_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                  int branch) {
  const Found found = least(tool, path, p, branch, branch + 1);
  return {found.distance, parameter(path, found)};
}

}  // namespace mrsim
