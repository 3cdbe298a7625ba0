// Cuts and movers as seen from above. Where a mill has cleared all from some height up, whether the
// way of a mover above that height is clear can be seen in plan (docs/collisions.md, In plan).
#pragma once

#include "removal/collision/collision_view.h"
#include "removal/sweep/plan_path.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace mrsim {

struct CollisionScene;

/// Sweeps by their indices, which ascend.
struct PlanPaths {
  std::vector<std::uint32_t> sweeps;
  std::vector<PlanPath> paths;

  const PlanPath& of(std::uint32_t sweep) const;
};

/// Distances in plan, whatever the height. The stock is the rectangle about it.
class PlanView final : public CollisionView {
 public:
  PlanView(const Box3& stock, PlanPaths cuts, PlanPaths movers)
      : stock_(stock), cuts_(std::move(cuts)), movers_(std::move(movers)) {}
  const std::vector<std::uint32_t>& cuts() const { return cuts_.sweeps; }

  double stock_distance(const Vec3& p) const override;
  Vec3 out_of_stock(const Vec3& p) const override;
  void cut_distances(std::span<const std::uint32_t> cuts, const Vec3& p,
                     double* out) const override;
  void mover_distances(std::span<const std::uint32_t> movers, const Vec3& p,
                       double* out) const override;
  Vec3 out_of_cut(std::uint32_t cut, const Vec3& p) const override { return cuts_.of(cut).out(p); }
  Vec3 out_of_mover(std::uint32_t mover, const Vec3& p) const override {
    return movers_.of(mover).out(p);
  }
  double cut_radius(std::uint32_t cut) const override { return cuts_.of(cut).radius; }
  Vec3 drawn_onto(std::uint32_t mover, const Vec3& p) const override;

 private:
  Box3 stock_;
  PlanPaths cuts_, movers_;
};

/// Movers of one lowest height, or nearly so, by layers of their height: a mover that is clear in
/// each view is clear. In the view of a layer cuts are as wide as at its bottom, and movers as at
/// its top.
struct PlanLayers {
  std::vector<std::uint32_t> movers;  ///< ascending
  std::vector<std::unique_ptr<PlanView>> views;
};

/// The layers of all movers that can be searched in plan; the others are appended to `others`, but
/// for those that only touch the stock's top.
/// `cuts` and `movers` ascend. Cost: cuts x layers.
std::vector<PlanLayers> plan_layers(const CollisionScene& scene,
                                    std::span<const std::uint32_t> cuts,
                                    std::span<const std::uint32_t> movers,
                                    std::vector<std::uint32_t>& others);

}  // namespace mrsim
