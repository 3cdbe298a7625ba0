#include "removal/collision/collision_plan.h"

#include "core/numbers/vec.h"
#include "removal/collision/collision_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

namespace mrsim {
namespace {

// A mover that takes more layers is searched in space.
constexpr std::size_t kMostLayers = 12;

// Plunges before a mover that are asked for its nose.
constexpr std::ptrdiff_t kPlungesBefore = 16;

std::pair<double, double> place_of(const PlanPath& path) {
  return {path.plan[LineSlot::x], path.plan[LineSlot::y]};
}

// What an end mill's radius at a height above its tip is less than above its corner.
double less_at(double height, double round) {
  const double below = round - height;
  return below > 0 ? round - std::sqrt(std::max(0.0, round * round - below * below)) : 0;
}

}  // namespace

const PlanPath& PlanPaths::of(std::uint32_t sweep) const {
  const auto at = std::lower_bound(sweeps.begin(), sweeps.end(), sweep) - sweeps.begin();
  return paths[static_cast<std::size_t>(at)];
}

double PlanView::stock_distance(const Vec3& p) const {
  const double x = std::max(stock_.lo.x - p.x, p.x - stock_.hi.x),
               y = std::max(stock_.lo.y - p.y, p.y - stock_.hi.y);
  return x > 0 && y > 0 ? std::sqrt(x * x + y * y) : std::max(x, y);
}

Vec3 PlanView::out_of_stock(const Vec3& p) const {
  const Vec3 middle = 0.5 * (stock_.lo + stock_.hi), half = 0.5 * (stock_.hi - stock_.lo);
  const double x = std::abs(p.x - middle.x) - half.x, y = std::abs(p.y - middle.y) - half.y;
  return x > y ? Vec3{std::copysign(1.0, p.x - middle.x), 0, 0}
               : Vec3{0, std::copysign(1.0, p.y - middle.y), 0};
}

// Both lists ascend, and in small boxes the one is a short part of the other: each step doubles
// until it has passed the next.
void PlanView::cut_distances(std::span<const std::uint32_t> cuts, const Vec3& p,
                             double* out) const {
  const std::vector<std::uint32_t>& all = cuts_.sweeps;
  std::size_t at = 0;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    std::size_t step = 1;
    while (at + step < all.size() && all[at + step] < cuts[k]) at += step, step *= 2;
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(at + step + 1, all.size()));
    const auto found =
        std::lower_bound(all.begin() + static_cast<std::ptrdiff_t>(at), end, cuts[k]);
    at = static_cast<std::size_t>(found - all.begin());
    out[k] = cuts_.paths[at].distance(p);
  }
}

void PlanView::mover_distances(std::span<const std::uint32_t> movers, const Vec3& p,
                               double* out) const {
  for (std::size_t k = 0; k < movers.size(); ++k) out[k] = movers_.of(movers[k]).distance(p);
}

Vec3 PlanView::drawn_onto(std::uint32_t mover, const Vec3& p) const {
  const PlanPath& path = movers_.of(mover);
  return p - std::max(path.distance(p), 0.0) * path.out(p);
}

PlanSearch::PlanSearch(const CollisionScene& scene, std::span<const std::uint32_t> cuts,
                       std::span<const std::uint32_t> movers)
    : scene_(scene),
      touch_(scene.threshold - scene.rounding()),
      top_(scene.part.solid().bounds().hi.z) {
  take_cuts(cuts);
  for (const std::uint32_t mover : movers) {
    const Box3 bounds = scene.movers.sweeps.bounds(mover);
    if (bounds.lo.z >= top_ - scene.threshold) continue;
    const auto path = bounds_.empty() ? std::nullopt : plan_path(scene.movers.sweeps, mover);
    if (!path) {
      others_.push_back(mover);
      continue;
    }
    lifted_.push_back({bounds.lo.z, bounds, mover, *path});
    lift_nose(lifted_.back());
  }
}

std::vector<std::uint32_t> PlanSearch::movers() const {
  std::vector<std::uint32_t> all;
  for (const Lifted& one : lifted_) all.push_back(one.mover);
  return all;
}

std::size_t PlanSearch::heights() const {
  std::set<double> known;
  for (const Lifted& one : lifted_) known.insert(one.lowest);
  return known.size();
}

void PlanSearch::take_cuts(std::span<const std::uint32_t> cuts) {
  const SweepTable& sweeps = scene_.part.sweeps();
  for (const std::uint32_t cut : cuts) {
    const auto path = plan_path(sweeps, cut);
    if (!path || !(path->from < path->to)) continue;
    if (path->is_upright()) plunges_[place_of(*path)].push_back(bounds_.size());
    bounds_.push_back(sweeps.bounds(cut));
    cuts_.sweeps.push_back(cut);
    cuts_.paths.push_back(*path);
  }
}

// If an earlier plunge has cleared the mover's nose, which is the part below its widest place, the
// mover counts from its widest place up.
void PlanSearch::lift_nose(Lifted& mover) const {
  const auto plunges = plunges_.find(place_of(mover.path));
  if (!mover.path.is_upright() || plunges == plunges_.end()) return;
  const std::vector<std::size_t>& here = plunges->second;
  const std::int32_t time = scene_.movers.motions[mover.mover];
  const auto end = std::partition_point(here.begin(), here.end(), [&](std::size_t k) {
    return scene_.part.sweeps().motion(cuts_.sweeps[k]) <= time;
  });
  const auto first = end - std::min<std::ptrdiff_t>(kPlungesBefore, end - here.begin());
  if (std::none_of(first, end,
                   [&](std::size_t k) { return holds_nose(cuts_.paths[k], mover.path); }))
    return;
  mover.lowest = mover.path.low + mover.path.tool->widest();
  mover.path.round = 0;
}

PlanGroups PlanSearch::groups(std::span<const std::uint32_t> movers, std::size_t most) const {
  std::vector<Lifted> lifted;
  std::copy_if(lifted_.begin(), lifted_.end(), std::back_inserter(lifted), [&](const Lifted& one) {
    return std::binary_search(movers.begin(), movers.end(), one.mover);
  });
  std::sort(lifted.begin(), lifted.end(), [](const Lifted& a, const Lifted& b) {
    return a.lowest != b.lowest ? a.lowest < b.lowest : a.mover < b.mover;
  });
  PlanGroups found;
  const std::size_t least = std::max<std::size_t>(lifted.size() / most, 1);
  for (std::size_t from = 0, to = 0; to < lifted.size(); from = to) {
    to = std::min(from + least, lifted.size());
    while (to < lifted.size() && lifted[to].lowest == lifted[to - 1].lowest) ++to;
    PlanGroup group = group_of(std::span(lifted).subspan(from, to - from));
    if (add_layers(group))
      found.groups.push_back(std::move(group));
    else
      found.others.insert(found.others.end(), group.movers.sweeps.begin(),
                          group.movers.sweeps.end());
  }
  return found;
}

PlanGroup PlanSearch::group_of(std::span<Lifted> movers) const {
  PlanGroup group;
  group.lowest = movers.front().lowest;
  std::sort(movers.begin(), movers.end(),
            [](const Lifted& a, const Lifted& b) { return a.mover < b.mover; });
  for (const Lifted& one : movers) {
    extend(group.bounds, one.bounds);
    group.movers.sweeps.push_back(one.mover);
    group.movers.paths.push_back(one.path);
  }
  return group;
}

// Layers of a corner are as high as the movers are above the floor, so that a cut at the bottom of
// one is as wide as they are at its top; others reach as far as cuts do that begin below them.
// False where that takes too many, or no cut is so low.
bool PlanSearch::add_layers(PlanGroup& group) const {
  double round = 0;
  for (const PlanPath& path : group.movers.paths) round = std::max(round, path.round);
  const double lift = lift_of(group, round);
  if (lift < 0) return false;
  const double end = std::min(group.bounds.hi.z, top_);
  const double least = 2 * (end - group.lowest) / static_cast<double>(kMostLayers);
  for (double bottom = group.lowest, top = 0; bottom < end; bottom = top) {
    top = reach(group, bottom, least, end);
    if (bottom - group.lowest + lift < round) top = std::min(top, bottom + lift);
    if (!(top > bottom) || group.layers.size() == kMostLayers) return false;
    group.layers.push_back({bottom, top});
  }
  return true;
}

// How far the group lies above the highest of the cuts that are far enough below it for a corner.
double PlanSearch::lift_of(const PlanGroup& group, double round) const {
  const double least = round / static_cast<double>(kMostLayers);
  double lift = -1;
  for (std::size_t k = 0; k < bounds_.size(); ++k)
    if (const double above = group.lowest + touch_ - cuts_.paths[k].from;
        above >= least && (lift < 0 || above < lift) && is_near(group, k))
      lift = above;
  return lift;
}

// The end of a layer: where the first of the cuts that begin below it ends, but for those that
// reach less far than `least`. A layer that is higher would lose cuts that it needs.
double PlanSearch::reach(const PlanGroup& group, double bottom, double least, double end) const {
  double farthest = bottom, first = end;
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    const PlanPath& cut = cuts_.paths[k];
    if (cut.from > bottom + touch_ || !is_near(group, k)) continue;
    farthest = std::max(farthest, cut.to);
    if (cut.to >= bottom + least) first = std::min(first, cut.to);
  }
  return std::min(first, farthest);
}

bool PlanSearch::is_near(const PlanGroup& group, std::size_t cut) const {
  const Box3 &a = group.bounds, &b = bounds_[cut];
  return b.lo.x <= a.hi.x && b.hi.x >= a.lo.x && b.lo.y <= a.hi.y && b.hi.y >= a.lo.y;
}

PlanView PlanSearch::view(const PlanGroup& group, const PlanLayer& layer) const {
  PlanPaths cuts, movers = group.movers;
  for (PlanPath& path : movers.paths) path.radius -= less_at(layer.top - group.lowest, path.round);
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    PlanPath path = cuts_.paths[k];
    const double above = layer.bottom + touch_ - path.from;
    if (above < 0 || path.to < layer.top || !is_near(group, k)) continue;
    path.radius -= less_at(above, path.round);
    cuts.sweeps.push_back(cuts_.sweeps[k]);
    cuts.paths.push_back(path);
  }
  return {scene_.part.solid().bounds(), std::move(cuts), std::move(movers)};
}

}  // namespace mrsim
