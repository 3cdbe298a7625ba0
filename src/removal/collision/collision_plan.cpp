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

// Layers of a rounded corner: a mover that is lifted by less of its corner's height is searched in
// space.
constexpr int kMostLayers = 12;

// Horizontal cuts that reach up to the stock's top.
PlanPaths level_cuts(const SweepTable& sweeps, std::span<const std::uint32_t> cuts, double top) {
  PlanPaths found;
  for (const std::uint32_t cut : cuts)
    if (const auto path = plan_path(sweeps, cut); path && path->is_level && path->top >= top) {
      found.sweeps.push_back(cut);
      found.paths.push_back(*path);
    }
  return found;
}

// What an end mill's radius at a height above its tip is less than above its corner.
double less_at(double height, double round) {
  const double below = round - height;
  return below > 0 ? round - std::sqrt(std::max(0.0, round * round - below * below)) : 0;
}

// Layers of movers of one shape with one lowest height.
class LayerMaker {
 public:
  LayerMaker(const CollisionScene& scene, const PlanPaths& cuts)
      : scene_(scene), cuts_(cuts), touch_(scene.threshold - scene.rounding()) {}

  // Each layer is as high as the movers are above the floor, so that a cut at its bottom is as wide
  // as they are at its top. None where that takes too many, or no cut is so low.
  std::vector<std::unique_ptr<PlanView>> views(double lowest, const PlanPaths& movers) const {
    const double round = movers.paths.front().round;
    double lift = -1;
    for (const PlanPath& cut : cuts_.paths)
      if (const double above = lowest + touch_ - cut.tip;
          above >= round / kMostLayers && above >= 0 && (lift < 0 || above < lift))
        lift = above;
    if (lift < 0) return {};
    std::vector<std::unique_ptr<PlanView>> found;
    const int count = round > lift ? static_cast<int>(std::ceil(round / lift)) : 1;
    for (int k = 0; k < count; ++k) {
      const double less = k + 1 < count ? less_at((k + 1) * lift, round) : 0;
      PlanPaths narrower = movers;
      for (PlanPath& path : narrower.paths) path.radius -= less;
      found.push_back(std::make_unique<PlanView>(
          scene_.part.solid().bounds(), cuts_above(lowest + k * lift), std::move(narrower)));
    }
    return found;
  }

 private:
  // Those that clear what is above a height, as wide as there.
  PlanPaths cuts_above(double height) const {
    PlanPaths found;
    for (std::size_t k = 0; k < cuts_.paths.size(); ++k) {
      PlanPath path = cuts_.paths[k];
      const double above = height + touch_ - path.tip;
      if (above < 0) continue;
      path.radius -= less_at(above, path.round);
      found.sweeps.push_back(cuts_.sweeps[k]);
      found.paths.push_back(path);
    }
    return found;
  }

  const CollisionScene& scene_;
  const PlanPaths& cuts_;
  double touch_;
};

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
  const PlanPaths level = level_cuts(scene.part.sweeps(), cuts, scene.part.solid().bounds().hi.z);
  std::map<std::pair<std::int32_t, double>, PlanPaths> alike;
  for (const std::uint32_t mover : movers) {
    const auto path = level.sweeps.empty() ? std::nullopt : plan_path(sweeps, mover);
    if (!path) {
      others.push_back(mover);
      continue;
    }
    PlanPaths& list = alike[{path->shape, sweeps.bounds(mover).lo.z}];
    list.sweeps.push_back(mover);
    list.paths.push_back(*path);
  }
  const LayerMaker maker(scene, level);
  std::vector<PlanLayers> found;
  for (auto& [key, list] : alike) {
    auto views = maker.views(key.second, list);
    if (views.empty())
      others.insert(others.end(), list.sweeps.begin(), list.sweeps.end());
    else
      found.push_back({std::move(list.sweeps), std::move(views)});
  }
  return found;
}

}  // namespace mrsim
