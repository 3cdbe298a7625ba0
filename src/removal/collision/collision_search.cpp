// Finding the movers that collide. Every box carries the cuts and movers that can meet in it; the
// bounds that end it are, with p its centre and r its half diagonal:
//   - d_stock(p) >= r - threshold: no depth above the threshold in it, nor for any mover;
//   - d_i(p) <= threshold - r: cut i has cleared it for all movers from its motion on;
//   - d_c(p) > r: mover c is not in it;
//   - two clear balls that cover it (drop_touching): what ends the boxes on surfaces that a mover
//     only touches, at a size of sqrt(threshold * tool radius) instead of the threshold.
#include "removal/collision/collision_search.h"

#include "core/numbers/vec.h"
#include "removal/collision/collision_plan.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// Cuts near a box that are tried for a clear ball.
constexpr std::size_t kMostClear = 4;

// Longer lists belong to boxes that are too large to lie over one flat end.
constexpr std::size_t kMostFloors = 256;

// Movers and stocks are mostly convex: outside of them there is room for larger balls than in cuts.
constexpr double kOutside = 8;

// Share of the threshold: balls for less overlap than this would be too large.
constexpr double kLeastShare = 1.0 / 16;

// Boxes smaller than this many thresholds are tried for two clear balls; larger ones would need
// tools that are too large.
constexpr double kTouchSize = 60;

// Groups of movers by height, each of which looks at all cuts: with many heights a few groups are
// tried first, each from its lowest height, and show most of the movers clear.
constexpr std::size_t kMostGroups = 200, kManyHeights = 24, kFewGroups = 6;

// Of the threshold: where boxes in plan end. They are few along a line.
constexpr double kFinestInPlan = 0.5;

}  // namespace

std::array<Box3, 2> halves(const Box3& box) {
  const Vec3 size = box.hi - box.lo;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const double middle = 0.5 * (component(box.lo, axis) + component(box.hi, axis));
  std::array<Box3, 2> parts{box, box};
  component(parts[0].hi, axis) = middle;
  component(parts[1].lo, axis) = middle;
  return parts;
}

CollisionDetector::CollisionDetector(const CollisionScene& scene)
    : scene_(scene), slack_(scene.rounding()), space_(scene.part, scene.movers.sweeps) {}

std::vector<CollisionHit> CollisionDetector::detect(const Box3& box,
                                                    std::span<const std::uint32_t> cuts,
                                                    std::span<const std::uint32_t> movers) {
  std::vector<CollisionHit> hits;
  Candidates left(movers.begin(), movers.end());
  if (!scene_.turned) left = left_in_plan(box, cuts, movers, hits);
  search(space_, box, cuts, left);
  hits.insert(hits.end(), hits_.begin(), hits_.end());
  return hits;
}

// What is not clear in plan may still be clear, as other cuts than horizontal ones have cleared it.
Candidates CollisionDetector::left_in_plan(const Box3& box, std::span<const std::uint32_t> cuts,
                                           std::span<const std::uint32_t> movers,
                                           std::vector<CollisionHit>& hits) {
  const PlanSearch plan(scene_, cuts, movers);
  Box3 flat = box;
  flat.lo.z = flat.hi.z = 0;
  Candidates doubtful = plan.movers();
  if (plan.heights() > kManyHeights) {
    Candidates found;
    const Candidates others =
        search_in_plan(plan, flat, doubtful, kFewGroups,
                       [&](const CollisionHit& hit) { found.push_back(hit.mover); });
    found.insert(found.end(), others.begin(), others.end());
    std::sort(found.begin(), found.end());
    doubtful = std::move(found);
  }
  Candidates left = plan.others();
  const auto look = [&](const CollisionHit& hit) {
    if (const auto found = hit_in_space(hit, box, cuts))
      hits.push_back(*found);
    else
      left.push_back(hit.mover);
  };
  const Candidates others = search_in_plan(plan, flat, doubtful, kMostGroups, look);
  left.insert(left.end(), others.begin(), others.end());
  std::sort(left.begin(), left.end());
  return left;
}

// Calls doubt(hit) for each of the movers that is not clear in plan; returns those that no layers
// show clear.
template <class Doubt>
Candidates CollisionDetector::search_in_plan(const PlanSearch& plan, const Box3& flat,
                                             std::span<const std::uint32_t> movers,
                                             std::size_t most, Doubt&& doubt) {
  PlanGroups found = plan.groups(movers, most);
  for (const PlanGroup& group : found.groups) {
    Candidates clear = group.movers.sweeps;
    for (const PlanLayer& layer : group.layers) {
      const PlanView view = plan.view(group, layer);
      search(view, flat, view.cuts(), clear);
      Candidates found_here;
      for (const CollisionHit& hit : hits_) {
        found_here.push_back(hit.mover);
        doubt(hit);
      }
      std::sort(found_here.begin(), found_here.end());
      std::erase_if(clear, [&](std::uint32_t mover) {
        return std::binary_search(found_here.begin(), found_here.end(), mover);
      });
    }
  }
  return std::move(found.others);
}

// Whether the mover collides above or below a place that is not clear in plan.
std::optional<CollisionHit> CollisionDetector::hit_in_space(
    const CollisionHit& hit, const Box3& box, std::span<const std::uint32_t> cuts) const {
  const Box3 bounds = scene_.movers.sweeps.bounds(hit.mover);
  const double low = std::max(box.lo.z, bounds.lo.z), high = std::min(box.hi.z, bounds.hi.z);
  for (const double share : {0.5, 0.1, 0.9}) {
    const Vec3 at{hit.place.x, hit.place.y, low + share * (high - low)};
    const Vec3 p = space_.drawn_onto(hit.mover, at);
    if (distance(p, at) <= scene_.beside && space_.mover_distance(hit.mover, p) <= slack_ &&
        depth_at(space_, p, scene_.movers.motions[hit.mover], cuts) > scene_.threshold)
      return CollisionHit{hit.mover, p};
  }
  return {};
}

void CollisionDetector::search(const CollisionView& view, const Box3& box,
                               std::span<const std::uint32_t> cuts,
                               std::span<const std::uint32_t> movers) {
  view_ = &view;
  finest_ = view_ == &space_ ? scene_.finest : kFinestInPlan * scene_.threshold;
  hits_.clear();
  all_cuts_ = cuts;
  all_movers_ = movers;
  done_.assign(movers.size(), 0);
  if (!movers.empty()) visit(box, 0, cuts, movers);
}

void CollisionDetector::visit(const Box3& box, std::size_t tier,
                              std::span<const std::uint32_t> cuts,
                              std::span<const std::uint32_t> movers) {
  const Ball ball{0.5 * (box.lo + box.hi), 0.5 * distance(box.lo, box.hi)};
  const double stock = view_->stock_distance(ball.center);
  if (stock >= ball.radius - scene_.threshold) return;
  Tier& own = tiers_[tier];
  keep_movers(ball, movers, own);
  if (!own.movers.empty()) settle(ball, stock, cuts, own);
  if (view_ == &space_ && !own.movers.empty() && own.cuts.size() <= kMostFloors)
    drop_over_floors(box, own);
  if (!own.movers.empty() && ball.radius < kTouchSize * scene_.threshold)
    drop_touching(ball, stock, own);
  if (own.movers.empty()) return;
  if (ball.radius <= finest_ || tier + 1 == tiers_.size()) return look_beside(ball, own);
  for (const Box3& half : halves(box)) visit(half, tier + 1, own.cuts, own.movers);
}

// Keeps the movers that reach the ball and have not been found elsewhere.
void CollisionDetector::keep_movers(const Ball& ball, std::span<const std::uint32_t> movers,
                                    Tier& tier) const {
  tier.movers.clear();
  for (const std::uint32_t mover : movers) {
    const auto at =
        std::lower_bound(all_movers_.begin(), all_movers_.end(), mover) - all_movers_.begin();
    if (!done_[static_cast<std::size_t>(at)]) tier.movers.push_back(mover);
  }
  tier.mover_distance.resize(tier.movers.size());
  view_->mover_distances(tier.movers, ball.center, tier.mover_distance.data());
  std::size_t kept = 0;
  for (std::size_t m = 0; m < tier.movers.size(); ++m) {
    if (tier.mover_distance[m] > ball.radius + slack_) continue;
    tier.movers[kept] = tier.movers[m];
    tier.mover_distance[kept++] = tier.mover_distance[m];
  }
  tier.movers.resize(kept);
  tier.mover_distance.resize(kept);
}

// Cuts and movers together, in the order of time: `least` is the depth of the centre at the moment
// of each mover.
void CollisionDetector::settle(const Ball& ball, double stock, std::span<const std::uint32_t> cuts,
                               Tier& tier) {
  const SweepTable& sweeps = scene_.part.sweeps();
  const auto time_of = [this](std::uint32_t mover) { return scene_.movers.motions[mover]; };
  const std::int32_t last = time_of(tier.movers.back());
  const auto end = std::partition_point(
      cuts.begin(), cuts.end(), [&](std::uint32_t cut) { return sweeps.motion(cut) <= last; });
  const auto earlier = cuts.first(static_cast<std::size_t>(end - cuts.begin()));
  std::vector<double>& d = tier.cut_distance;
  d.resize(earlier.size());
  view_->cut_distances(earlier, ball.center, d.data());
  tier.cuts.clear();
  double least = -stock;
  std::size_t next = 0, kept = 0;
  const auto settle_until = [&](std::int32_t time) {
    for (; next < tier.movers.size() && time_of(tier.movers[next]) < time; ++next) {
      const std::uint32_t mover = tier.movers[next];
      const bool within = tier.mover_distance[next] <= 0;
      if (within && least > scene_.threshold) add_hit(mover, ball.center);
      if (least <= scene_.threshold - ball.radius || (within && least > scene_.threshold)) continue;
      tier.mover_distance[kept] = tier.mover_distance[next];
      tier.movers[kept++] = mover;
    }
  };
  bool cleared = false;
  for (std::size_t k = 0; k < earlier.size() && !cleared; ++k) {
    settle_until(sweeps.motion(earlier[k]));
    cleared = d[k] <= scene_.threshold - ball.radius;
    const bool near = d[k] <= ball.radius + scene_.threshold + slack_;
    if (cleared || !near || d[k] > least + 2 * ball.radius + slack_) continue;
    d[tier.cuts.size()] = d[k];
    tier.cuts.push_back(earlier[k]);
    least = std::min(least, d[k]);
  }
  if (!cleared) settle_until(last + 1);
  tier.movers.resize(kept);
  tier.mover_distance.resize(kept);
}

void CollisionDetector::add_hit(std::uint32_t mover, const Vec3& place) {
  hits_.push_back({mover, place});
  const auto at = std::lower_bound(all_movers_.begin(), all_movers_.end(), mover);
  done_[static_cast<std::size_t>(at - all_movers_.begin())] = 1;
}

double CollisionDetector::depth_at(const CollisionView& view, const Vec3& p, std::int32_t time,
                                   std::span<const std::uint32_t> cuts) const {
  const SweepTable& sweeps = scene_.part.sweeps();
  double least = -view.stock_distance(p);
  const auto end = std::partition_point(
      cuts.begin(), cuts.end(), [&](std::uint32_t cut) { return sweeps.motion(cut) <= time; });
  // From the last cut to the first: if many cuts pass one place, the last one has likely cleared
  // it.
  for (auto cut = end; cut != cuts.begin() && least > scene_.threshold;)
    least = std::min(least, view.cut_distance(*--cut, p));
  return least;
}

// Looks at boxes of the smallest size. Their centre may lie beside a mover, so the mover's nearest
// point is asked; that may lie outside of the box, where more cuts than the box's own count.
void CollisionDetector::look_beside(const Ball& ball, const Tier& tier) {
  for (const std::uint32_t mover : tier.movers) {
    const Vec3 p = view_->drawn_onto(mover, ball.center);
    if (view_->mover_distance(mover, p) > slack_) continue;
    const std::int32_t time = scene_.movers.motions[mover];
    if (depth_at(*view_, p, time, tier.cuts) > scene_.threshold &&
        depth_at(*view_, p, time, all_cuts_) > scene_.threshold)
      add_hit(mover, p);
  }
}

// Joins the range of heights with those that it meets. Two that are no farther apart than the
// threshold are joined too: each place between them lies within the threshold of one of them.
void CollisionDetector::add_cleared(Heights heights) {
  std::erase_if(cleared_, [&](const Heights& other) {
    if (other.low > heights.high + scene_.threshold || heights.low > other.high + scene_.threshold)
      return false;
    heights = {std::min(heights.low, other.low), std::max(heights.high, other.high)};
    return true;
  });
  cleared_.push_back(heights);
}

// A cutter with a flat end has cleared everything from its end up to its top, or for ever. So a box
// over the flat end is clear for movers that stay between them, whether or not the box does:
// surfaces that a mover touches from above cost a few large boxes only, and so do the planes at
// which the cuts of one level end and those of the next begin, which no cut alone has cleared.
void CollisionDetector::drop_over_floors(const Box3& box, Tier& tier) {
  const SweepTable& sweeps = scene_.part.sweeps();
  const Box3& stock = scene_.part.solid().bounds();
  const Vec3 center = 0.5 * (box.lo + box.hi), half = box.hi - center;
  const double reach = std::sqrt(half.x * half.x + half.y * half.y);
  const double touch = scene_.threshold - slack_;
  cleared_.clear();
  std::size_t kept = 0, cut = 0;
  for (std::size_t m = 0; m < tier.movers.size(); ++m) {
    const std::uint32_t mover = tier.movers[m];
    const std::int32_t time = scene_.movers.motions[mover];
    for (; cut < tier.cuts.size() && sweeps.motion(tier.cuts[cut]) <= time; ++cut) {
      const auto under = sweeps.flat_floor(tier.cuts[cut], center);
      if (under && under->inside > reach + slack_) add_cleared({under->z, under->top});
    }
    const Box3 bounds = scene_.movers.sweeps.bounds(mover);
    const double low = std::max({box.lo.z, bounds.lo.z, stock.lo.z});
    const double high = std::min({box.hi.z, bounds.hi.z, stock.hi.z});
    if (std::any_of(cleared_.begin(), cleared_.end(), [&](const Heights& h) {
          return low >= h.low - touch && high <= h.high + touch;
        }))
      continue;
    tier.mover_distance[kept] = tier.mover_distance[m];
    tier.movers[kept++] = mover;
  }
  tier.movers.resize(kept);
  tier.mover_distance.resize(kept);
}

// A ball of radius R about s is clear where s lies outside of the mover by R, or within a cut or
// outside of the stock by R - threshold: distances are 1-Lipschitz. Two of them on both sides of a
// surface cover a box on it, because they are far larger than the box.
void CollisionDetector::drop_touching(const Ball& ball, double stock, Tier& tier) {
  const SweepTable& sweeps = scene_.part.sweeps();
  clear_.clear();
  add_clear_stock(ball, stock);
  const std::size_t common = clear_.size();
  near_cuts_.clear();
  std::size_t kept = 0, cut = 0;
  for (std::size_t m = 0; m < tier.movers.size(); ++m) {
    const std::uint32_t mover = tier.movers[m];
    const std::int32_t time = scene_.movers.motions[mover];
    for (; cut < tier.cuts.size() && sweeps.motion(tier.cuts[cut]) <= time; ++cut)
      add_near({tier.cut_distance[cut], tier.cuts[cut]});
    // Where the mover grazes what the cut left, the clear sides overlap by less than the threshold.
    double overlap = scene_.threshold;
    if (!near_cuts_.empty())
      overlap = std::clamp(overlap + tier.mover_distance[m] - near_cuts_.front().distance,
                           kLeastShare * scene_.threshold, scene_.threshold);
    const double depth = 0.75 * ball.radius * ball.radius / overlap + ball.radius;
    for (NearCut& near : near_cuts_) {
      if (!near.is_known) find_clear(ball, depth, near);
      clear_.push_back(near.clear);
    }
    const bool touches = only_touches(ball, mover, depth);
    clear_.resize(common);
    if (touches) continue;
    tier.mover_distance[kept] = tier.mover_distance[m];
    tier.movers[kept++] = mover;
  }
  tier.movers.resize(kept);
}

void CollisionDetector::add_clear_stock(const Ball& ball, double stock) {
  if (stock <= -ball.radius) return;
  const double depth = 0.75 * ball.radius * ball.radius / scene_.threshold + ball.radius;
  const Vec3 offset = kOutside * depth * view_->out_of_stock(ball.center);
  clear_.push_back(
      clear_ball(offset, view_->stock_distance(ball.center + offset) + scene_.threshold));
}

// The nearest come first, of equal ones the earlier.
void CollisionDetector::add_near(const NearCut& cut) {
  const auto at =
      std::partition_point(near_cuts_.begin(), near_cuts_.end(),
                           [&](const NearCut& other) { return other.distance <= cut.distance; });
  near_cuts_.insert(at, cut);
  if (near_cuts_.size() > kMostClear) near_cuts_.pop_back();
}

void CollisionDetector::find_clear(const Ball& ball, double depth, NearCut& near) const {
  const Vec3 in = -view_->out_of_cut(near.cut, ball.center);
  // No deeper than the tool at rest: beyond the middle of a slot or bore balls are small again.
  const double middle = view_->cut_radius(near.cut) + near.distance;
  const Vec3 offset = std::min(depth, std::max(0.0, middle)) * in;
  near.clear =
      clear_ball(offset, scene_.threshold - view_->cut_distance(near.cut, ball.center + offset));
  near.is_known = true;
}

CollisionDetector::ClearBall CollisionDetector::clear_ball(const Vec3& offset,
                                                           double radius) const {
  radius = std::max(0.0, radius - slack_);
  return {offset, dot(offset, offset) - radius * radius};
}

bool CollisionDetector::only_touches(const Ball& ball, std::uint32_t mover, double depth) {
  const Vec3 out = view_->out_of_mover(mover, ball.center);
  for (const double far : {kOutside * depth, depth})
    clear_.push_back(clear_ball(far * out, view_->mover_distance(mover, ball.center + far * out)));
  // For a point v outside of ball a, |v|^2 - 2 v.offset + excess >= 0, and for b: weighted so that
  // opposite offsets cancel, the sum is at most this within the box.
  const auto covered = [&ball](const ClearBall& a, const ClearBall& b) {
    const double wa = length(b.offset), wb = length(a.offset), r = ball.radius;
    return (wa + wb) * r * r + 2 * r * length(wa * a.offset + wb * b.offset) + wa * a.excess +
               wb * b.excess <
           0;
  };
  for (std::size_t a = 0; a < clear_.size(); ++a)
    for (std::size_t b = a + 1; b < clear_.size(); ++b)
      if (covered(clear_[a], clear_[b])) return true;
  return false;
}

}  // namespace mrsim
