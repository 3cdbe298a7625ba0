// F(t) = signed distance of the tool at rest from p - c(t); its minimum over t.
//
// Convex tool, straight path: F is convex, and the tangents at both ends of a bracket bound it from
// below, so the search ends when the best value and the bound agree. Convex tool, arc or helix: the
// tangent plane with normal n at the nearest place of the tool bounds the distance from below. On a
// helix of radius R with the rise h,
//   F(t + s) >= F(t) - n (c(t + s) - c(t)) = F(t) + F'(t) sin s - n h (s - sin s) + I (1 - cos s),
// where I, the dot product of n and c(t) - centre, is at least -R. Branch and bound with that
// (0 <= s - sin s <= s^3 / 6), and with the Lipschitz bound speed * s, needs some tens of values.
// Two kinds of arcs need fewer. About Z, F is convex wherever the lateral distance of p is
// (Objective::convex_reach), as it never falls with it: only the rest of a turn is left to branch
// and bound. About other axes a local minimum clears its neighbourhood (clear_reach), at the bottom
// of a trough half a turn.
// Other tools are unions of convex ones (Profile::convex_pieces); where they are not, the
// Lipschitz bound alone is left, which takes up to 1e5 values about a smooth minimum.
#include "removal/forms/path_search.h"

#include "core/trig.h"
#include "core/units.h"
#include "removal/forms/cone_helix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace mrsim {
namespace {

constexpr double kTiny = 1e-300;  // in the place of a divisor that is 0

struct Value {
  double f = 0, slope = 0;
  double inward = 0, advance = 0;  ///< I and |n h| above
};

class Objective {
 public:
  Objective(const Profile& tool, const ToolPath& path, const Vec3& p)
      : tool_(tool), path_(path), p_(p) {}

  Value operator()(double t) const {
    const PathPoint at = path_point(path_, t);
    const Vec3 q = p_ - at.position, d = at.direction;
    const double rho = std::sqrt(q.x * q.x + q.y * q.y);
    const ProfileSample s = tool_sample(tool_, rho, q.z);
    const double lateral = rho > 0 ? s.gradient.x / rho : 0;
    const Vec3 n{lateral * q.x, lateral * q.y, s.gradient.y};
    const Vec3 out = at.position - path_.center - t * path_.rise;
    return {s.distance, -dot(n, d), dot(n, out), std::fabs(dot(n, path_.rise))};
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

  /// The same over all from `begin` to `end`.
  double range_bound(double begin, double end) const {
    return horizontal_bound(0.5 * (begin + end), 0.5 * (end - begin), to_circle());
  }

  /// On a horizontal path the lateral distance of p, sqrt(D^2 + R^2 - 2 D R cos(angle)), is convex
  /// up to this angle on both sides of the position that looks at p, and then has no minimum before
  /// that of the next turn.
  double convex_reach() const {
    const double dx = p_.x - path_.center.x, dy = p_.y - path_.center.y;
    const double d = std::sqrt(dx * dx + dy * dy);
    const double least = std::min(d, path_.radius), most = std::max(d, path_.radius);
    return mrsim::atan2(std::sqrt(most * most - least * least), least);
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

  /// The best position on each turn lies, in plan, towards p.
  double towards() const {
    const Vec3 w = p_ - path_.center;
    double a = mrsim::atan2(dot(w, path_.v), dot(w, path_.u));
    return a < 0 ? a + kTwoPi : a;
  }

 private:
  const Profile& tool_;
  const ToolPath& path_;
  const Vec3 p_;
};

double clamp(double t, double lo, double hi) { return t < lo ? lo : t > hi ? hi : t; }

// Both sides of a local minimum; equal at an end of the range.
struct Bracket {
  double lo, hi;
  Value a, b;  ///< F there

  PathSample least() const { return a.f < b.f ? PathSample{a.f, lo} : PathSample{b.f, hi}; }
};

// How far from t, on the side where F does not fall, F is at least F(t): less than half a turn. As
// slope sin s >= 0 and s - sin s <= s / 2 (1 - cos s), where I is not negative to 2 I / |n h|; and
// for s <= 1, where the slope makes up for the rest.
double clear_reach(const Value& m) {
  const double bend = std::fabs(m.slope) / (std::max(-m.inward, 0.0) + m.advance / 3 + kTiny);
  const double trough = 2 * m.inward / (m.advance + kTiny);
  return std::max(std::min(5.0 / 3 * bend, 1.0), std::min(trough, kPi));
}

// What the tangent plane at t says of how F bends within |s| <= half, per s^2 / 2;
// 1 - cos s >= s^2 / 2 - s^4 / 24.
double least_bend(const Value& m, double half) {
  const double share = m.inward > 0 ? std::max(0.0, 1 - half * half / 12) : 1;
  return m.inward * share - m.advance * half / 3;
}

// How far F may be below its tangent at t within `wide`, mm.
double below_tangent(const Value& m, double wide) {
  return std::max(0.0, -0.5 * least_bend(m, wide) * wide * wide);
}

// About the minimum of a convex F on [lo, hi], or the local one that F'(lo) < 0 < F'(hi) holds.
Bracket bracket(const Objective& F, double lo, double hi) {
  Value a = F(lo);
  if (a.slope >= 0) return {lo, lo, a, a};
  Value b = F(hi);
  if (b.slope <= 0) return {hi, hi, b, b};
  double weight_a = 1, weight_b = 1;
  int side = 0;  // of the last place, where two in a row lie on it
  for (int i = 0; i < 80; ++i) {
    const double cut =
        clamp((a.f - b.f + b.slope * hi - a.slope * lo) / (b.slope - a.slope), lo, hi);
    const double floor = a.f + a.slope * (cut - lo), best = a.f < b.f ? a.f : b.f;
    if (best - floor <= 1e-13 * (1 + (best < 0 ? -best : best))) break;
    // Tangents find kinks at once, the secant of the slopes smooth minima (Illinois); halving
    // bounds both.
    const double low = weight_a * a.slope, high = weight_b * b.slope;
    double t = i % 3 == 0   ? cut
               : i % 9 == 8 ? 0.5 * (lo + hi)
                            : lo - low * (hi - lo) / (high - low);
    if (!(t > lo && t < hi)) t = 0.5 * (lo + hi);
    if (!(t > lo && t < hi)) break;
    const Value m = F(t);
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

PathSample descend(const Objective& F, double lo, double hi) { return bracket(F, lo, hi).least(); }

struct Interval {
  double lo, hi;
};

// Lower bound of F over |s| <= half by the tangent plane at s = 0.
double plane_bound(const Value& m, double half) {
  const double slope = std::abs(m.slope), bend = least_bend(m, half);
  const double s = bend * half > slope ? slope / bend : half;
  return m.f - slope * s + 0.5 * bend * s * s;
}

PathSample nearer(const PathSample& a, const PathSample& b) {
  return a.distance <= b.distance ? a : b;
}
PathSample ends(const Objective& F, double begin, double end) {
  return nearer({F(begin).f, begin}, {F(end).f, end});
}

// A convex tool on an arc or a helix about Z, over [begin, end], for something nearer than `best`.
PathSample search_horizontal(const Objective& F, double begin, double end, PathSample best) {
  const double near = F.to_circle();
  double first = F.towards();
  while (first < begin) first += kTwoPi;
  if (first <= end)
    if (const auto wall = F.upright_wall(near, begin, end)) return nearer(best, {*wall, first});
  best = nearer(best, ends(F, begin, end));
  const double reach = F.convex_reach();
  static thread_local std::vector<Interval> open;
  open.clear();
  double from = begin;
  for (double facing = first - kTwoPi; from < end; facing += kTwoPi) {
    const double lo = clamp(facing - reach, from, end), hi = clamp(facing + reach, lo, end);
    if (lo > from) open.push_back({from, lo});
    from = hi;
    const double half = 0.5 * (hi - lo);
    if (hi <= lo || F.horizontal_bound(lo + half, half, near) >= best.distance) continue;
    const PathSample least = descend(F, lo, hi);
    if (least.distance < best.distance) best = least;
  }
  double finest = 0;
  while (!open.empty()) {
    const Interval in = open.back();
    open.pop_back();
    const double half = 0.5 * (in.hi - in.lo), mid = 0.5 * (in.lo + in.hi);
    const double nearest = std::min(F.lateral(in.lo), F.lateral(in.hi));
    if (F.horizontal_bound(mid, half, nearest) >= best.distance - kPathError) continue;
    const Value m = F(mid);
    if (m.f < best.distance) best = {m.f, mid}, finest = half;
    if (plane_bound(m, half) >= best.distance - kPathError) continue;
    open.push_back({in.lo, mid});
    open.push_back({mid, in.hi});
    if (m.slope < 0)
      std::swap(open.back(), open[open.size() - 2]);  // downhill last: looked at first
  }
  if (finest == 0) return best;
  const PathSample polished =
      descend(F, clamp(best.t - finest, begin, end), clamp(best.t + finest, begin, end));
  return polished.distance < best.distance ? polished : best;
}

// Branch and bound over [begin, end], for something nearer than `best`.
PathSample search_all(const Objective& F, const Profile& tool, const ToolPath& path, double begin,
                      double end, PathSample best) {
  if (path.horizontal) {
    const double guess = F.towards();
    for (double t = guess; t < end; t += kTwoPi) {
      if (t < begin) continue;
      const Value v = F(t);
      if (v.f < best.distance) best = {v.f, t};
    }
  }
  double finest = 0;
  std::array<Interval, 128> stack;
  std::size_t depth = 0;
  stack[depth++] = {begin, end};
  while (depth > 0) {
    const Interval in = stack[--depth];
    const double half = 0.5 * (in.hi - in.lo), mid = 0.5 * (in.lo + in.hi);
    if (path.horizontal &&
        F.horizontal_bound(mid, half, F.to_circle()) >= best.distance - kPathError)
      continue;
    const Value m = F(mid);
    if (m.f < best.distance) best = {m.f, mid}, finest = half;
    double bound = m.f - path.speed * half;
    if (tool.is_convex()) bound = std::max(bound, plane_bound(m, half));
    if (bound >= best.distance - kPathError || depth + 2 > stack.size()) continue;
    const Interval low = {in.lo, mid}, high = {mid, in.hi};
    stack[depth++] = m.slope < 0 ? low : high;  // the downhill half is looked at first
    stack[depth++] = m.slope < 0 ? high : low;
  }
  if (finest == 0) return best;
  return nearer(best,
                descend(F, clamp(best.t - finest, begin, end), clamp(best.t + finest, begin, end)));
}

// A convex tool on an arc in any plane but a horizontal one, over [begin, end].
PathSample search_steep(const Objective& F, const Profile& tool, const ToolPath& path, double begin,
                        double end) {
  if (end - begin > kPi) {
    const double mid = 0.5 * (begin + end);
    const PathSample a = search_steep(F, tool, path, begin, mid);
    return nearer(a, search_steep(F, tool, path, mid, end));
  }
  const Bracket local = bracket(F, begin, end);
  PathSample best = local.least();
  const auto look = [&](double from, double to, double bound) {
    if (from >= to) return;
    best = search_all(F, tool, path, from, to, nearer(best, {F(bound).f, bound}));
  };
  look(begin, local.lo - clear_reach(local.a), begin);
  const double wide = local.hi - local.lo;
  if (std::max(below_tangent(local.a, wide), below_tangent(local.b, wide)) > kPathError)
    look(local.lo, local.hi, local.lo);
  look(local.hi + clear_reach(local.b), end, end);
  return best;
}

std::optional<PathSample> cone_minimum(const Profile& tool, const ToolPath& path, const Vec3& p,
                                       double begin, double end) {
  if (!path.horizontal || !tool.is_convex() || end - begin > kTwoPi) return std::nullopt;
  return cone_helix_minimum(tool, path, p, begin, end);
}

PathSample search(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                  double end, PathSample best = {std::numeric_limits<double>::infinity()});

// The piece that may be nearest comes first, so that others need not be searched.
PathSample search_pieces(std::span<const Profile> pieces, const ToolPath& path, const Vec3& p,
                         double begin, double end, PathSample best) {
  std::size_t first = 0;
  if (path.horizontal) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const double bound = Objective(pieces[k], path, p).range_bound(begin, end);
      if (bound < least) least = bound, first = k;
    }
  }
  best = search(pieces[first], path, p, begin, end, best);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    if (k != first) best = nearer(best, search(pieces[k], path, p, begin, end, best));
  return best;
}

PathSample search(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                  double end, PathSample best) {
  if (const std::span<const Profile> pieces = tool.convex_pieces(); !pieces.empty())
    return search_pieces(pieces, path, p, begin, end, best);
  const Objective F(tool, path, p);
  const bool may_lose = path.horizontal && std::isfinite(best.distance);
  if (may_lose && F.range_bound(begin, end) >= best.distance) return best;
  if (const auto least = cone_minimum(tool, path, p, begin, end)) return nearer(best, *least);
  if (!tool.is_convex()) return search_all(F, tool, path, begin, end, ends(F, begin, end));
  if (!path.arc) return descend(F, begin, end);
  return path.horizontal ? search_horizontal(F, begin, end, best)
                         : search_steep(F, tool, path, begin, end);
}

}  // namespace

PathSample search_path(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                       double end) {
  return search(tool, path, p, begin, end);
}

// The lowest turn of a helix that falls with t, tool rising: F grows with the lateral distance and
// falls with the height above the tip. Of the positions before the one that looks at p none is
// better, because they are higher and no nearer; behind it, up to the opposite one, the lateral
// distance and the height both grow, so that the lateral distance at the beginning of an interval
// and the height at its end bound F. The end of the path is the lowest, and a candidate by itself.
PathSample search_lowest_turn(const Profile& tool, const ToolPath& path, const Vec3& p) {
  if (const auto least = cone_minimum(tool, path, p, 0, path.sweep)) return *least;
  const Objective F(tool, path, p);
  const double end = path.sweep, facing = F.towards();
  if (end >= kTwoPi) {  // beside the wall of a bore heights do not matter
    const double wall = F.at_rest(F.to_circle(), F.height(end));
    if (wall == F.at_rest(F.to_circle(), F.height(0))) return {wall, facing};
  }
  PathSample best{F(end).f, end};
  double from = facing, to = std::min(facing + kPi, end);
  if (facing > end) {  // p looks at the gap between end and start
    if (facing - end <= kTwoPi - facing) return best;
    from = 0, to = std::min(std::max(0.0, facing - kPi), end);
  }
  const double near = facing > end ? F.lateral(from) : F.to_circle();
  const double first = F.at_rest(near, F.height(from));
  if (first <= best.distance) best = {first, from};
  struct Span {
    double lo, hi, near;
  };
  std::array<Span, 128> stack;
  std::size_t depth = 0;
  double begin = from;  // of what is not known to be convex
  if (tool.is_convex()) {
    begin = clamp((facing > end ? facing - kTwoPi : facing) + F.convex_reach(), from, to);
    const PathSample least = descend(F, from, begin);
    if (least.distance < best.distance) best = least;
  }
  stack[depth++] = {begin, to, begin > from ? F.lateral(begin) : near};
  double finest = 0;
  while (depth > 0) {
    const Span in = stack[--depth];
    const double floor = F.at_rest(in.near, F.height(in.hi));
    if (floor >= best.distance - (finest > 0 ? kPathError : 1e-12)) continue;
    const double half = 0.5 * (in.hi - in.lo), mid = 0.5 * (in.lo + in.hi);
    const Value m = F(mid);
    finest = finest > 0 ? finest : half;
    if (m.f < best.distance) best = {m.f, mid}, finest = half;
    if (tool.is_convex() && plane_bound(m, half) >= best.distance - kPathError) continue;
    if (depth + 2 > stack.size()) continue;
    const Span low = {in.lo, mid, in.near}, high = {mid, in.hi, F.lateral(mid)};
    stack[depth++] = m.slope < 0 ? low : high;
    stack[depth++] = m.slope < 0 ? high : low;
  }
  if (finest == 0) return best;
  const PathSample polished =
      descend(F, clamp(best.t - finest, from, to), clamp(best.t + finest, from, to));
  return polished.distance < best.distance ? polished : best;
}

}  // namespace mrsim
