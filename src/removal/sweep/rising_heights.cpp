#include "removal/sweep/rising_heights.h"

#include "core/numbers/angles.h"
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/sweep/arc_heights.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kBottomError = 1e-9;  // mm: error of a bottom
constexpr double kOfWidth = 1e-2;      // error of a bound, as a share of the radius of the places

// Of a slope, perhaps infinite, and a rate that may be 0.
double product(double slope, double rate) { return rate > 0 ? slope * rate : 0; }

// Distance in plan from the path at t, which grows by `rate`.
struct Away {
  double rho = 0, rate = 0;
  bool quickens = true;  // the rate grows with t
};

// Paths downhill from where they are nearest, t >= 0: distances grow with t, and their rate grows
// and then shrinks.
struct LineCourse {
  double v, fall;
  Away at(double t) const {
    const double rho = std::sqrt(t * t + v * v);
    return {rho, rho > 0 ? t / rho : 0};
  }
  double reaches(double rho) const { return root_or_zero(rho * rho - v * v); }
  double quickest() const { return 1; }
};

struct HelixCourse {
  double near, span, fall;
  // rho' = span sin t / (4 rho) grows as long as the derivative of its square is positive.
  Away at(double t) const {
    const SinCos half = mrsim::sincos(0.5 * t);
    const double rho = std::sqrt(near * near + span * half.sin * half.sin);
    const double cosine = 1 - 2 * half.sin * half.sin, a = near * near + 0.5 * span;
    return {rho, rho > 0 ? 0.5 * span * half.sin * half.cos / rho : 0,
            0.5 * span * (1 + cosine * cosine) <= 2 * a * cosine};
  }
  double reaches(double rho) const {
    const double square = rho * rho - near * near;
    if (!(square > 0)) return 0;
    if (square >= span) return kPi;
    return 2 * mrsim::atan2(std::sqrt(square), std::sqrt(span - square));
  }
  // The smaller one of the path's radius and the place's distance from its axis.
  double quickest() const {
    const double sum = std::sqrt(near * near + span);
    return 0.5 * (sum - std::fabs(near));
  }
};

// The tool, widened by `wider`, on a course.
template <class Course>
class LeastHeight {
 public:
  // Heights are found up to `error`; `found`: what they have to be below.
  LeastHeight(const Underside& tool, const Course& course, double wider, double error, double found)
      : tool_(tool), course_(course), wider_(wider), error_(error), found_(found) {}
  // Of t in [from, to], where the tool comes to the place. Up to t = 0 the height falls: the path
  // goes down, and nearer.
  double over(double from, double to) {
    if (to <= 0) {
      const double on = std::clamp(course_.at(to).rho - wider_, 0.0, tool_.radius());
      return std::min(found_, tool_.height(on) - course_.fall * to);
    }
    from = std::max(from, 0.0);
    if (wider_ > 0 && course_.reaches(wider_) >= to)
      return std::min(found_, tool_.height(0) - course_.fall * to);
    const double nearest = course_.at(from).rho;
    for (const Underside::Edge& e : tool_.edges()) {
      if (e.to + wider_ < nearest) continue;
      const double first = std::max(from, course_.reaches(std::max(e.from + wider_, 0.0)));
      if (first > to) break;
      edge_ = &e;
      divide(at(first), at(std::max(first, std::min(to, course_.reaches(e.to + wider_)))));
    }
    return found_;
  }

 private:
  struct At {
    double t, height, slope;
    Away away;
  };
  At at(double t) {
    const Away away = course_.at(t);
    const double on = std::clamp(away.rho - wider_, edge_->from, edge_->to);
    const At out{t, edge_->height(on) - course_.fall * t, edge_->slope(on), away};
    found_ = std::min(found_, out.height);
    return out;
  }
  // Divides until no place can be lower than the least one found. On an edge the slope only grows
  // or only shrinks, so its ends and those of the rate bound what the height gains by t.
  void divide(const At& a, const At& b) {
    const auto [flat, steep] = std::minmax(a.slope, b.slope);
    const auto [slow, quick] = std::minmax(a.away.rate, b.away.rate);
    const bool turns = a.away.quickens && !b.away.quickens;
    const double least = product(flat, slow) - course_.fall;
    const double most = product(steep, turns ? course_.quickest() : quick) - course_.fall;
    if (least >= 0 || most <= 0) return;
    // Lines of these gains through both ends meet below the curve.
    const double wide = b.t - a.t;
    const double met =
        std::isfinite(most) ? (b.height - a.height - most * wide) / (least - most) : wide;
    if (a.height + least * std::clamp(met, 0.0, wide) >= found_ - error_) return;
    const double t = 0.5 * (a.t + b.t);
    if (!(t > a.t && t < b.t)) return;
    const At middle = at(t);
    divide(a, middle), divide(middle, b);
  }

  const Underside& tool_;
  const Course course_;
  const double wider_, error_;
  double found_;
  const Underside::Edge* edge_ = nullptr;
};

double least_height(const Underside& tool, const Underside::Slant& at, double wider, double error,
                    double below) {
  const double reach = tool.radius() + wider, wide = root_or_zero(reach * reach - at.v * at.v);
  const double low = std::max(at.u - at.length, -wide), high = std::min(at.u, wide);
  if (at.v > reach || low > high) return kInfinity;
  const double before = at.slope * at.u;  // the tip's height where it is nearest
  LeastHeight least(tool, LineCourse{at.v, at.slope}, wider, error, below + error - before);
  return before + least.over(low, high);
}

double least_height(const Underside& tool, const ToolPath& helix, double x, double y, double wider,
                    double error, double below) {
  const HelixView view = view_helix(helix, x, y, tool.radius() + wider);
  double found = below + error;
  for (std::size_t k = 0; k < view.count; ++k) {
    const HelixView::Stretch& s = view.stretches[k];
    LeastHeight least(tool, HelixCourse{view.near, view.span, view.fall}, wider, error,
                      found - s.height);
    found = std::min(found, s.height + least.over(s.from, s.to));
  }
  return view.count > 0 ? found : kInfinity;
}

template <class... Path>
Underside::Bounds bounds_of(const Underside& tool, double r, double below, const Path&... path) {
  const double error = std::max(kOfWidth * r, kBottomError);
  const double lower = least_height(tool, path..., r, error, below) - error;
  if (!(lower < below)) return {lower, kInfinity};
  return {lower - kRounding, least_height(tool, path..., -r, error, kInfinity) + kRounding};
}

}  // namespace

double rising_bottom(const Underside& tool, const Underside::Slant& at, double below) {
  return least_height(tool, at, 0, kBottomError, below);
}

double rising_bottom(const Underside& tool, const ToolPath& helix, double x, double y,
                     double below) {
  return least_height(tool, helix, x, y, 0, kBottomError, below);
}

Underside::Bounds rising_bounds(const Underside& tool, const Underside::Slant& at, double r,
                                double below) {
  return bounds_of(tool, r, below, at);
}

Underside::Bounds rising_bounds(const Underside& tool, const ToolPath& helix, double x, double y,
                                double r, double below) {
  return bounds_of(tool, r, below, helix, x, y);
}

}  // namespace mrsim
