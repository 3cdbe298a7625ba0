#include "removal/tool/profile_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr double kLeastOverlap = 1e-6;  // mm, of two pieces along the axis

using Chain = std::vector<ProfileEdge>;

double direction_at(const ProfileEdge& e, Vec2 at) {
  if (e.radius == 0) return e.direction.x;
  return (e.convex ? -1 : 1) * (at.y - e.center.y);
}

// The least height from which on a convex chain is at least r wide. An arc counts from its end, or
// from its widest place, which is surely inside where the arc comes in again.
double wide_from(const Chain& chain, double r) {
  for (const ProfileEdge& e : chain) {
    if (e.a.x >= r) return e.a.y;
    if (e.b.x < r) continue;
    if (e.radius > 0) return std::min(e.b.y, e.center.y);
    if (e.b.y == e.a.y) return e.b.y;
    return e.a.y + (r - e.a.x) / (e.b.x - e.a.x) * (e.b.y - e.a.y);
  }
  return std::numeric_limits<double>::infinity();
}

// The largest height up to which the chain is at least `r` wide.
double wide_up_to(const Chain& chain, double r) {
  for (auto e = chain.rbegin(); e != chain.rend(); ++e) {
    if (std::isinf(e->b.y)) return e->a.x >= r ? e->b.y : e->a.y;
    if (e->b.x >= r) return e->b.y;
    if (e->a.x < r) continue;
    if (e->radius > 0) return std::max(e->a.y, e->center.y);
    if (e->b.y == e->a.y) return e->a.y;
    return e->b.y - (r - e->b.x) / (e->a.x - e->b.x) * (e->b.y - e->a.y);
  }
  return -std::numeric_limits<double>::infinity();
}

ProfileEdge straight(Vec2 a, Vec2 b) {
  const double size = length(b - a);
  return {.a = a, .b = b, .direction = (1 / size) * (b - a), .length = size};
}

// A chain closed by discs at its ends, where they are not on the axis or endless.
std::optional<Profile> solid_of(Chain chain) {
  const Vec2 first = chain.front().a, last = chain.back().b;
  if (first.x > 0) chain.insert(chain.begin(), straight({0, first.y}, first));
  if (!std::isinf(last.y) && last.x > 0) chain.push_back(straight(last, {0, last.y}));
  Profile solid(std::move(chain));
  if (!solid.is_convex()) return std::nullopt;
  return solid;
}

// Where the tangents at a concave arc's ends meet, within the solid; none where that is beyond the
// axis, or far away.
std::optional<Vec2> tangents_met(const ProfileEdge& arc) {
  constexpr double kLeastCosine = 0.25;  // of half the arc's angle
  const Vec2 a = (1 / arc.radius) * (arc.a - arc.center),
             b = (1 / arc.radius) * (arc.b - arc.center);
  const Vec2 middle = a + b;
  const double square = dot(middle, middle);
  if (!(square > 4 * kLeastCosine * kLeastCosine)) return std::nullopt;
  const Vec2 met = arc.center + (2 * arc.radius / square) * middle;
  if (met.x < 0) return std::nullopt;
  return met;
}

// The outline with the tangents of its concave arcs in their place, which meet at a reflex corner.
bool replace_concave_arcs(std::vector<ProfileEdge>& edges, std::vector<Profile::Corner>& corners) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const ProfileEdge arc = edges[i];
    if (!arc.is_arc() || arc.convex) continue;
    const std::optional<Vec2> met = tangents_met(arc);
    if (!met) return false;
    const auto at = static_cast<std::ptrdiff_t>(i);
    edges[i] = straight(arc.a, *met);
    edges.insert(edges.begin() + at + 1, straight(*met, arc.b));
    corners.insert(corners.begin() + at + 1, Profile::Corner::reflex);
    ++i;
  }
  return true;
}

// The profile's edges between corners that point into the solid.
std::vector<Chain> chains_of(const std::vector<ProfileEdge>& edges,
                             const std::vector<Profile::Corner>& corners) {
  std::vector<Chain> chains(1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && corners[i] == Profile::Corner::reflex) chains.emplace_back();
    chains.back().push_back(edges[i]);
  }
  return chains;
}

}  // namespace

std::vector<Profile> convex_pieces_of(std::vector<ProfileEdge> edges,
                                      std::vector<Profile::Corner> corners) {
  if (!replace_concave_arcs(edges, corners)) return {};
  const std::vector<Chain> chains = chains_of(edges, corners);
  std::vector<Chain> pieces = chains;
  for (std::size_t k = 0; k + 1 < chains.size(); ++k) {
    const Vec2 corner = chains[k + 1].front().a;
    const double low = wide_from(chains[k], corner.x), high = wide_up_to(chains[k + 1], corner.x);
    const bool comes_in = direction_at(chains[k].back(), corner) < 0;
    const bool goes_out = direction_at(chains[k + 1].front(), corner) > 0;
    const double begin = comes_in ? low : corner.y, end = goes_out ? high : corner.y;
    if (end - begin < kLeastOverlap) return {};
    const ProfileEdge link = straight({corner.x, begin}, {corner.x, end});
    if (comes_in && goes_out)
      pieces.push_back({link});
    else if (comes_in)
      pieces[k + 1].insert(pieces[k + 1].begin(), link);
    else
      pieces[k].push_back(link);
  }
  std::vector<Profile> out;
  for (Chain& piece : pieces) {
    std::optional<Profile> solid = solid_of(std::move(piece));
    if (!solid) return {};
    out.push_back(std::move(*solid));
  }
  return out;
}

}  // namespace mrsim
