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
// (PathObjective::convex_part), as it never falls with it: only the rest of a turn is left to
// branch and bound. About other axes a local minimum clears its neighbourhood (clear_reach), at the
// bottom of a trough half a turn. Other tools are unions of convex ones (Profile::convex_pieces)
// and what concave arcs leave between them; where they are not, the Lipschitz bound alone is left,
// which takes up to 1e5 values about a smooth minimum.
#include "removal/forms/path_search.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "removal/forms/cone_helix.h"
#include "removal/forms/fillet_search.h"
#include "removal/forms/path_objective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace mrsim {
namespace {

constexpr double kValueError = 1e-12;  // mm: rounding of a distance at one position

struct Interval {
  double lo, hi;
};

PathSample nearer(const PathSample& a, const PathSample& b) {
  return a.distance <= b.distance ? a : b;
}
PathSample ends(const PathObjective& F, double begin, double end) {
  return nearer({F(begin).f, begin}, {F(end).f, end});
}

// A convex tool on an arc or a helix about Z, over [begin, end], for something nearer than `best`;
// `guess`: about where it is.
PathSample search_horizontal(const PathObjective& F, double begin, double end, double guess,
                             PathSample best) {
  const double near = F.to_circle();
  double first = F.towards();
  while (first < begin) first += kTwoPi;
  if (first <= end)
    if (const auto wall = F.upright_wall(near, begin, end)) return nearer(best, {*wall, first});
  const PathObjective::Convex convex = F.convex_part();
  static thread_local std::vector<Interval> open;
  open.clear();
  double from = begin;
  for (double facing = first - kTwoPi; from < end; facing += kTwoPi) {
    const double lo = std::clamp(facing - convex.reach, from, end),
                 hi = std::clamp(facing + convex.reach, lo, end);
    if (lo > from) open.push_back({from, lo});
    from = hi;
    const double half = 0.5 * (hi - lo);
    if (hi <= lo || F.horizontal_bound(lo + half, half, near) >= best.distance) continue;
    const double from_guess = lo <= guess && guess <= hi ? guess : facing;
    const PathSample least = descend(F, lo, hi, from_guess, best.distance);
    if (least.distance < best.distance) best = least;
  }
  const auto bound = [&](const Interval& in, double nearest) {
    return F.horizontal_bound(0.5 * (in.lo + in.hi), 0.5 * (in.hi - in.lo), nearest);
  };
  std::erase_if(open,
                [&](const Interval& in) { return bound(in, convex.beyond) >= best.distance; });
  if (open.empty()) return best;
  best = nearer(best, ends(F, begin, end));
  double finest = 0;
  while (!open.empty()) {
    const Interval in = open.back();
    open.pop_back();
    const double half = 0.5 * (in.hi - in.lo), mid = 0.5 * (in.lo + in.hi);
    const double nearest = std::min(F.lateral(in.lo), F.lateral(in.hi));
    if (bound(in, nearest) >= best.distance - kPathError) continue;
    const PathValue m = F(mid);
    if (m.f < best.distance) best = {m.f, mid}, finest = half;
    if (plane_bound(m, half) >= best.distance - kPathError) continue;
    open.push_back({in.lo, mid});
    open.push_back({mid, in.hi});
    if (m.slope < 0)
      std::swap(open.back(), open[open.size() - 2]);  // downhill last: looked at first
  }
  if (finest == 0) return best;
  const PathSample polished = descend(F, std::clamp(best.t - finest, begin, end),
                                      std::clamp(best.t + finest, begin, end), best.t);
  return polished.distance < best.distance ? polished : best;
}

// Branch and bound over [begin, end], for something nearer than `best`.
PathSample search_all(const PathObjective& F, const Profile& tool, const ToolPath& path,
                      double begin, double end, PathSample best) {
  if (path.horizontal) {
    const double guess = F.towards();
    for (double t = guess; t < end; t += kTwoPi) {
      if (t < begin) continue;
      const PathValue v = F(t);
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
    const PathValue m = F(mid);
    if (m.f < best.distance) best = {m.f, mid}, finest = half;
    double bound = m.f - path.speed * half;
    if (tool.is_convex()) bound = std::max(bound, plane_bound(m, half));
    if (bound >= best.distance - kPathError || depth + 2 > stack.size()) continue;
    const Interval low = {in.lo, mid}, high = {mid, in.hi};
    stack[depth++] = m.slope < 0 ? low : high;  // the downhill half is looked at first
    stack[depth++] = m.slope < 0 ? high : low;
  }
  if (finest == 0) return best;
  return nearer(best, descend(F, std::clamp(best.t - finest, begin, end),
                              std::clamp(best.t + finest, begin, end), best.t));
}

// A convex tool on an arc in any plane but a horizontal one, over [begin, end].
PathSample search_steep(const PathObjective& F, const Profile& tool, const ToolPath& path,
                        double begin, double end) {
  if (end - begin > kPi) {
    const double mid = 0.5 * (begin + end);
    const PathSample a = search_steep(F, tool, path, begin, mid);
    return nearer(a, search_steep(F, tool, path, mid, end));
  }
  const Bracket local = bracket(F, begin, end, F.towards());
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

// The cones of a tool on a path about Z, if one of them may be nearest.
std::optional<ConeHelix> cones_about(const ToolPath& path, const Vec3& p, double begin,
                                     double end) {
  if (!path.horizontal || end - begin > kTwoPi) return std::nullopt;
  return std::optional<ConeHelix>(std::in_place, path, p, begin, end);
}

// Searches for something nearer than `best`, with a tool as a whole or with one piece. Where
// nothing is nearer than `limit`, any distance above it.
PathSample search_whole(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                        double end, const std::optional<ConeHelix>& cones, PathSample best,
                        double limit = kInfinity) {
  double guess = -kInfinity;
  if (cones && tool.is_convex()) {
    const auto [least, is_exact] = cones->minimum(tool, best.distance);
    if (is_exact || least.distance > limit) return nearer(best, least);
    guess = least.t;
  }
  const PathObjective F(tool, path, p);
  if (!tool.is_convex())
    return search_all(F, tool, path, begin, end, nearer(best, ends(F, begin, end)));
  if (!path.arc)
    return nearer(best, descend(F, begin, end, F.towards(), std::min(best.distance, limit)));
  return path.horizontal ? search_horizontal(F, begin, end, guess, best)
                         : nearer(best, search_steep(F, tool, path, begin, end));
}

// How a place lies to the positions of a path: heights above their tips, and the least distance
// from their axes.
struct Seen {
  double low = -kInfinity, high = kInfinity, near = 0;

  /// No position of the tool is nearer.
  double bound(const Profile& tool) const {
    return std::max({tool.bottom() - high, low - tool.top(), near - tool.max_radius()});
  }
};

Seen seen_from(const ToolPath& path, const Vec3& p, double begin, double end) {
  if (path.arc && !path.horizontal) return {};
  const Vec3 a = p - path_point(path, begin).position, b = p - path_point(path, end).position;
  Seen seen{.low = std::min(a.z, b.z), .high = std::max(a.z, b.z)};
  const double x = p.x - path.center.x, y = p.y - path.center.y;
  if (path.arc) seen.near = std::fabs(std::sqrt(x * x + y * y) - path.radius);
  return seen;
}

// Whether no piece is nearer than `limit`, as far as cones tell.
bool is_beyond(std::span<const Profile> pieces, const ConeHelix& cones, double limit) {
  return std::ranges::all_of(
      pieces, [&](const Profile& piece) { return cones.minimum(piece).least.distance > limit; });
}

bool is_concave_arc(const ProfileEdge& edge) { return edge.is_arc() && !edge.convex; }

// The least of `best` and what lies between the pieces and the concave arcs of a tool.
PathSample search_fillets(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                          double end, PathSample best) {
  for (const ProfileEdge& edge : tool.edges())
    if (is_concave_arc(edge)) best = search_fillet(tool, edge, path, p, begin, end, best);
  return best;
}

// Whether nothing of that is nearer than `limit`. Not known inside, where a search ends early.
bool are_fillets_beyond(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                        double end, double limit) {
  if (std::ranges::none_of(tool.edges(), is_concave_arc)) return true;
  const PathSample most{limit + 2 * kPathError, begin};
  return limit > 0 && search_fillets(tool, path, p, begin, end, most).distance > limit;
}

// Searches with each of a tool's convex pieces. The one that may be nearest comes first, so that
// others need not be searched.
PathSample search_pieces(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                         double end, double limit) {
  const std::span<const Profile> pieces = tool.convex_pieces();
  static thread_local std::vector<double> bounds;
  bounds.assign(pieces.size(), -kInfinity);
  std::size_t first = 0;
  if (path.horizontal || !path.arc) {
    const Seen seen = seen_from(path, p, begin, end);
    double least = kInfinity;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      bounds[k] = seen.bound(pieces[k]);
      if (bounds[k] >= least) continue;
      if (path.horizontal) bounds[k] = PathObjective(pieces[k], path, p).range_bound(begin, end);
      if (bounds[k] < least) least = bounds[k], first = k;
    }
  }
  const std::optional<ConeHelix> cones = cones_about(path, p, begin, end);
  const bool are_beyond = std::ranges::all_of(bounds, [&](double b) { return b > limit; }) ||
                          (limit < kInfinity && cones && is_beyond(pieces, *cones, limit));
  if (are_beyond && are_fillets_beyond(tool, path, p, begin, end, limit)) return {kInfinity, begin};
  PathSample best = search_whole(pieces[first], path, p, begin, end, cones, {kInfinity, begin});
  for (std::size_t k = 0; k < pieces.size(); ++k)
    if (k != first && bounds[k] < best.distance)
      best = search_whole(pieces[k], path, p, begin, end, cones, best);
  return search_fillets(tool, path, p, begin, end, best);
}

}  // namespace

PathSample search_path(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                       double end, double limit) {
  if (!tool.convex_pieces().empty()) return search_pieces(tool, path, p, begin, end, limit);
  return search_whole(tool, path, p, begin, end, cones_about(path, p, begin, end),
                      {kInfinity, begin}, limit);
}

// The lowest turn of a helix that falls with t, tool rising: F grows with the lateral distance and
// falls with the height above the tip. Of the positions before the one that looks at p none is
// better, because they are higher and no nearer; behind it, up to the opposite one, the lateral
// distance and the height both grow, so that the lateral distance at the beginning of an interval
// and the height at its end bound F. The end of the path is the lowest, and a candidate by itself.
PathSample search_lowest_turn(const Profile& tool, const ToolPath& path, const Vec3& p,
                              double limit) {
  if (!tool.convex_pieces().empty()) return search_pieces(tool, path, p, 0, path.sweep, limit);
  if (const auto cones = cones_about(path, p, 0, path.sweep); cones && tool.is_convex())
    if (const auto found = cones->minimum(tool); found.is_exact || found.least.distance > limit)
      return found.least;
  const PathObjective F(tool, path, p);
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
    begin = std::clamp((facing > end ? facing - kTwoPi : facing) + F.convex_part().reach, from, to);
    const PathSample least = descend(F, from, begin, from);
    if (least.distance < best.distance) best = least;
  }
  stack[depth++] = {begin, to, begin > from ? F.lateral(begin) : near};
  double finest = 0;
  while (depth > 0) {
    const Span in = stack[--depth];
    const double floor = F.at_rest(in.near, F.height(in.hi));
    if (floor >= best.distance - (finest > 0 ? kPathError : kValueError)) continue;
    const double half = 0.5 * (in.hi - in.lo), mid = 0.5 * (in.lo + in.hi);
    const PathValue m = F(mid);
    finest = finest > 0 ? finest : half;
    if (m.f < best.distance) best = {m.f, mid}, finest = half;
    if (tool.is_convex() && plane_bound(m, half) >= best.distance - kPathError) continue;
    if (depth + 2 > stack.size()) continue;
    const Span low = {in.lo, mid, in.near}, high = {mid, in.hi, F.lateral(mid)};
    stack[depth++] = m.slope < 0 ? low : high;
    stack[depth++] = m.slope < 0 ? high : low;
  }
  if (finest == 0) return best;
  const PathSample polished = descend(F, std::clamp(best.t - finest, from, to),
                                      std::clamp(best.t + finest, from, to), best.t);
  return polished.distance < best.distance ? polished : best;
}

}  // namespace mrsim
