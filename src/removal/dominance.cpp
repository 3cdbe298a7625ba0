#include "removal/dominance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Room for rounding in a squared distance, far above a few ulps of it.
double margin(double squared) { return 1e-9 * (1 + squared); }

float rounded_up(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}
float rounded_down(double x) {
  return std::max(0.0f, std::nextafter(static_cast<float>(x), -1.0f));
}

// gap > 2 r sqrt(apart2) + rest, without the root.
bool beats(double gap, double rest, double radius, double apart2) {
  const double left = gap - rest;
  return left > 0 && left * left > 4 * radius * radius * apart2;
}

double square(double x) { return x * x; }

}  // namespace

void Dominance::Nearest::resize(std::size_t size) {
  if (distance.size() >= size) return;
  for (auto* column : {&distance, &squared, &x, &y, &z}) column->resize(size);
}

Dominance::Dominance(const SweepTable& sweeps) {
  rows_.reserve(sweeps.size());
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const SweepSkeleton s = sweeps.skeleton(i);
    rows_.push_back({s.low, rounded_up(s.length), rounded_down(s.flat),
                     s.kind == SweepSkeleton::Kind::none ? -1 : s.group, s.kind, s.rising,
                     s.convex});
  }
}

void Dominance::drop(const Vec3& center, double radius, double band,
                     std::span<const std::uint32_t> ids, const Nearest& nearest,
                     std::vector<char>& keep) const {
  const Ball ball{center.z, radius, band};
  // Groups are few; each is found by its first sweep that is left.
  static thread_local std::vector<std::int32_t> done;
  done.clear();
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Row& row = rows_[ids[k]];
    if (!keep[k] || row.group < 0 || std::find(done.begin(), done.end(), row.group) != done.end())
      continue;
    done.push_back(row.group);
    if (row.kind == SweepSkeleton::Kind::plan)
      drop_plan(ball, ids, nearest, row.group, keep);
    else
      drop_solid(ball, ids, nearest, row.group, keep);
  }
}

void Dominance::drop_solid(const Ball& ball, std::span<const std::uint32_t> ids, const Nearest& n,
                           std::int32_t group, std::vector<char>& keep) const {
  const double r = ball.radius;
  std::size_t j = kNone;
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (keep[k] && rows_[ids[k]].group == group && (j == kNone || n.squared[k] < n.squared[j]))
      j = k;
  const bool section = rows_[ids[j]].kind == SweepSkeleton::Kind::section;
  if (section && n.squared[j] <= square(r) + margin(square(r)))
    return;  // inside of the polygon all distances are 0
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Row& row = rows_[ids[k]];
    if (k == j || !keep[k] || row.group != group || !row.convex) continue;
    double rest = square(r) + margin(n.squared[k]);
    // Below a short strip the nearest point stays on its segment: a sharper bound.
    const double length = row.length;
    if (!section && length < r && ball.z + r <= row.low)
      rest = length * (2 * r - length) + margin(n.squared[k]);
    const double apart2 =
        square(n.x[k] - n.x[j]) + square(n.y[k] - n.y[j]) + square(n.z[k] - n.z[j]);
    if (beats(n.squared[k] - n.squared[j], rest, r, apart2)) keep[k] = 0;
  }
}

// Level moves: the distance grows with the lateral distance and falls with depth, so a sweep that
// is laterally nearer at every point and no higher is never beaten. On a flat floor both may tie,
// and the lower index owns it: a tie in height needs the lower index.
void Dominance::drop_plan(const Ball& ball, std::span<const std::uint32_t> ids, const Nearest& n,
                          std::int32_t group, std::vector<char>& keep) const {
  std::size_t nearest = kNone, lowest = kNone, cover = kNone;
  const auto lower = [&](std::size_t a, std::size_t b) {
    return n.z[a] != n.z[b] ? n.z[a] < n.z[b] : n.squared[a] < n.squared[b];
  };
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Row& row = rows_[ids[k]];
    if (!keep[k] || row.group != group) continue;
    if (nearest == kNone || n.squared[k] < n.squared[nearest]) nearest = k;
    if (lowest == kNone || lower(k, lowest)) lowest = k;
    // The whole ball lies over the flat end: the floor decides, wherever |d| < band.
    const double inside = row.flat - ball.band - ball.radius - 1e-6;
    const bool covers = ball.band > 0 && row.rising && inside > 0 && n.squared[k] < square(inside);
    if (covers && (cover == kNone || n.z[k] < n.z[cover])) cover = k;
  }
  const auto tip_allows = [&](std::size_t k, std::size_t j) {
    return (rows_[ids[k]].rising && n.z[j] < n.z[k]) || (n.z[j] == n.z[k] && j < k);
  };
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Row& row = rows_[ids[k]];
    if (!keep[k] || row.group != group) continue;
    if (cover != kNone && k != cover && tip_allows(k, cover)) {
      keep[k] = 0;
      continue;
    }
    if (!row.convex) continue;
    for (const std::size_t j : {nearest, lowest}) {
      if (j == k) continue;
      // Beyond the flat end at every point, distances differ strictly, and the index does not
      // matter.
      const bool beyond =
          n.z[j] == n.z[k] && row.flat > 0 && n.squared[k] > square(row.flat + ball.radius + 1e-5);
      if (!beyond && !tip_allows(k, j)) continue;
      const double rest = square(ball.radius) + margin(n.squared[k]);
      const double apart2 = square(n.x[k] - n.x[j]) + square(n.y[k] - n.y[j]);
      if (!beats(n.squared[k] - n.squared[j], rest, ball.radius, apart2)) continue;
      keep[k] = 0;
      break;
    }
  }
}

}  // namespace mrsim
