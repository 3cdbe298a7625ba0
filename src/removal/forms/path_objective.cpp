#include "removal/forms/path_objective.h"

#include "core/units.h"

#include <algorithm>

namespace mrsim {
namespace {

constexpr double kTiny = 1e-300;  // in the place of a divisor that is 0

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
  const double bend = std::fabs(m.slope) / (std::max(-m.inward, 0.0) + m.advance / 3 + kTiny);
  const double trough = 2 * m.inward / (m.advance + kTiny);
  return std::max(std::min(5.0 / 3 * bend, 1.0), std::min(trough, kPi));
}

double below_tangent(const PathValue& m, double wide) {
  return std::max(0.0, -0.5 * least_bend(m, wide) * wide * wide);
}

Bracket bracket(const PathObjective& F, double lo, double hi, double limit) {
  PathValue a = F(lo);
  if (a.slope >= 0) return {lo, lo, a, a};
  PathValue b = F(hi);
  if (b.slope <= 0) return {hi, hi, b, b};
  double weight_a = 1, weight_b = 1;
  int side = 0;  // of the last place, where two in a row lie on it
  for (int i = 0; i < 80; ++i) {
    const double cut =
        std::clamp((a.f - b.f + b.slope * hi - a.slope * lo) / (b.slope - a.slope), lo, hi);
    const double floor = a.f + a.slope * (cut - lo), best = a.f < b.f ? a.f : b.f;
    if (best - floor <= 1e-13 * (1 + (best < 0 ? -best : best)) || floor >= limit) break;
    // Tangents find kinks at once, the secant of the slopes smooth minima (Illinois); halving
    // bounds both.
    const double low = weight_a * a.slope, high = weight_b * b.slope;
    double t = i % 3 == 0   ? cut
               : i % 9 == 8 ? 0.5 * (lo + hi)
                            : lo - low * (hi - lo) / (high - low);
    if (!(t > lo && t < hi)) t = 0.5 * (lo + hi);
    if (!(t > lo && t < hi)) break;
    const PathValue m = F(t);
    if (m.slope < 0) {
      lo = t, a = m, weight_a = 1;
      weight_b = side < 0 ? 0.5 * weight_b : 1;
      side = -1;
    } else {
      hi = t, b = m, weight_b = 1;
      weight_a = side > 0 ? 0.5 * weight_a : 1;
      side = 1;
    }
    if (m.slope == 0) break;
  }
  return {lo, hi, a, b};
}

PathSample descend(const PathObjective& F, double lo, double hi, double limit) {
  return bracket(F, lo, hi, limit).least();
}

double plane_bound(const PathValue& m, double half) {
  const double slope = std::abs(m.slope), bend = least_bend(m, half);
  const double s = bend * half > slope ? slope / bend : half;
  return m.f - slope * s + 0.5 * bend * s * s;
}

}  // namespace mrsim
