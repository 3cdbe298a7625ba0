#include "removal/sweep/arc_heights.h"

#include "core/numbers/angles.h"
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kSampled = 0.1;      // radians between places that are asked
constexpr double kAngleFound = 1e-7;  // radians: the height changes by the square
constexpr int kMostAngles = 60;

// The tool on the path, seen from a place: `t` radians downhill from where the path is nearest.
struct View {
  const Underside& tool;
  double near = 0, span = 0;  // rho^2 = near^2 + span * sin(t / 2)^2
  double fall = 0;            // mm per radian, not negative

  // Height of the tool above its tip, that of the place above the tip at 0, and its slope in t.
  struct At {
    double t, tool, height, slope;
  };
  At at(double t) const {
    const SinCos half = mrsim::sincos(0.5 * t);
    const double rho = std::sqrt(near * near + span * half.sin * half.sin);
    const double on = std::min(rho, tool.radius());
    const double away = rho > 0 ? 0.5 * span * half.sin * half.cos / rho : 0;
    const double up = tool.height(on);
    return {t, up, up - fall * t, (away > 0 ? away * tool.slope(on) : 0) - fall};
  }
  // Requires: downhill at `low`, uphill at `high`.
  double least_between(At low, At high) const {
    double below = low.slope, above = high.slope;
    for (int k = 0; k < kMostAngles && high.t - low.t > kAngleFound; ++k) {
      double t = low.t + (high.t - low.t) * below / (below - above);
      if (k % 3 == 2 || !(t > low.t && t < high.t)) t = 0.5 * (low.t + high.t);
      const At middle = at(t);
      if (middle.slope < 0)
        low = middle, below = middle.slope, above *= 0.5;
      else
        high = middle, above = middle.slope, below *= 0.5;
    }
    return std::min(low.height, high.height);
  }
  // The least height of t in [from, to]. Up to t = 0 it falls: the path goes down, and nearer. From
  // there on the tool rises, so that nothing is lower behind a place where it is higher than the
  // least height and the rest of the fall.
  double least(double from, double to) const {
    from = std::clamp(0.0, from, to);
    const int parts = static_cast<int>(std::ceil((to - from) / kSampled));
    At last = at(from);
    double found = last.height;
    for (int k = 1; k <= parts && last.tool - fall * to < found; ++k) {
      const At next = at(from + (to - from) * k / parts);
      const bool turns = last.slope < 0 && next.slope >= 0;
      found = std::min(found, turns ? least_between(last, next) : next.height);
      last = next;
    }
    return found;
  }
};

}  // namespace

HelixView view_helix(const ToolPath& path, double x, double y, double reach) {
  const Vec3 off{x - path.center.x, y - path.center.y, 0};
  const double from = std::sqrt(dot(off, off)), turn = path.radius;
  HelixView view{.near = from - turn, .span = 4 * from * turn, .fall = std::fabs(path.rise.z)};
  if (!(std::fabs(view.near) <= reach)) return view;
  double half = kPi;
  if (from + turn > reach) {
    const double cosine = (from * from + turn * turn - reach * reach) / (2 * from * turn);
    half = mrsim::atan2(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine);
  }
  const bool falls = path.rise.z <= 0;
  // The nearest place of the path, in radians from its lower end uphill.
  const double facing = from > 0 ? mrsim::atan2(dot(off, path.v), dot(off, path.u)) : 0;
  double uphill = wrapped_angle(falls ? path.sweep - facing : facing) - kTwoPi;
  const double lowest = path.center.z + (falls ? path.sweep * path.rise.z : 0);
  for (std::size_t k = 0; k < view.stretches.size(); ++k, uphill += kTwoPi) {
    const double first = std::max(-half, uphill - path.sweep), last = std::min(half, uphill);
    if (first <= last) view.stretches[view.count++] = {lowest + view.fall * uphill, first, last};
  }
  return view;
}

double arc_bottom(const Underside& tool, const ToolPath& path, double x, double y) {
  const HelixView helix = view_helix(path, x, y, tool.radius());
  const View view{tool, helix.near, helix.span, helix.fall};
  double found = kInfinity;
  for (std::size_t k = 0; k < helix.count; ++k) {
    const HelixView::Stretch& s = helix.stretches[k];
    found = std::min(found, s.height + view.least(s.from, s.to));
  }
  return found;
}

}  // namespace mrsim
