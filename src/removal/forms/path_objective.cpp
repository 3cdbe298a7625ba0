#include "removal/forms/path_objective.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"

#include <algorithm>

namespace mrsim {
namespace {

constexpr double kExact = 1e-13;       // of the size: best value and bound agree
constexpr double kBeyond = 1.1;        // of a Newton step, so that the minimum lies behind
constexpr double kAcross = 1.0 / 32;   // of a bracket: how far a step goes across a kink at most
constexpr double kLeastAcross = 1e-7;  // of t: as far as F, bent, leaves its tangent by 1e-14

struct Place {
  double t;
  PathValue at;
};

bool agree(double best, double floor) { return best - floor <= kExact * (1 + std::fabs(best)); }

// Walks from x downhill until F rises, or to the end of [lo, hi]: Newton's steps, longer ones where
// these do not get far.
Bracket walk_down(const PathObjective& F, Place x, double lo, double hi, double limit) {
  const bool rises = x.at.slope > 0;
  const double end = rises ? lo : hi;
  for (double least = 0;;) {
    const double left = std::fabs(end - x.t), slope = std::fabs(x.at.slope);
    const double floor = x.at.f - slope * left;
    if (left == 0 || slope == 0 || agree(x.at.f, floor) || floor >= limit)
      return {x.t, x.t, x.at, x.at};
    const double newton = x.at.bend > 0 ? slope / x.at.bend : left;
    const double step = std::max(kBeyond * newton, least);
    Place y{step < left ? x.t + (rises ? -step : step) : end, {}};
    if (y.t == x.t) y.t = end;
    y.at = F(y.t);
    if (rises ? y.at.slope < 0 : y.at.slope > 0)
      return rises ? Bracket{y.t, x.t, y.at, x.at} : Bracket{x.t, y.t, x.at, y.at};
    least = 2 * std::fabs(y.t - x.t);
    x = y;
  }
}

struct Likely {
  double t;
  bool is_kink;
};

// Where the minimum probably lies, from what is known at both ends of a bracket. `x` is the end
// that was found last. It is where Newton's step from `x` leads, unless the tangent at `y` lies
// above that place: then it is a kink. `cut`: where both tangents meet.
Likely likely_minimum(const Place& x, const Place& y, double cut) {
  if (x.at.bend > 0) {
    const double t = x.t - x.at.slope / x.at.bend;
    if (x.at.f + 0.5 * x.at.slope * (t - x.t) >= y.at.f + y.at.slope * (t - y.t)) return {t, false};
  }
  const double a = cut - x.t, b = cut - y.t;
  const double slope_x = x.at.slope + x.at.bend * a, slope_y = y.at.slope + y.at.bend * b;
  const double apart = 0.5 * (x.at.bend * a * a - y.at.bend * b * b);
  return {slope_x * slope_y < 0 ? cut - apart / (slope_x - slope_y) : cut, true};
}

// A place beyond the likely minimum, tried because the last `same` places all lay on the side of
// the end `x`. It lies beyond by as much as x is off a smooth minimum, or by a share of what the
// other end is off a kink.
double beyond(const Likely& likely, const Place& x, double other, int same) {
  const double left = other - likely.t;
  const double share = std::min(kAcross, std::ldexp(std::fabs(left), 2 * (same - 1)));
  const double step = likely.is_kink ? share * left : likely.t - x.t;
  return likely.t + (left > 0 ? std::max(step, kLeastAcross) : std::min(step, -kLeastAcross));
}

// Narrows the bracket until the tangents at its ends leave no room below the better end.
Bracket narrowed(const PathObjective& F, Bracket in, double limit) {
  bool is_low = std::fabs(in.a.slope) < std::fabs(in.b.slope);  // the end that was found last
  double wide = in.hi - in.lo;
  for (int i = 0, same = 0; i < 80; ++i) {
    const auto& [lo, hi, a, b] = in;
    const double cut =
        std::clamp((a.f - b.f + b.slope * hi - a.slope * lo) / (b.slope - a.slope), lo, hi);
    const double floor = a.f + a.slope * (cut - lo);
    if (agree(std::min(a.f, b.f), floor) || floor >= limit) break;
    const Place low{lo, a}, high{hi, b};
    const Place &last = is_low ? low : high, &other = is_low ? high : low;
    const Likely likely = likely_minimum(last, other, cut);
    const bool is_stuck = same > (likely.is_kink ? 0 : 1);
    double t = is_stuck ? beyond(likely, last, other.t, same) : likely.t;
    if (t <= lo) t = lo + kAcross * (hi - lo);
    if (t >= hi) t = hi - kAcross * (hi - lo);
    if (i % 4 == 3) {
      if (hi - lo > 0.25 * wide) t = 0.5 * (lo + hi);
      wide = hi - lo;
    }
    if (!(t > lo && t < hi)) break;
    const PathValue m = F(t);
    const bool falls = m.slope < 0;
    same = falls == is_low ? same + 1 : 0;
    is_low = falls;
    (falls ? in.lo : in.hi) = t;
    (falls ? in.a : in.b) = m;
    if (m.slope == 0) break;
  }
  return in;
}

// What the tangent plane at t says of how F bends within |s| <= half, per s^2 / 2;
// 1 - cos s >= s^2 / 2 - s^4 / 24.
double least_bend(const PathValue& m, double half) {
  const double share = m.inward > 0 ? std::max(0.0, 1 - half * half / 12) : 1;
  return m.inward * share - m.advance * half / 3;
}

}  // namespace

// As slope sin s >= 0 and s - sin s <= s / 2 (1 - cos s), where I is not negative to 2 I / |n h|;
// and for s <= 1, where the slope makes up for the rest.
double clear_reach(const PathValue& m) {
  const double bend = std::fabs(m.slope) / (std::max(-m.inward, 0.0) + m.advance / 3 + kNoDivisor);
  const double trough = 2 * m.inward / (m.advance + kNoDivisor);
  return std::max(std::min(5.0 / 3 * bend, 1.0), std::min(trough, kPi));
}

double below_tangent(const PathValue& m, double wide) {
  return std::max(0.0, -0.5 * least_bend(m, wide) * wide * wide);
}

Bracket bracket(const PathObjective& F, double lo, double hi, double guess, double limit) {
  const double from = std::clamp(guess, lo, hi);
  const Bracket first = walk_down(F, {from, F(from)}, lo, hi, limit);
  return first.lo < first.hi ? narrowed(F, first, limit) : first;
}

PathSample descend(const PathObjective& F, double lo, double hi, double guess, double limit) {
  return bracket(F, lo, hi, guess, limit).least();
}

double plane_bound(const PathValue& m, double half) {
  const double slope = std::abs(m.slope), bend = least_bend(m, half);
  const double s = bend * half > slope ? slope / bend : half;
  return m.f - slope * s + 0.5 * bend * s * s;
}

}  // namespace mrsim
