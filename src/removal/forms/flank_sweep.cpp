// In the arc's plane x lies on the ground and z up, both about the centre; a position of the tip is
// R w, w a unit vector. G(w), the distance of p from the flank's cone continued without end, bounds
// the tool's distance F from below wherever the tool is, since the tool is convex. H(w), the
// distance of p from a mill with the same tip, bounds F from above, since the tool holds that mill.
// F is H where the tip is nearest and G where the flank is. Where the least F is H, it is the least
// of H; where it is G, it is a local minimum of G or at an end of the path, and G has few:
//   one on the lower half of the circle, as G is convex in x there;
//   at most one on the upper half, for p.x >= 0 at x >= p.x: its slope is concave there, and it
//   has none elsewhere (docs/sweeps.md).
// Newton's method comes from one side of the slope's zero each time.
#include "removal/forms/flank_sweep.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/forms/upright_sweep.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr double kSameDistance = 1e-12;  // mm: two distances are one, but for rounding
constexpr int kMostNewton = 40;

// A tip (point, ball, disc or bull nose) and the flank that joins it.
struct Flank {
  const ProfileEdge* edge = nullptr;
  double core = 0, round = 0, height = 0;  ///< of the tip: a disc at `height`, thickened by `round`
};

Flank flank_of(const Profile& tool) {
  const std::vector<ProfileEdge>& edges = tool.edges();
  std::size_t k = 0;
  Flank f{.height = tool.bottom()};
  if (edges[0].radius == 0 && edges[0].direction.y == 0) f.core = edges[k++].b.x;
  if (k < edges.size() && edges[k].radius > 0) {
    const ProfileEdge& nose = edges[k++];
    if (nose.center.x != f.core) return {};
    f.round = nose.radius, f.height = nose.center.y;
    // A nose that meets its flank with an edge has points that neither of them is nearest to.
    if (k < edges.size() && edges[k].patch != nose.patch) return {};
  }
  if (k == edges.size()) return {};
  const ProfileEdge& e = edges[k];
  if (e.radius == 0 && e.direction.x > 0 && e.direction.y > 0) f.edge = &e;
  return f;
}

class FlankOnArc {
 public:
  FlankOnArc(const Profile& tool, const Flank& flank, const ToolPath& path, const Vec3& p)
      : tool_(tool),
        path_(path),
        p_(p),
        edge_(*flank.edge),
        core_(flank.core),
        round_(flank.round),
        height_(flank.height),
        radius_(path.radius),
        a_(edge_.direction.y),
        b_(edge_.direction.x) {
    const Vec3 w = p - path.center;
    x_ = w.x * path.along.x + w.y * path.along.y;
    beside2_ = square(w.y * path.along.x - w.x * path.along.y);
    z_ = w.z;
  }

  void ask_positions() {
    ask(path_.begin);
    ask(path_.end);
    ask_within(nearest_tip());
    if (path_.begin.y > 0 || path_.end.y > 0 || holds({0, 1})) ask_within(upper());
    if (path_.begin.y < 0 || path_.end.y < 0 || holds({0, -1})) ask_within(lower());
    if (!known_) ask_wall();
  }

  bool is_found() const { return known_; }
  double distance() const { return best_; }
  Vec2 place() const { return at_; }

 private:
  static double square(double x) { return x * x; }

  // Where a mill with the same tip is nearest.
  Vec2 nearest_tip() const {
    if (core_ > 0) return upright_place(core_, height_, path_, p_);
    const double up = z_ - height_, n = std::sqrt(x_ * x_ + up * up);
    return n > 0 ? Vec2{x_ / n, up / n} : path_.begin;
  }

  // The wall above the flank bounds F from below as well: where the position that is nearest in
  // plan touches p with it, none is nearer.
  void ask_wall() {
    const double u = std::clamp(x_ / radius_, -1.0, 1.0), z = std::sqrt(1 - u * u);
    Vec2 nearest = path_.begin;
    for (const Vec2 w : {path_.end, Vec2{1, 0}, Vec2{-1, 0}, Vec2{u, z}, Vec2{u, -z}})
      if (holds(w) && off_in_plan(w) <= off_in_plan(nearest)) nearest = w;
    const double rho = std::sqrt(square(off_in_plan(nearest)) + beside2_);
    const double wall = rho - tool_.max_radius();
    known_ = tool_.distance({rho, z_ - radius_ * nearest.y}) <= wall + kSameDistance;
    best_ = wall, at_ = nearest;
  }

  double off_in_plan(Vec2 w) const { return std::fabs(x_ - radius_ * w.x); }
  bool holds(Vec2 w) const {
    const bool after = cross(path_.begin, w) >= 0, before = cross(w, path_.end) >= 0;
    return path_.sweep >= kTwoPi || (path_.sweep < kPi ? after && before : after || before);
  }
  void ask_within(Vec2 w) {
    if (holds(w)) ask(w);
  }
  void ask(Vec2 w) {
    const double rho = std::sqrt(square(x_ - radius_ * w.x) + beside2_), z = z_ - radius_ * w.y;
    const double r = rho - edge_.a.x, up = z - edge_.a.y, along = b_ * r + a_ * up;
    const bool at_tip = along < 0;
    const double f = at_tip ? lane::slab(rho - core_, height_ - z, round_) : a_ * r - b_ * up;
    if (!(f < best_)) return;
    best_ = f, at_ = w;
    known_ = (at_tip || along <= edge_.length) && (f > 0 || is_nearest(rho, z, f));
  }
  // Within the tool another face may be nearer than tip and flank. Within a flat tip the tool may
  // be deeper than the mill with the same tip.
  bool is_nearest(double rho, double z, double f) const {
    return core_ == 0 && std::fabs(tool_.distance({rho, z}) - f) <= kSameDistance;
  }

  // The slope of G / R in x / R = u, with p mirrored to `x` >= 0: a lean + b times the path's
  // slope.
  struct Slope {
    double value = 0, slope = 0;
    double scale2 = 0;  // squared: of the change of the slope
    // Newton's next step is the square of this one, in proportion to the scale: below rounding.
    bool is_last(double step) const {
      constexpr double kLastStep = 1e-15;  // fourth power of the step over the scale
      return square(square(step)) < kLastStep * scale2 * scale2 * scale2;
    }
  };
  Slope slope_at(double u, double x, double beside2, double sign) const {
    const double away = u - x, lateral2 = away * away + beside2, rest2 = 1 - u * u;
    const double lateral = std::sqrt(lateral2), rest = std::sqrt(rest2);
    const double lateral3 = lateral * lateral2;
    return {a_ * away / lateral + sign * b_ * u / rest,
            a_ * beside2 / lateral3 + sign * b_ / (rest * rest2), std::min(lateral2, rest2)};
  }

  // The slope is at most 0 at p and concave beyond: Newton's method rises to its first zero.
  Vec2 upper() const {
    const double x = std::fabs(x_) / radius_, beside2 = beside2_ / (radius_ * radius_);
    double u = std::min(x, a_);  // beyond a the path falls steeper than the flank
    for (int k = 0; k < kMostNewton && u < a_ && beside2 > 0; ++k) {
      const Slope s = slope_at(u, x, beside2, -1);
      if (!(s.slope > 0 && s.value < 0)) break;
      const double step = -s.value / s.slope;
      u = std::min(u + step, a_);
      if (s.is_last(step)) break;
    }
    return {x_ < 0 ? -u : u, std::sqrt(1 - u * u)};
  }

  // The slope grows, convex up to p: Newton's method falls to its zero.
  Vec2 lower() const {
    const double x = std::fabs(x_) / radius_, beside2 = beside2_ / (radius_ * radius_);
    double u = std::min(x, a_);
    for (int k = 0; k < kMostNewton && beside2 > 0; ++k) {
      const Slope s = slope_at(u, x, beside2, 1);
      if (!(s.value > 0)) break;
      const double step = s.value / s.slope;
      u = std::max(0.0, u - step);
      if (s.is_last(step)) break;
    }
    return {x_ < 0 ? -u : u, -std::sqrt(1 - u * u)};
  }

  const Profile& tool_;
  const ToolPath& path_;
  const Vec3& p_;
  const ProfileEdge& edge_;
  const double core_, round_, height_, radius_, a_, b_;
  double x_ = 0, beside2_ = 0, z_ = 0;  // of p
  double best_ = std::numeric_limits<double>::infinity();
  Vec2 at_;
  bool known_ = false;
};

Vec2 direction_at(const ToolPath& path, double t) {
  if (t <= 0) return path.begin;
  if (t >= path.sweep) return path.end;
  const SinCos sc = sincos(t);
  const Vec2 u = path.begin;
  return {sc.cos * u.x - sc.sin * u.y, sc.cos * u.y + sc.sin * u.x};
}

ToolPath part_of(const ToolPath& path, double begin, double end) {
  ToolPath part = path;
  part.begin = direction_at(path, begin), part.end = direction_at(path, end);
  part.sweep = end - begin;
  set_quarters(part);
  return part;
}

std::optional<PathSample> minimum(const Profile& tool, const ToolPath& path, const Vec3& p) {
  FlankOnArc f(tool, flank_of(tool), path, p);
  f.ask_positions();
  if (!f.is_found()) return std::nullopt;
  double t = mrsim::atan2(cross(path.begin, f.place()), dot(path.begin, f.place()));
  if (t < -kAtPathEnd) t += kTwoPi;
  return PathSample{f.distance(), t < kAtPathEnd                ? 0
                                  : t > path.sweep - kAtPathEnd ? path.sweep
                                                                : t};
}

}  // namespace

bool has_flank(const Profile& tool) {
  return tool.is_convex() && tool.is_rising() && flank_of(tool).edge != nullptr;
}

std::optional<PathSample> flank_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                        double begin, double end) {
  if (begin <= 0 && end >= path.sweep) return minimum(tool, path, p);
  std::optional<PathSample> least = minimum(tool, part_of(path, begin, end), p);
  if (least) least->t += begin;
  return least;
}

std::optional<double> flank_value(const Profile& tool, const ToolPath& path, const Vec3& p) {
  FlankOnArc f(tool, flank_of(tool), path, p);
  f.ask_positions();
  if (!f.is_found()) return std::nullopt;
  return f.distance();
}

}  // namespace mrsim
