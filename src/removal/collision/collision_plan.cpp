#include "removal/collision/collision_plan.h"

#include "core/numbers/vec.h"
#include "removal/collision/collision_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace mrsim {
namespace {

// A mover that takes more layers is searched in space.
constexpr std::size_t kMostLayers = 12;

// Plunges before a mover that are asked for its nose.
constexpr std::ptrdiff_t kPlungesBefore = 16;

// Groups of movers by height: each looks at all cuts.
constexpr std::size_t kMostGroups = 200;

// The cuts that have a path in plan, and the plunges among them by place.
struct SeenCuts {
  PlanPaths all;
  std::map<std::pair<double, double>, std::vector<std::size_t>> plunges;  // into all.paths
};

std::pair<double, double> place_of(const PlanPath& path) {
  return {path.plan[LineSlot::x], path.plan[LineSlot::y]};
}

SeenCuts seen_cuts(const SweepTable& sweeps, std::span<const std::uint32_t> cuts) {
  SeenCuts found;
  for (const std::uint32_t cut : cuts) {
    const auto path = plan_path(sweeps, cut);
    if (!path || !(path->from < path->to)) continue;
    if (path->is_upright()) found.plunges[place_of(*path)].push_back(found.all.paths.size());
    found.all.sweeps.push_back(cut);
    found.all.paths.push_back(*path);
  }
  return found;
}

// What an end mill's radius at a height above its tip is less than above its corner.
double less_at(double height, double round) {
  const double below = round - height;
  return below > 0 ? round - std::sqrt(std::max(0.0, round * round - below * below)) : 0;
}

struct Lifted {
  double lowest = 0, highest = 0;  // mm
  std::uint32_t mover = 0;
  PlanPath path;
};

// Movers of one lowest height; where there are many heights, of neighbouring ones.
std::vector<std::span<Lifted>> groups(std::vector<Lifted>& movers) {
  std::sort(movers.begin(), movers.end(), [](const Lifted& a, const Lifted& b) {
    return a.lowest != b.lowest ? a.lowest < b.lowest : a.mover < b.mover;
  });
  const std::size_t least = movers.size() / kMostGroups;
  std::vector<std::span<Lifted>> found;
  for (std::size_t from = 0, to = 0; to < movers.size(); from = to) {
    to = std::min(from + std::max<std::size_t>(least, 1), movers.size());
    while (to < movers.size() && movers[to].lowest == movers[to - 1].lowest) ++to;
    found.push_back(std::span(movers).subspan(from, to - from));
  }
  return found;
}

// Layers of movers with one lowest height.
class LayerMaker {
 public:
  LayerMaker(const CollisionScene& scene, const PlanPaths& cuts)
      : scene_(scene),
        cuts_(cuts),
        touch_(scene.threshold - scene.rounding()),
        top_(scene.part.solid().bounds().hi.z) {}

  // Up to the stock's top. Layers of a corner are as high as the movers are above the floor, so
  // that a cut at the bottom of one is as wide as they are at its top; others reach as far as cuts
  // do that begin below them. None where that takes too many, or no cut is so low.
  std::vector<std::unique_ptr<PlanView>> views(double lowest, double highest,
                                               const PlanPaths& movers) const {
    double round = 0;
    for (const PlanPath& path : movers.paths) round = std::max(round, path.round);
    const double lift = lift_of(lowest, round);
    if (lift < 0) return {};
    std::vector<std::unique_ptr<PlanView>> found;
    const double end = std::min(highest, top_);
    for (double bottom = lowest, top = 0; bottom < end; bottom = top) {
      top = reach(bottom, 2 * (end - lowest) / static_cast<double>(kMostLayers), end);
      if (bottom - lowest + lift < round) top = std::min(top, bottom + lift);
      if (!(top > bottom) || found.size() == kMostLayers) return {};
      PlanPaths narrower = movers;
      for (PlanPath& path : narrower.paths) path.radius -= less_at(top - lowest, path.round);
      found.push_back(std::make_unique<PlanView>(scene_.part.solid().bounds(),
                                                 cuts_through(bottom, top), std::move(narrower)));
    }
    return found;
  }

 private:
  // How far a height lies above the highest of the cuts that are far enough below it for a corner.
  double lift_of(double lowest, double round) const {
    double lift = -1;
    for (const PlanPath& cut : cuts_.paths)
      if (const double above = lowest + touch_ - cut.from;
          above >= round / static_cast<double>(kMostLayers) && above >= 0 &&
          (lift < 0 || above < lift))
        lift = above;
    return lift;
  }
  // The end of a layer: where the first of the cuts that begin below it ends, but for those that
  // reach less far than `least`. A layer that is higher would lose cuts that it needs.
  double reach(double bottom, double least, double end) const {
    double farthest = bottom, first = end;
    for (const PlanPath& cut : cuts_.paths) {
      if (cut.from > bottom + touch_) continue;
      farthest = std::max(farthest, cut.to);
      if (cut.to >= bottom + least) first = std::min(first, cut.to);
    }
    return std::min(first, farthest);
  }
  // Those that clear all between two heights, as wide as at the lower one.
  PlanPaths cuts_through(double bottom, double top) const {
    PlanPaths found;
    for (std::size_t k = 0; k < cuts_.paths.size(); ++k) {
      PlanPath path = cuts_.paths[k];
      const double above = bottom + touch_ - path.from;
      if (above < 0 || path.to < top) continue;
      path.radius -= less_at(above, path.round);
      found.sweeps.push_back(cuts_.sweeps[k]);
      found.paths.push_back(path);
    }
    return found;
  }

  const CollisionScene& scene_;
  const PlanPaths& cuts_;
  double touch_, top_;  // mm; the stock's
};

// Where a plunge before it has cleared what it has below its widest place, a mover counts from
// there.
void lift_nose(const CollisionScene& scene, const SeenCuts& cuts, Lifted& mover) {
  const auto plunges = cuts.plunges.find(place_of(mover.path));
  if (!mover.path.is_upright() || plunges == cuts.plunges.end()) return;
  const std::int32_t time = scene.movers.motions[mover.mover];
  const auto end = std::partition_point(
      plunges->second.begin(), plunges->second.end(),
      [&](std::size_t k) { return scene.part.sweeps().motion(cuts.all.sweeps[k]) <= time; });
  const auto first = end - std::min<std::ptrdiff_t>(kPlungesBefore, end - plunges->second.begin());
  if (std::any_of(first, end,
                  [&](std::size_t k) { return holds_nose(cuts.all.paths[k], mover.path); }))
    mover.lowest = mover.path.low + mover.path.tool->widest(), mover.path.round = 0;
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

void PlanView::cut_distances(std::span<const std::uint32_t> cuts, const Vec3& p,
                             double* out) const {
  for (std::size_t k = 0; k < cuts.size(); ++k) out[k] = cuts_.of(cuts[k]).distance(p);
}

void PlanView::mover_distances(std::span<const std::uint32_t> movers, const Vec3& p,
                               double* out) const {
  for (std::size_t k = 0; k < movers.size(); ++k) out[k] = movers_.of(movers[k]).distance(p);
}

Vec3 PlanView::drawn_onto(std::uint32_t mover, const Vec3& p) const {
  const PlanPath& path = movers_.of(mover);
  return p - std::max(path.distance(p), 0.0) * path.out(p);
}

std::vector<PlanLayers> plan_layers(const CollisionScene& scene,
                                    std::span<const std::uint32_t> cuts,
                                    std::span<const std::uint32_t> movers,
                                    std::vector<std::uint32_t>& others) {
  const SweepTable& sweeps = scene.movers.sweeps;
  const SeenCuts seen = seen_cuts(scene.part.sweeps(), cuts);
  const double top = scene.part.solid().bounds().hi.z - scene.threshold;
  std::vector<Lifted> lifted;
  for (const std::uint32_t mover : movers) {
    const Box3 bounds = sweeps.bounds(mover);
    if (bounds.lo.z >= top) continue;
    const auto path = seen.all.sweeps.empty() ? std::nullopt : plan_path(sweeps, mover);
    if (!path) {
      others.push_back(mover);
      continue;
    }
    lifted.push_back({bounds.lo.z, bounds.hi.z, mover, *path});
    lift_nose(scene, seen, lifted.back());
  }
  const LayerMaker maker(scene, seen.all);
  std::vector<PlanLayers> found;
  for (const std::span<Lifted> group : groups(lifted)) {
    const double lowest = group.front().lowest;
    double highest = lowest;
    std::sort(group.begin(), group.end(),
              [](const Lifted& a, const Lifted& b) { return a.mover < b.mover; });
    PlanPaths list;
    for (const Lifted& one : group) {
      highest = std::max(highest, one.highest);
      list.sweeps.push_back(one.mover);
      list.paths.push_back(one.path);
    }
    auto views = maker.views(lowest, highest, list);
    if (views.empty())
      others.insert(others.end(), list.sweeps.begin(), list.sweeps.end());
    else
      found.push_back({std::move(list.sweeps), std::move(views)});
  }
  return found;
}

}  // namespace mrsim
