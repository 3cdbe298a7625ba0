#include "interp/path/region.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/path/plane_piece.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kKeeps = 1e-4;  // mm: a place may be too near by at most this
// mm: pieces of the offset border may be too near by this. The values are tried in turn until the
// pieces make loops.
constexpr double kTooNear[] = {1e-7, 1e-5, kKeeps};
constexpr double kSameSpot = 1e-6;    // mm
constexpr double kJoins = 2e-3;       // mm: the gap that rounding leaves between two pieces
constexpr double kOutwards = 0.0137;  // share of a step, where loops cannot be joined
constexpr std::size_t kMostLoops = 20'000;

double travel_of(const PlanePiece& piece) {
  return piece.arc ? extent(piece) * piece.radius : extent(piece);
}

PlanePiece part_of(const PlanePiece& piece, double from, double to) {
  PlanePiece out = piece;
  out.start = from <= 0 ? piece.start : point_at(piece, from);
  out.end = to >= extent(piece) ? piece.end : point_at(piece, to);
  if (piece.arc) out.sweep = piece.sweep < 0 ? from - to : to - from;
  return out;
}

bool near_each_other(const PieceBounds& a, const PieceBounds& b) {
  return a.low.x <= b.high.x + kSameSpot && b.low.x <= a.high.x + kSameSpot &&
         a.low.y <= b.high.y + kSameSpot && b.low.y <= a.high.y + kSameSpot;
}

PieceBounds bounds_of(const PlanePiece& piece) {
  if (piece.arc) {
    const Vec2 r{piece.radius, piece.radius};
    return {piece.center - r, piece.center + r};
  }
  return {{std::min(piece.start.x, piece.end.x), std::min(piece.start.y, piece.end.y)},
          {std::max(piece.start.x, piece.end.x), std::max(piece.start.y, piece.end.y)}};
}

// The pieces offset, and arcs about the corners that the area reaches around.
std::vector<PlanePiece> moved_border(const std::vector<Loop>& contours, double distance) {
  std::vector<PlanePiece> out;
  for (const Loop& loop : contours)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PlanePiece &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const PlanePiece aside = offset_piece(a, distance);
      if (!aside.arc || aside.radius > kSameSpot) out.push_back(aside);
      const Vec2 t1 = end_tangent(a), t2 = start_tangent(b);
      const double turn = cross(t1, t2), ahead = dot(t1, t2);
      if (turn > -kTurnRounding && (ahead > 0 || turn > kTurnRounding)) continue;
      PlanePiece round;
      round.arc = true;
      round.center = b.start;
      round.radius = distance;
      round.start = b.start + distance * left_of(t1);
      round.end = b.start + distance * left_of(t2);
      round.sweep = -std::abs(mrsim::atan2(turn, ahead));
      out.push_back(round);
    }
  return out;
}

// Where other pieces meet this one: values of position_on() in order.
std::vector<double> cuts_of(std::size_t i, const std::vector<PlanePiece>& pieces,
                            const std::vector<PieceBounds>& bounds) {
  const PlanePiece& piece = pieces[i];
  const double whole = extent(piece);
  std::vector<double> cuts{0, whole};
  const auto add = [&](Vec2 p) {
    if (distance_to(piece, p) > kSameSpot) return;
    const double along = position_on(piece, p);
    if (along > 0 && along < whole) cuts.push_back(along);
  };
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (k == i || !near_each_other(bounds[i], bounds[k])) continue;
    std::array<Vec2, 2> hits;
    const int n = intersect(piece, pieces[k], hits);
    for (int h = 0; h < n; ++h) {
      const Vec2 p = hits[static_cast<std::size_t>(h)];
      if (distance_to(pieces[k], p) <= kSameSpot) add(p);
    }
    add(pieces[k].start);
    add(pieces[k].end);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

using Parts =
    std::vector<std::pair<PlanePiece, double>>;  // each with its distance from the contours

bool same_piece(const PlanePiece& a, const PlanePiece& b) {
  return a.arc == b.arc && length(a.start - b.start) < kSameSpot &&
         length(a.end - b.end) < kSameSpot &&
         length(point_at(a, extent(a) / 2) - point_at(b, extent(b) / 2)) < kSameSpot;
}

// Pieces of two contours that coincide are kept once.
void drop_twins(Parts& parts) {
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.first.start.x < b.first.start.x; });
  Parts once;
  for (const auto& part : parts) {
    bool twin = false;
    for (std::size_t i = once.size(); i > 0 && !twin; --i) {
      const PlanePiece& other = once[i - 1].first;
      if (part.first.start.x - other.start.x > kSameSpot) break;
      twin = same_piece(other, part.first);
    }
    if (!twin) once.push_back(part);
  }
  parts = std::move(once);
}

// Joins pieces to closed loops, from end to start. False: a piece has no successor.
bool join_loops(std::vector<PlanePiece> pieces, std::vector<Loop>& out) {
  while (!pieces.empty()) {
    Loop loop{pieces.back()};
    pieces.pop_back();
    for (;;) {
      const Vec2 at = loop.back().end;
      double nearest = kJoins;
      std::size_t next = pieces.size();
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double far = length(pieces[i].start - at);
        if (far >= nearest) continue;
        nearest = far;
        next = i;
      }
      const double home = length(loop.front().start - at);
      const bool closed = home <= kJoins && home <= nearest + kSameSpot;
      if (!closed && next == pieces.size()) return false;
      const Vec2 to = closed ? loop.front().start : pieces[next].start;
      if (length(to - at) > kRounding) {
        PlanePiece bridge;
        bridge.start = at;
        bridge.end = to;
        loop.push_back(bridge);
      }
      if (closed) break;
      loop.push_back(pieces[next]);
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(next));
    }
    out.push_back(std::move(loop));
  }
  return true;
}

// The contour as a polygon that leaves it by at most `far`.
std::vector<Vec2> polygon_of(const Loop& loop, double far) {
  std::vector<Vec2> out;
  for (const PlanePiece& piece : loop) {
    int n = 1;
    if (piece.arc) {
      const double share = std::min(1.0, far / piece.radius);
      const double step = std::sqrt(8 * share);  // a little less than the sagitta allows
      n = 1 + static_cast<int>(std::min(1e5, std::ceil(extent(piece) / std::min(step, 1.0))));
    }
    for (int i = 0; i < n; ++i) out.push_back(point_at(piece, extent(piece) * i / n));
  }
  return out;
}

bool surrounds(const std::vector<Vec2>& polygon, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++) {
    const Vec2 a = polygon[i], b = polygon[k];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

Loop turning(const Loop& loop, bool counter_clockwise) {
  return (signed_area(loop) > 0) == counter_clockwise ? loop : reversed(loop);
}

double distance_to_loop(const Loop& loop, Vec2 p) {
  double least = kInfinity;
  for (const PlanePiece& piece : loop) least = std::min(least, distance_to(piece, p));
  return least;
}

}  // namespace

double signed_area(const Loop& loop) {
  double twice = 0;
  for (const PlanePiece& piece : loop) {
    twice += cross(piece.start, piece.end);
    if (piece.arc) twice += piece.radius * piece.radius * (piece.sweep - sincos(piece.sweep).sin);
  }
  return twice / 2;
}

Loop begun_near(const Loop& loop, Vec2 p) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < loop.size(); ++i)
    if (distance_to(loop[i], p) < distance_to(loop[best], p)) best = i;
  const PlanePiece& split = loop[best];
  const double at = nearest_along(split, p);
  Loop out;
  if (at < extent(split)) out.push_back(part_of(split, at, extent(split)));
  for (std::size_t i = 1; i < loop.size(); ++i) out.push_back(loop[(best + i) % loop.size()]);
  if (at > 0) out.push_back(part_of(split, 0, at));
  return out;
}

Region::Region(const std::optional<Loop>& outer, const std::vector<Loop>& islands)
    : has_outer_(outer.has_value()) {
  if (outer) contours_.push_back(turning(*outer, true));
  for (const Loop& island : islands) contours_.push_back(turning(island, false));
  for (const Loop& loop : contours_)
    for (const PlanePiece& piece : loop) bounds_.push_back(bounds_of(piece));
}

std::size_t Region::pieces() const {
  std::size_t n = 0;
  for (const Loop& loop : contours_) n += loop.size();
  return n;
}

bool Region::contains(Vec2 p, const std::vector<std::vector<Vec2>>& polygons) const {
  for (std::size_t i = 0; i < polygons.size(); ++i)
    if (surrounds(polygons[i], p) != (has_outer_ && i == 0)) return false;
  return true;
}

// A distance below `enough` is not needed exactly, so the search ends at the first such one.
double Region::distance_from_contours(Vec2 p, double enough) const {
  double least = kInfinity;
  std::size_t at = 0;
  for (const Loop& loop : contours_)
    for (const PlanePiece& piece : loop) {
      const PieceBounds& box = bounds_[at++];
      const double dx = std::max({box.low.x - p.x, p.x - box.high.x, 0.0});
      const double dy = std::max({box.low.y - p.y, p.y - box.high.y, 0.0});
      if (std::max(dx, dy) >= least) continue;
      least = std::min(least, distance_to(piece, p));
      if (least < enough) return least;
    }
  return least;
}

// A piece that ends in a cusp, or at a gap that the rounding of contours leaves, is in doubt. So
// first only pieces that keep the distance exactly are taken, then those that nearly do.
bool Region::inset(double distance, std::vector<Loop>& out) const {
  const std::vector<PlanePiece> border = moved_border(contours_, distance);
  std::vector<PieceBounds> bounds;
  for (const PlanePiece& piece : border) bounds.push_back(bounds_of(piece));
  std::vector<std::vector<Vec2>> polygons;
  for (const Loop& loop : contours_) polygons.push_back(polygon_of(loop, distance / 10));
  Parts parts;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const std::vector<double> cuts = cuts_of(i, border, bounds);
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      const PlanePiece part = part_of(border[i], cuts[k - 1], cuts[k]);
      if (travel_of(part) < kSameSpot) continue;
      const Vec2 middle = point_at(part, extent(part) / 2);
      const double far = distance_from_contours(middle, distance - kKeeps);
      if (far < distance - kKeeps || !contains(middle, polygons)) continue;
      parts.emplace_back(part, far);
    }
  }
  drop_twins(parts);
  bool none = false;
  for (const double doubt : kTooNear) {
    std::vector<PlanePiece> kept;
    for (const auto& [part, far] : parts)
      if (far >= distance - doubt) kept.push_back(part);
    out.clear();
    none = none || kept.empty();
    if (!kept.empty() && join_loops(std::move(kept), out)) return true;
  }
  out.clear();
  return none;
}

bool Region::keeps(Vec2 from, Vec2 to, double distance) const {
  if (length(to - from) < kSameSpot) return true;
  PlanePiece way;
  way.start = from;
  way.end = to;
  for (const Loop& loop : contours_)
    for (const PlanePiece& piece : loop)
      if (distance_between(way, piece) < distance - kKeeps) return false;
  return true;
}

bool clearing_loops(const Region& region, double radius, double aside, double step,
                    std::vector<Loop>& out) {
  struct Node {
    Loop loop;
    std::vector<std::size_t> inner;
  };
  std::vector<Node> nodes;
  std::vector<std::size_t> outer, level;
  step = step > 0 ? std::min(step, radius) : radius;
  for (double distance = radius + aside, next = 0;; distance = next) {
    std::vector<Loop> loops;
    next = distance + step;
    while (!region.inset(distance, loops)) {  // inner loops may lie a little farther out
      distance -= step * kOutwards;
      if (level.empty() || distance < next - 1.5 * step) return false;
    }
    if (loops.empty()) break;
    next = distance + step;
    std::vector<std::size_t> now;
    for (Loop& loop : loops) {
      std::size_t around = nodes.size();
      for (const std::size_t i : level)
        if (around == nodes.size() || distance_to_loop(nodes[i].loop, loop.front().start) <
                                          distance_to_loop(nodes[around].loop, loop.front().start))
          around = i;
      now.push_back(nodes.size());
      if (level.empty())
        outer.push_back(nodes.size());
      else
        nodes[around].inner.push_back(nodes.size());
      nodes.push_back({std::move(loop), {}});
    }
    if (nodes.size() > kMostLoops) return false;
    level = std::move(now);
  }
  // Orders loops from the inside out: a loop follows those within it.
  std::vector<std::size_t> waiting(outer.rbegin(), outer.rend()), order;
  while (!waiting.empty()) {
    const std::size_t at = waiting.back();
    waiting.pop_back();
    order.push_back(at);
    waiting.insert(waiting.end(), nodes[at].inner.begin(), nodes[at].inner.end());
  }
  out.clear();
  for (std::size_t i = order.size(); i > 0; --i) out.push_back(std::move(nodes[order[i - 1]].loop));
  return true;
}

}  // namespace mrsim
